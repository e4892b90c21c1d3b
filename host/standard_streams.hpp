// The numbers 0, 1 and 2 of a process that was started without stdin, stdout or stderr.
#pragma once

namespace morphcl {

// Opens /dev/null for those of them that are closed, so that no file which this process opens gets their number and
// what libraries print. It is opened the wrong way round: reading from it or printing to it fails as if it were closed.
// For main(), before anything else.
void open_closed_standard_streams();

}  // namespace morphcl
