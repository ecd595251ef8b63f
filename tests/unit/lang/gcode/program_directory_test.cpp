// What counts as a program in a file, and what does not (docs/dialect.md §1.1).
#include "lang/gcode/program_directory.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kerf::gcode {
namespace {

struct Found {
  std::string program;     // number or name
  std::uint32_t line = 0;  // of the first text behind the O word
  std::string text;        // from there to the end, without blanks at its ends
  friend bool operator==(const Found&, const Found&) = default;
};

void PrintTo(const Found& found, std::ostream* out) {
  *out << found.program << " from line " << found.line << ": "
       << testing::PrintToString(found.text);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

ProgramDirectory directory_of(const std::string& text) {
  return read_directory(*base::SourceFile::from_text("part.nc", text), base::FileId{0});
}

// LF, CR LF, CR…CR LF, LF CR, or a CR alone.
std::uint32_t line_ends_in(const std::string& text) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') {
      ++count;
      if (i + 1 < text.size() && text[i + 1] == '\r') ++i;
    } else if (text[i] == '\r') {
      ++count;
      const std::size_t behind = text.find_first_not_of('\r', i);
      if (behind != std::string::npos && text[behind] == '\n') i = behind;
    }
  }
  return count;
}

std::vector<Found> programs_of(const std::string& text) {
  std::vector<Found> found;
  for (const ProgramEntry& entry : directory_of(text).programs) {
    EXPECT_LE(entry.begin, entry.end);
    EXPECT_LE(entry.end, text.size());
    EXPECT_LE(entry.line_start, entry.begin);
    const std::string body = text.substr(entry.begin, entry.end - entry.begin);
    const std::string blanks = body.substr(0, body.find_first_not_of(" \t\r\n"));
    found.push_back({entry.name.empty() ? std::to_string(entry.number) : entry.name,
                     entry.line + line_ends_in(blanks), trimmed(body)});
  }
  return found;
}

void expect_programs(const std::string& text, const std::vector<Found>& wanted) {
  EXPECT_EQ(programs_of(text), wanted) << "in " << testing::PrintToString(text);
}

std::vector<std::string> numbers_of(const std::string& text) {
  std::vector<std::string> numbers;
  for (const Found& found : programs_of(text)) numbers.push_back(found.program);
  return numbers;
}

using Numbers = std::vector<std::string>;

TEST(ProgramDirectory, AMemoryDumpIsFramedByPercentSigns) {
  expect_programs("%\nO0001(PART)\nG00X1.\nM30\n%\n", {{"1", 2, "(PART)\nG00X1.\nM30"}});
}

TEST(ProgramDirectory, NothingBeforeTheFirstOrBehindTheSecondPercentSignCounts) {
  expect_programs("JUNK\n%\nO1\nM30\n%\nO2\nX1\n", {{"1", 4, "M30"}});
}

TEST(ProgramDirectory, WhatDoesNotCountIsTold) {
  using Where = UnreadText::Where;
  using Unread = std::vector<std::pair<Where, std::uint32_t>>;
  const auto unread = [](const std::string& text) {
    const auto file = base::SourceFile::from_text("unread.nc", text);
    Unread found;
    for (const UnreadText& each : read_directory(*file, base::FileId{0}).unread)
      found.emplace_back(each.where, each.line);
    return found;
  };
  EXPECT_EQ(unread("JUNK\n%\nO1\nM30\n%\nO2\nX1\n"),
            (Unread{{Where::before_percent, 2}, {Where::behind_tape, 5}}));
  EXPECT_EQ(unread("\n%LEADER G00 X1\nO1\nM30\n%X1"),
            (Unread{{Where::behind_percent, 2}, {Where::behind_tape, 5}}));
  EXPECT_EQ(unread("M4\nG1 X1 (30%)\n; 30% OF IT\nX2\nM2\n"),
            (Unread{{Where::before_percent, 3}, {Where::behind_percent, 3}}));
  for (const char* const all_is_read :
       {"%\nO1\nM30\n%\n \n%\n\n", "%O0003( BACKUP)\nM30\n%", "%(TITLE)\nM30\n%\n",
        "G00X1.\nM30\n%\n", "%\n%\nO1\nM30", "(30%)\n%\nO1\nM30\n%"}) {
    EXPECT_EQ(unread(all_is_read), Unread{}) << all_is_read;
  }
}

