#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/plan/edit_check.hpp"

namespace kerf::job {

/// Lines of a file that an edit has replaced, with their line ends.
struct TextChange {
  std::string file{};  ///< as the user wrote it
  std::uint32_t first =
      0;  ///< of the old text, from 1; of an insertion the line that it stands before
  std::vector<std::string> old_lines{};
  std::vector<std::string> new_lines{};
};

/// A file that an edit changes.
struct EditedText {
  std::string file{};
  bool is_main = true;
  std::string before{};
  std::string after{};
};

/// What the report of an edit tells (features-contract §9).
struct EditReport {
  std::size_t edits = 0;
  std::vector<TextChange> changes{};
  std::uint64_t bytes_changed = 0;
  std::uint32_t crc32 = 0;  ///< of the whole result, main file
  struct Blocks {
    std::uint32_t kept = 0;
    std::uint32_t patched = 0;
    std::uint32_t inserted = 0;
    std::uint32_t removed = 0;
  } blocks{};
  struct Regenerated {
    std::string feature{};
    std::vector<std::size_t> layers{};
  };
  std::vector<Regenerated> regenerated{};
  std::vector<features::RenamedLayer> ids{};
  features::VerifiedEdit verified{};
  std::vector<features::EditFault> warnings{};  ///< EDIT_NO_CHANGE and the like
};

/// An edit that was made and verified.
struct EditResult {
  std::vector<EditedText> texts{};  ///< those that change; empty: none does
  EditReport report{};
};

struct EditWishes {
  std::vector<features::Edit> edits{};
  bool allows_collision = false;
  bool allows_rest = false;
  bool allows_other_files = false;  ///< those of the library may change
};

}  // namespace kerf::job
