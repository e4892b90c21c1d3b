// OpenEXR streams over memory and over an open file.
#pragma once

#include <ImfIO.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace morphcl {

// Grows `bytes`, which it empties first; its capacity is kept, so a buffer used again costs no new memory.
class MemoryOutput : public Imf::OStream {
 public:
  explicit MemoryOutput(std::vector<char>& bytes) : OStream("memory"), bytes_(bytes) { bytes_.clear(); }
  void write(const char values[], int count) override;
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  std::vector<char>& bytes_;
  std::uint64_t position_ = 0;
};

// What can be read again from any position and knows its length.
class SizedInput : public Imf::IStream {
 public:
  std::uint64_t size() const { return size_; }
  bool read(char values[], int count) override;  // throws Iex::InputExc at the end
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 protected:
  SizedInput(const std::string& name, std::uint64_t size) : IStream(name.c_str()), size_(size) {}
  // Copies size bytes from `position`, all of which lie within the stream.
  virtual void fetch(std::uint64_t position, char* values, std::size_t count) = 0;
  void set_size(std::uint64_t size) { size_ = size; }

 private:
  std::uint64_t size_, position_ = 0;
};

class MemoryInput : public SizedInput {
 public:
  explicit MemoryInput(std::span<const char> bytes) : SizedInput("memory", bytes.size()), bytes_(bytes) {}

 private:
  void fetch(std::uint64_t position, char* values, std::size_t count) override;
  std::span<const char> bytes_;
};

// A regular file, through a buffer. Error(cannot_read) when it is missing, unreadable or no regular file (a pipe would
// wait for ever).
class FileInput : public SizedInput {
 public:
  explicit FileInput(const std::string& path);
  ~FileInput() override;

 private:
  void fetch(std::uint64_t position, char* values, std::size_t count) override;
  std::size_t read_at(std::uint64_t position, char* values, std::size_t count);

  int file_ = -1;
  std::vector<char> buffer_;
  std::size_t buffered_ = 0;  // bytes of buffer_ that are valid
  std::uint64_t buffer_position_ = 0;
};

}  // namespace morphcl
