#include "face/server/hub/speed_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace kerf::server {
namespace {

constexpr std::size_t kHeaderBytes = 32;

template <typename T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

// The arrays of a chunk that matter here: docs/panel-protocol.md.
class ChunkView {
 public:
  explicit ChunkView(const std::string& bytes)
      : bytes_(bytes),
        vertices_(value_at<std::uint32_t>(bytes, 20)),
        base_s_(value_at<double>(bytes, 24)) {}

  [[nodiscard]] std::size_t vertices() const { return vertices_; }
  [[nodiscard]] double time_s(std::size_t i) const { return base_s_ + real(3, i); }
  [[nodiscard]] double speed(std::size_t i) const { return real(5, i); }
  [[nodiscard]] std::uint32_t line(std::size_t i) const {
    return value_at<std::uint32_t>(bytes_, offset(7, i));
  }

 private:
  // All arrays before it have four bytes a vertex; xyz is three of them.
  [[nodiscard]] std::size_t offset(std::size_t arrays_before, std::size_t i) const {
    return kHeaderBytes + 4 * (arrays_before * vertices_ + i);
  }
  [[nodiscard]] double real(std::size_t arrays_before, std::size_t i) const {
    return static_cast<double>(value_at<float>(bytes_, offset(arrays_before, i)));
  }

  const std::string& bytes_;
  std::size_t vertices_;
  double base_s_;
};

struct Interval {
  double speed = 0;
  std::uint32_t line = 0;
};

class Profile {
 public:
  explicit Profile(const SpeedQuestion& question)
      : question_(question),
        width_s_((question.to_s - question.from_s) / static_cast<double>(question.points)),
        intervals_(question.points) {}

  // False: this chunk and all behind it come later.
  bool add(const ChunkView& chunk) {
    if (chunk.time_s(0) > question_.to_s) return false;
    for (std::size_t i = 1; i < chunk.vertices(); ++i)
      add(chunk.time_s(i - 1), chunk.time_s(i), {chunk.speed(i), chunk.line(i)});
    return true;
  }

  [[nodiscard]] Json json() const {
    Json times = Json::array(), speeds = Json::array(), lines = Json::array();
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
      times.push_back(question_.from_s + width_s_ * static_cast<double>(i));
      speeds.push_back(std::round(intervals_[i].speed * 1000) / 1000);
      lines.push_back(intervals_[i].line);
    }
    return {{"time_s", times}, {"speed_mm_min", speeds}, {"line", lines}};
  }

 private:
  void add(double begin_s, double end_s, const Interval& segment) {
    if (end_s < question_.from_s || begin_s > question_.to_s) return;
    const std::size_t last = index_of(end_s);
    for (std::size_t i = index_of(begin_s); i <= last; ++i) {
      if (intervals_[i].line == 0 || segment.speed > intervals_[i].speed) intervals_[i] = segment;
    }
  }

  [[nodiscard]] std::size_t index_of(double time_s) const {
    const double place = width_s_ > 0 ? (time_s - question_.from_s) / width_s_ : 0;
    return static_cast<std::size_t>(
        std::clamp(place, 0.0, static_cast<double>(intervals_.size() - 1)));
  }

  SpeedQuestion question_;
  double width_s_;
  std::vector<Interval> intervals_;
};

}  // namespace

Json speed_profile(const ChunkStore& chunks, const SpeedQuestion& question,
                   const base::WorkLimit& limit) {
  Profile profile(question);
  for (std::size_t number = 0; number < chunks.count() && !limit.reached(); ++number) {
    const auto bytes = chunks.read(number);
    if (!bytes || bytes->size() < kHeaderBytes || !profile.add(ChunkView(*bytes))) break;
  }
  return profile.json();
}

}  // namespace kerf::server
