#include "output/picture/solid/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/each_by_threads.hpp"
#include "output/picture/solid/internal/band.hpp"
#include "output/picture/solid/internal/corner_normals.hpp"
#include "output/picture/solid/internal/corner_shade.hpp"
#include "output/picture/solid/internal/lighting.hpp"

namespace kerf::output::plot {
namespace {

constexpr int kSamples = 3;       // along each side of a pixel
constexpr int kBandRows = 48;     // pixels
constexpr int kAround = 2;        // rows of samples that lines need beyond their band
constexpr float kReach = 0.045F;  // of the picture's smaller side: how far shade goes
constexpr Color kGroundHigh{232, 237, 242}, kGroundLow{252, 253, 254};
constexpr std::array<float, 4> kInk{1, 0.62F, 0.34F, 0.20F};  // by Line: what is left of the light

constexpr float kNowhere = -std::numeric_limits<float>::infinity();

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Renderer {
 public:
  Renderer(const Scene& scene, const Projector& projector, int width, int height)
      : scene_(scene),
        samples_(projector.scaled(kSamples)),
        width_(width),
        height_(height),
        mm_(static_cast<float>(1 / projector.pixels_per_mm())),
        relief_{width, height, {}, {}} {
    const std::size_t pixels = index(width) * index(height);
    lights_.resize(pixels);
    relief_.depths.assign(pixels, kNowhere);
    relief_.normals.resize(pixels);
    for (const Body& body : scene.bodies) normals_.emplace_back(*body.mesh);
    for (const Color& paint : scene.paints) paints_.push_back(tone_.light(paint));
  }

  Rendering draw(unsigned jobs) {
    const int bands = (height_ + kBandRows - 1) / kBandRows;
    project(bands);
    const unsigned threads = base::useful_threads(jobs);
    std::vector<float> open(lights_.size(), 1);
    const float reach = kReach * static_cast<float>(std::min(width_, height_));
    base::each_by_threads(index(bands), threads,
                          [&](std::size_t band) { draw_band(static_cast<int>(band)); });
    base::each_by_threads(index(height_), threads, [&](std::size_t row) {
      shade_row(relief_, static_cast<int>(row), mm_, reach, open);
    });
    return result(open);
  }

 private:
  /// Sorts the triangles into the bands that they touch.
  void project(int bands) {
    of_band_.resize(index(bands));
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      const Body& body = scene_.bodies[b];
      std::vector<Point> places;
      std::vector<float> depths;
      for (const Vec3& p : body.mesh->points) {
        places.push_back(samples_.map(p));
        depths.push_back(static_cast<float>(samples_.depth(p)));
      }
      for (std::size_t i = 0; i < body.mesh->triangles.size(); ++i) {
        const mesh::Triangle& t = body.mesh->triangles[i];
        SeenTriangle seen;
        for (std::size_t k = 0; k < 3; ++k) {
          seen.x[k] = places[t[k]].x;
          seen.y[k] = places[t[k]].y;
          seen.depth[k] = depths[t[k]];
        }
        seen.number = static_cast<std::uint32_t>(i);
        seen.paint = body.paints[i];
        seen.body = static_cast<std::uint16_t>(b);
        add(seen, bands);
      }
    }
  }

  void add(const SeenTriangle& seen, int bands) {
    const auto [low, high] = std::minmax({seen.y[0], seen.y[1], seen.y[2]});
    const int rows = kBandRows * kSamples;
    const auto band = [&](double y) {
      return std::clamp(static_cast<int>(std::floor(y / rows)), 0, bands - 1);
    };
    for (int i = band(low - kAround - 1); i <= band(high + kAround + 1); ++i)
      of_band_[index(i)].push_back(seen);
  }

  void draw_band(int number) {
    const int first = number * kBandRows;
    const int rows = std::min(kBandRows, height_ - first);
    Band band(width_ * kSamples, first * kSamples - kAround, rows * kSamples + 2 * kAround);
    for (const SeenTriangle& t : of_band_[index(number)])
      band.draw(t, seen_normals(normals_[t.body].of(t.number)));
    of_band_[index(number)] = {};
    const std::vector<Line> lines = lines_of(band);
    for (int y = first; y < first + rows; ++y) {
      for (int x = 0; x < width_; ++x) resolve(band, lines, x, y);
    }
  }

  [[nodiscard]] std::array<Vec3, 3> seen_normals(std::array<Vec3, 3> normals) const {
    const Camera& camera = samples_.camera();
    for (Vec3& n : normals) n = {dot(camera.right, n), dot(camera.up, n), dot(camera.toward, n)};
    return normals;
  }

