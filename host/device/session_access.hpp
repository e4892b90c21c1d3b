// What the library itself takes from a session: context and queue (opencl_interop.hpp), and kernels.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "host/device/kernel.hpp"
#include "host/device/opencl.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

// Opens a session that changes each kernel program's text before it is built: for tests that break a kernel on purpose.
using EditSource = std::function<std::string(const std::string&)>;
std::shared_ptr<Session> open_session(const SessionOptions& options, EditSource edit_source);

// A kernel of a program that the build embedded, built on first use from what the cache has, else from source.
// Thread-safe; each call returns a kernel object of its own, so that threads do not share arguments. Errors name the
// file and hold the first line of the build log. `more_options` (" -DNAME=VALUE") are added to those of every kernel;
// each choice of them is a program of its own.
Kernel kernel_of(Session& session, const KernelSource& source, const std::string& kernel_name,
                 const std::string& more_options = "");

// Whether kernel_of() was called for this kernel before, or finds its binary in the cache: it takes no compiler then.
bool is_compiled(Session& session, const KernelSource& source, const std::string& kernel_name,
                 const std::string& more_options = "");

// Session::store_programs() that looks at `stop` before each program, and leaves the others for another call.
void store_programs(Session& session, const std::atomic<bool>& stop);

// For who has time: the binaries of all kernels in use, which later processes load in half the time. With PoCL it takes
// about half as long as compiling.
void store_binaries(Session& session);

}  // namespace morphcl
