// The way of a frame from pixels to the bytes of its file, step by step, beside OpenEXR's own writer.
//
//   morphcl_bench_encode [--size=WxH] [--benchmark_...]     size: of the pictures; 1920x1080 unless given
//
// Names: SCENE/CHANNELS/STEP. One thread. Bytes are those of the pixels; the label is the size of what comes out. The
// pictures are the middle frames of the scenes that bench/run draws, with noise for the worst case.

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/morphcl_scene.hpp"
#include "host/device/prepare_process.hpp"
#include "host/image/exr_byte_split.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_stream.hpp"
#include "host/image/exr_zip_chunk.hpp"
#include "host/image/pixel_hash.hpp"
#include "host/image/png_encode.hpp"
#include "host/image/running_adler32.hpp"
#include "host/image/zlib_encoder.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace {

using namespace morphcl;

using Bytes = std::vector<std::uint8_t>;

struct Picture {
  std::string name;
  std::unique_ptr<FrameBuffer> frame;
  std::vector<Bytes> prepared;  // chunks, split and differenced
};

int width = 1920, height = 1080;

std::size_t pixel_bytes(const FrameBuffer& frame) {
  return line_bytes(frame) * static_cast<std::size_t>(frame.height());
}

// The bytes of a chunk in the file's order, one after the other.
Bytes plain_chunk(const FrameBuffer& frame, int first_line) {
  Bytes bytes;
  const auto append = [&](const auto& row) {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(row.data());
    bytes.insert(bytes.end(), first, first + row.size_bytes());
  };
  for (int y = first_line; y < std::min(first_line + zip_chunk_lines, frame.height()); ++y) {
    for (const int channel : {3, 2, 1, 0}) append(frame.color_row(channel, y));
    if (frame.has_depth()) append(frame.depth_row(y));
  }
  return bytes;
}

Bytes prepare(const Bytes& plain) {
  Bytes out(plain.size());
  ExrByteSplit split(out.data(), out.size());
  split.add(plain.data(), plain.size() / 2);
  split.finish();
  return out;
}

Picture make_picture(std::string name, std::unique_ptr<FrameBuffer> frame) {
  Picture picture{std::move(name), std::move(frame), {}};
  for (int y = 0; y < picture.frame->height(); y += zip_chunk_lines)
    picture.prepared.push_back(prepare(plain_chunk(std::as_const(*picture.frame), y)));
  return picture;
}

std::unique_ptr<FrameBuffer> draw(Renderer& renderer, const std::string& scene_name, ChannelSet channels) {
  bench::BenchScene plain = bench::make_bench_scene(scene_name, width, height, 0);
  constexpr int frames = 25;
  Scene scene = bench::morphcl_scene(plain, frames);
  scene.image.channels = channels;
  auto frame = std::make_unique<FrameBuffer>(width, height, channels);
  renderer.render(plan_frame(scene, frames / 2), *frame);
  return frame;
}

std::unique_ptr<FrameBuffer> noise(ChannelSet channels) {
  auto frame = std::make_unique<FrameBuffer>(width, height, channels);
  std::uint64_t state = 1;
  const auto next = [&state] { return (state = state * 6364136223846793005u + 1442695040888963407u) >> 33; };
  for (int y = 0; y < height; ++y) {
    for (int channel = 0; channel < 4; ++channel)
      for (std::uint16_t& value : frame->color_row(channel, y)) value = static_cast<std::uint16_t>(next() & 0x3fff);
    for (float& value : frame->depth_row(y)) value = static_cast<float>(next());
  }
  return frame;
}

// `step` returns how many bytes came out.
void add(const Picture& picture, const std::string& step_name, const std::function<std::size_t()>& step) {
  const std::string name =
      fmt::format("{}/{}/{}", picture.name, picture.frame->has_depth() ? "RGBA+Z" : "RGBA", step_name);
  const std::size_t bytes = pixel_bytes(*picture.frame);
  benchmark::RegisterBenchmark(name.c_str(), [step, bytes](benchmark::State& state) {
    std::size_t out = 0;
    for (auto _ : state) out = step();
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
    state.SetLabel(out > 0 ? fmt::format("{} bytes", out) : "");
  })->Unit(benchmark::kMillisecond);
}

