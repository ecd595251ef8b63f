#include "control/gcode/words/idle_words.hpp"

namespace kerf::control {
namespace {

constexpr std::uint32_t kParts = Words::mask('I') | Words::mask('J') | Words::mask('K');
constexpr std::uint32_t kOfACode =
    kParts | Words::mask('P') | Words::mask('L') | Words::mask('Q') | Words::mask('R');

// Letters that a G code gives a meaning to in its block.
std::uint32_t letters_of(GCode code) {
  switch (code) {
    case 40:   // dwell
    case 41:   // look-ahead
    case 50:   // high-speed machining
    case 80:   // look-ahead
    case 300:  // number of the reference point
    case 310:  // skip signal
    case 540:
    case 541:  // number of the work system
    case 960: return Words::mask('P');
    case 51: return Words::mask('P') | Words::mask('Q') | Words::mask('R');
    case 100:
    case 110: return kOfACode;
    case 220:
    case 400: return kParts;
    case 510: return kParts | Words::mask('P');
    case 680: return Words::mask('R');
    case 330: return Words::mask('Q');
    default: return 0;
  }
}

// The centre of an arc lies in its plane.
std::uint32_t letters_of_arc(motion::Plane plane) {
  switch (plane) {
    case motion::Plane::zx: return Words::mask('I') | Words::mask('K');
    case motion::Plane::yz: return Words::mask('J') | Words::mask('K');
    default: return Words::mask('I') | Words::mask('J');
  }
}

}  // namespace

std::uint32_t idle_words(const Words& words, const ModalState& modal, bool calls) {
  std::uint32_t rest = words.present() & kOfACode;
  if (rest == 0) return 0;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) rest &= ~letters_of(g->code);
  const GCode motion = modal[Group::motion];
  if (motion == 20 || motion == 30) rest &= ~(letters_of_arc(modal.plane()) | Words::mask('R'));
  if (motion == 330) rest &= ~Words::mask('Q');
  if (modal.in_cycle()) rest = 0;
  if (calls) rest &= ~(Words::mask('P') | Words::mask('L') | Words::mask('Q'));
  return rest;
}

}  // namespace kerf::control
