// Integers of 128 bits, in which every decision about polygons fits.
#pragma once

namespace morphcl {

__extension__ using Int128 = __int128;

}  // namespace morphcl
