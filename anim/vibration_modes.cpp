#include "anim/vibration_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "anim/householder.hpp"

namespace morphcl {

namespace {

// How many pieces hang together: that many masses more than springs can strain on their own.
std::size_t count_pieces(const SpringNet& net) {
  std::vector<std::uint32_t> parent(net.masses);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&parent](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::size_t pieces = net.masses;
  for (const SpringNet::Edge& edge : net.edges) {
    if (edge.stiffness == 0) continue;
    const std::uint32_t a = root(edge.a), b = root(edge.b);
    if (a != b) {
      parent[a] = b;
      --pieces;
    }
  }
  return pieces;
}

DenseMatrix strain_matrix(const SpringNet& net) {
  DenseMatrix b(net.masses, net.edges.size());
  for (std::size_t c = 0; c < net.edges.size(); ++c) {
    const double root = std::sqrt(net.edges[c].stiffness);
    b.column(c)[net.edges[c].a] = root;
    b.column(c)[net.edges[c].b] = -root;
  }
  return b;
}

DenseMatrix transposed_top(const DenseMatrix& a, std::size_t rows) {
  DenseMatrix t(a.columns, rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t c = 0; c < a.columns; ++c) t.column(row)[c] = a.column(c)[row];
  return t;
}

double dot(const double* a, const double* b, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

void rotate(double* a, double* b, std::size_t count, double cosine, double sine) {
  for (std::size_t i = 0; i < count; ++i) {
    const double old = a[i];
    a[i] = cosine * old - sine * b[i];
    b[i] = sine * old + cosine * b[i];
  }
}

// Turns columns a and b of `x` in their plane until they are at right angles, and those of `turns` with them. False
// when they are already, up to rounding.
bool orthogonalize(DenseMatrix& x, DenseMatrix& turns, std::size_t a, std::size_t b) {
  const std::size_t rows = x.rows;
  const double aa = dot(x.column(a), x.column(a), rows), bb = dot(x.column(b), x.column(b), rows);
  const double ab = dot(x.column(a), x.column(b), rows);
  const double negligible = 0x1p-52 * std::sqrt(static_cast<double>(rows)) * std::sqrt(aa) * std::sqrt(bb);
  if (!(std::abs(ab) > negligible)) return false;
  const double zeta = (bb - aa) / (2 * ab);
  const double tangent = std::copysign(1 / (std::abs(zeta) + std::sqrt(1 + zeta * zeta)), zeta);
  const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
  rotate(x.column(a), x.column(b), rows, cosine, sine);
  rotate(turns.column(a), turns.column(b), turns.rows, cosine, sine);
  return true;
}

// x W = V diag(lengths of the columns); returns W.
DenseMatrix jacobi(DenseMatrix& x) {
  constexpr int max_sweeps = 60;  // some 6 to 10 are needed; each makes the angles quadratically smaller
  DenseMatrix turns(x.columns, x.columns);
  for (std::size_t i = 0; i < x.columns; ++i) turns.column(i)[i] = 1;
  bool turned = true;
  for (int sweep = 0; sweep < max_sweeps && turned; ++sweep) {
    turned = false;
    for (std::size_t a = 0; a + 1 < x.columns; ++a)
      for (std::size_t b = a + 1; b < x.columns; ++b) turned |= orthogonalize(x, turns, a, b);
  }
  return turns;
}

}  // namespace

VibrationModes find_modes(const SpringNet& net) {
  const std::size_t n = net.masses, strained = n - count_pieces(net);
  DenseMatrix b = strain_matrix(net);
  const HouseholderQr first(b, Pivoting::columns);  // B P = Q R, of rank `strained`
  DenseMatrix rows = transposed_top(b, strained);   // R^T = Q2 R2, so that B P = Q R2^T Q2^T
  const HouseholderQr second(rows, Pivoting::none);
  DenseMatrix core(strained, strained);
  for (std::size_t c = 0; c < strained; ++c) std::copy_n(rows.column(c), strained, core.column(c));
  const DenseMatrix left = jacobi(core);  // R2 W = V S: R2^T = W S V^T, and the modes are Q W

  VibrationModes modes;
  modes.shapes.assign(n * n, 0.0);
  for (std::size_t mode = 0; mode < n; ++mode) {
    double* const shape = modes.shapes.data() + mode * n;
    double square = 0;
    if (mode < strained) {
      square = dot(core.column(mode), core.column(mode), strained);
      std::copy_n(left.column(mode), strained, shape);
    } else {
      shape[mode] = 1;  // a piece that moves as a whole
    }
    first.apply_q(shape);
    modes.stiffness.push_back(net.anchor + square);
  }
  return modes;
}

}  // namespace morphcl
