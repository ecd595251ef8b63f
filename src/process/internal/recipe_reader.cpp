#include "process/internal/recipe_reader.hpp"

#include <algorithm>
#include <array>

#include "process/internal/key_value.hpp"
#include "process/internal/nearest_name.hpp"
#include "process/settled.hpp"

namespace kerf::process {
namespace {

constexpr std::size_t kMostOperations = 1000;
constexpr std::size_t kMostLines = 10'000;
constexpr std::size_t kMostMaterials = 10'000;

constexpr std::array<std::string_view, 8> kRoots = {"job",   "place", "array", "text",
                                                    "image", "wrap",  "lens",  "operation"};

std::vector<std::string_view> names_in(KeyTable table, Process process) {
  std::vector<std::string_view> names;
  for (const JobKey& key : job_keys()) {
    if (key.table == table && is_taken(&key, process)) names.push_back(key.name);
  }
  if (table == KeyTable::material) {
    for (const std::string_view word : words_of(find_key(KeyTable::operation, "process")->takes))
      names.push_back(word);
  }
  if (table == KeyTable::text) names.insert(names.end(), {"serial", "line"});
  return names;
}

const Takes& process_words() { return find_key(KeyTable::operation, "process")->takes; }

std::optional<Process> process_named(std::string_view name) {
  const std::vector<std::string_view> names = words_of(process_words());
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Process>(found - names.begin());
}

/// Of an operation its process is needed before its other keys.
Process process_in(const toml::node& node) {
  const toml::node* const said = node.is_table() ? node.as_table()->get("process") : nullptr;
  const auto value = said == nullptr ? std::nullopt : value_of(process_words(), *said);
  return value ? static_cast<Process>(value->number) : Process::engrave;
}

/// The name, or the name and the first number that makes it one of its own.
std::string free_name(const std::vector<Operation>& operations, std::string_view name) {
  std::string free{name};
  const auto has_it = [&](const Operation& each) { return each.name == free; };
  for (int i = 2; std::any_of(operations.begin(), operations.end(), has_it); ++i)
    free = std::string(name) + ' ' + std::to_string(i);
  return free;
}

bool is_before(const base::Diagnostic& a, const base::Diagnostic& b) {
  return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
}

}  // namespace

bool is_taken(const JobKey* key, Process process) {
  return key != nullptr && (key->table != KeyTable::operation || (key->processes & only(process)));
}

base::Diagnostic unknown_key(KeyTable table, std::string_view name, Process process,
                             const base::Place& place) {
  if (const JobKey* const key = find_key(table, name)) {
    return make_error(base::Code::job_key, place,
                      std::string(name) + " is a key of " + names_of(key->processes) +
                          ", and this operation is " + std::string(name_of(process)));
  }
  return make_error(base::Code::job_key, place,
                    std::string(title_of(table)) + " has no key " + shown(name),
                    nearest_hint(name, names_in(table, process)));
}

base::Diagnostic wrong_value(const JobKey& key, const toml::node& node, const base::Place& place) {
  const std::string what = std::string(key.name) + " is " + in_words(key.takes);
  const auto* const text = node.as_string();
  return make_error(base::Code::job_value, place, what + ", not " + shown_value(node),
                    text == nullptr ? "" : nearest_hint(text->get(), words_of(key.takes)));
}

RecipeReader::RecipeReader(const std::string& text, base::FileId file) : file_(file) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
}

base::Place RecipeReader::place_of(const toml::source_region& source) const {
  base::Place place{file_, source.begin.line, source.begin.column};
  if (place.line > 0 && place.line <= line_starts_.size())
    place.line_start = line_starts_[place.line - 1];
  if (source.end.line == source.begin.line && source.end.column > source.begin.column)
    place.length = source.end.column - source.begin.column;
  return place;
}

base::Place RecipeReader::place_of(const std::string& path) const {
  for (std::size_t end = path.size(); end != std::string::npos; end = path.rfind('.', end - 1)) {
    const auto found = places_.find(path.substr(0, end));
    if (found != places_.end()) return found->second;
    if (end == 0) break;
  }
  return {file_, 1, 1};
}

Diagnostics RecipeReader::findings() {
  std::stable_sort(found_.begin(), found_.end(), is_before);
  return std::move(found_);
}

void RecipeReader::wrong(const toml::node& node, const std::string& sentence) {
  tell(make_error(base::Code::job_value, place_of(node.source()), sentence));
}

void RecipeReader::read(const toml::table& file, Recipe& recipe) {
  for (const auto& [name, node] : file) read_root(name, node, recipe);
  recipe.material_place = place_of(std::string("job.material"));
}

