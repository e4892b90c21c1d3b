// Vertices in memory that belongs to the caller, as the batch transforms take them.
//
// Real is float or double, const where they are only read.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

namespace morphcl {

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
const char* name_of(VertexLayout layout);

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

  Vertices part(std::size_t first, std::size_t count) const;

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

// Error(usage) unless both have the same layout and size, the outputs are apart from each other, and each output is
// apart from every input or is the same array.
template <class Real>
void check_in_and_out(const Vertices<const Real>& in, const Vertices<Real>& out);

}  // namespace morphcl
