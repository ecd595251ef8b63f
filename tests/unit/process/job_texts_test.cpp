#include "process/job_texts.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace kerf::process {
namespace {

constexpr base::Place kPlace{base::FileId{3}, 7, 2};

std::string filled(std::string_view words, const TextVariables& variables) {
  const auto result = filled_words(words, variables, kPlace);
  if (result) return *result;
  EXPECT_EQ(result.error().number, "JOB_TEXT");
  EXPECT_EQ(result.error().place.line, 7U);
  const std::string& message = result.error().message;
  return message.substr(message.find(": ") + 2) +
         (result.error().hint.empty() ? "" : " (" + result.error().hint + ")");
}

TEST(JobTexts, variables_stand_in_braces) {
  const TextVariables variables{{"serial", "007"}, {"date", "2026-01-02"}, {"odd", "{x}"}};
  EXPECT_EQ(filled("No. {serial}, {date}", variables), "No. 007, 2026-01-02");
  EXPECT_EQ(filled("{serial}{serial}", variables), "007007");
  EXPECT_EQ(filled("a {{ b {{serial} c }", variables), "a { b {serial} c }");
  EXPECT_EQ(filled("{odd}", variables), "{x}");
  EXPECT_EQ(filled("", variables), "");
  EXPECT_EQ(filled("µ{serial}°", variables), "µ007°");
}

TEST(JobTexts, what_nothing_gives_a_value_to_is_told) {
  const TextVariables variables{{"customer", "A"}};
  EXPECT_EQ(filled("for {custmer}", variables),
            "\"for {custmer}\" names custmer, to which nothing gives a value (customer is the "
            "nearest name)");
  EXPECT_EQ(filled("{}", variables), "\"{}\" names , to which nothing gives a value");
  EXPECT_EQ(filled("a {customer", variables), "\"a {customer\" has a brace that is not closed");
  EXPECT_EQ(filled("{{{", variables), "\"{{{\" has a brace that is not closed");
}

TEST(JobTexts, serials_grow_from_copy_to_copy) {
  TextWords words;
  EXPECT_EQ(Serials(words).text(0), "1");
  EXPECT_EQ(Serials(words).text(11), "12");
  words.serial_start = 8;
  words.serial_step = 2;
  words.serial_width = 3;
  Serials serials{words};
  EXPECT_EQ(serials.text(0), "008");
  EXPECT_EQ(serials.text(1), "010");
  EXPECT_EQ(serials.text(500), "1008");
  EXPECT_EQ(serials.behind(12), 32U);
  serials.begin_with(32);
  EXPECT_EQ(serials.text(0), "032");
}

TEST(JobTexts, copies_differ_where_a_text_names_the_serial) {
  EXPECT_TRUE(names_serial("a {serial}"));
  EXPECT_FALSE(names_serial("a {{serial} {date}"));
  EXPECT_FALSE(names_serial("{serial"));
}

class KeptSerial : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("kerf_serial_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path() const { return (folder_ / "serial.txt").string(); }
  void write(const std::string& text) const { std::ofstream(path()) << text; }

 private:
  std::filesystem::path folder_;
};

TEST_F(KeptSerial, goes_on_where_the_last_run_ended) {
  EXPECT_EQ(kept_serial(path(), 5).value(), 5U);
  ASSERT_TRUE(keep_serial(path(), 13).has_value());
  EXPECT_EQ(kept_serial(path(), 5).value(), 13U);
  ASSERT_TRUE(keep_serial(path(), 14).has_value());
  EXPECT_EQ(kept_serial(path(), 5).value(), 14U);
  write("15\r\n");
  EXPECT_EQ(kept_serial(path(), 5).value(), 15U);
}

TEST_F(KeptSerial, that_is_no_number_is_told) {
  for (const char* const text : {"", "x", "-3\n", "1.5\n", "9999999999999999\n",
                                 "1                                                      \n"}) {
    write(text);
    const auto kept = kept_serial(path(), 5);
    ASSERT_FALSE(kept.has_value()) << text;
    EXPECT_NE(kept.error().message.find(path()), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf::process
