#include "control/core/parameters.hpp"

#include <cmath>
#include <span>
#include <variant>

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using Member = std::variant<bool Parameters::*, int Parameters::*, double Parameters::*,
                            char Parameters::*, OfEachAxis Parameters::*>;

struct Row {
  std::string_view key;
  std::string_view number;
  Member member;
  double low;
  double high;
  std::string_view choices;  // of a letter
  std::string_view meaning;
};

constexpr Row kRows[] = {
    {"DPI", "3401#0", &Parameters::calculator_point, 0, 1, "",
     "numbers without a point count whole units"},
    {"unit", "0000#2", &Parameters::power_on_inch, 0, 1, "",
     "power-on unit: 0 mm (G21), 1 inch (G20)"},
    {"G01_default", "3402#0", &Parameters::power_on_line, 0, 1, "",
     "power-on motion: 0 G00, 1 G01"},
    {"LRP", "1401#1", &Parameters::linear_rapid, 0, 1, "",
     "rapid: 0 each axis at its own rate, 1 linear"},
    {"offset_memory", "", &Parameters::offset_memory, 0, 0, "ABC", "tool offset memory"},
    {"n_offsets", "", &Parameters::n_offsets, 1, 999, "", "number of tool offsets"},
    {"V15", "6000#3", &Parameters::offset_numbering_15, 0, 1, "",
     "numbering of the tool offset variables"},
    {"macro_levels", "", &Parameters::macro_levels, 0, 99, "", "macro calls inside each other"},
    {"sub_levels", "", &Parameters::sub_levels, 0, 99, "", "subprograms inside each other"},
    {"total_levels", "", &Parameters::total_levels, 0, 199, "", "macros and subprograms together"},
    {"CLV", "6001#7", &Parameters::keep_locals, 0, 1, "", "1: local variables survive the reset"},
    {"CCV", "6001#6", &Parameters::keep_commons, 0, 1, "", "1: #100 to #199 survive the reset"},
    {"PRT", "6001#1", &Parameters::print_without_blanks, 0, 1, "",
     "DPRNT: 1 without leading blanks"},
    {"print_cr", "", &Parameters::print_cr, 0, 1, "", "DPRNT: 1 ends its lines with CR LF"},
    {"NAT", "6004#0", &Parameters::signed_angles, 0, 1, "",
     "1: ATAN gives -180 to 180, ASIN -90 to 90"},
    {"MFZ", "6004#1", &Parameters::small_is_zero, 0, 1, "", "1: SIN, COS, TAN below 1e-8 are 0"},
    {"MCA", "6008#1", &Parameters::alarm_number_itself, 0, 1, "",
     "1: #3000=n shows n instead of 3000+n"},
    {"IJK", "6008#7", &Parameters::single_ijk, 0, 1, "", "1: I, J, K are always #4, #5, #6"},
    {"G67", "6000#0", &Parameters::ignore_lone_g67, 0, 1, "",
     "1: G67 without a modal call is ignored"},
    {"SBM", "6000#5", &Parameters::stop_at_macro, 0, 1, "",
     "1: single block stops at macro statements"},
    {"TCS", "6001#5", &Parameters::t_calls_program, 0, 1, "", "1: T calls O9000"},
    {"SCS", "", &Parameters::s_calls_program, 0, 1, "", "1: S calls O9029"},
    {"BCS", "", &Parameters::b_calls_program, 0, 1, "", "1: B calls O9028"},
    {"long_program_numbers", "", &Parameters::long_program_numbers, 0, 1, "",
     "1: P of M98 is a program number of up to 8 digits"},
    {"SUP/SUV", "5003#0", &Parameters::start_up, 0, 0, "ABC", "cutter compensation start-up"},
    {"CCC", "19607#2", &Parameters::corner_arc, 0, 1, "", "outer corners: 0 straight, 1 arc"},
    {"CRE", "3410", &Parameters::arc_tolerance, 0, 100, "", "arc radius tolerance, mm"},
    {"d_G73", "5114", &Parameters::d_g73, 0, 1000, "", "retract of G73, mm"},
    {"d_G83", "5115", &Parameters::d_g83, 0, 1000, "", "clearance of G83, mm"},
    {"SCR", "5400#7", &Parameters::scale_thousandth, 0, 1, "", "G51 P counts 0.001 (0: 0.00001)"},
    {"rotation_angle", "5410", &Parameters::rotation_default, -360, 360, "",
     "G68 without R, degrees"},
    {"shift_direction", "5148", &Parameters::shift_direction, -2, 2, "",
     "G76, G87 shift: 1 +X, -1 -X, 2 +Y, -2 -Y"},
    {"drilling_axis", "5101#0", &Parameters::drill_along_normal, 0, 1, "",
     "cycles drill along: 0 Z, 1 the plane's normal"},
    {"simultaneous_axes", "", &Parameters::simultaneous_axes, 1, 8, "",
     "axes that one block may move"},
    {"feed_per_revolution", "", &Parameters::feed_per_revolution, 0, 1, "",
     "0: the spindle cannot be measured, G95 raises PS0014"},
    {"spindle_max_rpm", "3772", &Parameters::spindle_max_rpm, 0, 99999, "",
     "largest S; 0 no limit"},
    {"stroke_check", "", &Parameters::stroke_check, 0, 1, "",
     "1: stored stroke limits are checked"},
    {"invert_y", "", &Parameters::invert_y, 0, 1, "",
     "laser BASIC: 1 turns the picture upside down, Y of programs points down"},
    {"statement_limit", "", &Parameters::statement_limit, 0, 2e9, "",
     "laser BASIC: statements that a program may execute; 0 any number"},
    {"length_axis", "5001#0", &Parameters::length_axis_type, 0, 1, "",
     "tool length: 0 Z, 1 the axis of the block"},
    {"external_call", "6030", &Parameters::external_call_m, 0, 99999999, "",
     "M code that calls an external subprogram"},
    {"overrun", "5440", &Parameters::overrun, -1000, 1000, "",
     "of an axis: the last part of the way of G60, in the direction of its sign, mm or degrees"},
    {"gsystem", "3401#6", &Parameters::g_system, 0, 0, "ABC", "lathe: system of G codes"},
    {"T_digits", "5028", &Parameters::tool_offset_digits, 1, 4, "",
     "lathe: last digits of T that are the offset's number"},
    {"LGN", "5002#1", &Parameters::geometry_by_tool, 0, 1, "",
     "lathe: 1: the geometry offset has the tool's number"},
    {"MRC", "5102#1", &Parameters::check_shapes, 0, 1, "",
     "lathe: 1: G71 to G73 check their shapes"},
    {"monotone_z", "5145", &Parameters::monotone_z, 0, 1000, "",
     "lathe: so far a checked shape may go back along Z, mm"},
    {"monotone_x", "5146", &Parameters::monotone_x, 0, 1000, "",
     "lathe: so far a checked shape may go back along X, mm of radius"},
    {"cycle_nose", "", &Parameters::compensated_cycles, 0, 1, "",
     "lathe: 1: G71 to G73 compensate the nose radius"},
    {"CCR", "3405#4", &Parameters::bare_corners, 0, 1, "",
     "lathe: 1: A, C and R need no comma for angles and corners"},
    {"chamfer_thread", "5130", &Parameters::chamfer_thread, 0, 127, "",
     "lathe: run-out of threads, tenths of the lead"},
    {"chamfer_angle", "5131", &Parameters::chamfer_angle, 1, 89, "",
     "lathe: angle of that run-out, degrees"},
    {"rough_depth", "5132", &Parameters::rough_depth, 0, 99999, "",
     "lathe: depth of cut of G71 and G72, mm of radius"},
    {"rough_retreat", "5133", &Parameters::rough_retreat, 0, 99999, "",
     "lathe: retreat of G71 and G72, mm"},
    {"pattern_x", "5135", &Parameters::pattern_x, -99999, 99999, "",
     "lathe: first shift of G73 along X, mm of radius"},
    {"pattern_z", "5136", &Parameters::pattern_z, -99999, 99999, "",
     "lathe: first shift of G73 along Z, mm"},
    {"pattern_count", "5137", &Parameters::pattern_count, 1, 9999, "", "lathe: passes of G73"},
    {"peck_retreat", "5139", &Parameters::peck_retreat, 0, 99999, "",
     "lathe: retreat of the pecks of G74 and G75, mm"},
    {"thread_least_cut", "5140", &Parameters::thread_least_cut, 0, 99999, "",
     "lathe: least depth of a pass of G76, mm of radius"},
    {"thread_finish", "5141", &Parameters::thread_finish, 0, 99999, "",
     "lathe: what the last passes of G76 take, mm of radius"},
    {"thread_finish_passes", "5142", &Parameters::thread_finish_passes, 1, 99, "",
     "lathe: last passes of G76"},
    {"thread_angle", "5143", &Parameters::thread_angle, 0, 80, "",
     "lathe: angle of the tool's tip in G76: 0, 29, 30, 55, 60, 80"},
    {"G96_axis", "3770", &Parameters::css_axis, 1, 8, "",
     "lathe: number of the axis whose place is the diameter of G96"},
    {"measure_feed", "6241", &Parameters::measure_feed, 1, 15000, "",
     "lathe: feed of G36 and G37 to the signal, mm/min"},
    {"measure_begin_x", "6251", &Parameters::measure_begin_x, 0, 1000, "",
     "lathe: G36 begins to measure so far before the place, mm of radius"},
    {"measure_begin_z", "6252", &Parameters::measure_begin_z, 0, 1000, "",
     "lathe: likewise G37, mm"},
    {"measure_window_x", "6254", &Parameters::measure_window_x, 0, 1000, "",
     "lathe: the signal of G36 may come so far from the place, mm of radius"},
    {"measure_window_z", "6255", &Parameters::measure_window_z, 0, 1000, "",
     "lathe: likewise of G37, mm"},
    {"RTR", "5101#2", &Parameters::peck_to_r, 0, 1, "",
     "lathe: G83 and G87 clear each peck: 1 to level R, 0 by d_peck"},
    {"d_peck", "", &Parameters::d_g73, 0, 1000, "",
     "lathe: retreat of G83 and G87 and their clearance, mm (5114)"}};

