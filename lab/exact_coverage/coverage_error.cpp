#include "lab/exact_coverage/coverage_error.hpp"

#include <fmt/format.h>

#include <exception>
#include <mutex>
#include <thread>

#include "host/render/reference/visibility.hpp"
#include "host/threads.hpp"
#include "morphcl/error.hpp"

namespace morphcl::accuracy {

namespace {

using reference::Sample;
using reference::Visibility;

constexpr std::size_t counts = sample_counts.size();

// A surface of a pixel as it truly is and as samples see it. `key` says which one.
struct SeenSurface {
  std::uint64_t key;
  double area, with_x, with_y;  // pixels
  std::array<int, counts> samples;
};
constexpr std::uint64_t nothing_key = ~std::uint64_t{0};

void add_surface(std::vector<SeenSurface>& surfaces, const SeenSurface& added) {
  for (SeenSurface& s : surfaces) {
    if (s.key != added.key) continue;
    s.area += added.area;
    s.with_x += added.with_x;
    s.with_y += added.with_y;
    for (std::size_t i = 0; i < counts; ++i) s.samples[i] += added.samples[i];
    return;
  }
  surfaces.push_back(added);
}

// Some of a picture's rows.
class PartOfPicture {
 public:
  PartOfPicture(const FramePlan& plan, const ExactCoverage& exact, const RasterGrid& grid,
                const std::vector<std::vector<reference::Vertex>>& vertices, const reference::Rows& rows)
      : plan_(plan) {
    result_.frame = plan.frame;
    result_.width = plan.width;
    result_.height = plan.height;
    for (std::size_t i = 0; i < counts; ++i)
      reference::find_visible(plan, grid, vertices, rows, sample_counts[i], visible_[i]);
    for (int y = rows.first; y < plan.height; y += rows.step)
      exact.for_each_in_row(y, [&](int x, const PixelCoverage<double>& coverage) { compare(x, y, coverage); });
  }

  const CoverageError& result() const { return result_; }

 private:
  static std::uint64_t key_of(std::uint32_t draw, std::uint32_t primitive) {
    return draw == nothing_drawn ? nothing_key : std::uint64_t{draw} << 32 | primitive;
  }
  static std::uint64_t key_of(const Sample& sample) {
    return sample.order == reference::no_order ? nothing_key : key_of(sample.draw, sample.primitive);
  }

  std::uint64_t key_among(Surfaces surfaces, std::uint64_t triangle) const {
    if (surfaces == Surfaces::triangles || triangle == nothing_key) return triangle;
    return surfaces == Surfaces::all ? 0 : plan_.draws[triangle >> 32].object;
  }

  void compare(int x, int y, const PixelCoverage<double>& coverage) {
    result_.error_bound = std::max(result_.error_bound, coverage.error_bound());
    triangles_.clear();
    double shown = 0;
    for (const SurfacePart& part : coverage.parts()) {
      triangles_.push_back({key_of(part.draw, part.primitive), pixels_of(part.area), part.with_x, part.with_y, {}});
      if (part.draw != nothing_drawn) shown += triangles_.back().area;
    }
    result_.pixels += shown > coverage.error_bound();
    const bool agree = add_samples(x, y, coverage.error_bound());
    if (triangles_.size() == 1 && agree) return;
    for (const Surfaces surfaces : {Surfaces::all, Surfaces::objects, Surfaces::triangles})
      compare(surfaces, coverage.error_bound());
  }

  // Whether all samples show the first surface.
  bool add_samples(int x, int y, double error_bound) {
    bool agree = true;
    for (std::size_t i = 0; i < counts; ++i)
      for (const Sample& sample : visible_[i].samples_of(x, y)) {
        const std::uint64_t key = key_of(sample);
        if (key == triangles_.front().key) {
          ++triangles_.front().samples[i];
          continue;
        }
        agree = false;
        SeenSurface seen{key, 0, 0, 0, {}};
        seen.samples[i] = 1;
        add_surface(triangles_, seen);
        const auto found =
            std::find_if(triangles_.begin(), triangles_.end(), [&](const auto& s) { return s.key == key; });
        result_.strays[i] += found->area <= error_bound;
      }
    return agree;
  }

  void compare(Surfaces kind, double error_bound) {
    surfaces_.clear();
    for (SeenSurface surface : triangles_) {
      surface.key = key_among(kind, surface.key);
      add_surface(surfaces_, surface);
    }
    const auto is_there = [&](const SeenSurface& s) {
      return s.area > error_bound || s.samples != std::array<int, counts>{};
    };
    if (std::count_if(surfaces_.begin(), surfaces_.end(), is_there) < 2) return;
    for (std::size_t i = 0; i < counts; ++i) {
      CoverageTally& tally = result_.of[static_cast<std::size_t>(kind)][i];
      for (const SeenSurface& s : surfaces_) {
        const double error = static_cast<double>(s.samples[i]) / sample_counts[i] - s.area;
        tally.add(error, s.with_x, s.with_y);
        if (kind == Surfaces::all && s.key != nothing_key) tally.add_bias(error);
      }
      tally.end_pixel();
    }
  }

