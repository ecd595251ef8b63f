#pragma once

#include <string>

#include "base/result.hpp"

namespace kerf::server {

/// Holds a data folder for one server, as long as it lives: two in one folder would write over each
/// other. The file `lock` stays behind; what counts is the lock on it, which ends with the process.
class FolderLock {
 public:
  /// Of a folder that is there. Failure (output): it cannot be written, or another server has it.
  [[nodiscard]] static base::Outcome<FolderLock> take(const std::string& folder);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace kerf::server