  /// Of each sample the strongest line beside it.
  [[nodiscard]] std::vector<Line> lines_of(const Band& band) const {
    const int rows = band.end_row() - band.first_row();
    std::vector<Line> lines(index(band.width()) * index(rows), Line::none);
    const float mm = mm_ / kSamples;
    const auto mark = [&](int x, int row, Line line) {
      Line& at = lines[index(row - band.first_row()) * index(band.width()) + index(x)];
      at = std::max(at, line);
    };
    for (int row = band.first_row(); row < band.end_row(); ++row) {
      for (int x = 0; x < band.width(); ++x) {
        for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
          if (x + dx >= band.width() || row + dy >= band.end_row()) continue;
          const Line line = line_between(band.at(x, row), band.at(x + dx, row + dy), dx, dy, mm);
          if (line == Line::none) continue;
          mark(x, row, line);
          mark(x + dx, row + dy, line);
        }
      }
    }
    return lines;
  }

  /// A pixel of its samples.
  void resolve(const Band& band, const std::vector<Line>& lines, int x, int y) {
    Light sum{};
    std::array<float, 3> normal{};
    float depth = kNowhere;
    const Light ground = ground_at(y);
    const Vec3 sky{samples_.camera().right.z, samples_.camera().up.z, samples_.camera().toward.z};
    const std::array<float, 3> up{static_cast<float>(sky.x), static_cast<float>(sky.y),
                                  static_cast<float>(sky.z)};
    for (int sy = 0; sy < kSamples; ++sy) {
      for (int sx = 0; sx < kSamples; ++sx) {
        const int column = x * kSamples + sx;
        const int row = y * kSamples + sy;
        const Sample& sample = band.at(column, row);
        const Line line =
            lines[index(row - band.first_row()) * index(band.width()) + index(column)];
        Light light = ground;
        if (sample.body != Sample::kNothing) {
          const auto& n = sample.normal;
          light = lit(paints_[sample.paint], n, n[0] * up[0] + n[1] * up[1] + n[2] * up[2]);
          depth = std::max(depth, sample.depth);
          for (std::size_t i = 0; i < 3; ++i) normal[i] += n[i];
        }
        for (std::size_t i = 0; i < 3; ++i)
          sum[i] += light[i] * kInk[static_cast<std::size_t>(line)];
      }
    }
    const std::size_t at = relief_.at(x, y);
    for (float& each : sum) each /= kSamples * kSamples;
    lights_[at] = sum;
    relief_.depths[at] = depth;
    const float size =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (size > 0) relief_.normals[at] = {normal[0] / size, normal[1] / size, normal[2] / size};
  }

  [[nodiscard]] Light ground_at(int y) const {
    const float share = static_cast<float>(y) / static_cast<float>(std::max(1, height_ - 1));
    const Light high = tone_.light(kGroundHigh);
    const Light low = tone_.light(kGroundLow);
    Light out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = high[i] + share * (low[i] - high[i]);
    return out;
  }

  [[nodiscard]] Rendering result(const std::vector<float>& open) const {
    Rendering out;
    out.image.width = width_;
    out.image.height = height_;
    out.image.rgb.reserve(3 * lights_.size());
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const std::size_t at = relief_.at(x, y);
        const bool is_seen = std::isfinite(relief_.depths[at]);
        const float shade = is_seen ? smoothed(relief_, open, x, y, mm_) : 1;
        for (const float each : lights_[at])
          out.image.rgb.push_back(static_cast<char>(tone_.encoded(each * shade)));
      }
    }
    out.depths = relief_.depths;
    return out;
  }

  const Scene& scene_;
  Projector samples_;
  int width_;
  int height_;
  float mm_;  ///< of a pixel
  Tone tone_;
  std::vector<Light> paints_;
  std::vector<CornerNormals> normals_;
  std::vector<std::vector<SeenTriangle>> of_band_;
  std::vector<Light> lights_;
  Relief relief_;
};

}  // namespace

bool Rendering::hides(Point at, double depth_mm, double slack_mm) const {
  const auto x = static_cast<int>(std::floor(at.x));
  const auto y = static_cast<int>(std::floor(at.y));
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return false;
  const float seen = depths[index(y) * index(image.width) + index(x)];
  return double{seen} > depth_mm + slack_mm;
}

Rendering render(const Scene& scene, const Projector& projector, int width, int height,
                 unsigned jobs) {
  return Renderer(scene, projector, width, height).draw(jobs);
}

}  // namespace kerf::output::plot