TEST(ProgramDirectory, TheLeaderBehindThePercentSignIsPassedOver) {
  expect_programs("JUNK\n%LEADER\nO1\nM30\n%\nX1", {{"1", 4, "M30"}});
}

TEST(ProgramDirectory, AnONumberMayStandOnThePercentLine) {
  expect_programs("%O0003(  BACKUP)\nG00X1.\nM30\n%", {{"3", 1, "(  BACKUP)\nG00X1.\nM30"}});
}

TEST(ProgramDirectory, PercentSignsMayStandAmongBlanks) {
  expect_programs("\n\n  % \n\n\nO1\nM30\n \n % \n\n", {{"1", 7, "M30"}});
  expect_programs("%\n%\nO1\nM30\n%\n%\n", {{"1", 4, "M30"}});
}

TEST(ProgramDirectory, TheEndOfTheTapeMayBeNumbered) {
  expect_programs("%\nO1\nN7421M30\nN7422%\n", {{"1", 3, "N7421M30\nN7422"}});
}

TEST(ProgramDirectory, AFileWithoutPercentSignsIsReadFromItsFirstLine) {
  expect_programs("O1\nM30\nO2\nM99\n", {{"1", 2, "M30"}, {"2", 4, "M99"}});
}

TEST(ProgramDirectory, AFileWithOnlyTheClosingPercentSignIsReadFromItsFirstLine) {
  expect_programs("O1\nM30\n%\n", {{"1", 2, "M30"}});
  expect_programs("G00X1.\nM30\n%\n", {{"0", 1, "G00X1.\nM30"}});
}

TEST(ProgramDirectory, AFileWithoutAnONumberIsOneProgram) {
  expect_programs("G00X1.\nM30\n", {{"0", 1, "G00X1.\nM30"}});
  expect_programs("%\n(TITLE)\nG00X1.\nM30\n%\n", {{"0", 2, "(TITLE)\nG00X1.\nM30"}});
}

TEST(ProgramDirectory, AFileOfNothingHoldsNoProgram) {
  for (const char* const text : {"", "\n", "%", "%\n%", "% %\n%\n", " \t\r\n"})
    expect_programs(text, {});
}

TEST(ProgramDirectory, EveryKindOfLineEndCountsOnce) {
  for (const std::string end : {"\n", "\r\n", "\r", "\r\r\n"}) {
    std::string text = "%\nO1 (A)\n\nX1.\nM30\nO2\nM99\n%\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
      text.replace(at, 1, end);
    const std::vector<Found> found = programs_of(text);
    ASSERT_EQ(found.size(), 2U) << testing::PrintToString(text);
    EXPECT_EQ(found[0].line, 2U) << testing::PrintToString(end);
    EXPECT_EQ(found[1].line, 7U) << testing::PrintToString(end);
    EXPECT_EQ(found[1].text, "M99");
  }
}

TEST(ProgramDirectory, AnLfCrPairIsOneLineEnd) {
  const std::vector<Found> found = programs_of("%\n\rO1\n\rX1.\n\rM30\n\rO2\n\rM99\n\r%\n\r");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].line, 3U);
  EXPECT_EQ(found[1].line, 6U);
}

TEST(ProgramDirectory, AProgramMayBeginOnTheLineOfTheM99Before) {
  expect_programs("%\nO1\nX1.\nM99O0810(NEXT)\nX2.\nM99\n%",
                  {{"1", 3, "X1.\nM99"}, {"810", 4, "(NEXT)\nX2.\nM99"}});
}

