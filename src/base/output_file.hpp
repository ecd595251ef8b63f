#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace kerf::base {

/// A file that appears whole or not at all: written under a temporary name in the same folder, and
/// renamed by commit(). Without commit() nothing is left behind. "-" is standard output, written as
/// it comes; so are devices and pipes, which cannot be renamed over.
///
/// Writing never throws and never reports: a full disk is told once, by commit().
class OutputFile {
 public:
  [[nodiscard]] static Outcome<std::unique_ptr<OutputFile>> create(const std::string& path);

  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);

  /// What was to be written could not be made, for this reason (errno): the file will not be
  /// committed.
  void fail(int error) {
    if (error_ == 0) error_ = error;
  }

  /// False as soon as a write has failed: the rest need not be made.
  [[nodiscard]] bool good() const { return error_ == 0; }
  [[nodiscard]] const std::string& path() const { return path_; }

  enum class Durability : std::uint8_t { ordinary, survives_power_loss };

  /// Everything that was written is on the disk, still under written_to(). What fails then is only
  /// the name.
  [[nodiscard]] Outcome<void> prepare(Durability durability);
  /// Where the bytes are until commit().
  [[nodiscard]] const std::string& written_to() const {
    return temporary_.empty() ? path_ : temporary_;
  }

  /// Gives the file its name. Failure: what was written did not reach the disk; then no file is
  /// left.
  [[nodiscard]] Outcome<void> commit(Durability durability = Durability::ordinary);

 private:
  OutputFile(std::string path, std::string temporary, int descriptor);
  void flush();

  std::string path_;
  std::string temporary_;               // empty: writes go straight to `path_`
  std::size_t slot_ = ~std::size_t{0};  // among the unfinished ones
  int descriptor_;
  int error_ = 0;
  std::string buffer_;
};

/// The names of a folder's files are on the disk when this returns. Failure (output).
[[nodiscard]] Outcome<void> sync_folder(const std::string& folder);

/// Removes the temporary files of every OutputFile that is not committed yet. Async-signal-safe:
/// for the handler of Ctrl-C.
void remove_unfinished_outputs() noexcept;

}  // namespace kerf::base
