// device_child: what a process of its own finds out about its device, as lines "name value".
//
//   device_child info [DEVICE [THREADS]]     threads, compute_units, name, verdict
//   device_child transform COUNT...          hash of all batch transforms of COUNT points each; fills the cache
//   device_child points COUNT...             the same of transform_points alone
//   device_child stray_write                 a kernel that writes outside its buffer, for checkers that should see it
// An Error is printed as "error MESSAGE" and its exit code is the process's.
#include <fmt/format.h>
#include <xxhash.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "host/device/launch.hpp"
#include "host/device/session.hpp"
#include "host/device/transform_points.hpp"
#include "host/error.hpp"

namespace {

using namespace morphcl;

void print_info(const std::string& device, int threads) {
  fmt::print("threads {}\n", prepare_process(threads));
  SessionOptions options;
  options.device = device;
  const auto session = Session::open(options);
  fmt::print("compute_units {}\nname {}\nverdict {}\n", session->info().compute_units, session->info().name,
             session->verdict() == Verdict::identical ? "identical" : session->verdict_detail());
}

struct Arrays {
  std::vector<float> x, y, z;

  explicit Arrays(std::size_t count) : x(count), y(count), z(count) {}
  PointArrays arrays() { return {x, y, z}; }
};

// Coordinates from -1 to 1 that use all bits of a float.
Arrays input(std::size_t count) {
  Arrays points(count);
  unsigned state = 1;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<float>(state >> 8) * 0x1p-23f - 1.0f;
  };
  for (std::size_t i = 0; i < count; ++i) points.x[i] = next(), points.y[i] = next(), points.z[i] = next();
  return points;
}

void print_transform_hash(const std::vector<std::size_t>& counts, bool only_points) {
  const auto session = Session::open({});
  const AffineRows rows{{-0.71f, 0.37f, 1.93f, 3.3f}, {0.11f, -2.9f, 0.83f, -7.1f}, {0.57f, 0.61f, 0.13f, 100.7f}};
  const ProjectiveRows projection{rows.x, rows.y, rows.z, {0, 0, -1, 0.5f}};
  XXH64_hash_t hash = 0;
  for (const std::size_t count : counts) {
    Arrays in = input(count), out(count);
    const auto add = [&] {
      for (const auto* values : {&out.x, &out.y, &out.z})
        hash = XXH3_64bits_withSeed(values->data(), count * sizeof(float), hash);
    };
    transform_points(*session, rows, in.arrays(), out.arrays());
    add();
    if (only_points) continue;
    transform_vectors(*session, rows, in.arrays(), out.arrays());
    add();
    transform_normals(*session, rows, in.arrays(), out.arrays());
    add();
    project_points(*session, projection, in.arrays(), out.arrays());
    add();
  }
  session->store_programs();
  fmt::print("hash {:016x}\n", hash);
}

void write_outside() {
  const auto session = Session::open({});
  cl::Program program(session->context(),
                      "kernel void stray(global int* values) { values[get_global_id(0) + 4] = 1; }");
  program.build();
  cl::Kernel stray(program, "stray");
  const cl::Buffer buffer(session->context(), CL_MEM_READ_WRITE, 4 * sizeof(cl_int));
  launch(session->queue(), stray, cl::NDRange(4), cl::NDRange(1), buffer);
  session->queue().finish();
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> arguments(values + 1, values + count);
  try {
    if (arguments.empty()) return 2;
    if (arguments[0] == "info") {
      print_info(arguments.size() > 1 ? arguments[1] : "", arguments.size() > 2 ? std::stoi(arguments[2]) : 0);
    } else if (arguments[0] == "transform" || arguments[0] == "points") {
      std::vector<std::size_t> counts;
      for (std::size_t i = 1; i < arguments.size(); ++i) counts.push_back(std::stoul(arguments[i]));
      print_transform_hash(counts, arguments[0] == "points");
    } else if (arguments[0] == "stray_write") {
      write_outside();
    } else {
      return 2;
    }
  } catch (const Error& error) {
    fmt::print("error {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
