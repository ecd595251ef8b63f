#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "job/edit_result.hpp"
#include "job/job.hpp"

namespace kerf::job {

/// Texts behind an edit where a run finds them: the files of the library in a folder of their own,
/// which is gone when this is.
class ChangedLibrary {
 public:
  [[nodiscard]] static base::Outcome<ChangedLibrary> of(const std::vector<EditedText>& texts);

  /// The job with these texts instead of those that they were.
  void change(Job& job) const;

 private:
  struct Folder;
  explicit ChangedLibrary(const std::vector<EditedText>& texts) : texts_(texts) {}

  const std::vector<EditedText>& texts_;
  std::shared_ptr<const Folder> folder_{};  // none: no file of the library changes
};

}  // namespace kerf::job