std::size_t stock_file(const FrameBuffer& frame, Imf::Compression compression, int zip_level) {
  static std::vector<char> bytes;
  Imf::Header header(frame.width(), frame.height());
  header.compression() = compression;
  header.zipCompressionLevel() = zip_level;
  const std::vector<NamedPlane> planes = named_planes(frame.channels(), ChannelNames::plain);
  header.channels() = channel_list(planes);
  MemoryOutput output(bytes);
  Imf::OutputFile file(output, header, 0);
  file.setFrameBuffer(slices_to_write(frame, planes));
  file.writePixels(frame.height());
  return bytes.size();
}

std::size_t deflated(const Picture& picture, ZlibEncoder& encoder) {
  static Bytes out;
  std::size_t sum = 0;
  for (const Bytes& chunk : picture.prepared) {
    out.resize(chunk.size() + chunk.size() / 8 + 1000);
    RunningAdler32 adler;
    adler.add(chunk.data(), chunk.size());
    sum += encoder.encode(chunk, adler.value(), out);
  }
  return sum;
}

void add_steps(const Picture& picture) {
  const FrameBuffer& frame = *picture.frame;
  const Picture* const p = &picture;
  static std::vector<char> bytes;
  add(picture, "pixel hash", [&frame] {
    benchmark::DoNotOptimize(pixel_hash(frame));
    return std::size_t{0};
  });
  for (const ZlibEffort effort : {ZlibEffort::fast, ZlibEffort::small}) {
    const std::string library = effort == ZlibEffort::small ? "libdeflate, small" : std::string(fast_zlib_library());
    const std::shared_ptr<ZlibEncoder> encoder = make_zlib_encoder(effort);
    add(picture, "deflate, " + library, [p, encoder] { return deflated(*p, *encoder); });
  }
  for (const char* compression : {"zip", "zip:small", "rle", "none"})
    add(picture, std::string("file, ") + compression, [&frame, compression] {
      encode_exr(bytes, frame, {}, compression, 1);
      return bytes.size();
    });
  for (const int bits : {8, 16}) {
    if (frame.has_depth()) continue;  // PNG has none
    add(picture, fmt::format("file, PNG of {} bits", bits), [&frame, bits] {
      encode_png(bytes, frame, {}, bits, 1);
      return bytes.size();
    });
  }
  for (const int level : {1, 4})
    add(picture, fmt::format("OpenEXR, zip level {}", level),
        [&frame, level] { return stock_file(frame, Imf::ZIP_COMPRESSION, level); });
}

// Takes --size=WxH out of the arguments.
void read_size(std::vector<char*>& arguments) {
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument)
    if (std::sscanf(*argument, "--size=%dx%d", &width, &height) == 2) {
      arguments.erase(argument);
      return;
    }
}

}  // namespace

int main(int count, char** values) try {
  std::vector<char*> arguments(values, values + count);
  read_size(arguments);
  prepare_process(1);
  const std::unique_ptr<Renderer> renderer = make_device_renderer(Session::open({}));
  std::vector<Picture> pictures;
  for (const ChannelSet channels : {ChannelSet{Channel::color}, default_channels}) {
    for (const char* scene : {"morph", "heavy", "many"})
      pictures.push_back(make_picture(scene, draw(*renderer, scene, channels)));
    pictures.push_back(make_picture("noise", noise(channels)));
  }
  for (const Picture& picture : pictures) add_steps(picture);
  auto left = static_cast<int>(arguments.size());
  benchmark::Initialize(&left, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(left, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "{}\n", error.what());
  return error.exit_code();
}
