#include "lab/accuracy/device_run.hpp"

#include <algorithm>

#include "host/device/launch.hpp"

namespace morphcl::accuracy {

namespace {

template <class T>
cl::Buffer buffer_of(const Session& session, const std::vector<T>& values) {
  return checked("a buffer of constants", [&] {
    std::vector<T> copy = values;
    copy.resize(std::max<std::size_t>(copy.size(), 1));
    return cl::Buffer(session.context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, copy.size() * sizeof(T), copy.data());
  });
}

cl::Buffer constants_buffer(const Session& session, const std::vector<double>& values, bool fp64) {
  if (fp64) return buffer_of(session, values);
  std::vector<float> rounded;
  for (const double value : values) rounded.push_back(static_cast<float>(value));
  return buffer_of(session, rounded);
}

cl::Buffer empty_buffer(const Session& session, std::size_t floats) {
  return checked("a buffer of the batch",
                 [&] { return cl::Buffer(session.context(), CL_MEM_READ_WRITE, floats * sizeof(float)); });
}

}  // namespace

DevicePrepare kernel_run(const std::string& program, const std::string& kernel,
                         const std::function<std::vector<double>(const Batch&)>& constants) {
  return [=](Session& session, const Batch& batch, Planes<float>& results) {
    const bool fp64 = program.size() > 4 && program.compare(program.size() - 4, 4, "_f64") == 0;
    const cl::Buffer in = empty_buffer(session, batch.stored.values().size());
    const cl::Buffer out = empty_buffer(session, results.values().size());
    const cl::Buffer shared = constants_buffer(session, constants(batch), fp64);
    const cl::CommandQueue queue = session.queue();
    const std::vector<float>& planes = batch.stored.values();
    const std::size_t count = batch.size();
    cl::Kernel entry = session.kernel(program, kernel);
    DeviceRun run;
    run.upload = [=, &planes] {
      checked("writing a batch",
              [&] { queue.enqueueWriteBuffer(in, CL_TRUE, 0, planes.size() * sizeof(float), planes.data()); });
    };
    run.compute = [=](int times) mutable {
      constexpr std::size_t group = 64;
      const std::size_t items = (count + group - 1) / group * group;
      for (int i = 0; i < times; ++i)
        launch(queue, entry, cl::NDRange(items), cl::NDRange(group), in, shared, out, static_cast<cl_uint>(count));
      checked("running " + kernel, [&] { queue.finish(); });
    };
    run.download = [=, &results] {
      std::vector<float>& values = results.values();
      checked("reading results",
              [&] { queue.enqueueReadBuffer(out, CL_TRUE, 0, values.size() * sizeof(float), values.data()); });
    };
    return run;
  };
}

}  // namespace morphcl::accuracy