TEST(ProgramDirectory, ONumbersAreReadInEveryWriting) {
  EXPECT_EQ(numbers_of("O0339(6043068/B16)\nM30\no0010\nM99\nO 00 20 \nM99\n:0030\nM99\n"
                       "O7101()\nM99\nO910001\nM99\nO80000001\nM99\n"),
            (Numbers{"339", "10", "20", "30", "7101", "910001", "80000001"}));
}

TEST(ProgramDirectory, AColonBeginsAProgramOnlyAtTheBeginningOfABlock) {
  EXPECT_EQ(numbers_of(":1\nM30\nX1.:2\nM30\n"), Numbers{"1"});
}

TEST(ProgramDirectory, NamesStandBetweenAngleBrackets) {
  expect_programs("%\n<PROBE-1>\nM99\nO<MAIN>(X)\nM30\n%",
                  {{"PROBE-1", 3, "M99"}, {"MAIN", 4, "(X)\nM30"}});
}

TEST(ProgramDirectory, ACallByNameIsNoProgram) {
  EXPECT_EQ(numbers_of("%\nO1\nM98<PROBE>\nG65<PROBE>A1.\nM30\n%"), Numbers{"1"});
}

TEST(ProgramDirectory, FolderLinesOfADumpAreNoText) {
  expect_programs("%\n&F=//CNC_MEM/\n&F=/MTB1/\nO1\nM30\n&F=/USER/O77/\n<PART>\nM99\n%",
                  {{"1", 5, "M30\n&F=/USER/O77/"}, {"PART", 8, "M99"}});
}

TEST(ProgramDirectory, AnOInsideOfWordsAndCommentsIsNoProgram) {
  EXPECT_EQ(numbers_of("O1(O2)\nGOTO3\nGOTO 4\nPOPEN\nIF[#1EQ1OR2EQ3]GOTO5\n(O6\nO7)\nM30\n"),
            (Numbers{"1", "7"}))  // an open comment ends with its line
      << "GOTO, POPEN, OR, comments";
  EXPECT_EQ(numbers_of("O1\nDPRNT[*O5]\nDPRNT[A*O5*#1[33]]\nX[#1OR5]\nM30\n"), Numbers{"1"});
  EXPECT_EQ(numbers_of("O1\n#1=ROUND[5]\nG04X0\n#2=#1XOR5\nTOOL1\nM30\n"), Numbers{"1"});
}

TEST(ProgramDirectory, ACommentMayHoldAnything) {
  EXPECT_EQ(numbers_of("%\nO1(% ; O5 <A> :3 &F=)\n(%)\n(O9)\nM30\n%\nO2"), Numbers{"1"});
}

TEST(ProgramDirectory, ABlockSkipBeforeAnONumberDoesNotHideIt) {
  EXPECT_EQ(numbers_of("O1\nM30;O2\nM99\n"), (Numbers{"1", "2"}));
}

struct WrongNumber {
  base::Code code;
  std::uint32_t line;
  std::uint32_t column;
};

void expect_finding(const std::string& text, const WrongNumber& wanted) {
  const ProgramDirectory directory = directory_of(text);
  ASSERT_EQ(directory.findings.size(), 1U) << testing::PrintToString(text);
  EXPECT_EQ(directory.findings[0].code, wanted.code);
  EXPECT_EQ(directory.findings[0].place.line, wanted.line);
  EXPECT_EQ(directory.findings[0].place.column, wanted.column);
}

TEST(ProgramDirectory, ANumberThatIsTakenAlreadyIsToldWhereItStands) {
  expect_finding("%\nO1\nM30\nO2\nM99\n  O0001(AGAIN)\nM99\n%",
                 {base::Code::duplicate_program, 6, 3});
  expect_finding("<A>\nM30\n<A>\nM99\n", {base::Code::duplicate_program, 3, 1});
}

