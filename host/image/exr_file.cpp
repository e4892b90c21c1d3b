#include "morphcl/exr.hpp"

#include "host/image/atomic_file.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/written_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

std::string write_exr(const std::string& path, const FrameBuffer& frame, const FrameAttributes& attributes,
                      const std::string& compression, int threads) {
  // Kept from frame to frame: the first touch of fresh memory costs more than the encoding.
  thread_local std::vector<char> bytes;
  try {
    const std::string hash = encode_exr(bytes, frame, attributes, compression, threads);
    write_file_atomically(path, bytes);
    return hash;
  } catch (const Error& error) {
    throw error.at(path);
  }
}

void verify_exr(const std::string& path, const std::string& hash) {
  std::string found;
  try {
    const ExrFrame frame = read_exr(path);
    found = frame.stored_hash == hash ? frame.hash : frame.stored_hash;
  } catch (const Error& error) {
    found = error.message();
  }
  require_read_back(path, hash, found);
}

}  // namespace morphcl
