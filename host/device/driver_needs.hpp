// What PoCL, the OpenCL driver for CPUs, needs of a process. Where something is missing it ends the process by abort()
// or crashes, at times after minutes; so it is asked for before PoCL is.
#pragma once

#include <filesystem>
#include <string>

namespace morphcl {

// Room that a driver's folder must have: the files of one process take 1.3 MB with PoCL 3.1, the largest 0.23 MB.
constexpr std::size_t driver_folder_bytes = std::size_t{4} << 20, driver_file_bytes = std::size_t{256} << 10;

// Why PoCL cannot work in a folder, in the system's words: it cannot be made or written, has no room for
// driver_folder_bytes, or nothing can be executed from it. "" when it can. The folder is made.
std::string folder_trouble(const std::filesystem::path& folder);

// Error(usage) at the variable when the user has set one of PoCL's that PoCL crashes on: numbers of threads that are
// none from 1 to max_threads, work groups of less than one item. Empty ones are taken out of the environment.
void check_driver_variables();

// The number of threads, at most `wanted`, that PoCL can have where the job starts some as well. Error(no_device) when
// there is not even one: a limit of processes (ulimit -u, pids.max) or of memory (ulimit -v).
int startable_threads(int wanted);

// Error(no_device) when a limit of this process, ulimit -s or -f, is below what PoCL needs; or ulimit -s below that and
// what a kernel keeps in private arrays.
void check_driver_limits();
void check_stack_limit(std::size_t kernel_bytes);

// Error(no_device) when PoCL's compiler would find no linker.
void check_linker();

}  // namespace morphcl
