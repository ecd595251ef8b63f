#include "job/changed_library.hpp"

#include <filesystem>
#include <utility>

#include "base/output_file.hpp"

namespace kerf::job {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFolders = 10'000;  // that other runs have there

/// A new one where temporary files go; empty: there can be none.
fs::path new_folder() {
  std::error_code error;
  const fs::path around = fs::temp_directory_path(error);
  for (int i = 0; i < kMostFolders && !error; ++i) {
    fs::path folder = around / ("kerf-edit-" + std::to_string(i));
    std::error_code taken;
    if (fs::create_directory(folder, taken)) return folder;
    if (taken && taken != std::errc::file_exists) break;
  }
  return {};
}

}  // namespace

struct ChangedLibrary::Folder {
  fs::path path{};

  Folder() : path(new_folder()) {}
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code gone;
    if (!path.empty()) fs::remove_all(path, gone);
  }
};

base::Outcome<ChangedLibrary> ChangedLibrary::of(const std::vector<EditedText>& texts) {
  ChangedLibrary library(texts);
  for (const EditedText& text : texts) {
    if (text.is_main) continue;
    if (!library.folder_) library.folder_ = std::make_shared<const Folder>();
    const fs::path path = library.folder_->path / fs::path(text.file).filename();
    auto file = base::OutputFile::create(path.string());
    if (!file) return tl::unexpected(file.error());
    (*file)->write(text.after);
    if (auto written = (*file)->commit(); !written) return tl::unexpected(written.error());
  }
  return library;
}

void ChangedLibrary::change(Job& job) const {
  for (const EditedText& text : texts_) {
    if (text.is_main) job.program = base::ProgramText::of(job.program.name, text.after);
  }
  if (!folder_) return;
  auto& folders = job.settings.library_folders;
  folders.insert(folders.begin(), folder_->path.string());
}

}  // namespace kerf::job
