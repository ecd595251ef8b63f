#pragma once

#include <cstdint>

#include "random_path.hpp"

namespace kerf::test {

/// The lines and arcs of a random program, without the code under test.
class ProgrammedPath {
 public:
  explicit ProgrammedPath(const RandomPath& path) : path_(path) {}

  /// Whether a tip is within `most_mm` of the programmed path near the motion of `line`; otherwise
  /// how far it is from there.
  [[nodiscard]] bool is_near(const base::TipPoint& tip, std::uint32_t line, double most_mm,
                             double& distance_mm) const;
  [[nodiscard]] base::TipPoint end() const { return start_of(path_.motions.size()); }

 private:
  enum class Way : std::uint8_t { quick, searched };

  [[nodiscard]] double distance(const base::TipPoint& tip, std::size_t line, Way way) const;
  [[nodiscard]] base::TipPoint start_of(std::size_t motion) const;

  const RandomPath& path_;
};

}  // namespace kerf::test
