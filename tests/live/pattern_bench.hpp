#pragma once

// A listing on the bench, and what a replay of it makes.
#include <random>
#include <sstream>
#include <string>

#include "base/source_file.hpp"
#include "bench.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "engraver/pattern_replay.hpp"

namespace kerf::test {

using engraver::PatternReplay;
using machine::PatternMachine;

/// What `kerf pattern replay` makes of a listing.
struct Replayed {
  Points points;
  double time_s = 0;
  drive::ArmCounts counters;
};

inline void replay(const machine::MachineDefinition& definition, const std::string& listing,
                   Replayed& into) {
  const auto counting = PatternMachine::of(definition);
  ASSERT_TRUE(counting);
  engraver::PatternReplay replay(*counting);
  replay.add_sink(into.points);
  const auto file = base::SourceFile::from_text("w.txt", listing);
  drive::ListingReader reader(*file, base::FileId{0});
  for (;;) {
    const auto move = reader.next();
    ASSERT_TRUE(move);
    if (!*move) break;
    drive::each_record(
        **move, [&](const drive::PatternRecord& record) { EXPECT_TRUE(replay.take(record)); });
  }
  replay.finish();
  into.time_s = replay.time_s();
  into.counters = replay.counters();
}

/// Records of all kinds that stay within the travel of the arm.
inline std::string random_listing(unsigned seed, int records) {
  std::mt19937 random(seed);
  const auto number = [&](int most) {
    return std::uniform_int_distribution<int>(-most, most)(random);
  };
  std::ostringstream text;
  for (int i = 0; i < records; ++i) {
    switch (number(3)) {
      case -3: text << "F T1 " << number(700) << '\n'; break;
      case -2: text << "F T2 " << number(700) << '\n'; break;
      case -1: text << "F T3 " << number(90) << '\n'; break;
      case 3: text << "F Z " << number(90) << '\n'; break;
      default: text << "S " << number(30) << ' ' << number(30) << ' ' << number(30) << '\n';
    }
  }
  return text.str();
}

inline Bench& with_pattern(Bench& bench, const std::string& listing) {
  return bench.load(listing, "w.pat", "pattern");
}

inline void expect_same_points(const Points& a, const Points& b) {
  ASSERT_EQ(a.all.size(), b.all.size());
  for (std::size_t i = 0; i < a.all.size(); ++i) {
    ASSERT_EQ(a.all[i].tip.time_s, b.all[i].tip.time_s) << i;
    ASSERT_EQ(a.all[i].joints, b.all[i].joints) << i;
    ASSERT_EQ(a.all[i].tip.tip, b.all[i].tip.tip) << i;
    ASSERT_EQ(a.all[i].tip.mark.block.line, b.all[i].tip.mark.block.line) << i;
  }
}

}  // namespace kerf::test
