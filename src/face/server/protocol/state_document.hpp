#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "face/server/protocol/json.hpp"

namespace kerf::server {

/// The state of a machine, or of its part, as watchers get it: keys with values, each with the
/// revision in which it changed last. So what one of them has not seen is found without knowing
/// what he was sent.
class StateDocument {
 public:
  /// Takes over the values of an object; what is as it was keeps its revision.
  void update(const Json& object);
  /// Grows whenever a value changes; 0: there is none yet.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// An event with all that has changed since revision `seen` (0: everything), and what else there
  /// is to tell.
  [[nodiscard]] std::string event_since(std::uint64_t seen, const std::string& machine,
                                        const std::string& event = "state",
                                        const Json& more = Json::object()) const;

 private:
  struct Entry {
    std::string key;
    std::string value;  // as JSON
    std::uint64_t revision = 0;
  };

  std::vector<Entry> entries_;
  std::uint64_t revision_ = 0;
};

}  // namespace kerf::server
