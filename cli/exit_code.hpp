// Exit codes that are no ErrorKind (morphcl/error.hpp): how a render job ended.
#pragma once

namespace morphcl::cli {

enum ExitCode : int {
  exit_done = 0,           // everything that was asked for is written
  exit_frames_failed = 1,  // some frames failed, the others stand
  exit_interrupted = 75,   // stopped by a signal; finished frames stand, --resume goes on
};

}  // namespace morphcl::cli
