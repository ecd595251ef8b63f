#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/place.hpp"
#include "base/result.hpp"

namespace kerf::base {

/// The bytes of one program file, readable at any offset, never held in memory as a whole: a file
/// of any size costs the same. Not copyable; shared by whoever points into it.
class SourceFile {
 public:
  /// What is copied, until it is refused: it may have no end.
  struct Intake {
    std::uint64_t most_bytes = std::uint64_t{1} << 30U;
    double seconds = 0;  ///< behind its first byte; 0: no limit
  };

  /// Opens a regular file, or copies what cannot be read twice (a pipe, "-" for standard input) to
  /// an unnamed temporary file first. Failure: missing, unreadable, a folder, no room to copy to,
  /// more than the intake allows.
  [[nodiscard]] static Outcome<std::unique_ptr<SourceFile>> open(const std::string& path,
                                                                 const Intake& intake);
  [[nodiscard]] static Outcome<std::unique_ptr<SourceFile>> open(const std::string& path) {
    return open(path, {});
  }

  /// A file that exists only in memory: tests, MDI, editors.
  [[nodiscard]] static std::unique_ptr<SourceFile> from_text(std::string name, std::string text);

  /// Likewise, with a text that others hold, too.
  [[nodiscard]] static std::unique_ptr<SourceFile> from_shared(
      std::string name, std::shared_ptr<const std::string> text);

  ~SourceFile();
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;

  /// As the user wrote it; "-" for standard input.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Copies bytes from `offset` into `into`; returns how many there were (less only at the end of
  /// the file, or when the file has been cut short or damaged since it was opened).
  [[nodiscard]] std::size_t read(std::uint64_t offset, std::span<char> into) const;

  /// The line that starts at byte `offset`, without its end, at most `limit` bytes.
  [[nodiscard]] std::string line_at(std::uint64_t offset, std::size_t limit) const;

 private:
  SourceFile(std::string name, int descriptor, std::uint64_t size);
  SourceFile(std::string name, std::shared_ptr<const std::string> text);

  std::string name_;
  std::shared_ptr<const std::string> text_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// The bytes of a file of settings, which `what` names: "a state file". Failure (input): it cannot
/// be opened, or has more than `most_bytes`.
[[nodiscard]] Outcome<std::string> read_whole(const std::string& path, std::uint64_t most_bytes,
                                              const std::string& what);

/// The files that one machine has opened. Files stay until the set goes.
class SourceSet {
 public:
  FileId add(std::unique_ptr<SourceFile> file);
  [[nodiscard]] const SourceFile& operator[](FileId id) const;
  [[nodiscard]] bool contains(FileId id) const;

 private:
  std::vector<std::unique_ptr<SourceFile>> files_;
};

}  // namespace kerf::base
