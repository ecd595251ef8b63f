#include "base/source_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

#include "temporary_folder.hpp"

namespace kerf::base {
namespace {

using test::TemporaryFolder;

std::string read(const SourceFile& file, std::uint64_t offset, std::size_t count) {
  std::string text(count, '\0');
  text.resize(file.read(offset, text));
  return text;
}

std::unique_ptr<SourceFile> open(const std::string& path) {
  auto file = SourceFile::open(path);
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? std::move(*file) : nullptr;
}

void expect_input_failure(const std::string& path) {
  const auto file = SourceFile::open(path);
  ASSERT_FALSE(file) << path << " could be opened";
  EXPECT_EQ(file.error().kind, Failure::Kind::input);
  EXPECT_NE(file.error().message.find(path), std::string::npos) << file.error().message;
}

// Opens a pipe into which another thread writes `text`.
std::unique_ptr<SourceFile> open_pipe(const std::string& text) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return nullptr;
  std::jthread writer([&] {
    std::string_view rest = text;
    while (!rest.empty()) {
      const ssize_t count = ::write(ends[1], rest.data(), std::min<std::size_t>(rest.size(), 7000));
      if (count <= 0) break;
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
    ::close(ends[1]);
  });
  auto file = open("/dev/fd/" + std::to_string(ends[0]));
  writer.join();
  ::close(ends[0]);
  return file;
}

TEST(SourceFile, ReadsAnyStretchOfAFile) {
  const TemporaryFolder folder;
  const auto file = open(folder.write("part.nc", "0123456789"));
  EXPECT_EQ(file->size(), 10U);
  EXPECT_EQ(file->name(), folder / "part.nc");
  EXPECT_EQ(read(*file, 0, 4), "0123");
  EXPECT_EQ(read(*file, 7, 100), "789");
  EXPECT_EQ(read(*file, 3, 2), "34");
  EXPECT_EQ(read(*file, 10, 1), "");
  EXPECT_EQ(read(*file, 1ULL << 60, 1), "");
}

TEST(SourceFile, ReadsBehindFourGibibytes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("part.nc", "");
  constexpr std::uint64_t kFar = 5ULL << 30;
  std::filesystem::resize_file(path, kFar);
  std::ofstream(path, std::ios::binary | std::ios::app) << "M30\n";
  const auto file = open(path);
  EXPECT_EQ(file->size(), kFar + 4);
  EXPECT_EQ(read(*file, kFar, 10), "M30\n");
  EXPECT_EQ(file->line_at(kFar, 10), "M30");
}

TEST(SourceFile, OfTextReadsAsOneOnDisk) {
  const auto file = SourceFile::from_text("MDI", "G00X1.\nM30\n");
  EXPECT_EQ(file->name(), "MDI");
  EXPECT_EQ(file->size(), 11U);
  EXPECT_EQ(read(*file, 7, 100), "M30\n");
  EXPECT_EQ(read(*file, 11, 1), "");
}

TEST(SourceFile, GivesALineWithoutItsEnd) {
  const auto file = SourceFile::from_text("MDI", "one\ntwo\r\nthree\rfour");
  EXPECT_EQ(file->line_at(0, 100), "one");
  EXPECT_EQ(file->line_at(4, 100), "two");
  EXPECT_EQ(file->line_at(9, 100), "three");
  EXPECT_EQ(file->line_at(15, 100), "four");
  EXPECT_EQ(file->line_at(9, 3), "thr");
  EXPECT_EQ(file->line_at(100, 10), "");
}

TEST(SourceFile, CopiesAPipeAndReadsItMoreThanOnce) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += std::to_string(i) + "\n";
  const auto file = open_pipe(text);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size(), text.size());
  EXPECT_TRUE(read(*file, 0, text.size() + 1) == text) << "the copy differs";
  EXPECT_EQ(read(*file, 5000, 10), text.substr(5000, 10));
}

TEST(SourceFile, OfAnEmptyPipeIsEmpty) {
  const auto file = open_pipe("");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size(), 0U);
  EXPECT_EQ(read(*file, 0, 10), "");
}

TEST(SourceFile, TheCopyOfAPipeHasNoName) {
  const TemporaryFolder folder;
  ::setenv("TMPDIR", (folder / "").c_str(), 1);
  const auto file = open_pipe("text");
  ::unsetenv("TMPDIR");
  ASSERT_TRUE(file);
  EXPECT_EQ(folder.files(), std::vector<std::string>{});
}

TEST(SourceFile, OfAPipeFailsWhereNothingCanBeCopiedTo) {
  const TemporaryFolder folder;
  ::setenv("TMPDIR", (folder / "gone").c_str(), 1);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[1]);
  expect_input_failure("/dev/fd/" + std::to_string(ends[0]));
  ::close(ends[0]);
  ::unsetenv("TMPDIR");
}

TEST(SourceFile, ThatIsMissingOrAFolderIsAFailureOfTheInput) {
  const TemporaryFolder folder;
  expect_input_failure(folder / "gone.nc");
  expect_input_failure(folder / "");
  expect_input_failure("");
}

TEST(SourceFile, CutShortBehindItsOpeningReadsWhatIsLeft) {
  const TemporaryFolder folder;
  const std::string path = folder.write("part.nc", "0123456789");
  const auto file = open(path);
  std::filesystem::resize_file(path, 4);
  EXPECT_EQ(read(*file, 2, 100), "23");
  EXPECT_EQ(read(*file, 6, 2), "");
}

TEST(SourceSet, FilesKeepTheirIds) {
  SourceSet set;
  const FileId one = set.add(SourceFile::from_text("one", "1"));
  const FileId two = set.add(SourceFile::from_text("two", "2"));
  EXPECT_EQ(set[one].name(), "one");
  EXPECT_EQ(set[two].name(), "two");
  EXPECT_TRUE(set.contains(two));
  EXPECT_FALSE(set.contains(kNoFile));
}

TEST(SourceFile, WhatHasNoEndIsRefusedByItsSizeAndByTime) {
  const auto by_size = SourceFile::open("/dev/zero", {.most_bytes = 1 << 20});
  ASSERT_FALSE(by_size);
  EXPECT_NE(by_size.error().message.find("does not end within 1 MiB"), std::string::npos)
      << by_size.error().message;
  const auto by_time = SourceFile::open("/dev/zero", {.seconds = 0.01});
  ASSERT_FALSE(by_time);
  EXPECT_NE(by_time.error().message.find("does not end within 0.01 s"), std::string::npos)
      << by_time.error().message;
}

TEST(SourceFile, ASettingIsReadWholeOrRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("settings", "twelve bytes");
  EXPECT_EQ(*read_whole(path, 12, "a state file"), "twelve bytes");
  const auto larger = read_whole(path, 11, "a state file");
  ASSERT_FALSE(larger);
  EXPECT_NE(larger.error().message.find("too large for a state file"), std::string::npos);
  EXPECT_FALSE(read_whole("/dev/full", 1 << 20, "a state file"));
}

}  // namespace
}  // namespace kerf::base
