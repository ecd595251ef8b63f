#include "base/diagnostic_code.hpp"

#include <cstddef>

namespace kerf::base {
namespace {

// "cause | remedy"
constexpr std::string_view kBetween = " | ";
constexpr std::string_view cause_of(std::string_view text) {
  return text.substr(0, text.find(kBetween));
}
constexpr std::string_view remedy_of(std::string_view text) {
  const std::size_t at = text.find(kBetween);
  return at == std::string_view::npos ? std::string_view() : text.substr(at + kBetween.size());
}

// No std::array without a size: clang folds no more than 256 arguments to find it out.
// NOLINTNEXTLINE(modernize-avoid-c-arrays)
constexpr CodeText kCodes[] = {
#define CODE(name, number, message, text) \
  CodeText{#name, number, message, cause_of(text), remedy_of(text)},
#include "base/diagnostic_codes.def"
#undef CODE
};

}  // namespace

const CodeText& text_of(Code code) { return kCodes[static_cast<std::size_t>(code)]; }

}  // namespace kerf::base
