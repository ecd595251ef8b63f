#include "base/diagnostic.hpp"

#include <algorithm>
#include <cctype>

namespace kerf::base {
namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

}  // namespace

Diagnostic make_error(Code code, const Place& place, const std::string& detail,
                      const std::string& hint) {
  const CodeText& text = text_of(code);
  std::string message = lower_case(text.message);
  if (!detail.empty()) message += ": " + detail;
  return {Severity::error, code, std::string(text.number), std::move(message), place, {}, hint};
}

}  // namespace kerf::base
