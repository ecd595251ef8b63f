#include "machine/definition/internal/toml_value.hpp"

#include "base/decimal.hpp"

namespace kerf::machine {

std::string text_of(const toml::node& node) {
  if (const auto text = node.value<std::string>()) return *text;
  if (const auto flag = node.as_boolean()) return flag->get() ? "1" : "0";
  if (const auto number = node.value<double>()) return base::number_text(*number);
  return {};
}

std::optional<double> value_of(const Takes& takes, const toml::node& node) {
  switch (takes.form) {
    case Takes::Form::word: return value_of(takes, std::string_view(text_of(node)));
    case Takes::Form::flag:
      if (!node.is_boolean()) return {};
      return node.as_boolean()->get() ? 1 : 0;
    case Takes::Form::number:
    case Takes::Form::whole_number: break;
  }
  const auto number = node.is_number() ? node.value<double>() : std::nullopt;
  return number && admits(takes, *number) ? number : std::nullopt;
}

tl::unexpected<base::Failure> wrong_at(const std::string& source, const toml::node* node,
                                       const std::string& what) {
  std::string where = source;
  if (node != nullptr) where += ":" + std::to_string(node->source().begin.line);
  return tl::unexpected(base::Failure{base::Failure::Kind::input, where + ": " + what});
}

}  // namespace kerf::machine
