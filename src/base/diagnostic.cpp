#include "base/diagnostic.hpp"

#include <algorithm>
#include <cctype>

namespace kerf::base {
namespace {

// Of the table's text: all in capitals, as controls show it, or else as it is to be read.
std::string sentence(std::string_view text) {
  std::string result(text);
  const bool shouted =
      std::none_of(text.begin(), text.end(), [](unsigned char c) { return std::islower(c) != 0; });
  if (!shouted) return result;
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

}  // namespace

Diagnostic make_error(Code code, const Place& place, const std::string& detail,
                      const std::string& hint) {
  const CodeText& text = text_of(code);
  std::string message = sentence(text.message);
  if (!detail.empty()) message += ": " + detail;
  return {Severity::error, code, std::string(text.number), std::move(message), place, {}, hint};
}

}  // namespace kerf::base
