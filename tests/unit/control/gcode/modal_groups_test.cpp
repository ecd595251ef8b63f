// The modal codes as an operator is shown them.
#include "control/gcode/codes/modal_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "control/gcode/codes/lathe_codes.hpp"

namespace kerf::control {
namespace {

TEST(ModalGroups, HoldEachModalCodeOnce) {
  std::set<Group> groups;
  for (const ModalGroup& group : modal_groups())
    EXPECT_TRUE(groups.insert(group.group).second) << group.name;
  for (const CodeRow& row : mill_codes().codes())
    EXPECT_EQ(groups.contains(row.group), row.group != Group::one_shot) << name_of(row.number);
}

TEST(ModalGroups, HoldEachModalCodeOfALatheOnce) {
  std::set<Group> groups;
  for (const ModalGroup& group : modal_groups()) groups.insert(group.group);
  for (const char system : {'A', 'B', 'C'})
    for (const CodeRow& row : lathe_codes(system).codes())
      EXPECT_EQ(groups.contains(row.group), row.group != Group::one_shot) << name_of(row.number);
}

TEST(ModalGroups, CodesThatSayNothingSpecialAreThese) {
  std::string quiet;
  for (const CodeRow& row : mill_codes().codes()) {
    if (row.group != Group::one_shot && says_nothing_special(row))
      quiet += name_of(row.number) + " ";
  }
  EXPECT_EQ(quiet,
            "G13.1 G15 G17 G21 G22 G40 G40.1 G49 G50 G50.1 G64 G67 G69 G80 G90 G94 G97 G98 G160 ");
}

}  // namespace
}  // namespace kerf::control
