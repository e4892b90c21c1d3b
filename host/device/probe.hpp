// Finds out whether asking for OpenCL devices would kill this process.
#pragma once

namespace morphcl {

// Error(no_device) if the OpenCL installation crashes or hangs when it is asked for its devices.
//
// hwloc, which PoCL relies on, aborts the process where /sys is not mounted, as in some containers. Where the folders
// of /sys that it reads are in place this returns at once (the query in a child costs 18 ms, a fifth of a warm start);
// elsewhere a forked child asks first. Must run before the process's first OpenCL call.
void probe_installation();

}  // namespace morphcl
