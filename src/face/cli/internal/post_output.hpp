#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/output_files.hpp"
#include "output/programs/post_writer.hpp"

namespace kerf::cli {

/// --post with what belongs to it: the program, and the table of tools that it asks for.
class PostOutput {
 public:
  /// Both must outlive this.
  PostOutput(const CommonOptions& options, OutputFiles& files) : options_(options), files_(files) {}

  /// Opens the files, if --post asks for one. `title`: what people call the program. Failure
  /// (usage): the options do not fit each other or the machine; (output): a file cannot be written.
  [[nodiscard]] base::Outcome<void> open(const machine::MachineDefinition& machine,
                                         const std::string& title);
  /// What takes the motions; null: nothing was asked for.
  [[nodiscard]] output::PostWriter* writer() const { return writer_.get(); }
  /// Before the files are completed: with --post-strict a program that has lost something is left
  /// out, unless --keep-partial asks for it.
  void judge();
  /// Something is lost, and --post-strict was given.
  [[nodiscard]] bool fails() const;
  /// JSON, of a program that was finished or left out for what it lost; else empty.
  [[nodiscard]] const std::string& report() const { return report_; }
  /// For people: indented lines.
  [[nodiscard]] std::string remark() const { return report_.empty() ? "" : writer_->remark(); }

 private:
  [[nodiscard]] base::Outcome<const output::PostFlavour*> flavour() const;
  [[nodiscard]] base::Outcome<void> check_alone() const;
  [[nodiscard]] base::Outcome<void> check_axes(const machine::MachineDefinition& machine) const;
  [[nodiscard]] base::Outcome<void> open_tools(const output::PostFlavour& flavour);

  const CommonOptions& options_;
  OutputFiles& files_;
  std::unique_ptr<output::PostWriter> writer_;
  std::string report_;
};

}  // namespace kerf::cli
