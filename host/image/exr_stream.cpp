#include "host/image/exr_stream.hpp"

#include <Iex.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {
constexpr std::size_t buffer_bytes = 64 << 10;
}

void MemoryOutput::write(const char values[], int count) {
  const std::uint64_t end = position_ + static_cast<std::uint64_t>(count);
  if (end > bytes_.size()) bytes_.resize(end);
  std::memcpy(bytes_.data() + position_, values, static_cast<std::size_t>(count));
  position_ = end;
}

bool SizedInput::read(char values[], int count) {
  const auto bytes = static_cast<std::uint64_t>(count);
  if (count < 0 || position_ > size_ || bytes > size_ - position_) throw Iex::InputExc("the file ends too early");
  fetch(position_, values, bytes);
  position_ += bytes;
  return position_ < size_;
}

void MemoryInput::fetch(std::uint64_t position, char* values, std::size_t count) {
  std::memcpy(values, bytes_.data() + position, count);
}

FileInput::FileInput(const std::string& path) : SizedInput(path, 0) {
  file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0) throw Error(ErrorKind::cannot_read, path, std::strerror(errno));
  struct stat status{};
  if (fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(file_);
    throw Error(ErrorKind::cannot_read, path, "is not a regular file");
  }
  set_size(static_cast<std::uint64_t>(status.st_size));
}

FileInput::~FileInput() { close(file_); }

void FileInput::fetch(std::uint64_t position, char* values, std::size_t count) {
  while (count > 0) {
    if (position < buffer_position_ || position >= buffer_position_ + buffered_) {
      if (count >= buffer_bytes) {  // large blocks need no copy through the buffer
        const std::size_t got = read_at(position, values, count);
        position += got;
        values += got;
        count -= got;
        continue;
      }
      buffer_.resize(buffer_bytes);
      buffered_ = 0;
      buffered_ = read_at(position, buffer_.data(), buffer_bytes);
      buffer_position_ = position;
    }
    const std::size_t offset = position - buffer_position_;
    const std::size_t available = std::min(count, buffered_ - offset);
    std::memcpy(values, buffer_.data() + offset, available);
    position += available;
    values += available;
    count -= available;
  }
}

std::size_t FileInput::read_at(std::uint64_t position, char* values, std::size_t count) {
  for (;;) {
    const ssize_t got = pread(file_, values, count, static_cast<off_t>(position));
    if (got > 0) return static_cast<std::size_t>(got);
    if (got == 0) throw Iex::InputExc("the file became shorter while it was read");
    if (errno != EINTR) throw Error(ErrorKind::cannot_read, fileName(), std::strerror(errno));
  }
}

}  // namespace morphcl
