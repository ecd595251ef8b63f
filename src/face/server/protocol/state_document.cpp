#include "face/server/protocol/state_document.hpp"

#include <algorithm>

namespace kerf::server {

void StateDocument::update(const Json& object) {
  bool changed = false;
  const std::uint64_t revision = revision_ + 1;
  for (const auto& [key, value] : object.items()) {
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                    [&key = key](const Entry& e) { return e.key == key; });
    if (entry == entries_.end()) {
      entries_.push_back({key, std::move(text), revision});
      changed = true;
    } else if (entry->value != text) {
      entry->value = std::move(text);
      entry->revision = revision;
      changed = true;
    }
  }
  if (changed) revision_ = revision;
}

std::string StateDocument::event_since(std::uint64_t seen, const std::string& machine,
                                       const std::string& event, const Json& more) const {
  std::string text = R"({"event":)" + Json(event).dump() + R"(,"machine":)" + Json(machine).dump();
  for (const Entry& entry : entries_) {
    if (entry.revision > seen) text += ',' + Json(entry.key).dump() + ':' + entry.value;
  }
  for (const auto& [key, value] : more.items())
    text +=
        ',' + Json(key).dump() + ':' + value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text + '}';
}

}  // namespace kerf::server
