// How much memory this process may still take before the system ends it or refuses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace morphcl {

struct MemoryRoom {
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
  std::string whose = "the system";  // which limit it is that leaves no more
};

// The smallest of what is left of the memory limits of its control groups (a container's, or a Slurm job's; what others
// in them use is taken, caches of files are not), of ulimit -v, and of the machine's memory.
MemoryRoom memory_room();

// What the control groups leave, of version 1 or 2, with their files and those of /proc below `root`.
MemoryRoom control_group_room(const std::filesystem::path& root);

// Error(no_device) when `bytes`, which `what` takes, are more than memory_room(): with both numbers and `remedy`.
void require_memory(std::uint64_t bytes, const std::string& what, const std::string& remedy);

}  // namespace morphcl
