#include "base/diagnostic_code.hpp"

#include <array>
#include <cstddef>

namespace kerf::base {
namespace {

constexpr std::array kCodes = {
#define CODE(name, number, message, cause) CodeText{#name, number, message, cause},
#include "base/diagnostic_codes.def"
#undef CODE
};

}  // namespace

const CodeText& text_of(Code code) { return kCodes[static_cast<std::size_t>(code)]; }

}  // namespace kerf::base
