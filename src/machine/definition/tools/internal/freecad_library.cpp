#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/decimal.hpp"
#include "base/source_file.hpp"
#include "machine/definition/tools/internal/json_text.hpp"
#include "machine/definition/tools/internal/letters.hpp"
#include "machine/definition/tools/internal/library_builder.hpp"
#include "machine/definition/tools/tool_words.hpp"

namespace kerf::machine {
namespace {

using Bit = nlohmann::json;
using stock::Measure;
using stock::Tool;
using stock::ToolKind;

constexpr std::uint64_t kLargestBit = std::uint64_t{1} << 20U;

/// Shapes by the beginning of their name, letters alone, as capitals: "V-Bit" is VBIT.
struct Shape {
  std::string_view name;
  std::string_view type;
};
constexpr std::array<Shape, 13> kShapes = {{{"ENDMILL", "flat"},
                                            {"BALLEND", "ball"},
                                            {"BULLNOSE", "bull"},
                                            {"TORUS", "bull"},
                                            {"CHAMFER", "chamfer"},
                                            {"VBIT", "v"},
                                            {"DRILL", "drill"},
                                            {"DOVETAIL", "dovetail"},
                                            {"SLITTINGSAW", "saw"},
                                            {"TAP", "tap"},
                                            {"THREAD", "thread-mill"},
                                            {"REAMER", "reamer"},
                                            {"PROBE", "probe"}}};

struct Unit {
  std::string_view name;
  double scale;
};
constexpr std::array<Unit, 9> kUnits = {{{"", 1},
                                         {"mm", 1},
                                         {"cm", 10},
                                         {"m", 1000},
                                         {"in", kMmPerInch},
                                         {"\"", kMmPerInch},
                                         {"\xC2\xB0", 1},
                                         {"deg", 1},
                                         {"um", 0.001}}};

std::string_view trimmed_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "1/4" and "5.0".
std::optional<double> fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto above = base::read_number(trimmed_blanks(text.substr(0, slash)));
  if (!above) return {};
  if (slash == std::string_view::npos) return *above;
  const auto below = base::read_number(trimmed_blanks(text.substr(slash + 1)));
  return below && *below != 0 ? std::optional(*above / *below) : std::nullopt;
}

/// "5.0000 mm", "119.00 °", "1/4 in": mm or degrees.
std::optional<double> quantity(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789+-./ "), text.size());
  const auto value = fraction(trimmed_blanks(text.substr(0, end)));
  const std::string_view name = trimmed_blanks(text.substr(end));
  const auto* const unit = std::find_if(kUnits.begin(), kUnits.end(),
                                        [&](const Unit& each) { return each.name == name; });
  if (!value || unit == kUnits.end()) return {};
  return *value * unit->scale;
}

const Bit* child(const Bit& object, std::string_view key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string word_at(const Bit& object, std::string_view key) {
  const Bit* const value = child(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

std::string_view type_of(const Bit& bit) {
  const std::string written =
      word_at(bit, "shape-type").empty() ? word_at(bit, "shape") : word_at(bit, "shape-type");
  std::string letters;
  for (const char c : capitals(std::filesystem::path(written).stem().string()))
    if (is_capital(c)) letters += c;
  const auto* const shape = std::find_if(kShapes.begin(), kShapes.end(), [&](const Shape& each) {
    return letters.starts_with(each.name);
  });
  return shape == kShapes.end() ? std::string_view() : shape->type;
}

/// A tool bit: what its parameters say.
class BitReader {
 public:
  BitReader(const Bit& bit, LibraryBuilder& builder)
      : parameters_(child(bit, "parameter")), builder_(builder) {
    tool_.name = word_at(bit, "name").substr(0, 200);
  }

  Tool read(std::string_view type, int number) {
    tool_.number = number;
    set_type(tool_, type);
    constexpr std::array<std::pair<std::string_view, Measure>, 9> kFields = {
        {{"Diameter", Measure::diameter},
         {"CuttingEdgeHeight", Measure::flute_length},
         {"Flutes", Measure::flutes},
         {"CornerRadius", Measure::corner_radius},
         {"TipAngle", Measure::angle},
         {"CuttingEdgeAngle", Measure::angle},
         {"TipDiameter", Measure::tip_diameter},
         {"NeckDiameter", Measure::neck_diameter},
         {"Pitch", Measure::pitch}}};
    for (const auto& [key, measure] : kFields) set_where_fit(tool_, measure, value(key));
    set_where_fit(tool_, Measure::width, value("BladeThickness"));
    set_height_of_its_own();
    add_shank();
    return tool_;
  }

 private:
  std::optional<double> value(std::string_view key) {
    const Bit* const found = parameters_ != nullptr ? child(*parameters_, key) : nullptr;
    if (found == nullptr) return {};
    if (found->is_number()) return found->get<double>();
    const auto read = found->is_string() ? quantity(found->get<std::string>()) : std::nullopt;
    if (!read) builder_.remark(tool_.number, std::string(key) + " is not understood");
    return read;
  }

  void set_height_of_its_own() {
    if (tool_.kind == ToolKind::dovetail)
      set_where_fit(tool_, Measure::height, tool_.said(Measure::flute_length));
    // A saw sits on its arbor.
    if (tool_.kind == ToolKind::t_slot && !tool_.said(Measure::neck_diameter))
      set_where_fit(tool_, Measure::neck_diameter, value("ShankDiameter"));
  }

  // Neck and shank reach from the flutes to the end of the tool; how much the holder takes of that
  // the file does not say.
  void add_shank() {
    const double flutes = tool_.said(Measure::flute_length).value_or(0);
    if (flutes == 0) return;
    const double neck = value("NeckDiameter").value_or(0);
    const double neck_length = value("NeckLength").value_or(0);
    if (neck > 0 && neck_length > 0) tool_.shank.push_back({neck_length, neck, neck});
    const double from = flutes + (tool_.shank.empty() ? 0 : neck_length);
    const double end = value("Length").value_or(0);
    const double shank = value("ShankDiameter").value_or(0);
    if (end > from && shank > 0) tool_.shank.push_back({end - from, shank, shank});
  }

  const Bit* parameters_;
  LibraryBuilder& builder_;
  Tool tool_;
};

/// A bit lies beside the library, or in the folder Bit beside its own. A library leads nowhere
/// else.
base::Outcome<std::string> bit_text(const std::string& library, const std::string& name) {
  const std::filesystem::path path(name);
  const bool leads_away = path.is_absolute() ||
                          std::find(path.begin(), path.end(), "..") != path.end() ||
                          path.extension() != ".fctb";
  if (leads_away) return unreadable(name, "this is no path of a tool bit");
  const std::filesystem::path folder = std::filesystem::path(library).parent_path();
  std::error_code error;
  const std::filesystem::path beside = folder / path;
  if (std::filesystem::exists(beside, error))
    return base::read_whole(beside.string(), kLargestBit, "a tool bit");
  return base::read_whole((folder / ".." / "Bit" / path).string(), kLargestBit, "a tool bit");
}

void add_bit(const Bit& entry, const std::string& library, LibraryBuilder& builder) {
  const Bit* const nr = child(entry, "nr");
  const bool has_number = nr != nullptr && nr->is_number_integer();
  const auto wide = has_number ? nr->get<std::int64_t>() : 0;
  const int number = wide >= 1 && wide <= 99999999 ? static_cast<int>(wide) : 0;
  const auto text = bit_text(library, word_at(entry, "path"));
  if (!text) return builder.remark(number, text.error().message);
  const Bit bit = parse_library(*text);
  const std::string_view type = type_of(bit);
  if (type.empty()) return builder.remark(number, "its shape is not understood");
  builder.add(BitReader(bit, builder).read(type, number));
}

}  // namespace

base::Outcome<ToolLibrary> read_freecad(const std::string& text, const std::string& path) {
  const Bit library = parse_library(text);
  const Bit* const list = child(library, "tools");
  if (list == nullptr || !list->is_array()) return unreadable(path, "this is no library of tools");
  if (list->size() > kMostImportedTools) return unreadable(path, "there are too many tools");
  LibraryBuilder builder;
  for (const Bit& entry : *list) add_bit(entry, path, builder);
  return builder.take();
}

}  // namespace kerf::machine
