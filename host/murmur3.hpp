// MurmurHash3_x86_32 of Austin Appleby: what Cryptomatte makes of names.
#pragma once

#include <cstdint>
#include <string_view>

namespace morphcl {

// Of the text's bytes. The same on every machine.
std::uint32_t murmur3_32(std::string_view text, std::uint32_t seed = 0);

}  // namespace morphcl
