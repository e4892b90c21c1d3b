// A file under a temporary name, beside the name that it is to get.
//
// The name is ".NAME.HOST.PID.N.morphcl-tmp", in the same folder. Who writes holds a lock on it while he lives: by
// that, and not by the process number, which comes again in a restarted container, another process tells whether he
// does.
#pragma once

#include <sys/types.h>

#include <optional>
#include <span>
#include <string>

#include "host/leftovers.hpp"

namespace morphcl {

class TemporaryFile {
 public:
  // Makes the file; takes another number where one of that name is there. error() says whether it could.
  TemporaryFile(const std::string& path, mode_t mode);
  ~TemporaryFile();  // removes it unless it was published
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  // errno of what could not be done; 0 while all went well.
  int error() const { return error_; }

  // Each returns error() == 0. What a signal interrupts is tried again.
  bool write_all(std::span<const char> bytes);
  bool flush();    // to the disk; network file systems report a full one only here
  bool publish();  // under its name, in place of what stands there

 private:
  bool take_name(const std::string& name, mode_t mode);
  bool fails() {
    error_ = last_error();
    return false;
  }
  static int last_error();

  std::string path_;
  std::optional<Leftover> temporary_;
  int file_ = -1;
  int error_ = 0;
  bool published_ = false;
};

// The name that temporary file number `number` of `process`, on this host, has beside `path`.
std::string temporary_name(const std::string& path, pid_t process, unsigned number);

// Flushes the folder of `path`, so that what was published there is there after a power cut. Some file systems cannot.
void flush_folder_of(const std::string& path);

// Removes the temporary files in the folder of `path_prefix` that are for names beginning with it, were made on this
// host and belong to nobody who lives. Returns how many there were. Never throws: what cannot be removed stays.
int remove_stale_temporaries(const std::string& path_prefix);

}  // namespace morphcl