TEST(ProgramDirectory, ANumberThatIsNoneIsToldWhereItStands) {
  expect_finding("O0\nM30\n", {base::Code::illegal_program_number, 1, 1});
  expect_finding("O1\nM30\nM99O123456789\nM99\n", {base::Code::illegal_program_number, 3, 4});
}

TEST(ProgramDirectory, ManyProgramsAreFoundInTheOrderOfTheText) {
  std::string text = "%\n";
  Numbers wanted;
  for (int i = 1; i <= 500; ++i) {
    text += "O" + std::to_string(i * 7) + "\nM99\n";
    wanted.push_back(std::to_string(i * 7));
  }
  EXPECT_EQ(numbers_of(text + "%\n"), wanted);
}

// A comment line of any length before a program moves everything behind it by one line and its own
// bytes, wherever the file is cut into what is read at once.
TEST(ProgramDirectory, DoesNotDependOnWhereTheFileIsCutIntoChunks) {
  const std::vector<std::string> texts = {"O1 (A)\r\r\nX1.\r\r\nM30\r\r\nO2\r\nM99\r\n",
                                          "O1\rX1.\rM99O0810(N)\rM99\r%\rO9\r",
                                          "O 1 2 3\nX1.\nM30 ; O4\n<NAME>\nM99\n&F=/O5/\nO6\nM99\n",
                                          "GOTO5\n(O5)DPRNT[O7]\nO8\n%\nO9\n"};
  for (const std::string& text : texts) {
    const std::vector<Found> alone = programs_of("(\n" + text);
    for (std::size_t length = 65'500; length < 65'540; ++length) {
      const std::string padded = "(" + std::string(length - 2, 'c') + "\n" + text;
      std::vector<Found> found = programs_of(padded);
      ASSERT_EQ(found.size(), alone.size()) << testing::PrintToString(text) << " behind " << length;
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].program, alone[i].program) << "behind " << length;
        ASSERT_EQ(found[i].line, alone[i].line)
            << testing::PrintToString(text) << " behind " << length << " bytes";
        if (i > 0) {
          ASSERT_EQ(found[i].text, alone[i].text) << "behind " << length << " bytes";
        }
      }
    }
  }
}

// Programs of random words that hold no O, joined: what comes out is what was put in.
TEST(ProgramDirectory, ReadsBackWhatWasPutTogetherFromRandomPieces) {
  constexpr unsigned kSeed = 20260101;
  std::mt19937 random(kSeed);
  const std::vector<std::string> pieces = {"X1.",     "GOTO5", " ",   "\t", "(C O5 %)",
                                           "#1=#2",   "M99",   "N10", ";",  "/",
                                           "[#1EQ2]", "[O5]",  "()"};
  const std::vector<std::string> ends = {"\n", "\r\n", "\r", "\r\r\n"};
  for (int run = 0; run < 3000; ++run) {
    const std::string end = ends[random() % ends.size()];
    std::string text = "%" + end;
    std::uint32_t line = 2;
    Numbers wanted;
    std::vector<std::uint32_t> lines;
    for (unsigned program = 1; program < 4; ++program) {
      text += "O" + std::to_string(program) + "(TITLE)";
      wanted.push_back(std::to_string(program));
      lines.push_back(line);
      for (auto count = random() % 8; count > 0; --count) {
        text += " " + pieces[random() % pieces.size()];
        if (random() % 2 == 0) text += end, ++line;
      }
      text += end;
      ++line;
    }
    const std::vector<Found> found = programs_of(text + "%" + end);
    ASSERT_EQ(found.size(), wanted.size()) << testing::PrintToString(text) << ", run " << run;
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i].program, wanted[i]) << testing::PrintToString(text);
      ASSERT_EQ(found[i].line, lines[i]) << testing::PrintToString(text) << ", program " << i;
    }
  }
}

}  // namespace
}  // namespace kerf::gcode
