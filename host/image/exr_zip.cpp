#include "host/image/exr_zip.hpp"

#include <ImfVersion.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <thread>

#include "host/image/exr_stream.hpp"
#include "host/image/exr_zip_chunk.hpp"
#include "host/threads.hpp"

namespace morphcl {

namespace {

// What one thread makes: chunks one after the other as they stand in a file, each its first line, its length, its data.
struct ChunkRun {
  std::vector<char> bytes;
  std::vector<std::uint64_t> offsets;  // of each chunk in `bytes`
  std::exception_ptr failure;
};

void append(std::vector<char>& bytes, const void* values, std::size_t count) {
  const auto* const first = static_cast<const char*>(values);
  bytes.insert(bytes.end(), first, first + count);
}

// Appends the chunks first to last - 1 of the frame. The encoder is kept by the thread: fresh memory costs more than
// the work in it.
void encode_chunks(std::vector<char>& bytes, std::vector<std::uint64_t>& offsets, const FrameBuffer& frame,
                   std::span<const NamedPlane> planes, ZlibEffort effort, int first, int last) {
  thread_local std::array<std::unique_ptr<ExrZipChunks>, 2> encoders;
  std::unique_ptr<ExrZipChunks>& chunks = encoders[effort == ZlibEffort::small];
  if (!chunks) chunks = std::make_unique<ExrZipChunks>(effort);
  chunks->begin(frame, planes);
  for (int chunk = first; chunk < last; ++chunk) {
    const std::int32_t first_line = chunk * zip_chunk_lines;
    const std::span<const std::uint8_t> data = chunks->encode(first_line);
    const auto data_bytes = static_cast<std::int32_t>(data.size());
    offsets.push_back(bytes.size());
    append(bytes, &first_line, sizeof first_line);
    append(bytes, &data_bytes, sizeof data_bytes);
    append(bytes, data.data(), data.size());
  }
}

// Magic number, version and header. No name is longer than 31 characters, which would need a flag in the version.
void write_header(std::vector<char>& bytes, const Imf::Header& header) {
  header.sanityCheck();
  MemoryOutput output(bytes);
  const std::array<std::int32_t, 2> opening{Imf::MAGIC, Imf::EXR_VERSION};
  output.write(reinterpret_cast<const char*>(opening.data()), sizeof opening);
  header.writeTo(output);
}

// Runs of chunks by further threads, in the order of the file.
std::vector<ChunkRun> encode_with_threads(const FrameBuffer& frame, std::span<const NamedPlane> planes,
                                          ZlibEffort effort, int chunk_count, int threads) {
  std::vector<ChunkRun> runs(static_cast<std::size_t>(threads));
  const auto encode_run = [&](int i) {
    ChunkRun& run = runs[static_cast<std::size_t>(i)];
    try {
      encode_chunks(run.bytes, run.offsets, frame, planes, effort, chunk_count * i / threads,
                    chunk_count * (i + 1) / threads);
    } catch (...) {
      run.failure = std::current_exception();
    }
  };
  std::vector<std::jthread> workers;
  for (int i = start_threads(workers, threads, encode_run); i < threads; ++i) encode_run(i);
  workers.clear();  // a jthread joins when it goes
  for (const ChunkRun& run : runs)
    if (run.failure) std::rethrow_exception(run.failure);
  return runs;
}

}  // namespace

void encode_exr_zip(std::vector<char>& bytes, const Imf::Header& header, const FrameBuffer& frame, ChannelNames names,
                    ZlibEffort effort, int threads) {
  write_header(bytes, header);
  const std::size_t table = bytes.size();
  const int chunk_count = (frame.height() + zip_chunk_lines - 1) / zip_chunk_lines;
  bytes.resize(table + static_cast<std::size_t>(chunk_count) * sizeof(std::uint64_t));

  const std::vector<NamedPlane> planes = named_planes(frame.channels(), names);
  std::vector<std::uint64_t> offsets;
  if (threads > 1) {
    for (const ChunkRun& run :
         encode_with_threads(frame, planes, effort, chunk_count, std::min(threads, chunk_count))) {
      for (const std::uint64_t offset : run.offsets) offsets.push_back(bytes.size() + offset);
      append(bytes, run.bytes.data(), run.bytes.size());
    }
  } else {
    encode_chunks(bytes, offsets, frame, planes, effort, 0, chunk_count);
  }
  std::memcpy(bytes.data() + table, offsets.data(), offsets.size() * sizeof offsets[0]);
}

}  // namespace morphcl
