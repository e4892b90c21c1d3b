// The ids that stand for names in Cryptomatte channels (Cryptomatte specification 1.2, "uint32_to_float32").
#pragma once

#include <cstdint>
#include <string_view>

namespace morphcl {

// The bits of a name's id: MurmurHash3_32 of its UTF-8 bytes, seed 0. As these are read as binary32, an exponent of 0
// becomes 1 and one of 255 becomes 254: no id is 0, denormal, infinite or NaN.
std::uint32_t cryptomatte_bits(std::string_view name);

// The id itself.
float cryptomatte_id(std::string_view name);

}  // namespace morphcl
