#include "machine/dialect/motion_look.hpp"

#include <algorithm>
#include <array>

#include "base/text_window.hpp"
#include "lang/records/json_line.hpp"

namespace kerf::machine {
namespace {

using records::JsonLine;
using records::JsonValue;

// So much of a program is looked at.
constexpr std::size_t kLookAtRecords = 65'536;

struct MachineOfAxes {
  std::string_view axes;
  std::string_view machine;
  std::string_view with_beam;
};

constexpr std::array<MachineOfAxes, 6> kMachines = {{{"XYZ", "mill3", "laser3"},
                                                     {"XYZA", "mill4", "mill4"},
                                                     {"XYZAC", "mill5", "laser5"},
                                                     {"XYZC", "arm4", "arm4"},
                                                     {"XZ", "lathe2", "lathe2"},
                                                     {"XZC", "lathe3c", "lathe3c"}}};

/// What the first lines show.
struct Shown {
  std::string axes;  // of the first move
  bool beam = false;

  void see(const JsonLine& line) {
    const auto& values = line.values();
    for (std::size_t i = 1; i < values[0].end; i = values[i].end) {
      beam |= values[i].name == "kind" && values[i].text == "\"power\"";
      if (values[i].name != "to" || values[i].kind != JsonValue::Kind::object || !axes.empty())
        continue;
      for (std::size_t k = i + 1; k < values[i].end; k = values[k].end) axes += values[k].name;
    }
  }
};

Shown shown_by(const base::SourceFile& program) {
  Shown shown;
  base::TextWindow window;
  window.stand_at(program, base::FileId{0}, 0,
                  std::min<std::uint64_t>(kLookAtRecords, program.size()));
  JsonLine json;
  for (base::TextWindow::Line line; window.next(line);) {
    if (!json.read(line.offset == 0 ? base::without_byte_order_mark(line.text) : line.text))
      shown.see(json);
  }
  return shown;
}

}  // namespace

std::string_view machine_for(const DialectRow& row, const base::SourceFile& program) {
  if (row.kind != DialectRow::Kind::motion) return row.machine;
  const Shown shown = shown_by(program);
  const auto* const found =
      std::find_if(kMachines.begin(), kMachines.end(),
                   [&](const MachineOfAxes& machine) { return machine.axes == shown.axes; });
  if (found == kMachines.end()) return row.machine;
  return shown.beam ? found->with_beam : found->machine;
}

}  // namespace kerf::machine
