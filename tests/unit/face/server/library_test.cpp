#include "face/server/store/library.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "face/server/store/chunk_store.hpp"
#include "face/server/store/program_name.hpp"

namespace kerf::server {
namespace {

namespace fs = std::filesystem;

class LibraryTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "kerf-library-XXXXXX").string();
    root_ = ::mkdtemp(name.data());
    open();
  }
  void TearDown() override {
    library_.reset();
    fs::remove_all(root_);
  }
  void open() {
    library_.reset();
    auto opened = Library::open(root_ / "library", root_ / "revisions.sqlite");
    ASSERT_TRUE(opened) << opened.error().message;
    library_ = std::move(*opened);
  }
  [[nodiscard]] fs::path file(const std::string& name) const { return root_ / "library" / name; }
  static void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

  fs::path root_;
  std::unique_ptr<Library> library_;
};

TEST(ProgramName, IsTheNameOfAFile) {
  for (const char* name : {"O1.nc", "part 1.nc", "9401", "Welle_\xc3\xbc.nc",
                           "\xe9\x9b\xb6\xe4\xbb\xb6.nc", "a..b", "console", "COM10"})
    EXPECT_TRUE(check_program_name(name)) << name;
  for (const char* name : {"",
                           ".",
                           "..",
                           "../a",
                           "a/b",
                           "/a",
                           "a\\b",
                           ".hidden",
                           "a.",
                           " a",
                           "a ",
                           "a\nb",
                           "a\tb",
                           "\x7f",
                           "\xff\xfe",
                           "\xc0\xaf",
                           "C:x",
                           "a*",
                           "a?",
                           "a|b",
                           "<a>",
                           "\"a\"",
                           "-x",
                           "con",
                           "Aux.nc",
                           "lpt9",
                           "a\xe2\x80\xae"
                           "cn.nc",
                           "u\xcc\x88"})
    EXPECT_FALSE(check_program_name(name)) << name;
  EXPECT_TRUE(check_program_name(std::string(100, 'x')));
  EXPECT_FALSE(check_program_name(std::string(101, 'x')));
  EXPECT_FALSE(check_program_name(std::string("a\0b", 3)));
}

// The page mends names before it sends them; web/tests/program_name.test.ts reads the same table.
TEST(ProgramName, IsTakenAsThePageMendsItAndRefusedAsItWas) {
  std::ifstream file(KERF_TEXT_TESTS "/../program_names.json");
  const auto table = nlohmann::json::parse(file);
  ASSERT_GT(table.size(), 20U);
  for (const auto& row : table) {
    const auto wanted = row.at(0).get<std::string>();
    const auto mended = row.at(1).get<std::string>();
    EXPECT_TRUE(check_program_name(mended)) << mended;
    EXPECT_EQ(check_program_name(wanted).has_value(), wanted == mended) << wanted;
  }
}

TEST_F(LibraryTest, KeepsWhatIsWrittenAcrossAnEnd) {
  ASSERT_TRUE(library_->write("a.nc", "one"));
  EXPECT_EQ(library_->write("a.nc", "two")->number, 2);
  open();
  EXPECT_EQ(*library_->read("a.nc"), "two");
  EXPECT_EQ(*library_->read_revision("a.nc", 1), "one");
  EXPECT_EQ(library_->write("a.nc", "three")->number, 3);
}

TEST_F(LibraryTest, TouchesNothingThatIsNoFile) {
  put(root_ / "outside.nc", "SECRET");
  fs::create_symlink(root_ / "outside.nc", file("link.nc"));
  fs::create_directory(file("folder"));
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  fs::create_symlink(root_ / "nowhere", file("dangling.nc"));
  for (const char* name : {"link.nc", "folder", "pipe", "dangling.nc"}) {
    EXPECT_FALSE(library_->read(name)) << name;
    EXPECT_FALSE(library_->write(name, "X")) << name;
    EXPECT_FALSE(library_->remove(name)) << name;
    EXPECT_FALSE(library_->rename(name, "b.nc")) << name;
    EXPECT_FALSE(library_->path_of(name)) << name;
  }
  EXPECT_TRUE(library_->programs()->empty());
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(
                            *std::make_unique<std::ifstream>(root_ / "outside.nc")),
                        {}),
            "SECRET");
  EXPECT_FALSE(fs::exists(root_ / "nowhere"));
}

