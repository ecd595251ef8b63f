// Who knows what of a machine's memory is on the disk, with a disk that fails.
#include "face/server/store/memory_keeper.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <thread>

namespace kerf::server {
namespace {

class MemoryKeeperTest : public testing::Test {
 protected:
  static control::Memory memory(double value) {
    control::Memory made(10);
    made.work[0].values[0] = value;
    return made;
  }
  void offer(double value) {
    keeper_.offer("mill", std::make_shared<control::Memory>(memory(value)));
  }
  // Offers until it is on the disk, as a machine does.
  void offer_until_written(double value) {
    for (int i = 0; i < 1000 && !keeper_.is_on_disk("mill", memory(value)); ++i) {
      offer(value);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  void finish() { disk_.reset(); }

  std::atomic<bool> full_ = false;
  std::vector<double> written_;
  std::vector<std::string> told_;
  std::atomic<int> tries_ = 0;
  std::unique_ptr<Worker> disk_ = std::make_unique<Worker>();
  MemoryKeeper keeper_{
      *disk_,
      [this](const std::string&, const control::Memory& memory) -> base::Outcome<void> {
        ++tries_;
        if (full_) return tl::unexpected(base::Failure{base::Failure::Kind::output, "full"});
        written_.push_back(memory.work[0].values[0]);
        return {};
      },
      [this](const std::string&, const std::string& trouble) { told_.push_back(trouble); }};
};

TEST_F(MemoryKeeperTest, WritesWhatDiffersFromWhatWasWrittenLastWhoeverWroteIt) {
  keeper_.know("mill", memory(0));
  offer(0);
  offer_until_written(10);
  ASSERT_TRUE(keeper_.write("mill", memory(12)));
  offer_until_written(10);
  finish();
  EXPECT_EQ(written_, (std::vector<double>{10, 12, 10}));
}

TEST_F(MemoryKeeperTest, WritesNothingTwice) {
  keeper_.know("mill", memory(1));
  for (int i = 0; i < 100; ++i) offer(1);
  EXPECT_TRUE(keeper_.write("mill", memory(1)));
  finish();
  EXPECT_EQ(tries_, 0);
}

TEST_F(MemoryKeeperTest, TriesAgainMoreRarelyAndTellsItOnce) {
  keeper_.know("mill", memory(0));
  full_ = true;
  EXPECT_FALSE(keeper_.write("mill", memory(1)));
  for (int i = 0; i < 50; ++i) offer(1);  // within the pause
  EXPECT_FALSE(keeper_.is_on_disk("mill", memory(1)));
  EXPECT_FALSE(keeper_.is_on_disk("mill", memory(0)));  // it may have come half of the way
  EXPECT_FALSE(keeper_.write("mill", memory(2)));       // a command does not wait
  full_ = false;
  offer_until_written(2);
  finish();
  EXPECT_EQ(written_, (std::vector<double>{2}));
  EXPECT_LT(tries_, 10);  // of more than 50 offers
  EXPECT_EQ(told_, (std::vector<std::string>{"full", ""}));
}

TEST_F(MemoryKeeperTest, AMachineThatIsForgottenIsNotWritten) {
  keeper_.know("mill", memory(0));
  keeper_.forget("mill");
  offer(1);
  finish();
  EXPECT_EQ(tries_, 0);
}

// Commands, offers and failures in any order: in the end the disk has what was wanted last.
TEST_F(MemoryKeeperTest, InTheEndTheDiskHasWhatWasWantedLast) {
  std::mt19937 random(7);
  const auto number = [&](int below) {
    return std::uniform_int_distribution<int>(0, below - 1)(random);
  };
  keeper_.know("mill", memory(0));
  double wanted = 0;
  for (int i = 0; i < 3000; ++i) {
    full_ = number(10) == 0;
    wanted = number(3);
    if (number(2) == 0) {
      offer(wanted);
    } else {
      disk_->post([this, wanted] { static_cast<void>(keeper_.write("mill", memory(wanted))); });
    }
  }
  full_ = false;
  finish();
  ASSERT_TRUE(keeper_.write("mill", memory(wanted)));  // as at the end of the server
  EXPECT_TRUE(keeper_.is_on_disk("mill", memory(wanted)));
  EXPECT_EQ(written_.empty() ? 0 : written_.back(), wanted);
}

TEST(KeepsTheSame, ComparesBitByBitAndLeavesOutWhatIsLostWithThePower) {
  control::Memory a(10);
  control::Memory b(10);
  EXPECT_TRUE(keeps_the_same(a, b));  // all vacant
  a.commons[0] = 5;                   // #100
  EXPECT_TRUE(keeps_the_same(a, b));
  a.commons[control::kVolatileCommons] = 0;
  EXPECT_FALSE(keeps_the_same(a, b));
  b.commons[control::kVolatileCommons] = 0;
  EXPECT_TRUE(keeps_the_same(a, b));
  b.names["A"] = 500;
  EXPECT_FALSE(keeps_the_same(a, b));
}

}  // namespace
}  // namespace kerf::server
