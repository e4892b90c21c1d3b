// Cryptomatte's manifest: which names the ids of a layer stand for.
#pragma once

#include <span>
#include <string>

namespace morphcl {

// A JSON object of each distinct name, in the order of their first use, with its id as 8 hex digits:
// {"bunny":"13851a76","default":"42c9679f"}. It is UTF-8: what is none in a name becomes U+FFFD.
std::string cryptomatte_manifest(std::span<const std::string> names);

}  // namespace morphcl
