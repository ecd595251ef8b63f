#pragma once

#include <cstdint>

#include "lang/vm/code_page.hpp"
#include "lang/vm/fault.hpp"

namespace kerf::vm {

/// What happens after a block.
enum class Verdict : std::uint8_t {
  go_on,        ///< with the next instruction
  transferred,  ///< the host has called, returned or jumped: go on there
  pause,        ///< give control back to whoever runs the interpreter; resumable
  again,        ///< of read() and write(): likewise, and ask once more when it goes on
  stop          ///< the program is over: its end, or an alarm
};

/// What gives a program's blocks their meaning. The interpreter asks; during each call
/// Interpreter::place() tells the text that is running.
class Host {
 public:
  virtual ~Host() = default;

  /// Executes a block. `registers` are those of the running frame.
  virtual Verdict execute(const CodePage& page, std::uint32_t block, const double* registers) = 0;

  /// Reads a variable that is not a register or a global: go_on, again (it cannot be told yet), or
  /// stop, when the host has reported why not.
  virtual Verdict read(double number, double& value) = 0;
  /// Writes one. What happens then: go_on, again, pause or stop.
  virtual Verdict write(double number, double value) = 0;

  /// An instruction failed. The program is over.
  virtual void fault(Fault fault) = 0;

  /// The text of this block was wrong. The program is over.
  virtual void failure(const base::Diagnostic& diagnostic) = 0;

  /// Control ran off the end of the code.
  virtual Verdict end_of_code() = 0;

  /// A block begins; only called while tracing. Anything but go_on leaves the block for later.
  virtual Verdict begin_block(const CodePage& page, const BlockMark& mark) = 0;
};

}  // namespace kerf::vm
