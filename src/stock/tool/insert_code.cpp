#include "stock/tool/insert_code.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/decimal.hpp"

namespace kerf::stock {
namespace {

using M = Measure;

/// Angle of the tip, and the usual entering angle of holders for it.
struct Shape {
  char letter;
  double tip_angle;
  double kapr;
};
constexpr std::array<Shape, 16> kShapes = {{{'A', 85, 90},
                                            {'B', 82, 90},
                                            {'C', 80, 95},
                                            {'D', 55, 93},
                                            {'E', 75, 90},
                                            {'K', 55, 93},
                                            {'M', 86, 90},
                                            {'V', 35, 93},
                                            {'T', 60, 91},
                                            {'S', 90, 75},
                                            {'W', 80, 95},
                                            {'R', 0, 90},
                                            {'H', 120, 90},
                                            {'O', 135, 90},
                                            {'P', 108, 90},
                                            {'L', 90, 90}}};

/// Inscribed circle of an edge length.
struct Size {
  std::string_view code;
  double ic;
};
constexpr std::array<Size, 20> kSizes = {
    {{"C06", 6.35},  {"D07", 6.35},  {"V11", 6.35},  {"T11", 6.35},   {"W04", 6.35},
     {"C09", 9.525}, {"D11", 9.525}, {"V16", 9.525}, {"T16", 9.525},  {"W06", 9.525},
     {"S09", 9.525}, {"K16", 9.525}, {"C12", 12.7},  {"D15", 12.7},   {"V22", 12.7},
     {"T22", 12.7},  {"W08", 12.7},  {"S12", 12.7},  {"C16", 15.875}, {"T27", 15.875}}};
constexpr std::array<Size, 3> kLargeSizes = {{{"S15", 15.875}, {"C19", 19.05}, {"S19", 19.05}}};

constexpr std::size_t kLetters = 4;

std::optional<double> digits(std::string_view text, std::size_t at) {
  if (text.size() < kLetters + at + 2) return {};
  const auto value = base::read_whole_number(text.substr(kLetters + at, 2));
  return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
}

std::optional<double> circle_of(std::string_view code, double edge) {
  if (code[0] == 'R') return edge;
  const auto find = [&](const auto& sizes) {
    const auto found = std::find_if(sizes.begin(), sizes.end(),
                                    [&](const Size& size) { return size.code == code; });
    return found == sizes.end() ? std::nullopt : std::optional(found->ic);
  };
  const auto usual = find(kSizes);
  return usual ? usual : find(kLargeSizes);
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

bool begins_with_letters(std::string_view text) {
  return text.size() >= kLetters && std::all_of(text.begin(), text.begin() + kLetters,
                                                [](char c) { return c >= 'A' && c <= 'Z'; });
}

}  // namespace

tl::expected<InsertCode, std::string> read_insert_code(std::string_view text) {
  const std::string code = upper(text);
  const auto wrong = [&](const std::string& why) {
    return tl::unexpected("insert \"" + std::string(text.substr(0, 40)) + "\": " + why);
  };
  if (!begins_with_letters(code))
    return wrong("a designation begins with four letters: CNMG120408");
  const auto* const shape = std::find_if(kShapes.begin(), kShapes.end(),
                                         [&](const Shape& each) { return each.letter == code[0]; });
  if (shape == kShapes.end()) return wrong("there is no shape " + code.substr(0, 1));
  InsertCode read{.shape = code[0], .measures = {}};
  if (shape->tip_angle > 0) read.measures.set(M::tip_angle, shape->tip_angle);
  read.measures.set(M::kapr, shape->kapr);
  const auto edge = digits(code, 0);
  if (!edge && code.size() > kLetters) return wrong("two digits for the edge are expected");
  const auto ic = edge ? circle_of(code.substr(0, 1) + code.substr(kLetters, 2), *edge) : edge;
  if (ic && *ic > 0) read.measures.set(M::ic, *ic);
  if (read.shape == 'R' && ic && *ic > 0) {
    read.measures.set(M::nose_radius, *ic / 2);
  } else if (const auto nose = digits(code, 4)) {
    read.measures.set(M::nose_radius, *nose / 10);
  }
  return read;
}

}  // namespace kerf::stock