const Row* find(std::string_view key) {
  for (const Row& row : kRows) {
    if (row.key == key || (!row.number.empty() && row.number == key)) return &row;
  }
  return nullptr;
}

tl::unexpected<base::Failure> usage(std::string_view key, std::string_view value,
                                    const std::string& what) {
  return tl::unexpected(
      base::Failure{base::Failure::Kind::usage,
                    "parameter " + std::string(key) + "=" + std::string(value) + ": " + what});
}

struct Assign {
  Parameters& parameters;
  double number;
  char axis;
  void operator()(bool Parameters::*member) const { parameters.*member = number != 0; }
  void operator()(int Parameters::*member) const { parameters.*member = static_cast<int>(number); }
  void operator()(double Parameters::*member) const { parameters.*member = number; }
  void operator()(char Parameters::*) const {}
  void operator()(OfEachAxis Parameters::*member) const { (parameters.*member).set(axis, number); }
};

struct KeyOfAxis {
  std::string_view key;
  char axis;
};

// "overrun.X"; without a point there is no axis, '\0'.
KeyOfAxis split(std::string_view key) {
  const bool of_axis = key.size() > 2 && key[key.size() - 2] == '.' &&
                       OfEachAxis::kLetters.find(key.back()) != std::string_view::npos;
  return of_axis ? KeyOfAxis{key.substr(0, key.size() - 2), key.back()} : KeyOfAxis{key, '\0'};
}

