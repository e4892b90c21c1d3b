// Batch transforms: one matrix, or a palette of them, applied to any number of vertices on a device.
//
//   const auto turned = Transform<float>::points(CompositeTransform().rotate_z_degrees(30));
//   transform_vertices(*session, turned, Vertices<const float>::xyz(points), Vertices<float>::xyz(results));
//
// transform_vertices() takes arrays in the host's memory; opencl_interop.hpp has the same for buffers of a device.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "morphcl/transform.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

class Session;

// ---- matrices -------------------------------------------------------------------------------------------------------
//
// By rows, in the precision of the vertices. Real is float or double.

// One row of a matrix that multiplies column vectors (x, y, z, 1).
template <class Real>
using MatrixRow = std::array<Real, 4>;

// The upper three rows of an affine matrix, translation last.
template <class Real>
struct AffineRows {
  MatrixRow<Real> x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0};
};

template <class Real>
struct ProjectiveRows {
  MatrixRow<Real> x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0}, w{0, 0, 0, 1};
};

// The rows of a matrix, each entry rounded once to nearest. Error(usage) where one is not finite or too large for Real;
// of affine_rows also where the last row is not 0 0 0 1.
template <class Real>
[[gnu::visibility("default")]] AffineRows<Real> affine_rows(const glm::dmat4& affine);
template <class Real>
[[gnu::visibility("default")]] ProjectiveRows<Real> projective_rows(const glm::dmat4& matrix);

// The inverse transpose of the linear part of `rows`, times the positive power of two that brings its largest entry to
// [1/2, 1]; the translations are 0. It is computed as the cofactor matrix with the determinant's sign, in fp64, each
// cofactor as Kahan's difference of products, and rounded once. From floats, whose products are
// exact in fp64, every entry is within u32 (1 + 2^-28) of its exact value, relative, or within 2^-150 where it is
// denormal. From doubles it is within 2 u64, relative, if no product of two entries is below 2^-900 times the square of
// the largest one.
//
// A singular matrix has no inverse; its cofactors still hold the normal of the plane that everything falls on, and are
// 0 where everything falls on a line. Its sign, and that of a determinant too near to 0 to tell, counts as positive.
// Error(usage) if an entry of the linear part is not finite.
template <class Real>
AffineRows<Real> normal_rows(const AffineRows<Real>& rows);

// ---- vertices -------------------------------------------------------------------------------------------------------
//
// In memory that belongs to the caller. Real is float or double, const where they are only read.

enum class VertexLayout {
  separate,  // one array for x, one for y, one for z
  xyz,       // records of three reals
  xyzw       // records of four reals; w is no coordinate, but goes along with its vertex unchanged
};

// How many arrays a layout has, and how many reals of a vertex are in each.
constexpr std::size_t array_count(VertexLayout layout) { return layout == VertexLayout::separate ? 3 : 1; }
constexpr std::size_t reals_per_vertex(VertexLayout layout) {
  return layout == VertexLayout::separate ? 1 : layout == VertexLayout::xyz ? 3 : 4;
}
std::string_view name_of(VertexLayout layout);

template <class Real>
class Vertices {
 public:
  // Error(usage) if the sizes differ, or do not hold whole records.
  static Vertices separate(std::span<Real> x, std::span<Real> y, std::span<Real> z);
  static Vertices xyz(std::span<Real> records);
  static Vertices xyzw(std::span<Real> records);

  operator Vertices<const Real>() const
    requires(!std::is_const_v<Real>)
  {
    return {layout_, {arrays_[0], arrays_[1], arrays_[2]}, count_};
  }

  VertexLayout layout() const { return layout_; }
  std::size_t size() const { return count_; }  // vertices
  std::span<const std::span<Real>> arrays() const { return {arrays_.data(), array_count(layout_)}; }

  // Coordinate 0, 1 or 2 of vertex i is coordinates(axis)[i * stride()], and w of xyzw is carried()[i * stride()].
  // Of no vertices: where the array is, which may be nowhere.
  Real* coordinates(std::size_t axis) const {
    return layout_ == VertexLayout::separate ? arrays_[axis].data() : in_vertex(axis);
  }
  Real* carried() const { return in_vertex(3); }
  std::size_t stride() const { return reals_per_vertex(layout_); }

  Vertices part(std::size_t first, std::size_t count) const;  // first + count <= size(), which is not tested

 private:
  template <class>
  friend class Vertices;
  Vertices(VertexLayout layout, std::array<std::span<Real>, 3> arrays, std::size_t count)
      : layout_(layout), arrays_(arrays), count_(count) {}
  Real* in_vertex(std::size_t real) const { return arrays_[0].data() + (count_ == 0 ? 0 : real); }

  VertexLayout layout_;
  std::array<std::span<Real>, 3> arrays_;
  std::size_t count_;
};

// ---- transform ------------------------------------------------------------------------------------------------------
//
// What a batch transform does to its vertices: one matrix, or a palette of which each vertex chooses.
//
// A coordinate of the product of a row m and (x, y, z) is fma(x, m0, fma(y, m1, fma(z, m2, m3))), at most 3 roundings.
//   points    that product
//   vectors   the same without translations
//   project   (X, Y, Z) / w of the four products; a point with w <= 0 or NaN has no image: +infinity, three times
//   normals   unit normals of the transformed surface, from normal_rows(rows) for the matrix `rows` that the points are
//             transformed with. Lengths from denormal to near overflow are safe; a normal of length 0, or one that the
//             matrix takes to 0, gives 0. Normals as long as the matrix makes them are vectors(normal_rows(rows)).
// Infinities and NaN follow IEEE 754; which NaN a result is, is not promised.

