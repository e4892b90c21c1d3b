// Vectors and matrices over any real number type: double for the fp64 render, 113 bits and more for the tests of it.
// Nothing here rounds but the operations of Real itself.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace morphcl::accuracy {

template <class Real>
struct Vector3 {
  Real x{}, y{}, z{};
  Vector3 operator+(const Vector3& b) const { return {x + b.x, y + b.y, z + b.z}; }
  Vector3 operator-(const Vector3& b) const { return {x - b.x, y - b.y, z - b.z}; }
  Vector3 operator-() const { return {-x, -y, -z}; }
  Vector3 operator*(const Real& factor) const { return {x * factor, y * factor, z * factor}; }
  Vector3 operator*(const Vector3& b) const { return {x * b.x, y * b.y, z * b.z}; }
};

template <class Real>
Real dot(const Vector3<Real>& a, const Vector3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vector3<Real> cross(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Divided by its largest component, so that squares neither overflow nor vanish; 0 0 0 stays.
template <class Real>
Vector3<Real> scaled_to_one(const Vector3<Real>& v) {
  using std::abs;
  Real largest = abs(v.x);
  if (abs(v.y) > largest) largest = abs(v.y);
  if (abs(v.z) > largest) largest = abs(v.z);
  if (!(largest > 0)) return {};
  return {v.x / largest, v.y / largest, v.z / largest};
}

// Of length 1; 0 0 0 stays.
template <class Real>
Vector3<Real> unit(const Vector3<Real>& v) {
  using std::sqrt;
  const Vector3<Real> scaled = scaled_to_one(v);
  const Real square = dot(scaled, scaled);
  return square > 0 ? scaled * (1 / sqrt(square)) : scaled;
}

// The first three components of a glm vector of floats or doubles.
template <class Real, class Stored>
Vector3<Real> to_real(const Stored& v) {
  return {Real(v[0]), Real(v[1]), Real(v[2])};
}

// matrix[row][column], for column vectors.
template <class Real>
using Row = std::array<Real, 4>;
template <class Real>
using Matrix = std::array<Row<Real>, 4>;

template <class Real>
Matrix<Real> to_real(const glm::dmat4& m) {
  Matrix<Real> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix[row][column] = Real(m[column][row]);
  return matrix;
}

template <class Real>
Matrix<Real> operator*(const Matrix<Real>& a, const Matrix<Real>& b) {
  Matrix<Real> product;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      product[row][column] = 0;
      for (int k = 0; k < 4; ++k) product[row][column] += a[row][k] * b[k][column];
    }
  return product;
}

template <class Real>
Real row_times_point(const Row<Real>& row, const Vector3<Real>& p) {
  return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

template <class Real>
Vector3<Real> times_point(const Matrix<Real>& m, const Vector3<Real>& p) {
  return {row_times_point(m[0], p), row_times_point(m[1], p), row_times_point(m[2], p)};
}

template <class Real>
Vector3<Real> times_vector(const Matrix<Real>& m, const Vector3<Real>& v) {
  const auto part = [&](const Row<Real>& row) -> Real { return row[0] * v.x + row[1] * v.y + row[2] * v.z; };
  return {part(m[0]), part(m[1]), part(m[2])};
}

}  // namespace morphcl::accuracy
