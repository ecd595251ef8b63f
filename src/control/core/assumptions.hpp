#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace kerf::control {

/// Something that the control accepted without acting on it, or read in a way that may surprise.
struct Assumption {
  std::uint32_t line = 0;  ///< where it occurred first; 0: concerns the whole run
  std::string what;
};

/// Collects assumptions, each kind once with its first place.
class Assumptions {
 public:
  /// Cheap when this kind has been seen: `key` is compared before anything is built.
  [[nodiscard]] bool is_new(std::uint32_t key) { return seen_.insert(key).second; }
  void add(std::uint32_t line, std::string what) { list_.push_back({line, std::move(what)}); }

  [[nodiscard]] const std::vector<Assumption>& list() const { return list_; }

 private:
  std::set<std::uint32_t> seen_;
  std::vector<Assumption> list_;
};

}  // namespace kerf::control
