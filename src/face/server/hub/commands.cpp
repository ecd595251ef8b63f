#include "face/server/hub/commands.hpp"

#include <algorithm>

#include "machine/dialect/registry.hpp"
#include "machine/panel/operation_table.hpp"

namespace kerf::server {
namespace {

using namespace machine::argument;
using Who = Command::Who;

constexpr double kMostTime_s = 1e9;

// A key of the panel: the operator's.
Command key(std::string_view name, std::string_view more = {}, std::string_view answer = {}) {
  const machine::OperationRow& row = *machine::find_operation(name);
  return {row.name, Who::op, row.arguments, std::string(row.sentence).append(more), answer, &row};
}

std::vector<Command> make_table() {
  return {
#define ARGUMENTS(...) \
  { __VA_ARGS__ }
#define COMMAND(name, who, arguments, ...) {name, Who::who, arguments, __VA_ARGS__},
#define KEY(...) key(__VA_ARGS__),
#include "face/server/hub/commands.def"
#undef ARGUMENTS
#undef COMMAND
#undef KEY
  };
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> table = make_table();
  return table;
}

const Command* find_command(std::string_view name) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command& c) { return c.name == name; });
  return found == commands().end() ? nullptr : &*found;
}

}  // namespace kerf::server