// 6050 and the like: codes that call programs.
int* code_slot(Parameters& parameters, std::string_view key, double& scale) {
  const auto number = base::read_whole_number(key);
  if (key.size() != 4 || !number) return nullptr;
  const auto code = static_cast<int>(*number);
  scale = 1;
  if (code >= 6050 && code <= 6059) {
    scale = 10;
    return &parameters.g_macro[static_cast<std::size_t>(code - 6050)];
  }
  if (code >= 6080 && code <= 6089)
    return &parameters.m_macro[static_cast<std::size_t>(code - 6080)];
  if (code >= 6071 && code <= 6079) return &parameters.m_sub[static_cast<std::size_t>(code - 6071)];
  return nullptr;
}

std::string_view unit_value(std::string_view value) {
  if (value == "mm" || value == "G21") return "0";
  if (value == "inch" || value == "G20") return "1";
  return value;
}

// 5003#0 and 5003#1 (SUP, SUV) together are the letter of the start-up: A, B, or C with SUV.
bool set_start_up_bit(Parameters& parameters, std::string_view key, std::string_view value) {
  if ((key != "5003#0" && key != "5003#1") || (value != "0" && value != "1")) return false;
  if (key == "5003#0") {
    parameters.start_up = value == "1" ? 'B' : 'A';
  } else if (value == "1") {
    parameters.start_up = 'C';
  } else if (parameters.start_up == 'C') {
    parameters.start_up = 'A';
  }
  return true;
}

