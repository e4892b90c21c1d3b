#include "lab/accuracy/device_run.hpp"

#include <algorithm>
#include <type_traits>

#include "host/device/launch.hpp"
#include "host/device/session_access.hpp"
#include "lab/kernels/kernel_sources.hpp"

namespace morphcl::accuracy {

namespace {

using PlanesBuffer = Argument<float, "planes", "float">;
using ResultsBuffer = Argument<float, "results", "float">;
template <class T>
using ConstantsBuffer =
    std::conditional_t<std::is_same_v<T, float>, Argument<T, "constants", "float">, Argument<T, "constants", "double">>;

template <class T>
BufferAs<ConstantsBuffer<T>> constants_buffer(const Session& session, const std::vector<double>& values) {
  return checked("a buffer of constants", [&] {
    std::vector<T> rounded(values.begin(), values.end());
    rounded.resize(std::max<std::size_t>(rounded.size(), 1));
    return BufferAs<ConstantsBuffer<T>>(cl::Buffer(context_of(session), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                                                   rounded.size() * sizeof(T), rounded.data()));
  });
}

template <class Meaning>
BufferAs<Meaning> empty_buffer(const Session& session, std::size_t floats) {
  return checked("a buffer of the batch", [&] {
    return BufferAs<Meaning>(cl::Buffer(context_of(session), CL_MEM_READ_WRITE, floats * sizeof(float)));
  });
}

// T is the type of the constants.
template <class T>
DeviceRun prepare(Session& session, const KernelSource& program, const std::string& name, const Batch& batch,
                  const std::vector<double>& constants, Planes<float>& results) {
  const auto in = empty_buffer<PlanesBuffer>(session, batch.stored.values().size());
  const auto out = empty_buffer<ResultsBuffer>(session, results.values().size());
  const auto shared = constants_buffer<T>(session, constants);
  const cl::CommandQueue queue = queue_of(session);
  const std::vector<float>& planes = batch.stored.values();
  const std::size_t count = batch.size();
  const Kernel kernel = kernel_of(session, program, name);
  DeviceRun run;
  run.upload = [=, &planes] {
    checked("writing a batch",
            [&] { queue.enqueueWriteBuffer(in.buffer(), CL_TRUE, 0, planes.size() * sizeof(float), planes.data()); });
  };
  run.compute = [=](int times) {
    constexpr std::size_t group = 64;
    const std::size_t items = (count + group - 1) / group * group;
    for (int i = 0; i < times; ++i)
      launch(queue, kernel, cl::NDRange(items), cl::NDRange(group), in, shared, out,
             Named{"count", static_cast<cl_uint>(count)});
    checked("running " + name, [&] { queue.finish(); });
  };
  run.download = [=, &results] {
    std::vector<float>& values = results.values();
    checked("reading results",
            [&] { queue.enqueueReadBuffer(out.buffer(), CL_TRUE, 0, values.size() * sizeof(float), values.data()); });
  };
  return run;
}

}  // namespace

DevicePrepare kernel_run(const std::string& program, const std::string& kernel,
                         const std::function<std::vector<double>(const Batch&)>& constants) {
  return [=](Session& session, const Batch& batch, Planes<float>& results) {
    const KernelSource& source = kernel_source(program, lab_kernel_sources());
    return program.ends_with("_f64") ? prepare<double>(session, source, kernel, batch, constants(batch), results)
                                     : prepare<float>(session, source, kernel, batch, constants(batch), results);
  };
}

}  // namespace morphcl::accuracy
