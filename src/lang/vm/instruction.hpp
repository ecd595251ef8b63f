#pragma once

#include <cstdint>

namespace kerf::vm {

/// The instructions. R[x] is a register of the running frame, K[n] a constant of the page, V[n] the
/// register n, or from kRegisters on the global n - kRegisters.
/// Arithmetic reads null as 0. `a`, `b`, `c` are registers, `n` is the operand.
enum class Op : std::uint8_t {
  load_constant,      ///< R[a] = K[n]
  load_null,          ///< R[a] = null
  move,               ///< R[a] = R[b]
  load_global,        ///< R[a] = global n
  store_global,       ///< global n = R[a]
  read,               ///< R[a] = the host's variable R[b]
  write,              ///< the host's variable R[a] = R[b]
  read_fixed,         ///< R[a] = the host's variable n
  write_fixed,        ///< the host's variable n = R[a]
  negate,             ///< R[a] = -R[b]
  add,                ///< R[a] = R[b] + R[c]
  subtract,           ///< R[a] = R[b] - R[c]
  multiply,           ///< R[a] = R[b] * R[c]
  divide,             ///< R[a] = R[b] / R[c]
  add_constant,       ///< R[a] = R[b] + K[n]
  subtract_constant,  ///< R[a] = R[b] - K[n]
  multiply_constant,  ///< R[a] = R[b] * K[n]
  divide_constant,    ///< R[a] = R[b] / K[n]
  equal,              ///< R[a] = 1 if R[b] equals R[c], else 0; null equals only null
  not_equal,
  less,  ///< order compares null as 0
  less_equal,
  greater,
  greater_equal,
  branch_equal,  ///< to instruction n of the page if (R[b] equals R[c]) is a (1 or 0)
  branch_not_equal,
  branch_less,
  branch_less_equal,
  branch_greater,
  branch_greater_equal,
  branch,         ///< to instruction n if (R[b] is neither 0 nor null) is a
  jump,           ///< to instruction n of the page
  jump_to_label,  ///< to the label R[b], or with c = 1 to the label n
  call_builtin,   ///< R[a] = function n of the page's table (R[b], R[b+1], …)
  do_block,       ///< the host executes block n of the page
  enter_region,   ///< region n of the page is active from here on
  leave_region,   ///< region n is over: on behind its end
  repeat_region,  ///< the end of the region in slot a: back to its head
  read_if_null,   ///< R[a], where it is null, = the host's variable n
  open_loop,      ///< a loop of V[n] from R[a] to R[a+1] by R[a+2]: if it has a pass, the next
                  ///< instruction is skipped and its passes begin behind that
  repeat_loop,    ///< next pass of the innermost loop, or with n below kAnyLoop of that of V[n]
  call_label,     ///< calls what stands at label n, in the registers of this frame
  leave_call,     ///< back behind the call
  save_variable,  ///< V[n] gets the value that it has now when this call is left
  count_steps,    ///< the next n blocks of the page are a step each
  skip_when_on,   ///< to instruction n if operator switch a is on
  note,           ///< remember n (a sequence number)
  fail,           ///< the host reports failure n of the page
  next_page,      ///< on with the page behind this one
  end_of_code     ///< there is nothing behind this
};

/// One instruction. 8 bytes.
struct Instruction {
  Op op;
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  std::uint8_t c = 0;
  std::uint32_t n = 0;
};
static_assert(sizeof(Instruction) == 8);

/// Registers of one frame. The first ones are the language's local variables.
inline constexpr std::uint32_t kRegisters = 128;

/// As the operand of repeat_loop: whichever loop is the innermost.
inline constexpr std::uint32_t kAnyLoop = ~0U;

/// Regions that can be active at once in a frame (slots 0 to 3).
inline constexpr std::uint32_t kRegionSlots = 4;

}  // namespace kerf::vm
