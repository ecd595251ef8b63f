#include "machine/dialect/internal/lathe_signs.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace kerf::machine {
namespace {

// So many points make it a lathe's: a code that no mill has, or several habits.
constexpr int kEnough = 3;

using Line = LineWords;

bool has_one_of(const Line& line, std::initializer_list<int> codes) {
  return std::any_of(codes.begin(), codes.end(), [&](int code) { return line.has_code(code); });
}

bool is_call(const Line& line) {
  const LookedAtWord* const m = line.find('M');
  return has_one_of(line, {650, 660, 661}) ||
         (m != nullptr && (m->value == 97 || m->value == 98 || m->value == 198));
}

bool is_data(const Line& line) { return line.has_code(100); }

bool moves_along_x_or_z(const Line& line) { return line.has_any("XZ"); }

// Not a letter of prose.
bool has_number(const Line& line, char letter) {
  const LookedAtWord* const word = line.find(letter);
  return word != nullptr && word->text.size() > 1;
}

// The words of `letters` as they stand: "G50 S3000".
std::string quoted(const Line& line, std::string_view letters) {
  std::string text;
  for (const LookedAtWord& word : line.all()) {
    if (letters.find(word.letter) == std::string_view::npos) continue;
    text += (text.empty() ? "" : " ") + std::string(word.text);
  }
  return text;
}

// A cycle of several blocks and a shape, in systems A to C.
bool is_shape_cycle(const Line& line) {
  return has_one_of(line, {700, 710, 720, 730, 740, 750}) && line.has_all("PQ") &&
         !line.has_any("XYZ");
}

// The first block of two: `G71 U2. R0.5`.
bool sets_up_roughing(const Line& line) {
  return has_one_of(line, {710, 720, 730, 740, 750}) && line.has('R') && line.has_any("UW") &&
         !line.has_any("XYZ");
}

// `G76 P020060 Q100 R0.1`: the P has six digits, which is no dwell of a boring bar.
bool sets_up_threads(const Line& line) {
  const LookedAtWord* const p = line.find('P');
  return has_one_of(line, {760, 780}) && p != nullptr && p->text.size() >= 6 &&
         !line.has_any("XYZ");
}

bool threads_in_one_block(const Line& line) {
  return has_one_of(line, {760, 780}) && line.has_all("XZ") && line.has_any("KQ") &&
         line.has_any("DP") && line.has('F') && !line.has_any("RY");
}

bool clamps_speed(const Line& line) {
  return line.has_code(500) && line.has('S') && !line.has_any("XYZ");
}

// Also of mills that have the option.
bool tells_kind_of_speed(const Line& line) {
  const bool clamps = line.has_code(920) && line.has('S') && !line.has_any("XYZ");
  return clamps || has_one_of(line, {960, 970});
}

bool cuts_single_thread(const Line& line) {
  return has_one_of(line, {320, 340}) && line.has('F') && line.has_any("XZUW");
}

// In place of G00 to G03, with both ends and a feed: `G90 X46. Z-30. F0.2`.
bool is_single_cycle(const Line& line) {
  return has_one_of(line, {900, 920, 940}) && !has_one_of(line, {0, 10, 20, 30, 280}) &&
         line.has_all("XZF") && !line.has_any("YS");
}

bool returns_by_increments(const Line& line) {
  return has_one_of(line, {280, 300}) && line.has_any("UW");
}

// On a mill the code is none, or one of grinders.
bool cuts_grooves(const Line& line) { return line.has_code(750) && line.has_any("XR"); }

// U and W as ways along X and Z. A cutter of foam has V beside U.
bool moves_by_increments(const Line& line) {
  const bool dwells = line.has_code(40) && line.has('U');
  const bool rough = has_one_of(line, {700, 710, 720, 730, 740, 750});
  return (has_number(line, 'U') || has_number(line, 'W')) && !line.has('V') && !rough && !dwells;
}

bool dwells_by_u(const Line& line) { return line.has_code(40) && line.has('U'); }

// T of four digits or more holds the number of an offset, and no M06 fetches the tool.
bool brings_offset(const Line& line) {
  const LookedAtWord* const t = line.find('T');
  const LookedAtWord* const m = line.find('M');
  return t != nullptr && t->value >= 100 && t->text.size() >= 4 && (m == nullptr || m->value != 6);
}

// T0101, T1212, as shops number them, and T01001 with three digits of an offset.
bool brings_offset_of_same_number(const Line& line) {
  if (!brings_offset(line)) return false;
  const LookedAtWord& t = *line.find('T');
  if (t.text.size() != 5) return t.text.size() == 6;
  return t.text[1] == '0' || t.text.substr(1, 2) == t.text.substr(3, 2);
}

bool feeds_each_turn(const Line& line) {
  const LookedAtWord* const f = line.find('F');
  return f != nullptr && f->value > 0 && f->value < 1;
}

bool drills(const Line& line) {
  return has_one_of(line, {810, 820, 830, 840, 850, 860, 870, 880, 890});
}

// Those that a lathe has, too.
bool drills_with_c(const Line& line) { return has_one_of(line, {830, 840, 850, 870, 880, 890}); }

bool names_feed_mode(const Line& line) { return has_one_of(line, {980, 990}) && !drills(line); }

// An arc about a centre in the ZX plane, which a mill would need a G18 for.
bool turns_arc(const Line& line) {
  return has_one_of(line, {20, 30}) && line.has_all("XZ") && line.has_any("IK") &&
         !line.has_any("JY");
}

bool uses_polar_plane(const Line& line) { return has_one_of(line, {121, 1120}); }

bool unrolls_cylinder(const Line& line) { return has_one_of(line, {71, 1070}) && line.has('C'); }

// Holes on a circle without Y.
bool drills_at_an_angle(const Line& line) { return drills_with_c(line) && line.has_any("CH"); }

// What speaks for a mill.

bool brings_length(const Line& line) { return line.has_code(430) && line.has('H'); }

bool compensates_by_d(const Line& line) { return has_one_of(line, {410, 420}) && line.has('D'); }

bool drills_as_mills(const Line& line) { return has_one_of(line, {810, 820, 860}); }

bool drills_without_c(const Line& line) { return drills(line) && !line.has_any("CH"); }

bool tilts(const Line& line) { return line.has_any("AB") && moves_along_x_or_z(line); }

bool rotates(const Line& line) { return line.has_code(680) && line.has('R'); }

struct Weight {
  int points;  // below 0: a mill's
  bool (*is)(const Line&);
  std::string_view letters;  // of the words that show it
};

constexpr std::array kWeights = {
    Weight{4, is_shape_cycle, "GPQ"},
    Weight{4, sets_up_roughing, "GUWR"},
    Weight{4, sets_up_threads, "GPQR"},
    Weight{3, threads_in_one_block, "GXZKQ"},
    Weight{4, clamps_speed, "GS"},
    Weight{4, returns_by_increments, "GUW"},
    Weight{3, cuts_single_thread, "GXZUWF"},
    Weight{3, moves_by_increments, "UW"},
    Weight{3, uses_polar_plane, "G"},
    Weight{3, drills_at_an_angle, "GCH"},
    Weight{2, brings_offset, "T"},
    Weight{1, brings_offset_of_same_number, "T"},
    Weight{2, cuts_grooves, "GXZPQR"},
    Weight{2, is_single_cycle, "GXZ"},
    Weight{2, unrolls_cylinder, "GC"},
    Weight{2, tells_kind_of_speed, "GS"},
    Weight{2, dwells_by_u, "GU"},
    Weight{1, turns_arc, "GXZIK"},
    Weight{1, names_feed_mode, "G"},
    Weight{1, feeds_each_turn, "F"},
    Weight{-4, brings_length, ""},
    Weight{-3, compensates_by_d, ""},
    Weight{-3, drills_as_mills, ""},
    Weight{-1, drills_without_c, ""},
    Weight{-2, tilts, ""},
    Weight{-2, rotates, ""},
    Weight{-5, [](const Line& line) { return line.has_code(170); }, ""},
};
static_assert(kWeights.size() <= LatheSigns::kMostKinds);

// Where C and H are ways of an axis: in G01 beside X or Z, C is a chamfer.
bool moves_c(const Line& line, bool cuts) {
  if (!line.has_any("CH") || has_one_of(line, {430, 440, 490})) return false;
  return drills_with_c(line) || has_one_of(line, {280, 300, 530}) || !cuts || !line.has_any("XZ");
}

bool drives_tools(const Line& line) {
  const LookedAtWord* const m = line.find('M');
  return m != nullptr && (m->value == 133 || m->value == 134);
}

}  // namespace

