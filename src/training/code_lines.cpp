#include "training/code_lines.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace kerf::training {
namespace {

std::string without_brackets(std::string_view line) {
  std::string rest;
  bool inside = false;
  for (const char c : line) {
    if (c == '(') inside = true;
    if (!inside) rest += c;
    if (c == ')') inside = false;
  }
  return rest;
}

bool is_remark(std::string_view line) {
  constexpr std::string_view kWord = "REM";
  const bool same = line.size() >= kWord.size() &&
                    std::equal(kWord.begin(), kWord.end(), line.begin(), [](char a, char b) {
                      return a == std::toupper(static_cast<unsigned char>(b));
                    });
  return same && (line.size() == kWord.size() ||
                  std::isalnum(static_cast<unsigned char>(line[kWord.size()])) == 0);
}

std::string code_of(std::string_view line, std::string_view dialect) {
  if (dialect == "laser-basic") {
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    if (is_remark(line.substr(begin))) return {};
    return std::string(line.substr(begin, line.find('\'', begin) - begin));
  }
  if (dialect == "teach") return std::string(line.substr(0, line.find(';')));
  return without_brackets(line);
}

}  // namespace

int code_lines(std::string_view program, std::string_view dialect) {
  int count = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find_first_of("\r\n", begin), program.size());
    const std::string code = code_of(program.substr(begin, end - begin), dialect);
    if (code.find_first_not_of(" \t%;") != std::string::npos) ++count;
    begin = end + 1;
  }
  return count;
}

}  // namespace kerf::training
