#include "stock/cutting/findings.hpp"

#include <algorithm>
#include <tuple>

namespace kerf::stock {

std::size_t Findings::Hash::operator()(const Key& key) const {
  const std::uint64_t place = static_cast<std::uint64_t>(key.file) << 48U ^ key.from;
  return std::hash<std::uint64_t>{}(place * 0x9e3779b97f4a7c15U);
}

Finding* Findings::known(const base::BlockId& block, base::Code code) {
  const auto of_block = places_.find({block.file, block.from});
  if (of_block == places_.end()) return nullptr;
  for (const std::size_t place : of_block->second) {
    if (findings_[place].code == code) return &findings_[place];
  }
  return nullptr;
}

void Findings::add(const Finding& finding) {
  const bool is_of_block = finding.block.line > 0;
  Finding* const known = is_of_block ? this->known(finding.block, finding.code) : nullptr;
  if (known == nullptr && findings_.size() >= kMost) {
    ++dropped_;
  } else if (known == nullptr) {
    places_[{finding.block.file, finding.block.from}].push_back(findings_.size());
    findings_.push_back(finding);
  } else {
    known->count += finding.count;
    known->volume_mm3 += finding.volume_mm3;
    const bool is_worse =
        std::tie(known->depth_mm, known->excess) < std::tie(finding.depth_mm, finding.excess);
    if (is_worse) become(*known, finding);
  }
}

void Findings::become(Finding& known, const Finding& worse) {
  known.motion = worse.motion;
  known.time_s = worse.time_s;
  known.depth_mm = worse.depth_mm;
  known.excess = worse.excess;
  known.at = worse.at;
  known.detail = worse.detail;
}

void Findings::set_time(const base::BlockId& block, std::uint64_t motion, double time_s) {
  const auto of_block = places_.find({block.file, block.from});
  if (of_block == places_.end()) return;
  for (const std::size_t place : of_block->second) {
    if (findings_[place].motion == motion) findings_[place].time_s = time_s;
  }
}

std::vector<Finding> Findings::in_order() const {
  std::vector<Finding> sorted = findings_;
  put_in_order(sorted);
  return sorted;
}

void put_in_order(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return std::tuple(a.motion == 0, a.motion, a.code) <
           std::tuple(b.motion == 0, b.motion, b.code);
  });
}

}  // namespace kerf::stock