void LatheSigns::read(std::uint32_t number, const LineWords& line) {
  if (has_one_of(line, {0})) cuts_ = false;
  if (has_one_of(line, {10, 20, 30})) cuts_ = true;
  if (is_call(line)) return;
  see_axes(line);
  weigh(number, line);
  if (!is_data(line)) see_c_axis(number, line);
}

void LatheSigns::see_axes(const LineWords& line) {
  moves_x_or_z_ |= line.has_any("XZUW");
  moves_y_ |= line.has('Y');
}

void LatheSigns::weigh(std::uint32_t number, const LineWords& line) {
  for (std::size_t kind = 0; kind < kWeights.size(); ++kind) {
    const Weight& weight = kWeights[kind];
    if (kinds_[kind] || !weight.is(line) || (is_data(line) && weight.points > 0)) continue;
    kinds_[kind] = true;
    points_ += weight.points;
    if (weight.points <= most_points_) continue;
    most_points_ = weight.points;
    strongest_ = {number, quoted(line, weight.letters)};
  }
}

void LatheSigns::see_c_axis(std::uint32_t number, const LineWords& line) {
  if (uses_polar_plane(line)) c_axis_.see(number, quoted(line, "G"));
  if (unrolls_cylinder(line)) c_axis_.see(number, quoted(line, "GC"));
  if (moves_c(line, cuts_)) c_axis_.see(number, quoted(line, "CH"));
  if (drives_tools(line)) c_axis_.see(number, quoted(line, "M"));
}

bool LatheSigns::is_lathe() const { return points_ >= kEnough && moves_x_or_z_ && !moves_y_; }

}  // namespace kerf::machine
