#include "process/internal/key_value.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "process/internal/nearest_name.hpp"

namespace kerf::process {
namespace {

using Form = Takes::Form;
using Value = std::optional<KeyValue>;

constexpr std::size_t kLongestText = 1000;
constexpr std::size_t kMostTexts = 1000;
constexpr std::size_t kMostPairs = 1000;

std::optional<double> number_in(const Takes& takes, const toml::node& node) {
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  if (!number || !(*number >= takes.low && *number <= takes.high)) return std::nullopt;
  if (!takes.low_itself && *number == takes.low) return std::nullopt;
  const bool is_whole = static_cast<double>(static_cast<std::int64_t>(*number)) == *number;
  return takes.form == Form::whole_number && !is_whole ? std::nullopt : number;
}

Value number_of(const Takes& takes, const toml::node& node) {
  const auto number = number_in(takes, node);
  if (!number) return std::nullopt;
  return KeyValue{*number};
}

Value flag_of(const toml::node& node) {
  if (!node.is_boolean()) return std::nullopt;
  return KeyValue{node.as_boolean()->get() ? 1.0 : 0.0};
}

Value text_of(const toml::node& node) {
  const toml::value<std::string>* const text = node.as_string();
  if (text == nullptr || text->get().empty() || text->get().size() > kLongestText)
    return std::nullopt;
  KeyValue value;
  value.text = text->get();
  return value;
}

Value word_of(const Takes& takes, const toml::node& node) {
  Value value = text_of(node);
  if (!value) return value;
  const std::vector<std::string_view> words = words_of(takes);
  const auto found = std::find(words.begin(), words.end(), value->text);
  if (found == words.end()) return std::nullopt;
  value->number = static_cast<double>(found - words.begin());
  value->is_word = true;
  return value;
}

Value texts_of(const toml::node& node) {
  KeyValue all;
  const auto add = [&](const toml::node& each) {
    Value one = text_of(each);
    if (one) all.texts.push_back(std::move(one->text));
    return one.has_value();
  };
  const toml::array* const list = node.as_array();
  if (list == nullptr) return add(node) ? Value(std::move(all)) : std::nullopt;
  if (list->empty() || list->size() > kMostTexts) return std::nullopt;
  for (const toml::node& each : *list) {
    if (!add(each)) return std::nullopt;
  }
  return all;
}

Value list_of(const Takes& takes, const toml::node& node, std::size_t count) {
  const toml::array* const list = node.as_array();
  if (list == nullptr || list->size() != count) return std::nullopt;
  KeyValue all;
  for (const toml::node& each : *list) {
    const auto number = number_in(takes, each);
    if (!number) return std::nullopt;
    all.numbers.push_back(*number);
  }
  return all;
}

Value pairs_of(const Takes& takes, const toml::node& node) {
  const toml::array* const list = node.as_array();
  if (list == nullptr || list->size() > kMostPairs) return std::nullopt;
  KeyValue all;
  for (const toml::node& each : *list) {
    const Value pair = list_of(takes, each, 2);
    if (!pair) return std::nullopt;
    all.numbers.insert(all.numbers.end(), pair->numbers.begin(), pair->numbers.end());
  }
  return all;
}

}  // namespace

Value value_of(const Takes& takes, const toml::node& node) {
  switch (takes.form) {
    case Form::number:
    case Form::whole_number: return number_of(takes, node);
    case Form::flag: return flag_of(node);
    case Form::word: return word_of(takes, node);
    case Form::text: return text_of(node);
    case Form::texts: return texts_of(node);
    case Form::pair: return list_of(takes, node, 2);
    case Form::triple: return list_of(takes, node, 3);
    case Form::pairs: return pairs_of(takes, node);
    case Form::number_or_pair:
      return node.is_array() ? list_of(takes, node, 2) : number_of(takes, node);
    case Form::number_or_word:
      return node.is_string() ? word_of(takes, node) : number_of(takes, node);
    case Form::word_or_pair:
      return node.is_string() ? word_of(takes, node) : list_of(takes, node, 2);
    case Form::table: return std::nullopt;
  }
  return std::nullopt;
}

std::string shown_value(const toml::node& node) {
  if (const auto* const text = node.as_string()) return '"' + shown(text->get()) + '"';
  if (const auto* const flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "this list";
  const auto number = node.value<double>();
  if (!number) return "a date or time";
  if (*number != *number) return "nan";
  if (*number - *number != 0) return *number > 0 ? "inf" : "-inf";
  return base::number_text(*number);
}

}  // namespace kerf::process