TEST_F(LibraryTest, TakesOverWhatSomethingElseHasWritten) {
  put(file("a.nc"), "by hand");
  EXPECT_EQ(library_->revisions("a.nc")->size(), 1U);
  EXPECT_EQ(library_->revisions("a.nc")->size(), 1U);
  put(file("a.nc"), "by hand, again");
  ASSERT_TRUE(library_->write("a.nc", "mine"));
  EXPECT_EQ(*library_->read_revision("a.nc", 2), "by hand, again");
  EXPECT_EQ(*library_->read_revision("a.nc", 3), "mine");
}

TEST_F(LibraryTest, RenamedProgramsKeepTheirRevisionsBehindThoseOfTheName) {
  ASSERT_TRUE(library_->write("b.nc", "old b"));
  ASSERT_TRUE(library_->remove("b.nc"));
  ASSERT_TRUE(library_->write("a.nc", "a1"));
  ASSERT_TRUE(library_->write("a.nc", "a2"));
  ASSERT_TRUE(library_->rename("a.nc", "b.nc"));
  EXPECT_EQ(*library_->read_revision("b.nc", 1), "old b");
  EXPECT_EQ(*library_->read_revision("b.nc", 3), "a2");
  EXPECT_FALSE(library_->revisions("a.nc"));
}

TEST_F(LibraryTest, AnUploadThatIsNotFinishedIsNothing) {
  {
    auto upload = library_->begin_upload("a.nc");
    ASSERT_TRUE(upload);
    (*upload)->write("half");
    EXPECT_FALSE(library_->read("a.nc"));
  }
  EXPECT_TRUE(fs::is_empty(root_ / "library"));
  put(file(".a.nc.x1y2z3"), "left by a crash");
  open();
  EXPECT_TRUE(fs::is_empty(root_ / "library"));
}

TEST_F(LibraryTest, LargeProgramsHaveARevisionWithoutAText) {
  ASSERT_TRUE(library_->write("a.nc", std::string(Revisions::kMostText + 1, 'x')));
  const auto all = library_->revisions("a.nc");
  ASSERT_EQ(all->size(), 1U);
  EXPECT_FALSE(all->front().kept);
  EXPECT_FALSE(library_->read_revision("a.nc", 1));
  EXPECT_FALSE(library_->read("a.nc"));
}

TEST_F(LibraryTest, AsManyRevisionsAsItPromises) {
  for (int i = 1; i <= Revisions::kMostOfProgram + 5; ++i)
    ASSERT_TRUE(library_->write("a.nc", std::to_string(i)));
  const auto all = library_->revisions("a.nc");
  EXPECT_EQ(all->size(), static_cast<std::size_t>(Revisions::kMostOfProgram));
  EXPECT_EQ(all->front().number, Revisions::kMostOfProgram + 5);
  EXPECT_EQ(*library_->read_revision("a.nc", 6), "6");
}

TEST_F(LibraryTest, ChunksAreRefusedWhereAllStoresHoldWhatTheyMay) {
  const auto budget = std::make_shared<ChunkBudget>();
  budget->bytes = ChunkBudget::kMostBytes - 6;
  {
    ChunkStore store(root_, budget);
    EXPECT_TRUE(store.add("first"));
    EXPECT_FALSE(store.add("second"));
    EXPECT_EQ(store.count(), 1U);
  }
  EXPECT_EQ(budget->bytes, ChunkBudget::kMostBytes - 6);
}

TEST_F(LibraryTest, ChunksComeBackAsTheyWereAndLeaveNoFile) {
  const auto budget = std::make_shared<ChunkBudget>();
  ChunkStore store(root_, budget);
  const std::string large(3 << 20, 'x');
  ASSERT_TRUE(store.add("first"));
  ASSERT_TRUE(store.add(large));
  EXPECT_EQ(store.count(), 2U);
  EXPECT_EQ(*store.read(0), "first");
  EXPECT_EQ(*store.read(1), large);
  EXPECT_EQ(store.read(2), std::nullopt);
  EXPECT_EQ(budget->bytes, 5 + large.size());
  for (const auto& entry : fs::directory_iterator(root_))
    EXPECT_EQ(entry.path().filename().string().find("preview"), std::string::npos);
}

}  // namespace
}  // namespace kerf::server
