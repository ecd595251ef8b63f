#include "training/exercise.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

namespace kerf::training {
namespace {

constexpr std::array<std::string_view, 12> kKeys = {
    "file",       "machine",     "tolerance_mm", "zero_mm", "clearance_z_mm", "bar_mm",
    "most_lines", "time_factor", "title",        "task",    "program",        "part"};
constexpr std::array<std::string_view, 4> kPartKeys = {"stock", "fixtures", "tools", "cell_mm"};

// A line break behind the last word is none of the text's.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

// Reads what it is asked for; the first thing that is wrong is kept.
class Reader {
 public:
  Reader(const toml::table& file, const std::string& name) : file_(file), name_(name) {}

  [[nodiscard]] base::Outcome<Exercise> read() {
    Exercise e;
    for (const auto& [key, node] : file_) {
      if (std::find(kKeys.begin(), kKeys.end(), key.str()) == kKeys.end())
        complain(&node, "an exercise has no key " + std::string(key.str()));
    }
    e.name = name_;
    e.title = words("title");
    e.task = words("task");
    e.machine = text(file_["machine"], "machine");
    e.file = text(file_["file"], "file");
    e.start = text(file_["program"]["start"], "program.start");
    e.solution = text(file_["program"]["solution"], "program.solution");
    e.tolerance_mm = at_least("tolerance_mm", 0.001);
    e.time_factor = at_least("time_factor", 1);
    e.clearance_z_mm = if_there<double>("clearance_z_mm");
    e.bar_mm = if_there<double>("bar_mm");
    e.most_lines = if_there<int>("most_lines");
    read_zero(e.zero_mm);
    check_bar(e);
    read_part(e);
    if (!wrong_.empty()) return tl::unexpected(base::Failure{base::Failure::Kind::input, wrong_});
    return e;
  }

 private:
  void complain(const toml::node* node, const std::string& what) {
    if (!wrong_.empty()) return;
    const auto line = node != nullptr ? node->source().begin.line : 0;
    wrong_ = name_ + ".toml:" + std::to_string(line) + ": " + what;
  }

  template <typename View>
  std::string text(const View& view, const std::string& key) {
    const auto found = view.template value<std::string>();
    if (!found || found->empty()) complain(view.node(), key + " must be a text");
    return found.value_or("");
  }

  Words words(const std::string& key) {
    return {trimmed(text(file_[key]["en"], key + ".en")),
            trimmed(text(file_[key]["zh-Hant"], key + ".zh-Hant"))};
  }

  double at_least(const std::string& key, double low) {
    const double number = file_[key].value<double>().value_or(0);
    if (!(number >= low)) complain(file_[key].node(), key + " must be a number, large enough");
    return number;
  }

  template <typename Number>
  std::optional<Number> if_there(const std::string& key) {
    const auto number = file_[key].value<Number>();
    if (file_.contains(key) && !number) complain(file_[key].node(), key + " must be a number");
    return number;
  }

  void read_zero(std::array<double, 3>& zero) {
    if (!file_.contains("zero_mm")) return;
    const toml::array* const list = file_["zero_mm"].as_array();
    if (list == nullptr || list->size() != zero.size())
      return complain(file_["zero_mm"].node(), "zero_mm must be three numbers");
    for (std::size_t i = 0; i < zero.size(); ++i) {
      const auto number = (*list)[i].value<double>();
      if (!number) complain(&(*list)[i], "zero_mm must be three numbers");
      zero[i] = number.value_or(0);
    }
  }

  void check_bar(const Exercise& e) {
    if (!e.bar_mm) return;
    if (*e.bar_mm <= 0) complain(file_["bar_mm"].node(), "bar_mm must be above 0");
    if (e.clearance_z_mm)
      complain(file_["bar_mm"].node(), "what is turned from a bar has no clearance_z_mm");
    if (e.zero_mm[0] != 0 || e.zero_mm[1] != 0)
      complain(file_["zero_mm"].node(), "what is turned has its zero on the axis");
  }

  void read_part(Exercise& e) {
    if (!file_.contains("part")) return;
    const toml::node_view part = file_["part"];
    if (!part.is_table()) return complain(part.node(), "part must be a table");
    for (const auto& [key, node] : *part.as_table()) {
      if (std::find(kPartKeys.begin(), kPartKeys.end(), key.str()) == kPartKeys.end())
        complain(&node, "a part has no key " + std::string(key.str()));
    }
    if (e.clearance_z_mm || e.bar_mm)
      complain(part.node(), "what is judged by its part has no clearance_z_mm and no bar_mm");
    e.part = PartWork{.stock = text(part["stock"], "part.stock"),
                      .fixtures = fixtures(part["fixtures"]),
                      .tools = text(part["tools"], "part.tools"),
                      .cell_mm = part["cell_mm"].value<double>().value_or(0)};
    if (!(e.part->cell_mm >= PartWork::kLeastCell_mm))
      complain(part["cell_mm"].node(), "part.cell_mm must be a number, large enough");
  }

  std::vector<std::string> fixtures(const toml::node_view<const toml::node>& list) {
    std::vector<std::string> words;
    if (!list) return words;
    if (!list.is_array()) complain(list.node(), "part.fixtures must be a list of texts");
    for (std::size_t i = 0; list.is_array() && i < list.as_array()->size(); ++i)
      words.push_back(text(list[i], "each of part.fixtures"));
    return words;
  }

  const toml::table& file_;
  const std::string& name_;
  std::string wrong_;
};

std::vector<Exercise> read_all() {
  std::vector<Exercise> list;
  for (const ExerciseFile& file : exercise_files()) {
    // Those that come with Kerf are right: a test reads each of them.
    if (auto exercise = Exercise::parse(file.toml, std::string(file.name)))
      list.push_back(std::move(*exercise));
  }
  return list;
}

}  // namespace

base::Outcome<Exercise> Exercise::parse(std::string_view text, const std::string& name) {
  try {
    const toml::table file = toml::parse(text);
    return Reader(file, name).read();
  } catch (const toml::parse_error& error) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::input, name + ".toml:" + std::to_string(error.source().begin.line) +
                                        ": " + std::string(error.description())});
  }
}

const std::vector<Exercise>& exercises() {
  static const std::vector<Exercise> all = read_all();
  return all;
}

const Exercise* find_exercise(std::string_view name) {
  const auto found = std::find_if(exercises().begin(), exercises().end(),
                                  [&](const Exercise& e) { return e.name == name; });
  return found == exercises().end() ? nullptr : &*found;
}

std::string PartWork::set_up() const {
  std::string toml = fmt::format("[stock]\nshape = \"{}\"\nzero = \"G54\"\n", stock);
  for (const std::string& fixture : fixtures)
    toml += fmt::format("\n[[fixture]]\nshape = \"{}\"\n", fixture);
  return toml + "\n" + tools;
}

}  // namespace kerf::training
