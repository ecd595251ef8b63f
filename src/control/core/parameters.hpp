#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "control/core/machine_codes.hpp"

namespace kerf::control {

/// A value for each axis, by its letter; 0 where none was set.
class OfEachAxis {
 public:
  static constexpr std::string_view kLetters = "XYZABCUVW";

  // Precondition of both: one of kLetters.
  [[nodiscard]] double operator[](char letter) const { return values_[kLetters.find(letter)]; }
  void set(char letter, double value) { values_[kLetters.find(letter)] = value; }

 private:
  std::array<double, kLetters.size()> values_{};
};

/// Settings of the control: data of the machine file, each changeable by name
/// (docs/parameters.md). Lengths in mm.
struct Parameters {
  bool calculator_point = false;  ///< DPI: a number without a point counts whole units
  bool power_on_inch = false;     ///< unit
  bool power_on_line = false;     ///< G01_default
  bool linear_rapid = true;       ///< LRP: else each axis moves at its own rapid rate
  char offset_memory = 'C';       ///< tool offset memory A, B or C
  int n_offsets = 400;
  bool offset_numbering_15 = false;  ///< V15
  int macro_levels = 4;
  int sub_levels = 10;
  int total_levels = 15;
  bool keep_locals = false;          ///< CLV
  bool keep_commons = false;         ///< CCV
  bool print_without_blanks = true;  ///< PRT
  bool print_cr = false;             ///< end lines of DPRNT with CR LF
  bool signed_angles = false;        ///< NAT
  bool small_is_zero = true;         ///< MFZ
  bool alarm_number_itself = false;  ///< MCA
  bool single_ijk = false;           ///< IJK
  bool ignore_lone_g67 = false;      ///< G67
  bool stop_at_macro = false;        ///< SBM
  bool t_calls_program = false;      ///< TCS
  bool s_calls_program = false;      ///< SCS
  bool b_calls_program = false;      ///< BCS
  bool long_program_numbers =
      false;                     ///< M98 P takes a program number of up to 8 digits, no repeats
  char start_up = 'A';           ///< SUP/SUV: cutter compensation start-up type A, B or C
  bool corner_arc = false;       ///< CCC: outer corners as arcs
  double arc_tolerance = 0.010;  ///< CRE
  double d_g73 = 1.0;
  double d_g83 = 1.0;
  bool scale_thousandth = true;  ///< SCR: G51 P counts 0.001, else 0.00001
  double rotation_default = 0;   ///< 5410: G68 without R, degrees
  int shift_direction = 1;       ///< 5148: ±1 = ±X, ±2 = ±Y: where G76 and G87 shift to
  bool drill_along_normal =
      true;                   ///< 5101#0: cycles drill along the normal of the plane, else along Z
  int simultaneous_axes = 8;  ///< axes that one block may move
  bool feed_per_revolution = true;  ///< G95 is available
  int spindle_max_rpm = 0;          ///< 3772; 0: no limit
  bool stroke_check = false;
  bool invert_y = false;             ///< laser BASIC: Y of programs points the other way
  int statement_limit = 10'000'000;  ///< laser BASIC: statements that a program may execute; 0: any
  int length_axis_type = 0;          ///< 5001#0: 0 = always Z, 1 = the axis of the block
  int external_call_m = 198;         ///< 6030
  OfEachAxis overrun;  ///< 5440: G60 ends with so much of its way, in the direction of the sign
  // Of lathes (docs/dialect/turning.md).
  char g_system = 'A';            ///< gsystem: system A, B or C of G codes
  int tool_offset_digits = 2;     ///< T_digits, 5028: last digits of T that are the offset's number
  bool geometry_by_tool = false;  ///< LGN: the geometry offset has the tool's number
  bool check_shapes = false;      ///< MRC: G71 to G73 check their shapes
  double monotone_z = 0;          ///< 5145: so far a checked shape may go back along Z, mm
  double monotone_x = 0;          ///< 5146: likewise along X, mm of radius
  bool compensated_cycles = false;  ///< cycle_nose: G71 to G73 compensate the nose radius
  bool bare_corners = false;        ///< CCR: A, C and R without the comma are angle and corners
  double chamfer_thread = 10;       ///< 5130: run-out of threads, tenths of the lead
  double chamfer_angle = 45;        ///< 5131: of the run-out, degrees
  double rough_depth = 1;           ///< 5132: depth of cut of G71 and G72, mm of radius
  double rough_retreat = 0.5;       ///< 5133: retreat of G71 and G72, mm
  double pattern_x = 0;             ///< 5135: first shift of G73, mm of radius
  double pattern_z = 0;             ///< 5136: likewise along Z, mm
  int pattern_count = 1;            ///< 5137: passes of G73
  double peck_retreat = 0.5;        ///< 5139: retreat of the pecks of G74 and G75, mm
  double thread_least_cut = 0;      ///< 5140: of G76, mm of radius
  double thread_finish = 0;         ///< 5141: finishing allowance of G76, mm of radius
  int thread_finish_passes = 1;     ///< 5142
  int thread_angle = 60;            ///< 5143: of the tool's tip in G76, degrees
  int css_axis = 1;             ///< G96_axis, 3770: number of the axis that G96 without P measures
  double measure_feed = 100;    ///< 6241: of G36 and G37, mm/min
  double measure_begin_x = 10;  ///< 6251: γ of G36, mm of radius
  double measure_begin_z = 10;  ///< 6252: γ of G37, mm
  double measure_window_x = 5;  ///< 6254: ε of G36, mm of radius
  double measure_window_z = 5;  ///< 6255: ε of G37, mm
  bool peck_to_r = true;        ///< RTR: G83 and G87 of lathes clear each peck to level R
  std::array<int, 10> g_macro{};  ///< 6050 to 6059: G code × 10 that calls O9010 to O9019; 0: none
  std::array<int, 10> m_macro{};  ///< 6080 to 6089: M code that calls O9020 to O9029 as a macro
  std::array<int, 9> m_sub{};  ///< 6071 to 6079: M code that calls O9001 to O9009 as a subprogram

  MachineCodes machine_codes;  ///< not by name: the machine file has tables for them

  /// Sets the parameter `key` (a name or a FANUC number) from text. One that belongs to an axis has
  /// its letter behind a point: "overrun.X", "5440.X".
  /// Failure (usage): no such key, or a value that it cannot take.
  [[nodiscard]] base::Outcome<void> set(std::string_view key, std::string_view value);

  /// True when there is a parameter of this name or FANUC number.
  [[nodiscard]] static bool is_key(std::string_view key);
  /// True when there is one that has a value for each axis.
  [[nodiscard]] static bool belongs_to_axis(std::string_view key);
};

}  // namespace kerf::control
