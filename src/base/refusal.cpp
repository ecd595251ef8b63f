#include "base/refusal.hpp"

#include <array>
#include <cassert>
#include <string_view>

namespace kerf::base {
namespace {

struct Row {
  std::string_view code;
  std::string_view sentence;
};

constexpr std::array kTable = {
#define REFUSAL(enumerator, code, sentence) Row{code, sentence},
#include "base/refusals.def"
#undef REFUSAL
};

}  // namespace

Failure refuse(Refusal which, std::vector<std::string> values) {
  const Row& row = kTable[static_cast<std::size_t>(which)];
  Failure failure{Failure::Kind::usage, {}, std::string(row.code), {}};
  std::string_view rest = row.sentence;
  for (std::string& value : values) {
    const std::size_t open = rest.find('{');
    const std::size_t close = rest.find('}');
    assert(open != std::string_view::npos && close > open);
    failure.message += std::string(rest.substr(0, open)) + value;
    failure.values.push_back(
        {std::string(rest.substr(open + 1, close - open - 1)), std::move(value)});
    rest.remove_prefix(close + 1);
  }
  assert(rest.find('{') == std::string_view::npos);
  failure.message += rest;
  return failure;
}

Failure refuse_for(std::string alarm, Refusal which, std::vector<std::string> values) {
  Failure failure = refuse(which, std::move(values));
  failure.values.push_back({"alarm", std::move(alarm)});
  return failure;
}

}  // namespace kerf::base
