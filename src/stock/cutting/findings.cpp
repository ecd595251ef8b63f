#include "stock/cutting/findings.hpp"

#include <algorithm>
#include <tuple>

namespace kerf::stock {

std::size_t Findings::Hash::operator()(const Key& key) const {
  const std::uint64_t place = static_cast<std::uint64_t>(key.file) << 48U ^ key.from << 8U;
  return std::hash<std::uint64_t>{}((place ^ static_cast<std::uint64_t>(key.code)) *
                                    0x9e3779b97f4a7c15U);
}

void Findings::add(const Finding& finding) {
  const Key key{finding.block.file, finding.block.from, finding.code};
  const auto [place, is_new] = places_.try_emplace(key, findings_.size());
  if (is_new && findings_.size() < kMost) {
    findings_.push_back(finding);
    return;
  }
  if (is_new) {
    places_.erase(place);
    ++dropped_;
    return;
  }
  Finding& known = findings_[place->second];
  known.count += finding.count;
  known.volume_mm3 += finding.volume_mm3;
  if (finding.depth_mm <= known.depth_mm) return;
  known.motion = finding.motion;
  known.depth_mm = finding.depth_mm;
  known.at = finding.at;
  known.detail = finding.detail;
}

std::vector<Finding> Findings::in_order() const {
  std::vector<Finding> sorted = findings_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Finding& a, const Finding& b) {
    return std::tie(a.motion, a.code) < std::tie(b.motion, b.code);
  });
  return sorted;
}

}  // namespace kerf::stock
