#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/motion.hpp"
#include "output/programs/post_flavour.hpp"

namespace kerf::output {

/// How a posted program is written.
struct PostSettings {
  const PostFlavour& flavour = post_flavours().front();
  /// Letters of axes that are written besides X Y Z; none: those that the flavour has.
  std::optional<std::string> axes = std::nullopt;
};

/// Writes motions as a program of G-code, whoever makes them: a run, or a plan that no program
/// stands behind. Nothing is in the file before finish().
class PostWriter : public motion::MotionSink {
 public:
  /// Text for people at this place, of that source line.
  virtual void comment(const std::string& text, std::uint32_t line) = 0;
  /// Pulses of the beam from here on, at a frequency that is not the machine's. No flavour has a
  /// word for it: it is lost.
  virtual void frequency(double hz, std::uint32_t line) = 0;
  /// Writes the file, with an end if there was none. The last call.
  virtual void finish() = 0;
  /// How many things are only a comment.
  [[nodiscard]] virtual std::uint64_t lost() const = 0;
  /// How many they are, for people: an indented line, or nothing.
  [[nodiscard]] virtual std::string remark() const = 0;
  /// `{"flavour":…,"lost":[…]}`, for the summary.
  [[nodiscard]] virtual std::string json() const = 0;
  /// The control's table of tools as the program wants it: of LinuxCNC a .tbl, of FANUC a punch-out
  /// of G10. Empty: the flavour has none.
  [[nodiscard]] virtual std::string tools() const = 0;
};

/// The writer for a machine. Machine and file must outlive it; `program` as people call it. Null:
/// no control of that flavour turns, and the machine is a lathe.
[[nodiscard]] std::unique_ptr<PostWriter> make_post(const machine::MachineDefinition& machine,
                                                    std::string program, base::OutputFile& file,
                                                    const PostSettings& settings = {});

}  // namespace kerf::output