// 3401#6 and 3401#7 (GSB, GSC) together are the letter of the system of G codes: A, or B, or C.
bool set_system_bit(Parameters& parameters, std::string_view key, std::string_view value) {
  if ((key != "3401#6" && key != "3401#7") || (value != "0" && value != "1")) return false;
  const char letter = key == "3401#6" ? 'B' : 'C';
  if (value == "1") {
    parameters.g_system = letter;
  } else if (parameters.g_system == letter) {
    parameters.g_system = 'A';
  }
  return true;
}

// Why a parameter cannot take a number; empty: it can.
std::string objection_to(const Row& row, const tl::expected<double, base::NumberFault>& number) {
  if (!number || *number < row.low || *number > row.high) {
    return "a number from " + std::to_string(static_cast<int>(row.low)) + " to " +
           std::to_string(static_cast<int>(row.high)) + " is expected";
  }
  if (row.key == "shift_direction" && *number == 0) return "it is never 0";
  const bool whole = std::holds_alternative<bool Parameters::*>(row.member) ||
                     std::holds_alternative<int Parameters::*>(row.member);
  if (whole && *number != std::floor(*number)) return "a whole number is expected";
  return {};
}

// Why a parameter is not one of this axis ('\0': of none); empty: it is.
std::string objection_to_axis(const Row& row, char axis) {
  const bool of_axis = std::holds_alternative<OfEachAxis Parameters::*>(row.member);
  if (of_axis == (axis != '\0')) return {};
  return of_axis ? "it belongs to an axis: " + std::string(row.key) + ".X is that of X"
                 : "it does not belong to an axis";
}

std::string set_row(Parameters& parameters, const Row& row, char axis, std::string_view value) {
  if (auto objection = objection_to_axis(row, axis); !objection.empty()) return objection;
  if (const auto* const letter = std::get_if<char Parameters::*>(&row.member)) {
    if (value.size() != 1 || row.choices.find(value[0]) == std::string_view::npos)
      return "one of the letters " + std::string(row.choices) + " is expected";
    parameters.*(*letter) = value[0];
    return {};
  }
  const auto number = base::read_number(row.key == "unit" ? unit_value(value) : value);
  if (auto objection = objection_to(row, number); !objection.empty()) return objection;
  std::visit(Assign{parameters, *number, axis}, row.member);
  return {};
}

}  // namespace

base::Outcome<void> Parameters::set(std::string_view key, std::string_view value) {
  if (set_start_up_bit(*this, key, value) || set_system_bit(*this, key, value)) return {};
  double scale = 1;
  if (int* const slot = code_slot(*this, key, scale)) {
    const auto number = base::read_number(value);
    if (!number || *number < 0 || *number > 99999999)
      return usage(key, value, "a code is expected");
    *slot = static_cast<int>(base::round_away(*number * scale));
    return {};
  }
  const auto [name, axis] = split(key);
  const Row* const row = find(name);
  if (row == nullptr) return usage(key, value, "there is no such parameter");
  if (const auto objection = set_row(*this, *row, axis, value); !objection.empty())
    return usage(key, value, objection);
  return {};
}

bool Parameters::is_key(std::string_view key) {
  Parameters scratch;
  double scale = 1;
  const bool is_bit = key == "5003#1" || key == "3401#7";
  return find(key) != nullptr || is_bit || code_slot(scratch, key, scale) != nullptr;
}

bool Parameters::belongs_to_axis(std::string_view key) {
  const Row* const row = find(key);
  return row != nullptr && std::holds_alternative<OfEachAxis Parameters::*>(row->member);
}

}  // namespace kerf::control