void RecipeReader::read_materials(const toml::table& file, std::vector<Material>& materials) {
  for (const auto& [name, node] : file) {
    if (name.str() == "material") {
      for (const toml::node* const each :
           tables_in(node, title_of(KeyTable::material), kMostMaterials))
        read_material(*each, materials.emplace_back());
    } else {
      tell(make_error(base::Code::job_key, place_of(name.source()),
                      "there is no table " + shown(name.str()) + ": [[material]] are expected"));
    }
  }
}

void RecipeReader::read_material(const toml::node& node, Material& material) {
  read_table(node, KeyTable::material, &material, "material");
  if (material.name.empty()) wrong(node, "[[material]] needs its name");
}

void RecipeReader::read_root(const toml::key& name, const toml::node& node, Recipe& recipe) {
  const std::string root{name.str()};
  places_[root] = place_of(name.source());
  if (root == "job") return read_table(node, KeyTable::job, &recipe, root);
  if (root == "place") return read_table(node, KeyTable::place, &recipe.place, root);
  if (root == "array") return read_table(node, KeyTable::array, &recipe.array, root);
  if (root == "image") return read_table(node, KeyTable::image, &recipe.image, root);
  if (root == "wrap") return read_table(node, KeyTable::wrap, &recipe.wrap, root);
  if (root == "lens") return read_table(node, KeyTable::lens, &recipe, root);
  if (root == "text") return read_text(node, recipe.text);
  if (root == "operation") return read_operations(node, recipe.operations);
  tell(make_error(base::Code::job_key, place_of(name.source()), "there is no table " + shown(root),
                  nearest_hint(root, kRoots)));
}

void RecipeReader::read_text(const toml::node& node, TextWords& text) {
  text.is_said = true;
  read_table(node, KeyTable::text, &text, "text");
}

std::vector<const toml::node*> RecipeReader::tables_in(const toml::node& node,
                                                       std::string_view title, std::size_t most) {
  std::vector<const toml::node*> tables;
  if (!node.is_array_of_tables()) {
    wrong(node, std::string(title) + " tables are expected");
  } else if (node.as_array()->size() > most) {
    wrong(node, "there are more than " + std::to_string(most) + " " + std::string(title));
  } else {
    for (const toml::node& each : *node.as_array()) tables.push_back(&each);
  }
  return tables;
}

void RecipeReader::read_lines(const toml::node& node, std::vector<TextLine>& lines) {
  for (const toml::node* const each : tables_in(node, title_of(KeyTable::line), kMostLines)) {
    const std::string path = "text.line." + std::to_string(lines.size());
    places_[path] = place_of(each->source());
    read_table(*each, KeyTable::line, &lines.emplace_back(), path);
  }
}

void RecipeReader::read_operations(const toml::node& node, std::vector<Operation>& operations) {
  for (const toml::node* const each :
       tables_in(node, title_of(KeyTable::operation), kMostOperations)) {
    const std::string path = "operation." + std::to_string(operations.size());
    places_[path] = place_of(each->source());
    read_operation(*each, operations.emplace_back(), path);
  }
  for (Operation& each : operations) {
    if (each.name.empty()) each.name = free_name(operations, name_of(each.process));
  }
}

void RecipeReader::read_operation(const toml::node& node, Operation& operation,
                                  const std::string& path) {
  operation.place = place_of(node.source());
  operation.line = operation.place.line;
  read_table(node, KeyTable::operation, &operation, path, process_in(node));
  if (operation.layers.empty()) operation.layers = {"*"};
}

void RecipeReader::read_table(const toml::node& node, KeyTable table, const KeyOwner& owner,
                              const std::string& path, Process process) {
  if (!node.is_table()) {
    return wrong(node, std::string(title_of(table)) + " is a table, not " + shown_value(node));
  }
  for (const auto& [name, value] : *node.as_table())
    read_key(name, value, table, owner, path, process);
}

void RecipeReader::read_key(const toml::key& name, const toml::node& node, KeyTable table,
                            const KeyOwner& owner, const std::string& path, Process process) {
  const std::string here = path + '.' + std::string(name.str());
  if (path == "text" && name == "serial") return read_table(node, KeyTable::serial, owner, here);
  if (path == "text" && name == "line") return read_lines(node, std::get<TextWords*>(owner)->lines);
  if (table == KeyTable::material && process_named(name.str())) {
    Preset& preset = std::get<Material*>(owner)->presets.emplace_back();
    preset.process = *process_named(name.str());
    return read_table(node, KeyTable::preset, &preset, here);
  }
  const JobKey* const key = find_key(table, name.str());
  if (!is_taken(key, process))
    return tell(unknown_key(table, name.str(), process, place_of(name.source())));
  places_[here] = place_of(name.source());
  if (key->takes.form == Takes::Form::table && node.is_table())
    return read_table(node, table_inside(*key), key->inside(owner), here);
  const auto value = value_of(key->takes, node);
  if (!value) return tell(wrong_value(*key, node, place_of(node.source())));
  say(*key, owner, *value);
}

}  // namespace kerf::process
