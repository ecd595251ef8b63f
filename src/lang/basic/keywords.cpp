#include "lang/basic/keywords.hpp"

#include <algorithm>
#include <array>

namespace kerf::basic {
namespace {

struct Row {
  std::string_view text;
  Word word;
};

constexpr std::array kWords = {
    Row{"LET", Word::let},        Row{"PRINT", Word::print}, Row{"INPUT", Word::input},
    Row{"IF", Word::if_},         Row{"THEN", Word::then},   Row{"ELSE", Word::else_},
    Row{"FOR", Word::for_},       Row{"TO", Word::to},       Row{"STEP", Word::step},
    Row{"NEXT", Word::next},      Row{"GOTO", Word::go_to},  Row{"GOSUB", Word::gosub},
    Row{"RETURN", Word::return_}, Row{"END", Word::end},     Row{"HOME", Word::home},
    Row{"SPEED", Word::speed},    Row{"POWER", Word::power}, Row{"MOVE", Word::move},
    Row{"LINE", Word::line},      Row{"ARC", Word::arc},     Row{"CIRCLE", Word::circle},
    Row{"WAIT", Word::wait},      Row{"BURN", Word::burn},   Row{"PULSE", Word::pulse},
    Row{"AIR", Word::air},        Row{"LOCAL", Word::local}, Row{"AND", Word::and_},
    Row{"OR", Word::or_},         Row{"NOT", Word::not_},    Row{"REM", Word::rem},
    Row{"SIN", Word::sin},        Row{"COS", Word::cos},     Row{"TAN", Word::tan},
    Row{"ATN", Word::atn},        Row{"ATAN", Word::atn},    Row{"ASIN", Word::asin},
    Row{"ACOS", Word::acos},      Row{"SQR", Word::sqr},     Row{"SQRT", Word::sqr},
    Row{"ABS", Word::abs},        Row{"INT", Word::int_},    Row{"SGN", Word::sgn},
    Row{"EXP", Word::exp},        Row{"LOG", Word::log},     Row{"DEG", Word::deg},
    Row{"RAD", Word::rad},        Row{"ATAN2", Word::atan2}, Row{"MIN", Word::min},
    Row{"MAX", Word::max},        Row{"MOD", Word::mod},     Row{"DIST", Word::dist},
    Row{"XPOS", Word::xpos},      Row{"YPOS", Word::ypos},   Row{"ZPOS", Word::zpos},
    Row{"MOVED", Word::moved}};

constexpr auto kTexts = [] {
  std::array<std::string_view, kWords.size()> texts{};
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = kWords[i].text;
  return texts;
}();

}  // namespace

std::span<const std::string_view> key_words() { return kTexts; }

Word word_of(std::string_view capitals) {
  const auto row = std::find_if(kWords.begin(), kWords.end(),
                                [&](const Row& candidate) { return candidate.text == capitals; });
  return row == kWords.end() ? Word::none : row->word;
}

}  // namespace kerf::basic
