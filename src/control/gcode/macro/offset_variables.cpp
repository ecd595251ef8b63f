#include "control/gcode/macro/offset_variables.hpp"

namespace kerf::control {
namespace {

using base::AxisVector;

constexpr std::uint32_t kAxesOfRow = 20;

bool lies_between(std::uint32_t number, std::uint32_t low, std::uint32_t high) {
  return number >= low && number <= high;
}

// A row of offsets and which of its axes.
struct Item {
  AxisVector* row = nullptr;
  std::uint32_t axis = 0;
};

Item in_rows(std::vector<AxisVector>& rows, std::uint32_t place) {
  return {&rows[place / kAxesOfRow], place % kAxesOfRow};
}

// EXT first, then G54 to G59.
Item of_system(Memory& memory, std::uint32_t system, std::uint32_t axis) {
  return {system == 0 ? &memory.external : &memory.work[system - 1], axis};
}

// The old numbers, a hundred for each axis.
Item by_old_number(Memory& memory, std::uint32_t number, bool turns) {
  if (turns && lies_between(number, 2550, 2856) && lies_between(number % 100, 50, 56))
    return of_system(memory, number % 100 - 50, number / 100 - 25);
  if (turns)
    return lies_between(number, 2501, 2801) && number % 100 == 1
               ? of_system(memory, 0, number / 100 - 25)
               : Item{};
  if (lies_between(number, 2500, 2906) && number % 100 <= kWorkSystems)
    return of_system(memory, number % 100, (number - 2500) / 100);
  return {};
}

Item item_of(Memory& memory, std::uint32_t number, bool turns) {
  if (lies_between(number, 5201, 5340))
    return of_system(memory, (number - 5201) / kAxesOfRow, (number - 5201) % kAxesOfRow);
  if (lies_between(number, 7001, 7960)) return in_rows(memory.extended, number - 7001);
  if (!turns && lies_between(number, 14001, 20000)) return in_rows(memory.extended, number - 14001);
  return by_old_number(memory, number, turns);
}

}  // namespace

OffsetVariables::Place OffsetVariables::work(std::uint32_t number) {
  const Item item = item_of(state_.memory, number, turns());
  const bool exists = item.row != nullptr && item.axis < state_.axes.count();
  return {exists ? &item.row->values[item.axis] : nullptr};
}

OffsetVariables::Place OffsetVariables::tool(std::uint32_t number) {
  return turns() ? turning_tool(number) : milling_tool(number);
}

// §3.5: which part of the tool offset table a variable names.
OffsetVariables::Place OffsetVariables::milling_tool(std::uint32_t number) {
  enum class Part : std::uint8_t { length_geometry, length_wear, radius_geometry, radius_wear };
  struct Range {
    std::uint32_t first;
    std::uint32_t count;
    Part part;
    Part part_15;  // with V15 = 1
  };
  static constexpr Range kMemoryA[] = {{2000, 200, Part::length_geometry, Part::length_geometry},
                                       {10000, 999, Part::length_geometry, Part::length_geometry}};
  static constexpr Range kMemoryBC[] = {{2000, 200, Part::length_wear, Part::length_geometry},
                                        {10000, 999, Part::length_wear, Part::length_geometry},
                                        {2200, 200, Part::length_geometry, Part::length_wear},
                                        {11000, 999, Part::length_geometry, Part::length_wear}};
  static constexpr Range kMemoryCRadius[] = {
      {12000, 999, Part::radius_wear, Part::radius_geometry},
      {13000, 999, Part::radius_geometry, Part::radius_wear}};
  static constexpr Range kMemoryC15[] = {{2400, 200, Part::radius_geometry, Part::radius_geometry},
                                         {2600, 200, Part::radius_wear, Part::radius_wear}};
  const bool v15 = state_.parameters.offset_numbering_15;
  const auto search = [&](const auto& ranges) -> Place {
    for (const Range& range : ranges) {
      if (number <= range.first || number > range.first + range.count) continue;
      const std::uint32_t index = number - range.first;
      if (index > static_cast<std::uint32_t>(state_.parameters.n_offsets)) return {};
      ToolOffset& tool = state_.memory.tools[index];
      switch (v15 ? range.part_15 : range.part) {
        case Part::length_geometry: return {&tool.length_geometry};
        case Part::length_wear: return {&tool.length_wear};
        case Part::radius_geometry: return {&tool.radius_geometry};
        case Part::radius_wear: return {&tool.radius_wear};
      }
    }
    return {};
  };
  if (state_.parameters.offset_memory == 'A') return search(kMemoryA);
  if (const Place length = search(kMemoryBC)) return length;
  if (state_.parameters.offset_memory == 'B') return {};
  if (const Place radius = search(kMemoryCRadius)) return radius;
  return v15 ? search(kMemoryC15) : Place{};
}

// §3.6: wear has numbers up to 64 below #2500, geometry up to 49 below #3000; all have new ones.
OffsetVariables::Place OffsetVariables::turning_tool(std::uint32_t number) {
  using Part = TurningOffset::Part;
  struct Range {
    std::uint32_t first;
    std::uint32_t count;
    Part TurningOffset::*part;  // null: the direction of the tip
    double Part::*value;
  };
  static constexpr Range kRanges[] = {{2000, 64, &TurningOffset::wear, &Part::x},
                                      {2100, 64, &TurningOffset::wear, &Part::z},
                                      {2200, 64, &TurningOffset::wear, &Part::radius},
                                      {2300, 64, nullptr, nullptr},
                                      {2400, 49, &TurningOffset::wear, &Part::y},
                                      {2450, 49, &TurningOffset::geometry, &Part::y},
                                      {2700, 49, &TurningOffset::geometry, &Part::x},
                                      {2800, 49, &TurningOffset::geometry, &Part::z},
                                      {2900, 64, &TurningOffset::geometry, &Part::radius},
                                      {10000, 999, &TurningOffset::wear, &Part::x},
                                      {11000, 999, &TurningOffset::wear, &Part::z},
                                      {12000, 999, &TurningOffset::wear, &Part::radius},
                                      {13000, 999, nullptr, nullptr},
                                      {14000, 999, &TurningOffset::wear, &Part::y},
                                      {15000, 999, &TurningOffset::geometry, &Part::x},
                                      {16000, 999, &TurningOffset::geometry, &Part::z},
                                      {17000, 999, &TurningOffset::geometry, &Part::radius},
                                      {19000, 999, &TurningOffset::geometry, &Part::y}};
  for (const Range& range : kRanges) {
    if (number <= range.first || number > range.first + range.count) continue;
    const std::uint32_t index = number - range.first;
    if (index > static_cast<std::uint32_t>(state_.parameters.n_offsets)) return {};
    TurningOffset& row = state_.memory.turning[index];
    if (range.part == nullptr) return {&row.tip, false};
    return {&(row.*range.part.*range.value)};
  }
  return {};
}

}  // namespace kerf::control
