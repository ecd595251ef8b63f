#include "machine/definition/internal/set_up_reader.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/decimal.hpp"
#include "machine/definition/number_list.hpp"
#include "machine/definition/stock_place.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kLongestWord = 1000;
constexpr std::size_t kShownOfKey = 40;
constexpr std::size_t kMostFixtures = 1000;

/// A key of a table, and what takes its value.
template <typename Into>
struct SetUpKey {
  std::string_view name;
  void (*take)(const toml::node& value, Into& into);
};

std::string shown(std::string_view key) { return std::string(key.substr(0, kShownOfKey)); }

template <typename Keys>
std::string names_of(const Keys& keys) {
  std::string list;
  for (const auto& key : keys) list += (list.empty() ? "" : ", ") + std::string(key.name);
  return list;
}

template <typename Keys, typename Into>
void take_table(const toml::node& node, const std::string& title, const Keys& keys, Into& into) {
  if (!node.is_table()) throw WrongSetUp{node, title + " must be a table"};
  for (const auto& [name, value] : *node.as_table()) {
    const auto key = std::find_if(keys.begin(), keys.end(), [&name = name](const auto& each) {
      return each.name == name.str();
    });
    if (key == keys.end()) {
      throw WrongSetUp{name.source().begin, title + " has no key " + shown(name.str()) + ": " +
                                                names_of(keys) + " are there"};
    }
    key->take(value, into);
  }
}

std::string word_of(const toml::node& node, const std::string& what) {
  const auto text = node.value<std::string>();
  if (!node.is_string() || text->empty() || text->size() > kLongestWord)
    throw WrongSetUp{node, what + " is a text"};
  return *text;
}

double number_in(const toml::node& node, double low, double high, const std::string& what) {
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  if (number && *number >= low && *number <= high) return *number;
  throw WrongSetUp{node, what + " is a number from " + base::number_text(low) + " to " +
                             base::number_text(high)};
}

/// What words of the command line come to, with the place of the text instead of the option.
template <typename T>
T worth(base::Outcome<T> outcome, const toml::node& node) {
  if (!outcome) throw WrongSetUp{node, outcome.error().message};
  return std::move(*outcome);
}

void take_shape(const toml::node& node, SetUp::Piece& piece) {
  piece.said = word_of(node, "shape");
  piece.word = worth(stock_word(piece.said, "shape"), node);
}

MeshUnit unit_in(const toml::node& node) {
  const std::string word = word_of(node, "unit");
  if (word != "mm" && word != "inch") throw WrongSetUp{node, "unit is mm or inch"};
  return word == "inch" ? MeshUnit::inch : MeshUnit::mm;
}

stock::Placement place_in(const toml::node& node) {
  if (node.is_string()) return worth(stock_place(word_of(node, "place"), "place"), node);
  std::vector<double> numbers;
  if (const toml::array* const list = node.as_array(); list != nullptr && list->size() <= 6) {
    for (const toml::node& each : *list)
      numbers.push_back(number_in(each, -kFarthest_mm, kFarthest_mm, "each of place"));
  }
  const auto place = placement_of(numbers);
  if (!place) throw WrongSetUp{node, "place is [X, Y, Z] or [X, Y, Z, A, B, C], mm and degrees"};
  return *place;
}

/// The values of a table that has a shape, until it is known what that is.
struct ShapeTable {
  SetUp::Piece piece;
  std::optional<MeshUnit> unit;
  std::optional<StockZero> zero;
  std::optional<stock::Placement> place;
};

constexpr std::array<SetUpKey<ShapeTable>, 4> kStockKeys = {{
    {"shape", [](const toml::node& v, ShapeTable& t) { take_shape(v, t.piece); }},
    {"zero", [](const toml::node& v,
                ShapeTable& t) { t.zero = worth(stock_zero(word_of(v, "zero"), "zero"), v); }},
    {"place", [](const toml::node& v, ShapeTable& t) { t.place = place_in(v); }},
    {"unit", [](const toml::node& v, ShapeTable& t) { t.unit = unit_in(v); }},
}};

constexpr std::array<SetUpKey<ShapeTable>, 3> kFixtureKeys = {{
    {"shape", [](const toml::node& v, ShapeTable& t) { take_shape(v, t.piece); }},
    {"name", [](const toml::node& v, ShapeTable& t) { t.piece.name = word_of(v, "name"); }},
    {"unit", [](const toml::node& v, ShapeTable& t) { t.unit = unit_in(v); }},
}};

/// A file lies beside the set-up; only a file has a unit.
void settle(const ShapeTable& table, const toml::node& node, const std::filesystem::path& folder,
            SetUp::Piece& piece) {
  auto* const file = std::get_if<StockFile>(&piece.word);
  if (file == nullptr && table.unit)
    throw WrongSetUp{*node.as_table()->get("unit"), "unit is that of an STL file"};
  if (file == nullptr) return;
  file->path = (folder / file->path).string();
  file->unit = table.unit.value_or(MeshUnit::mm);
}

void take_stock(const toml::node& node, const std::filesystem::path& folder, SetUp& set_up) {
  ShapeTable table;
  take_table(node, "[stock]", kStockKeys, table);
  if (!table.piece.said.empty()) {
    set_up.stock = table.piece;
  } else if (table.unit) {
    throw WrongSetUp{*node.as_table()->get("unit"), "unit is that of an STL file"};
  }
  if (set_up.stock) settle(table, node, folder, *set_up.stock);
  set_up.zero = table.zero;
  set_up.place = table.place;
}

