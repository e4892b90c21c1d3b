// Buffers that host and device share.
#include "host/device/shared_buffer.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "host/device/launch.hpp"
#include "host/device/session_access.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::shared_session;

using Words = Argument<cl_uint, "values", "uint">;

BufferAs<Words> values_in(const SharedBuffer& buffer) { return BufferAs<Words>(buffer.buffer()); }

const cl::CommandQueue& queue() { return queue_of(shared_session()); }

TEST(SharedBuffer, StartsWithAPageAndNeverShrinks) {
  SharedBuffer buffer(context_of(shared_session()));
  EXPECT_GE(buffer.capacity(), 4096u);
  buffer.ensure(10000);
  const std::size_t capacity = buffer.capacity();
  EXPECT_GE(capacity, 10000u);
  const cl_mem object = buffer.buffer()();
  buffer.ensure(0);
  buffer.ensure(10000);
  EXPECT_EQ(buffer.capacity(), capacity);
  EXPECT_EQ(buffer.buffer()(), object);
}

TEST(SharedBuffer, IsAlignedToPagesAndLargeOnesToHugePages) {
  SharedBuffer buffer(context_of(shared_session()));
  const auto address = [&] { return reinterpret_cast<std::uintptr_t>(buffer.map<char>(queue(), 1).data()); };
  EXPECT_EQ(address() % 4096, 0u);
  buffer.ensure(std::size_t{5} << 20);
  EXPECT_EQ(address() % (2 << 20), 0u);
}

TEST(SharedBuffer, HostAndDeviceSeeEachOthersWrites) {
  const KernelSource source{"increment",
                            "tests/device/shared_buffer_test.cpp",
                            "kernel void increment(global uint* values) { ++values[get_global_id(0)]; }",
                            {{"increment", {{"values", "uint"}}}}};
  const Kernel increment = kernel_of(shared_session(), source, "increment");
  SharedBuffer buffer(context_of(shared_session()));
  constexpr int count = 3000;
  buffer.ensure(count * sizeof(int));
  for (int round = 0; round < 3; ++round) {
    {
      const auto values = buffer.map<int>(queue(), count);
      for (int i = 0; i < count; ++i) values[i] = i * round;
    }
    launch(queue(), increment, cl::NDRange(count), cl::NDRange(100), values_in(buffer));
    const auto values = buffer.map<const int>(queue(), count);
    for (int i = 0; i < count; ++i) ASSERT_EQ(values[i], i * round + 1) << "element " << i << ", round " << round;
  }
}

// A kernel is still at work on the old memory when the buffer grows; under a sanitizer a freed block would show.
TEST(SharedBuffer, GrowsWhileTheDeviceUsesTheOldMemory) {
  const KernelSource source{"keep_busy",
                            "tests/device/shared_buffer_test.cpp (keep_busy)",
                            R"CL(
    kernel void keep_busy(global uint* values, uint rounds) {
      uint state = get_global_id(0);
      for (uint i = 0; i < rounds; ++i) {
        state = state * 1664525u + 1013904223u;
        values[(get_global_id(0) * 1024) + (state >> 22)] = state;
      }
    })CL",
                            {{"keep_busy", {{"values", "uint"}, {"rounds", "uint"}}}}};
  const Kernel keep_busy = kernel_of(shared_session(), source, "keep_busy");
  SharedBuffer buffer(context_of(shared_session()));
  buffer.ensure(16 * 1024 * sizeof(cl_uint));
  launch(queue(), keep_busy, cl::NDRange(16), cl::NDRange(1), values_in(buffer), Named{"rounds", cl_uint{1000000}});
  buffer.ensure(std::size_t{8} << 20);
  queue().finish();
  EXPECT_GE(buffer.capacity(), std::size_t{8} << 20);
}

TEST(SharedBuffer, MoreThanTheDeviceHasIsRefused) {
  SharedBuffer buffer(context_of(shared_session()));
  for (const std::size_t bytes :
       {shared_session().info().max_allocation + 1, std::numeric_limits<std::size_t>::max()}) {
    try {
      buffer.ensure(bytes);
      FAIL() << bytes << " bytes were granted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::no_device);
      EXPECT_NE(std::string(error.what()).find(std::to_string(bytes)), std::string::npos) << error.what();
    }
  }
  EXPECT_GE(buffer.capacity(), 4096u);  // what there was is kept
}

}  // namespace
}  // namespace morphcl
