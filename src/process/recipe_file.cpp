#include "process/recipe_file.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "process/internal/key_value.hpp"
#include "process/internal/nearest_name.hpp"
#include "process/internal/recipe_check.hpp"
#include "process/internal/recipe_reader.hpp"

namespace kerf::process {
namespace {

constexpr std::size_t kMostTold = 100;

Diagnostics first_of(Diagnostics found) {
  if (found.size() > kMostTold) found.resize(kMostTold);
  return found;
}

Diagnostics only_one(base::Diagnostic diagnostic) {
  Diagnostics list;
  list.push_back(std::move(diagnostic));
  return list;
}

/// A key that somebody names by its path, and what it is a part of.
struct Named {
  KeyTable table = KeyTable::job;
  KeyOwner owner = nullptr;
  Process process = Process::engrave;
};

/// Cuts off what stands before the first point.
std::string_view cut_front(std::string_view& path) {
  const std::size_t end = std::min(path.find('.'), path.size());
  const std::string_view front = path.substr(0, end);
  path.remove_prefix(std::min(end + 1, path.size()));
  return front;
}

bool takes_front(std::string_view& path, std::string_view name) {
  if (!path.starts_with(name) || path.size() <= name.size() || path[name.size()] != '.')
    return false;
  path.remove_prefix(name.size() + 1);
  return true;
}

/// The operation whose name `path` begins with, else the one of that number, from 1; cuts it off.
Operation* find_operation(Recipe& recipe, std::string_view& path) {
  Operation* longest = nullptr;
  for (Operation& each : recipe.operations) {
    std::string_view rest = path;
    if (takes_front(rest, each.name) &&
        (longest == nullptr || each.name.size() > longest->name.size()))
      longest = &each;
  }
  if (longest != nullptr) {
    takes_front(path, longest->name);
    return longest;
  }
  const auto number = base::read_whole_number(cut_front(path));
  const bool is_there = number && *number >= 1 && *number <= recipe.operations.size();
  return is_there ? &recipe.operations[*number - 1] : nullptr;
}

KeyOwner find_text(Recipe& recipe, std::string_view& path, KeyTable& table) {
  recipe.text.is_said = true;
  if (takes_front(path, "serial")) {
    table = KeyTable::serial;
    return &recipe.text;
  }
  if (!takes_front(path, "line")) return &recipe.text;
  table = KeyTable::line;
  const auto number = base::read_whole_number(cut_front(path));
  const bool is_there = number && *number >= 1 && *number <= recipe.text.lines.size();
  if (!is_there) return nullptr;
  return &recipe.text.lines[*number - 1];
}

/// The table that `path` begins with; cuts it off.
Named find_table(Recipe& recipe, std::string_view& path) {
  const std::string_view root = cut_front(path);
  if (root == "job") return {KeyTable::job, &recipe};
  if (root == "lens") return {KeyTable::lens, &recipe};
  if (root == "place") return {KeyTable::place, &recipe.place};
  if (root == "array") return {KeyTable::array, &recipe.array};
  if (root == "image") return {KeyTable::image, &recipe.image};
  if (root == "wrap") return {KeyTable::wrap, &recipe.wrap};
  if (root == "text") {
    Named named{KeyTable::text, nullptr};
    named.owner = find_text(recipe, path, named.table);
    return named;
  }
  Operation* const operation = root == "operation" ? find_operation(recipe, path) : nullptr;
  if (operation == nullptr) return {};
  return {KeyTable::operation, operation, operation->process};
}

base::Diagnostic no_table(std::string_view path, const Recipe& recipe) {
  std::vector<std::string_view> names;
  for (const Operation& each : recipe.operations) names.push_back(each.name);
  std::string_view rest = path;
  if (cut_front(rest) != "operation") {
    return make_error(base::Code::job_key, {}, "there is no key " + shown(path),
                      "as in place.scale=2 or operation.NAME.feed=600");
  }
  const std::string_view name = cut_front(rest);
  return make_error(base::Code::job_key, {}, "there is no operation " + shown(name),
                    nearest_hint(name, names));
}

bool is_there(const Named& named) { return !std::holds_alternative<std::nullptr_t>(named.owner); }

/// Goes into the table of a key, as lead_in of an operation.
void go_inside(Named& named, std::string_view& path) {
  if (path.find('.') == std::string_view::npos) return;
  std::string_view rest = path;
  const JobKey* const key = find_key(named.table, cut_front(rest));
  if (!is_taken(key, named.process) || key->takes.form != Takes::Form::table) return;
  named = {table_inside(*key), key->inside(named.owner), named.process};
  path = rest;
}

/// Texts and words may stand without quotes.
toml::table parsed(const Takes& takes, std::string_view value) {
  const bool is_text = takes.form == Takes::Form::text || takes.form == Takes::Form::word;
  const auto as_text = [&] { return toml::table{{"v", std::string(value)}}; };
  try {
    toml::table table = toml::parse("v = " + std::string(value));
    const toml::node* const node = table.get("v");
    if (table.size() != 1 || node == nullptr) return as_text();
    return is_text && !node->is_string() ? as_text() : table;
  } catch (const toml::parse_error&) {
    return as_text();
  }
}

/// What stands instead of the key is said no more.
void make_room(const JobKey& key, const KeyOwner& owner) {
  if (key.table != KeyTable::operation) return;
  Operation& operation = *std::get<Operation*>(owner);
  const bool is_pulse = key.name == "ton_ms" || key.name == "toff_ms";
  if (key.name == "power" || key.name == "frequency_hz") operation.ton_ms = operation.toff_ms = {};
  if (is_pulse) operation.power_percent = operation.frequency_hz = {};
  if (key.name == "feed") operation.ms_per_mm = {};
  if (key.name == "ms_per_mm") operation.feed = {};
  if (key.name == "pulses") operation.dwell_s = {};
  if (key.name == "dwell_s") operation.pulses = {};
}

/// Sets a key; what is wrong otherwise.
std::optional<base::Diagnostic> say(const Named& named, std::string_view name,
                                    const toml::node& node) {
  const JobKey* const key = find_key(named.table, name);
  if (!is_taken(key, named.process)) return unknown_key(named.table, name, named.process, {});
  if (key->takes.form == Takes::Form::table && node.is_table()) {
    const Named inner{table_inside(*key), key->inside(named.owner), named.process};
    for (const auto& [inner_name, inner_node] : *node.as_table()) {
      if (auto wrong = say(inner, inner_name.str(), inner_node)) return wrong;
    }
    return std::nullopt;
  }
  const auto value = value_of(key->takes, node);
  if (!value) return wrong_value(*key, node, {});
  make_room(*key, named.owner);
  process::say(*key, named.owner, *value);
  return std::nullopt;
}

std::optional<base::Diagnostic> say(Recipe& recipe, std::string_view path, std::string_view value) {
  const std::string_view whole = path;
  Named named = find_table(recipe, path);
  if (!is_there(named)) return no_table(whole, recipe);
  go_inside(named, path);
  const JobKey* const key = find_key(named.table, path);
  const toml::table table = parsed(key == nullptr ? Takes{} : key->takes, value);
  return say(named, path, *table.get("v"));
}

}  // namespace

tl::expected<Recipe, Diagnostics> read_recipe(const std::string& text, const std::string& source,
                                              base::FileId file) {
  RecipeReader reader{text, file};
  Recipe recipe;
  recipe.source = source;
  try {
    reader.read(toml::parse(base::without_byte_order_mark(text), source), recipe);
  } catch (const toml::parse_error& error) {
    return tl::unexpected(only_one(make_error(
        base::Code::job_value, reader.place_of(error.source()), std::string(error.description()))));
  }
  for (base::Diagnostic& each :
       check_recipe(recipe, [&](const std::string& path) { return reader.place_of(path); }))
    reader.tell(std::move(each));
  Diagnostics found = reader.findings();
  if (!found.empty()) return tl::unexpected(first_of(std::move(found)));
  return recipe;
}

Diagnostics set(Recipe& recipe, std::string_view key, std::string_view value) {
  Recipe changed = recipe;
  if (auto wrong = say(changed, key, value)) return only_one(std::move(*wrong));
  recipe = std::move(changed);
  return {};
}

Diagnostics contradictions(const Recipe& recipe) {
  return first_of(check_recipe(recipe, [](const std::string&) { return base::Place{}; }));
}

}  // namespace kerf::process