void take_fixtures(const toml::node& node, const std::filesystem::path& folder, SetUp& set_up) {
  if (!node.is_array_of_tables()) throw WrongSetUp{node, "[[fixture]] tables are expected"};
  if (node.as_array()->size() > kMostFixtures)
    throw WrongSetUp{node, "there are more than " + std::to_string(kMostFixtures) + " fixtures"};
  for (const toml::node& each : *node.as_array()) {
    ShapeTable table;
    take_table(each, "[[fixture]]", kFixtureKeys, table);
    if (table.piece.said.empty()) throw WrongSetUp{each, "a fixture needs its shape"};
    settle(table, each, folder, table.piece);
    set_up.fixtures.push_back(std::move(table.piece));
  }
}

/// [material] before it is known whether it is a group or numbers.
struct MaterialTable {
  std::optional<stock::CutMaterial> group;
  std::optional<double> kc11;
  std::optional<double> mc;
  std::optional<double> energy_j_mm3;
};

constexpr double kMostForce = 1e6;
constexpr double kMostEnergy = 1e6;

constexpr std::array<SetUpKey<MaterialTable>, 4> kMaterialKeys = {{
    {"group",
     [](const toml::node& v, MaterialTable& t) {
       t.group = worth(cut_material(word_of(v, "group"), "group"), v);
     }},
    {"kc11",
     [](const toml::node& v, MaterialTable& t) { t.kc11 = number_in(v, 1, kMostForce, "kc11"); }},
    {"mc", [](const toml::node& v, MaterialTable& t) { t.mc = number_in(v, 0, 0.99, "mc"); }},
    {"energy_j_mm3",
     [](const toml::node& v, MaterialTable& t) {
       t.energy_j_mm3 = number_in(v, 1e-6, kMostEnergy, "energy_j_mm3");
     }},
}};

void take_material(const toml::node& node, SetUp& set_up) {
  MaterialTable table;
  take_table(node, "[material]", kMaterialKeys, table);
  const bool has_numbers = table.kc11 || table.mc;
  if (has_numbers && (table.group || !table.kc11 || !table.mc))
    throw WrongSetUp{node, "[material] has group, or kc11 and mc"};
  set_up.material = table.group;
  if (has_numbers) set_up.material = stock::CutMaterial{*table.kc11, *table.mc};
  set_up.energy_j_mm3 = table.energy_j_mm3;
}

void take_left_out(const toml::node& node, SetUp& set_up) {
  const toml::array* const list = node.as_array();
  if (list == nullptr) throw WrongSetUp{node, "no_check is a list of codes"};
  for (const toml::node& each : *list)
    set_up.left_out.push_back(worth(stock_check(word_of(each, "a code"), "no_check"), each));
}

void take_lengths(const toml::node& node, SetUp& set_up) {
  const std::string word = word_of(node, "lengths");
  if (word != "programmed" && word != "real")
    throw WrongSetUp{node, "lengths is programmed or real"};
  set_up.has_real_lengths = word == "real";
}

constexpr std::array<SetUpKey<SetUp>, 4> kCheckKeys = {{
    {"touch_mm",
     [](const toml::node& v, SetUp& s) { s.touch_mm = number_in(v, 0.001, 1, "touch_mm"); }},
    {"no_check", take_left_out},
    {"fail_on", [](const toml::node& v,
                   SetUp& s) { s.fail_on = worth(fail_on(word_of(v, "fail_on"), "fail_on"), v); }},
    {"lengths", take_lengths},
}};

constexpr std::array<SetUpKey<SetUp::Design>, 4> kDesignKeys = {{
    {"file", [](const toml::node& v, SetUp::Design& d) { d.file.path = word_of(v, "file"); }},
    {"place", [](const toml::node& v, SetUp::Design& d) { d.place = place_in(v); }},
    {"tolerance", [](const toml::node& v,
                     SetUp::Design& d) { d.tolerance_mm = number_in(v, 1e-6, 1000, "tolerance"); }},
    {"unit", [](const toml::node& v, SetUp::Design& d) { d.file.unit = unit_in(v); }},
}};

void take_design(const toml::node& node, const std::filesystem::path& folder, SetUp& set_up) {
  SetUp::Design design;
  take_table(node, "[design]", kDesignKeys, design);
  if (design.file.path.empty()) throw WrongSetUp{node, "a design needs its file"};
  design.file.path = (folder / design.file.path).string();
  set_up.design = std::move(design);
}

}  // namespace

SetUp set_up_in(const toml::table& file, const std::string& source) {
  const std::filesystem::path folder = std::filesystem::path(source).parent_path();
  SetUp set_up;
  for (const auto& [name, node] : file) {
    if (name.str() == "stock") {
      take_stock(node, folder, set_up);
    } else if (name.str() == "fixture") {
      take_fixtures(node, folder, set_up);
    } else if (name.str() == "material") {
      take_material(node, set_up);
    } else if (name.str() == "checks") {
      take_table(node, "[checks]", kCheckKeys, set_up);
    } else if (name.str() == "design") {
      take_design(node, folder, set_up);
    } else if (name.str() == "tool" || name.str() == "holder") {
      if (!node.is_array_of_tables())
        throw WrongSetUp{node, "[[" + std::string(name.str()) + "]] tables are expected"};
    } else {
      throw WrongSetUp{name.source().begin,
                       "there is no table " + shown(name.str()) +
                           ": stock, fixture, material, checks, design and tool are there"};
    }
  }
  return set_up;
}

}  // namespace kerf::machine
