#include "control/gcode/words/idle_words.hpp"

namespace kerf::control {
namespace {

// Those that belong to some codes only.
constexpr std::uint32_t kOfACode = Words::mask("PLQRIJK");
constexpr std::uint32_t kOfACall = Words::mask("PLQ");

// The centre of an arc lies in its plane.
std::uint32_t letters_of_arc(motion::Plane plane) {
  switch (plane) {
    case motion::Plane::xy: return Words::mask("IJR");
    case motion::Plane::zx: return Words::mask("IKR");
    case motion::Plane::yz: return Words::mask("JKR");
  }
  return 0;
}

}  // namespace

std::uint32_t idle_words(const Words& words, const ModalState& modal, bool calls) {
  std::uint32_t rest = words.present() & kOfACode;
  if (rest == 0) return 0;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->row != nullptr) rest &= ~Words::mask(g->row->letters);
  }
  const bool on_face = modal[Group::polar_interpolation] == Meaning::polar_interpolation_on;
  if (modal.circular()) rest &= ~(on_face ? Words::mask("IJR") : letters_of_arc(modal.plane()));
  if (const CodeRow* const motion = modal.row(Group::motion)) rest &= ~Words::mask(motion->letters);
  if (modal.in_cycle()) rest = 0;
  if (calls) rest &= ~kOfACall;
  return rest;
}

}  // namespace kerf::control
