#include "output/programs/internal/lost_things.hpp"

#include <algorithm>

#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

constexpr std::size_t kMostKinds = 100;
const std::string kOthers = "others";

}  // namespace

void LostThings::add(const std::string& what, std::uint32_t line) {
  ++count_;
  const auto of = [&](const std::string& name) {
    return std::find_if(kinds_.begin(), kinds_.end(),
                        [&](const Kind& kind) { return kind.what == name; });
  };
  const std::string& name =
      of(what) == kinds_.end() && kinds_.size() >= kMostKinds ? kOthers : what;
  if (of(name) == kinds_.end()) kinds_.push_back({name, 0, line});
  ++of(name)->count;
}

std::string LostThings::remark() const {
  if (count_ == 0) return {};
  return "  --post: what plain G-code cannot say is in " + std::to_string(count_) +
         (count_ == 1 ? " comment" : " comments") + ", the first one of line " +
         std::to_string(kinds_.front().line) + "\n";
}

std::string LostThings::json() const {
  std::string list = "[";
  for (const Kind& kind : kinds_) {
    if (list.size() > 1) list += ',';
    list += JsonObject()
                .text("what", kind.what)
                .number("count", static_cast<double>(kind.count))
                .number("line", kind.line)
                .done();
  }
  return list + "]";
}

}  // namespace kerf::output
