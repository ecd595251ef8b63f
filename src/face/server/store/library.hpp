#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "face/server/store/revisions.hpp"

namespace kerf::server {

struct ProgramInfo {
  std::string name;
  std::uint64_t bytes = 0;
  std::int64_t modified_ms = 0;  ///< since 1970, UTC
};

/// The programs on disk: files of one folder, each save a revision.
///
/// Never outside of the folder: names are names of files (check_program_name()), and what is no
/// regular file, a symbolic link above all, is not touched. A file that something else has changed
/// is taken over as a revision before it is replaced. What a call reports as done is on the disk,
/// what it refuses has changed nothing.
/// Failures: (usage) the name, or there is no such program; (output) the disk.
class Library {
 public:
  static constexpr std::uint64_t kMostReadBytes = 4U << 20U;
  static constexpr std::uint64_t kMostBytes = 256U << 20U;  ///< of one program
  static constexpr std::size_t kMostPrograms = 10'000;

  /// Makes the folder if it is not there. Failure (output).
  [[nodiscard]] static base::Outcome<std::unique_ptr<Library>> open(const std::string& folder,
                                                                    const std::string& database);

  /// In the order of their names.
  [[nodiscard]] base::Outcome<std::vector<ProgramInfo>> programs() const;
  /// The text of a program of at most kMostReadBytes.
  [[nodiscard]] base::Outcome<std::string> read(const std::string& name) const;
  [[nodiscard]] base::Outcome<std::string> read_revision(const std::string& name,
                                                         std::int64_t number);
  [[nodiscard]] base::Outcome<std::vector<Revision>> revisions(const std::string& name);
  /// Its path, for whoever reads it piece by piece.
  [[nodiscard]] base::Outcome<std::string> path_of(const std::string& name) const;

  [[nodiscard]] base::Outcome<Revision> write(const std::string& name, const std::string& text);
  [[nodiscard]] base::Outcome<void> rename(const std::string& from, const std::string& to);
  /// Its revisions stay: it can be had back.
  [[nodiscard]] base::Outcome<void> remove(const std::string& name);

  /// What a program was set up with last (docs/set-up.md); empty: it was not. Of any name that a
  /// program may have; it goes with the program when that is renamed.
  [[nodiscard]] base::Outcome<std::string> set_up(const std::string& name);
  [[nodiscard]] base::Outcome<void> keep_set_up(const std::string& name, const std::string& toml);

  /// Writes what an edit has made of a program, and keeps its report, to take it back.
  [[nodiscard]] base::Outcome<Revision> write_edited(const std::string& name,
                                                     const std::string& text,
                                                     const std::string& report);
  /// An edit that is kept.
  struct KeptEdit {
    std::int64_t number = 0;
    std::string report;
    std::size_t before = 0;  ///< how many there are besides, which were made before it
  };
  /// The last one; nothing: none is kept. It goes with the program when that is renamed.
  [[nodiscard]] base::Outcome<std::optional<KeptEdit>> last_edit(const std::string& name);
  /// Writes what the program was before its last edit, which is kept no longer.
  [[nodiscard]] base::Outcome<Revision> write_unedited(const std::string& name,
                                                       const std::string& text,
                                                       const KeptEdit& edit);

  /// A file under a temporary name in the folder, for an upload that comes in pieces.
  [[nodiscard]] base::Outcome<std::unique_ptr<base::OutputFile>> begin_upload(
      const std::string& name) const;
  [[nodiscard]] base::Outcome<Revision> finish_upload(const std::string& name,
                                                      base::OutputFile& upload);

  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  Library(std::string folder, std::unique_ptr<Revisions> revisions)
      : folder_(std::move(folder)), revisions_(std::move(revisions)) {}

  [[nodiscard]] std::string join(const std::string& name) const { return folder_ + "/" + name; }
  [[nodiscard]] base::Outcome<void> check_room_for(const std::string& name) const;
  void take_over(const std::string& name);
  [[nodiscard]] base::Outcome<Revision> note(const std::string& name, const std::string& path);

  std::string folder_;
  std::unique_ptr<Revisions> revisions_;
};

}  // namespace kerf::server
