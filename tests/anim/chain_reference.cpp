#include "tests/anim/chain_reference.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace morphcl::reference {

namespace {

using ChainReal =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>, boost::multiprecision::et_off>;

struct ChainMatrix {
  std::size_t size;
  std::vector<ChainReal> entries;
  explicit ChainMatrix(std::size_t n) : size(n), entries(n * n) {}
  ChainReal& operator()(std::size_t row, std::size_t column) { return entries[row * size + column]; }
  const ChainReal& operator()(std::size_t row, std::size_t column) const { return entries[row * size + column]; }
};

ChainMatrix chain_product(const ChainMatrix& a, const ChainMatrix& b) {
  ChainMatrix c(a.size);
  for (std::size_t i = 0; i < a.size; ++i)
    for (std::size_t k = 0; k < a.size; ++k) {
      const ChainReal& factor = a(i, k);
      if (factor == 0) continue;
      for (std::size_t j = 0; j < a.size; ++j) c(i, j) += factor * b(k, j);
    }
  return c;
}

// By halving until the Taylor series converges fast, and squaring.
ChainMatrix chain_exponential(ChainMatrix m) {
  ChainReal norm = 0;
  for (const ChainReal& entry : m.entries) norm += abs(entry);
  int halvings = 0;
  for (; norm > ChainReal(1) / 1024; norm /= 2) ++halvings;
  for (ChainReal& entry : m.entries) entry = ldexp(entry, -halvings);
  ChainMatrix sum = m, term = m;
  for (int n = 2; n <= 45; ++n) {
    term = chain_product(term, m);
    for (std::size_t i = 0; i < sum.entries.size(); ++i) {
      term.entries[i] /= n;
      sum.entries[i] += term.entries[i];
    }
  }
  for (; halvings > 0; --halvings) {
    const ChainMatrix square = chain_product(sum, sum);
    for (std::size_t i = 0; i < sum.entries.size(); ++i) sum.entries[i] = 2 * sum.entries[i] + square.entries[i];
  }
  for (std::size_t i = 0; i < m.size; ++i) sum(i, i) += 1;
  return sum;
}

int driven_at(int frame) { return (7 * frame * frame + 3 * frame) % 11; }

double share_of(std::size_t mass) { return 1 + static_cast<double>(mass) / 8; }

}  // namespace

SpringNet stiff_chain(std::size_t masses) {
  SpringNet net;
  net.masses = masses;
  net.anchor = 1;
  net.damping = 2;
  net.stiffness_damping = 1e-8;
  for (std::uint32_t i = 0; i + 1 < masses; ++i)
    net.edges.push_back({i, i + 1, std::pow(10.0, 12.0 * i / static_cast<double>(masses - 2))});
  return net;
}

MorphDrive chain_drive(std::size_t masses, int frames) {
  std::vector<std::int64_t> ticks;
  std::vector<double> values;
  for (int k = 0; k <= frames; ++k) {
    ticks.push_back(chain_time.frame_ticks(k));
    values.push_back(driven_at(k) / 8.0);
  }
  MorphDrive drive;
  drive.weights.weights = {0};
  drive.weights.tracks = {
      {.first_target = 0,
       .track = Track({Interpolation::linear, 1, false, chain_time.ticks_per_second(), ticks, values})}};
  drive.targets.resize(1);
  for (std::size_t i = 0; i < masses; ++i) drive.targets[0].emplace_back(share_of(i), 0, -2 * share_of(i));
  return drive;
}

std::vector<std::vector<Exact>> chain_motion(const SpringNet& net, int frames) {
  const std::size_t n = net.masses, constant = 2 * n, ramp = constant + 1;
  ChainMatrix m(2 * n + 2);
  const auto add_stiffness = [&](std::size_t row, std::size_t column, const ChainReal& k) {
    m(n + row, column) -= k;
    m(n + row, n + column) -= ChainReal(net.stiffness_damping) * k;
  };
  for (std::size_t i = 0; i < n; ++i) {
    m(i, n + i) = 1;
    add_stiffness(i, i, net.anchor);
    m(n + i, n + i) -= net.damping;
    m(n + i, constant) = ChainReal(net.anchor) * share_of(i);
  }
  for (const SpringNet::Edge& edge : net.edges) {
    add_stiffness(edge.a, edge.a, edge.stiffness);
    add_stiffness(edge.b, edge.b, edge.stiffness);
    add_stiffness(edge.a, edge.b, -edge.stiffness);
    add_stiffness(edge.b, edge.a, -edge.stiffness);
  }
  m(constant, ramp) = 1;
  for (ChainReal& entry : m.entries) entry /= 24;  // time in frames
  m(constant, ramp) = 1;
  const ChainMatrix step = chain_exponential(m);

  std::vector<ChainReal> state(m.size);
  std::vector<std::vector<Exact>> motion;
  for (int k = 0; k <= frames; ++k) {
    std::vector<Exact>& positions = motion.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      const double high = state[i].convert_to<double>();
      positions.push_back({high, (state[i] - ChainReal(high)).convert_to<double>()});
    }
    state[constant] = ChainReal(driven_at(k)) / 8;
    state[ramp] = ChainReal(driven_at(k + 1)) / 8 - state[constant];
    std::vector<ChainReal> next(m.size);
    for (std::size_t i = 0; i < m.size; ++i)
      for (std::size_t j = 0; j < m.size; ++j) next[i] += step(i, j) * state[j];
    state = std::move(next);
  }
  return motion;
}

}  // namespace morphcl::reference
