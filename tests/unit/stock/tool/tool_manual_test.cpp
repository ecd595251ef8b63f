// docs/tools.md has a row for each kind with its keys and defaults, and one for each measure.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "base/decimal.hpp"
#include "stock/tool/tool_kind.hpp"

namespace kerf::stock {
namespace {

std::set<std::string> lines_of_the_manual() {
  std::ifstream file(KERF_MANUAL "/tools.md");
  std::set<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.insert(line);
  EXPECT_GT(lines.size(), 50U);
  return lines;
}

bool has_row(const std::set<std::string>& lines, const std::string& beginning) {
  const auto found = lines.lower_bound(beginning);
  return found != lines.end() && found->starts_with(beginning);
}

std::string quoted(std::string_view word) { return "`" + std::string(word) + "`"; }

/// "**`diameter`**, `angle` (118)": needed ones are bold, defaults in parentheses.
std::string keys_of(const KindRow& row) {
  std::string text;
  for (const KindKey& key : row.keys) {
    const std::string name = quoted(row_of(key.measure).name);
    text += (text.empty() ? "" : ", ") + (key.is_needed ? "**" + name + "**" : name);
    if (key.has_default()) text += " (" + base::number_text(key.otherwise) + ")";
  }
  return text;
}

TEST(ToolManual, HasARowForEachKindWithItsKeysAndDefaults) {
  const auto lines = lines_of_the_manual();
  for (const KindRow& row : kind_rows()) {
    std::string names;
    for (const std::string_view name : row.names)
      names += (names.empty() ? "" : ", ") + quoted(name);
    const std::string beginning = "| " + names + " | " + keys_of(row) + " |";
    EXPECT_TRUE(has_row(lines, beginning)) << beginning;
  }
}

TEST(ToolManual, HasARowForEachMeasureWithItsRange) {
  const auto lines = lines_of_the_manual();
  for (const MeasureRow& row : measure_rows()) {
    const std::string beginning = "| " + quoted(row.name) + " | " + row.in_words() + " |";
    EXPECT_TRUE(has_row(lines, beginning)) << beginning;
  }
}

}  // namespace
}  // namespace kerf::stock
