#include "host/device/point_arrays.hpp"

#include <fmt/format.h>

#include <functional>

#include "host/error.hpp"

namespace morphcl {

namespace {

bool overlap(std::span<const float> a, std::span<const float> b) {
  // std::less orders pointers into different arrays, < does not.
  const std::less<const float*> before;
  return before(a.data(), b.data() + b.size()) && before(b.data(), a.data() + a.size());
}

}  // namespace

std::size_t checked_size(const ConstPointArrays& in, const PointArrays& out) {
  const std::span<const float> inputs[] = {in.x, in.y, in.z}, outputs[] = {out.x, out.y, out.z};
  const std::size_t count = in.x.size();
  for (int axis = 0; axis < 3; ++axis)
    if (inputs[axis].size() != count || outputs[axis].size() != count)
      throw Error(ErrorKind::usage, "",
                  fmt::format("arrays of {}, {}, {} coordinates in and {}, {}, {} out; all six must have one size",
                              in.x.size(), in.y.size(), in.z.size(), out.x.size(), out.y.size(), out.z.size()));
  for (int axis = 0; axis < 3; ++axis)
    for (int other = 0; other < 3; ++other) {
      if (other != axis && overlap(outputs[axis], outputs[other]))
        throw Error(ErrorKind::usage, "", "two output arrays share memory; each needs its own");
      if (overlap(outputs[axis], inputs[other]) && outputs[axis].data() != inputs[other].data())
        throw Error(ErrorKind::usage, "",
                    "an output array begins inside an input array; it must be the same array or apart from it");
    }
  return count;
}

}  // namespace morphcl
