#include "host/batch/vertices.hpp"

#include <fmt/format.h>

#include <functional>

#include "host/batch/usage_error.hpp"

namespace morphcl {

namespace {

template <class Real>
std::size_t record_count(std::span<Real> records, VertexLayout layout) {
  const std::size_t reals = reals_per_vertex(layout);
  if (records.size() % reals != 0)
    throw usage_error(fmt::format("{} values are not whole {} vertices; a multiple of {} is needed", records.size(),
                                  name_of(layout), reals));
  return records.size() / reals;
}

template <class Real>
bool overlap(std::span<const Real> a, std::span<const Real> b) {
  // std::less orders pointers into different arrays, < does not.
  const std::less<const Real*> before;
  return before(a.data(), b.data() + b.size()) && before(b.data(), a.data() + a.size());
}

}  // namespace

std::string_view name_of(VertexLayout layout) {
  return layout == VertexLayout::separate ? "separate" : layout == VertexLayout::xyz ? "xyz" : "xyzw";
}

template <class Real>
Vertices<Real> Vertices<Real>::separate(std::span<Real> x, std::span<Real> y, std::span<Real> z) {
  if (y.size() != x.size() || z.size() != x.size())
    throw usage_error(
        fmt::format("arrays of {}, {} and {} coordinates; all three must have one size", x.size(), y.size(), z.size()));
  return {VertexLayout::separate, {x, y, z}, x.size()};
}

template <class Real>
Vertices<Real> Vertices<Real>::xyz(std::span<Real> records) {
  return {VertexLayout::xyz, {records}, record_count(records, VertexLayout::xyz)};
}

template <class Real>
Vertices<Real> Vertices<Real>::xyzw(std::span<Real> records) {
  return {VertexLayout::xyzw, {records}, record_count(records, VertexLayout::xyzw)};
}

template <class Real>
Vertices<Real> Vertices<Real>::part(std::size_t first, std::size_t count) const {
  Vertices some = *this;
  for (std::size_t array = 0; array < array_count(layout_); ++array)
    some.arrays_[array] = arrays_[array].subspan(first * stride(), count * stride());
  some.count_ = count;
  return some;
}

template <class Real>
void check_in_and_out(const Vertices<const Real>& in, const Vertices<Real>& out) {
  if (in.layout() != out.layout())
    throw usage_error(fmt::format("the input is {} and the output {}; both must have one layout", name_of(in.layout()),
                                  name_of(out.layout())));
  if (in.size() != out.size())
    throw usage_error(fmt::format("{} vertices in and {} out; both must have one size", in.size(), out.size()));
  const auto outputs = out.arrays();
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other)
      if (overlap<Real>(outputs[i], outputs[other]))
        throw usage_error("two output arrays share memory; each needs its own");
    for (const std::span<const Real> input : in.arrays())
      if (overlap<Real>(outputs[i], input) && outputs[i].data() != input.data())
        throw usage_error("an output array begins inside an input array; it must be the same array or apart from it");
  }
}

template class Vertices<float>;
template class Vertices<double>;
template class Vertices<const float>;
template class Vertices<const double>;
template void check_in_and_out(const Vertices<const float>&, const Vertices<float>&);
template void check_in_and_out(const Vertices<const double>&, const Vertices<double>&);

}  // namespace morphcl
