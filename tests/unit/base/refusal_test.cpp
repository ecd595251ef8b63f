#include "base/refusal.hpp"

#include <gtest/gtest.h>

namespace kerf::base {
namespace {

TEST(Refusal, PutsItsValuesIntoTheSentenceAndKeepsThemByName) {
  const Failure failure = refuse(Refusal::asked_already, {"Lee", "mill"});
  EXPECT_EQ(failure.message, "Lee has asked for mill already");
  EXPECT_EQ(failure.code, "asked-already");
  ASSERT_EQ(failure.values.size(), 2U);
  EXPECT_EQ(failure.values[0].name, "name");
  EXPECT_EQ(failure.values[0].text, "Lee");
  EXPECT_EQ(failure.values[1].name, "machine");
}

TEST(Refusal, TakesBracesOfAValueAsTheyAre) {
  EXPECT_EQ(refuse(Refusal::no_machine, {"{name}"}).message, "there is no machine {name}");
}

TEST(Refusal, WithoutValuesIsTheSentence) {
  const Failure failure = refuse(Refusal::running);
  EXPECT_EQ(failure.message, "the machine is running");
  EXPECT_TRUE(failure.values.empty());
}

}  // namespace
}  // namespace kerf::base
