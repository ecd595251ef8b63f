#include "output/records/internal/tool_radii.hpp"

#include "base/decimal.hpp"

namespace kerf::output {

ToolRadii::ToolRadii(const control::Memory& memory, bool turns)
    : memory_(memory), turns_(turns), revision_(memory.revision) {
  for (std::size_t i = 0; i < count(); ++i) known_.push_back(radius(i));
}

std::size_t ToolRadii::count() const {
  return turns_ ? memory_.turning.size() : memory_.tools.size();
}

ToolRadii::Radius ToolRadii::radius(std::size_t number) const {
  if (turns_) return {memory_.turning[number].geometry.radius, memory_.turning[number].wear.radius};
  return {memory_.tools[number].radius_geometry, memory_.tools[number].radius_wear};
}

void ToolRadii::append_changes(std::string& record) {
  if (memory_.revision == revision_) return;
  revision_ = memory_.revision;
  bool first = true;
  for (std::size_t i = 0; i < known_.size() && i < count(); ++i) {
    const Radius now = radius(i);
    if (now == known_[i]) continue;
    known_[i] = now;
    record += first ? ",\"radii\":{\"" : ",\"";
    first = false;
    base::append_integer(record, static_cast<std::int64_t>(i));
    record += "\":[";
    base::append_number(record, now.geometry);
    record += ',';
    base::append_number(record, now.wear);
    record += ']';
  }
  if (!first) record += '}';
}

}  // namespace kerf::output
