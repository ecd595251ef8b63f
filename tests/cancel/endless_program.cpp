#include "endless_program.hpp"

#include <array>

namespace kerf::test {
namespace {

template <std::size_t N>
std::string one_of(SeededRandom& random, const std::array<const char*, N>& list) {
  return list[static_cast<std::size_t>(random.count(0, static_cast<int>(N) - 1))];
}

// FANUC

constexpr std::array kBlocks = {"M00",
                                "M01",
                                "#3006=1(LOOK)",
                                "G04P1",
                                "G04X1000.",
                                "G04P99999999",
                                "#100=#100+1",
                                "#101=SIN[#100]*2",
                                "IF[#100LT0]THEN#102=3",
                                "G00X1.Y2.",
                                "G00X0Y0",
                                "G01X5.F100.",
                                "G01X0F60000.",
                                "G02X0Y0I1.J0F500.",
                                "G81X1.Y1.Z-2.R1.F200.",
                                "G80",
                                "M03S1000",
                                "M08",
                                "T1M06",
                                "M98P1000",
                                "M98P1000L20",
                                "G65P1000A1.L5",
                                "G65P1001A1.",
                                "/2M00",
                                "(NOTHING)",
                                "#100=#3001",
                                "#100=#5021",
                                "G10L2P1X0",
                                "DPRNT[X#100[53]]",
                                "G91",
                                "G90"};

std::string blocks(SeededRandom& random, int most) {
  std::string text;
  for (int i = random.count(0, most); i > 0; --i) text += one_of(random, kBlocks) + "\n";
  return text;
}

// A number of turns that is endless for all practical purposes, around what is within.
std::string gcode_loop(SeededRandom& random, int level, int& label) {
  std::string within = blocks(random, 3);
  if (level < 3 && random.coin()) within += gcode_loop(random, level + 1, label);
  within += blocks(random, 2);
  const std::string n = std::to_string(++label);
  const std::string loop = std::to_string(level);
  switch (random.count(0, 3)) {
    case 0: return "N" + n + "\n" + within + "GOTO" + n + "\n";
    case 1: return "WHILE[1EQ1]DO" + loop + "\n" + within + "END" + loop + "\n";
    case 2: return "DO" + loop + "\n" + within + "END" + loop + "\n";
    default: return "N" + n + "\n" + within + "#110=0\nIF[#110EQ0]GOTO" + n + "\n";
  }
}

std::string gcode(SeededRandom& random) {
  int label = 0;
  const std::string subs =
      "O1000\n" + blocks(random, 2) + "M99\nO1001\n" + blocks(random, 1) + "M98P1000L3\nM99\n";
  if (random.count(0, 3) == 0) return "O1\n" + blocks(random, 4) + "#1=1\nM99\n" + subs;
  return "O1\n" + blocks(random, 2) + gcode_loop(random, 1, label) + "M30\n" + subs;
}

// Laser BASIC: its statements are counted, so that what does not move comes to an end.

constexpr std::array kStatements = {"A=A+1",
                                    "B=SIN(A)*2",
                                    "IF A<0 THEN B=1 ELSE C=2",
                                    "MOVE 10,10,0",
                                    "MOVE 0,0,0",
                                    "LINE 0,0,0 TO 5,5,0",
                                    "POWER 20",
                                    "SPEED 100",
                                    "PRINT A",
                                    "INPUT \"?\",Q",
                                    "GOSUB 9000",
                                    "REM nothing",
                                    "HOME",
                                    "LINE 0,0,0 TO 300,0,0"};

std::string statements(SeededRandom& random, int most) {
  std::string text;
  for (int i = random.count(0, most); i > 0; --i) text += one_of(random, kStatements) + "\n";
  return text;
}

std::string basic_loop(SeededRandom& random, int level, int& label) {
  std::string within = statements(random, 3);
  if (level < 3 && random.coin()) within += basic_loop(random, level + 1, label);
  const std::string n = std::to_string(++label);
  if (random.coin()) return "FOR I" + n + "=1 TO 1000000000\n" + within + "NEXT I" + n + "\n";
  return n + " " + "A=A\n" + within + "GOTO " + n + "\n";
}

std::string basic(SeededRandom& random) {
  int label = 0;
  return "SPEED 50\n" + statements(random, 2) + basic_loop(random, 1, label) + "END\n9000 B=B+1\n" +
         "RETURN\n";
}

// Taught points: they run straight on, so these are many, and some of them long.

constexpr std::array kRecords = {"LINE 10 0 300 90 0", "LINE 0 10 300 90 0", "DWELL 1000",
                                 "LASER ON 40",        "LASER OFF",          "FEED 1",
                                 "FEED 2400",          "POINT 0 0 300 90 0"};

std::string taught(SeededRandom& random) {
  std::string text = "TEACH 1\nFEED 60\nPOINT 0 0 300 90 0\n";
  for (int i = random.count(5'000, 20'000); i > 0; --i) text += one_of(random, kRecords) + "\n";
  return text + "END\n";
}

}  // namespace

EndlessProgram endless_program(SeededRandom& random) {
  const int kind = random.count(0, 9);
  if (kind < 7) return {"endless.nc", random.coin() ? "mill3" : "laser5", gcode(random)};
  if (kind < 9) return {"endless.bas", "laser3", basic(random)};
  return {"endless.tch", "laser5", taught(random)};
}

}  // namespace kerf::test
