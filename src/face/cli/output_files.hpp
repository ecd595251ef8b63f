#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/output_file.hpp"
#include "drive/pulse_sink.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::cli {

/// Whether two paths lead to one ordinary file, under whatever names: what is written to one of
/// them is then read from the other. Streams and devices are no such files.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// The output files of a run or replay: opened before it, so that one that cannot be written is
/// told at once; committed behind it, so that none looks complete that is not.
class OutputFiles {
 public:
  /// What could drive a machine is written only when the run reached its end.
  enum class Kind : std::uint8_t { record, drives_a_machine };
  using Finish = std::function<void(base::OutputFile&)>;

  /// A file that is read: none of these may be written. Empty: none.
  void keep_from(const std::string& input) { inputs_.push_back(input); }
  /// Opens the file and has it used; does nothing where `path` is empty: not asked for. Failure
  /// (usage): it is an input, or another output; (output): it cannot be written.
  template <typename Use>
  [[nodiscard]] base::Outcome<void> open(const std::string& path, Kind kind, Use&& use) {
    if (path.empty()) return {};
    auto file = create(path, kind);
    if (!file) return tl::unexpected(file.error());
    std::forward<Use>(use)(**file);
    return {};
  }
  /// Of the file that was opened last: writes what is known only behind the run.
  void when_over(Finish finish) { files_.back().finish = std::move(finish); }

  /// An open file is not to be completed: it is removed.
  void leave_out(const std::string& path);
  enum class Which : std::uint8_t { all, records_only };
  /// Completes the files; those left out are removed. Failure (output): the first one that did not
  /// reach the disk; the others are written.
  [[nodiscard]] base::Outcome<void> commit(Which which);
  /// The files that commit() has written, for people.
  [[nodiscard]] const std::vector<std::string>& written() const { return written_; }

 private:
  struct File {
    Kind kind = Kind::record;
    std::unique_ptr<base::OutputFile> file;
    Finish finish;
  };
  [[nodiscard]] base::Outcome<void> check_alone(const std::string& path) const;
  base::Outcome<base::OutputFile*> create(const std::string& path, Kind kind);
  base::Outcome<void> commit(File& file);

  std::vector<File> files_;  // in the order in which they are completed
  std::vector<std::string> inputs_;
  std::vector<std::string> written_;
};

[[nodiscard]] inline bool is_png(const std::string& path) { return path.ends_with(".png"); }

/// Failure (usage): the file of this option has not the ending of a picture. None asked for fits.
[[nodiscard]] base::Outcome<void> check_picture(const std::string& option, const std::string& path);

/// The sink of --pulses `path` for the motors of the machine; null where none is asked for. Failure
/// (usage): it is neither .csv nor .vcd; (output): it cannot be written.
[[nodiscard]] base::Outcome<std::unique_ptr<drive::PulseSink>> open_pulse_file(
    OutputFiles& files, const std::string& path, const machine::MachineDefinition& machine);

}  // namespace kerf::cli
