#include "base/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "temporary_folder.hpp"

namespace kerf::base {
namespace {

using test::TemporaryFolder;
using Names = std::vector<std::string>;

std::unique_ptr<OutputFile> create(const std::string& path) {
  auto file = OutputFile::create(path);
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? std::move(*file) : nullptr;
}

void expect_failure(const Outcome<void>& outcome, const std::string& path) {
  ASSERT_FALSE(outcome) << "the failure was not told";
  EXPECT_EQ(outcome.error().kind, Failure::Kind::output);
  EXPECT_NE(outcome.error().message.find(path), std::string::npos) << outcome.error().message;
}

TEST(OutputFile, AppearsWithItsContentWhenItIsCommitted) {
  const TemporaryFolder folder;
  auto file = create(folder / "out");
  file->write("first ");
  file->write("second");
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "it appeared before it was whole";
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(folder.read("out"), "first second");
  EXPECT_EQ(folder.files(), Names{"out"});
}

TEST(OutputFile, LeavesNothingBehindWithoutCommit) {
  const TemporaryFolder folder;
  create(folder / "out")->write("half");
  EXPECT_EQ(folder.files(), Names{});
}

TEST(OutputFile, LeavesTheOldFileAloneUntilCommit) {
  const TemporaryFolder folder;
  folder.write("out", "old");
  auto file = create(folder / "out");
  file->write("new");
  EXPECT_EQ(folder.read("out"), "old");
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(folder.read("out"), "new");
  folder.write("kept", "old");
  create(folder / "kept")->write("new");
  EXPECT_EQ(folder.read("kept"), "old");
}

TEST(OutputFile, HoldsEveryByteOfALargeContent) {
  const TemporaryFolder folder;
  std::string wanted;
  auto file = create(folder / "out");
  for (int i = 0; i < 300'000; ++i) {
    const std::string piece = std::to_string(i) + (i % 7 == 0 ? "\n" : " ");
    file->write(piece);
    wanted += piece;
  }
  ASSERT_TRUE(file->commit(OutputFile::Durability::survives_power_loss));
  EXPECT_TRUE(folder.read("out") == wanted) << "the file differs from what was written";
}

TEST(OutputFile, IsAsReadableAsAnyNewFile) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  auto file = create(folder / "out");
  ::umask(before);
  ASSERT_TRUE(file->commit());
  struct stat status {};
  ASSERT_EQ(::stat((folder / "out").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(OutputFile, OfTheCurrentFolderNeedsNoFolderInItsName) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  const auto made = create("out")->commit(OutputFile::Durability::survives_power_loss);
  std::filesystem::current_path(before);
  EXPECT_TRUE(made);
  EXPECT_EQ(folder.files(), Names{"out"});
}

TEST(OutputFile, CannotBeMadeWhereThereIsNoFolder) {
  const TemporaryFolder folder;
  const auto file = OutputFile::create(folder / "gone/out");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, Failure::Kind::output);
  EXPECT_NE(file.error().message.find("gone/out"), std::string::npos) << file.error().message;
}

TEST(OutputFile, CannotTakeTheNameOfAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "out");
  EXPECT_FALSE(OutputFile::create(folder / "out"));
  EXPECT_EQ(folder.files(), Names{"out"});
}

TEST(OutputFile, TellsAFullDeviceByCommit) {
  auto file = create("/dev/full");
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->good());
  file->write("does not fit");
  expect_failure(file->commit(), "/dev/full");
}

TEST(OutputFile, IsNotGoodAnyMoreWhenTheDeviceIsFull) {
  auto file = create("/dev/full");
  ASSERT_TRUE(file);
  const std::string much(1 << 20, 'x');
  file->write(much);
  EXPECT_FALSE(file->good());
  for (int i = 0; i < 10; ++i) file->write(much);
  expect_failure(file->commit(), "/dev/full");
}

TEST(OutputFile, WritesThroughADeviceInPlaceOfReplacingIt) {
  auto file = create("/dev/null");
  ASSERT_TRUE(file);
  file->write("gone");
  EXPECT_TRUE(file->commit());
  struct stat status {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode)) << "/dev/null was replaced by a file";
}

TEST(OutputFile, WritesIntoAPipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  auto file = create("/dev/fd/" + std::to_string(ends[1]));
  ASSERT_TRUE(file);
  file->write("through");
  ASSERT_TRUE(file->commit());
  ::close(ends[1]);
  char text[16] = {};
  EXPECT_EQ(::read(ends[0], text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  ::close(ends[0]);
}

TEST(OutputFile, UnfinishedOnesAreRemovedOnRequestOfASignal) {
  const TemporaryFolder folder;
  auto one = create(folder / "one");
  auto two = create(folder / "two");
  auto done = create(folder / "done");
  one->write("half");
  ASSERT_TRUE(done->commit());
  remove_unfinished_outputs();
  EXPECT_EQ(folder.files(), Names{"done"});
  expect_failure(one->commit(), "one");
}

TEST(OutputFile, AHundredAtATimeAreWrittenAndLeaveNothingElse) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<OutputFile>> files;
  for (int i = 0; i < 100; ++i) files.push_back(create(folder / ("out" + std::to_string(i))));
  for (std::size_t i = 0; i < files.size(); ++i) {
    files[i]->write(std::to_string(i));
    if (i % 2 == 0) {
      ASSERT_TRUE(files[i]->commit());
    }
  }
  files.clear();
  const Names names = folder.files();
  EXPECT_EQ(names.size(), 50U);
  for (const std::string& name : names) EXPECT_EQ("out" + folder.read(name), name);
}

TEST(OutputFile, SlotsOfFinishedFilesAreUsedAgain) {
  const TemporaryFolder folder;
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(create(folder / "out")->commit());
  }
  auto last = create(folder / "half");
  remove_unfinished_outputs();
  EXPECT_EQ(folder.files(), Names{"out"}) << "a file behind 500 others was not remembered";
}

TEST(OutputFile, TwoOfTheSameNameDoNotMix) {
  const TemporaryFolder folder;
  auto one = create(folder / "out");
  auto two = create(folder / "out");
  one->write("11111");
  two->write("2");
  ASSERT_TRUE(one->commit());
  EXPECT_EQ(folder.read("out"), "11111");
  ASSERT_TRUE(two->commit());
  EXPECT_EQ(folder.read("out"), "2");
  EXPECT_EQ(folder.files(), Names{"out"});
}

}  // namespace
}  // namespace kerf::base
