#include "output/part/fact_frame.hpp"

#include <algorithm>
#include <cmath>

#include "output/part/internal/frame_bytes.hpp"

namespace kerf::output {
namespace {

/// The numbers that frames have for what is told.
enum class Fact : std::uint16_t { deviation = 0, owner = 1 };

constexpr int kNotKnown = -32768;
constexpr float kMostSteps = 32767;

std::string fact_head(stock::surface::Place part, Fact fact, std::size_t count, float scale) {
  std::string out;
  for (const int place : part) put_signed(out, place);
  append_little_endian(out, static_cast<std::uint16_t>(fact));
  put_half(out, 0);
  append_little_endian(out, static_cast<std::uint32_t>(count));
  append_little_endian(out, scale);
  return out;
}

float largest(std::span<const std::optional<float>> deviations_mm) {
  float most = 0;
  for (const auto& each : deviations_mm) most = std::max(most, std::fabs(each.value_or(0)));
  return most;
}

}  // namespace

std::string deviation_part(stock::surface::Place part,
                           std::span<const std::optional<float>> deviations_mm) {
  const float step = largest(deviations_mm) / kMostSteps;
  std::string out = fact_head(part, Fact::deviation, deviations_mm.size(), step);
  for (const auto& each : deviations_mm) {
    const float steps = each && step > 0 ? std::clamp(*each / step, -kMostSteps, kMostSteps) : 0;
    put_half(out, each ? static_cast<int>(std::lround(steps)) : kNotKnown);
  }
  pad(out);
  return out;
}

std::string owner_part(stock::surface::Place part, std::span<const std::uint16_t> owners) {
  std::string out = fact_head(part, Fact::owner, owners.size(), 0);
  for (const std::uint16_t owner : owners) append_little_endian(out, owner);
  pad(out);
  return out;
}

}  // namespace kerf::output
