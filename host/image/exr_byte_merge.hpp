// The way back from what ExrByteSplit makes: each byte but the first the sum of the differences up to it, and then the
// bytes at even and odd positions side by side again.
#pragma once

#include <cstddef>
#include <cstdint>

namespace morphcl {

// Replaces the differences by the bytes: all at even positions, then all at odd ones.
void add_up_differences(std::uint8_t* bytes, std::size_t count);

// out[2 i] = even[i], out[2 i + 1] = odd[i].
void merge_bytes(void* out, const std::uint8_t* even, const std::uint8_t* odd, std::size_t pairs);

}  // namespace morphcl