enum class TransformKind : std::uint32_t {
  affine = 0,      // three rows a matrix
  projective = 1,  // four rows a matrix, division by the fourth coordinate
  normals = 2      // three rows a matrix, results of length 1
};

template <class Real>
class Transform {
 public:
  // Error(usage) if there is no matrix, or more than 2^28; of normals() also if an entry is not finite.
  static Transform points(std::span<const AffineRows<Real>> matrices);
  static Transform vectors(std::span<const AffineRows<Real>> matrices);
  static Transform normals(std::span<const AffineRows<Real>> matrices);
  static Transform project(std::span<const ProjectiveRows<Real>> matrices);

  static Transform points(const AffineRows<Real>& matrix) { return points(std::span(&matrix, 1)); }
  static Transform vectors(const AffineRows<Real>& matrix) { return vectors(std::span(&matrix, 1)); }
  static Transform normals(const AffineRows<Real>& matrix) { return normals(std::span(&matrix, 1)); }
  static Transform project(const ProjectiveRows<Real>& matrix) { return project(std::span(&matrix, 1)); }

  // Of matrices in fp64, rounded once: composed step by step, or GLM's. Error(usage) where an entry does not fit Real,
  // or a matrix that has to be affine has another last row than 0 0 0 1.
  static Transform points(const CompositeTransform& composite) { return points(affine_rows<Real>(composite.matrix())); }
  static Transform vectors(const CompositeTransform& composite) {
    return vectors(affine_rows<Real>(composite.matrix()));
  }
  static Transform normals(const CompositeTransform& composite) {
    return normals(affine_rows<Real>(composite.matrix()));
  }
  static Transform points(const glm::dmat4& affine) { return points(affine_rows<Real>(affine)); }
  static Transform vectors(const glm::dmat4& affine) { return vectors(affine_rows<Real>(affine)); }
  static Transform normals(const glm::dmat4& affine) { return normals(affine_rows<Real>(affine)); }
  static Transform project(const glm::dmat4& matrix) { return project(projective_rows<Real>(matrix)); }
  template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
  static Transform points(const glm::mat<C, R, T, Q>&) = delete;  // GLM would turn another matrix into a 4 x 4 one
  template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
  static Transform vectors(const glm::mat<C, R, T, Q>&) = delete;
  template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
  static Transform normals(const glm::mat<C, R, T, Q>&) = delete;
  template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
  static Transform project(const glm::mat<C, R, T, Q>&) = delete;

  TransformKind kind() const { return kind_; }
  std::size_t rows_per_matrix() const { return kind_ == TransformKind::projective ? 4 : 3; }
  std::size_t matrix_count() const { return rows_.size() / rows_per_matrix(); }
  std::span<const MatrixRow<Real>> rows() const { return rows_; }  // as they are multiplied, matrix by matrix

 private:
  Transform(TransformKind kind, std::size_t matrix_count);
  void add(const AffineRows<Real>& matrix);

  TransformKind kind_;
  std::vector<MatrixRow<Real>> rows_;
};

// Vertex i goes through matrix index[i].
using MatrixIndices = std::span<const std::uint32_t>;

// Vertex i goes through the sum over k of weights[i][k] times matrix matrices[i][k], as skins are blended. The product
// with each matrix is rounded as above; the sum is the first product with its weight, rounded, and one fma for each of
// the others. Not for normals, as the inverse transpose of a sum is no sum of inverse transposes; where all matrices
// are rotations, vectors do.
template <class Real>
struct MatrixBlend {
  std::span<const std::array<std::uint16_t, 4>> matrices;
  std::span<const std::array<Real, 4>> weights;
};

// Nothing where all vertices go through the only matrix there is; where there are several that is Error(usage).
template <class Real>
using MatrixChoice = std::variant<std::monostate, MatrixIndices, MatrixBlend<Real>>;

// ---- execution ------------------------------------------------------------------------------------------------------
//
// The arrays are used where they lie (no copies on a CPU device); `out` may be the same arrays as `in`, any other
// overlap is Error(usage). The call returns when the results are in `out`. They are the same bits on every device with
// Verdict::identical (session.hpp), as transform_reference() computes them; batches of fewer than 8192 vertices are
// computed by it, in about the time that the launch of a kernel takes.
//
// Large batches are written past the cache from the first result on that starts a cache line (64 bytes). That takes
// arrays of `separate` that all start at the same offset in their lines, as large arrays from one allocator do, and
// xyzw records of which one starts a line (all that are aligned to their size); other batches lose about a third of
// their speed.

// Error(usage): `in`, `out` and the choice do not fit, or a vertex asks for a matrix past the last one: it becomes NaN,
// all others are transformed. Error(no_device): Real is double and the device has none, or the device failed;
// Error(internal) likewise. Threads may share a session.
template <class Real>
void transform_vertices(Session& session, const Transform<Real>& transform,
                        const Vertices<const std::type_identity_t<Real>>& in,
                        const Vertices<std::type_identity_t<Real>>& out,
                        const MatrixChoice<std::type_identity_t<Real>>& choice = {});

// The same in plain loops on the host, with the same bits. `out` may be the same arrays as `in`. A vertex that asks for
// a matrix past the last one becomes NaN. Error(usage) where `in`, `out` and the choice do not fit.
template <class Real>
void transform_reference(const Transform<Real>& transform, const Vertices<const std::type_identity_t<Real>>& in,
                         const Vertices<std::type_identity_t<Real>>& out,
                         const MatrixChoice<std::type_identity_t<Real>>& choice = {});

}  // namespace morphcl
#pragma GCC visibility pop