  const FramePlan& plan_;
  std::array<Visibility, counts> visible_;
  std::vector<SeenSurface> triangles_, surfaces_;
  CoverageError result_;
};

// So many rows at once that their samples take some 64 MB; what is found does not depend on it.
int parts_of(const FramePlan& plan) {
  constexpr std::size_t max_bytes = std::size_t{64} << 20;
  std::size_t a_pixel = 0;
  for (const int samples : sample_counts) a_pixel += static_cast<std::size_t>(samples) * sizeof(Sample);
  const std::size_t rows = std::max<std::size_t>(max_bytes / (a_pixel * static_cast<std::size_t>(plan.width)), 1);
  return static_cast<int>((static_cast<std::size_t>(plan.height) + rows - 1) / rows);
}

}  // namespace

const char* name_of(Surfaces surfaces) {
  return surfaces == Surfaces::all ? "all" : surfaces == Surfaces::objects ? "objects" : "triangles";
}

void CoverageTally::add(double error, double with_x, double with_y) {
  largest_of_pixel_ = std::max(largest_of_pixel_, std::abs(error));
  squares_ += 0.5 * error * error;
  xx_ += 0.5 * with_x * with_x;
  xy_ += 0.5 * with_x * with_y;
  yy_ += 0.5 * with_y * with_y;
  error_x_ += 0.5 * error * with_x;
  error_y_ += 0.5 * error * with_y;
}

void CoverageTally::end_pixel() {
  ++pixels_;
  beyond_ += largest_of_pixel_ > limit;
  largest_ = std::max(largest_, largest_of_pixel_);
  largest_of_pixel_ = 0;
}

CoverageTally& CoverageTally::operator+=(const CoverageTally& other) {
  pixels_ += other.pixels_;
  beyond_ += other.beyond_;
  largest_ = std::max(largest_, other.largest_);
  squares_ += other.squares_;
  bias_ += other.bias_;
  xx_ += other.xx_;
  xy_ += other.xy_;
  yy_ += other.yy_;
  error_x_ += other.error_x_;
  error_y_ += other.error_y_;
  return *this;
}

double CoverageTally::rms() const { return pixels_ == 0 ? 0 : std::sqrt(squares_ / static_cast<double>(pixels_)); }

// Where all edges run in one direction, the movement across it.
std::array<double, 2> CoverageTally::shift() const {
  const double trace = xx_ + yy_, determinant = xx_ * yy_ - xy_ * xy_;
  if (!(trace > 0)) return {0, 0};
  if (determinant <= 1e-9 * trace * trace) return {error_x_ / trace, error_y_ / trace};
  return {(yy_ * error_x_ - xy_ * error_y_) / determinant, (xx_ * error_y_ - xy_ * error_x_) / determinant};
}

double CoverageTally::spread() const {
  if (pixels_ == 0) return 0;
  const auto [x, y] = shift();
  return std::sqrt(std::max(squares_ - x * error_x_ - y * error_y_, 0.0) / static_cast<double>(pixels_));
}

CoverageError& CoverageError::operator+=(const CoverageError& other) {
  pixels += other.pixels;
  error_bound = std::max(error_bound, other.error_bound);
  for (std::size_t i = 0; i < counts; ++i) {
    strays[i] += other.strays[i];
    for (std::size_t s = 0; s < surfaces_count; ++s) of[s][i] += other.of[s][i];
  }
  return *this;
}

Scene scene_for_coverage(Scene scene) {
  scene.image.channels = (scene.image.channels & default_channels) | ChannelSet{Channel::color};
  scene.image.p_error = scene.image.n_error = 0;
  scene.image.samples = sample_counts.back();
  for (Object& object : scene.objects) object.material.alpha_mode = AlphaMode::opaque;
  return scene;
}

CoverageError coverage_error(const FramePlan& plan, const CoverageWork& work) {
  const ExactCoverage exact(plan);
  const RasterGrid grid(plan.width, plan.height);
  std::vector<std::vector<reference::Vertex>> vertices;
  for (const Draw& draw : plan.draws) vertices.push_back(reference::project_vertices(draw, plan, grid));
  const int parts = parts_of(plan);
  std::vector<CoverageError> results(static_cast<std::size_t>(parts));
  std::mutex mutex;
  int next = 0, done = 0;
  std::exception_ptr failure;
  const auto run = [&](int) {
    for (;;) {
      int part = 0;
      {
        const std::lock_guard lock(mutex);
        if (failure || next == parts) return;
        part = next++;
      }
      try {
        if (work.stop && *work.stop) throw Error(ErrorKind::interrupted, "", "interrupted");
        results[static_cast<std::size_t>(part)] = PartOfPicture(plan, exact, grid, vertices, {part, parts}).result();
        const std::lock_guard lock(mutex);
        ++done;
        if (work.progress) work.progress(done, parts);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    start_threads(others, std::min(work.threads, parts) - 1, run);
    run(0);
  }
  if (failure) std::rethrow_exception(failure);
  CoverageError sum = results.front();
  for (std::size_t part = 1; part < results.size(); ++part) sum += results[part];
  return sum;
}

std::string coverage_csv_header() {
  return "frame,surfaces,samples,edge_pixels,bias,max,rms,beyond,shift_x,shift_y,spread,strays\n";
}

std::string coverage_csv_lines(const CoverageError& error) {
  std::string lines;
  for (const Surfaces surfaces : {Surfaces::all, Surfaces::objects, Surfaces::triangles})
    for (std::size_t i = 0; i < counts; ++i) {
      const CoverageTally& t = error.tally(surfaces, i);
      const auto [x, y] = t.shift();
      lines += fmt::format("{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}\n", error.frame,
                           name_of(surfaces), sample_counts[i], t.edge_pixels(),
                           surfaces == Surfaces::all ? fmt::format("{:.9g}", t.bias()) : std::string(), t.largest(),
                           t.rms(), t.beyond(), x, y, t.spread(), error.strays[i]);
    }
  return lines;
}

}  // namespace morphcl::accuracy
