#include "output/records/path_chunks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "machine/run/batch_run.hpp"

namespace kerf::output {
namespace {

// A chunk as a reader in another language would read it: by the offsets of docs/panel-protocol.md.
struct Chunk {
  std::uint16_t version = 0;
  std::uint32_t run = 0, number = 0, first_motion = 0, n = 0;
  double base_s = 0;
  std::vector<float> xyz, time_s, feed, speed, rotary;
  std::vector<std::uint32_t> motion, line;
  std::vector<std::uint16_t> file;
  std::vector<std::uint8_t> kind, tool, power;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  T value() {
    T result{};
    EXPECT_LE(at_ + sizeof(T), bytes_.size());
    std::memcpy(&result, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return result;
  }
  template <typename T>
  std::vector<T> array(std::size_t count) {
    std::vector<T> values(count);
    for (T& each : values) each = value<T>();
    at_ = (at_ + 3) / 4 * 4;
    return values;
  }
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

Chunk read(const std::string& bytes) {
  Reader in(bytes);
  Chunk c;
  EXPECT_EQ(in.value<std::uint32_t>(), 0x4854504bU);  // KPTH
  c.version = in.value<std::uint16_t>();
  EXPECT_EQ(in.value<std::uint16_t>(), 0);
  c.run = in.value<std::uint32_t>();
  c.number = in.value<std::uint32_t>();
  c.first_motion = in.value<std::uint32_t>();
  c.n = in.value<std::uint32_t>();
  c.base_s = in.value<double>();
  c.xyz = in.array<float>(3 * std::size_t{c.n});
  c.time_s = in.array<float>(c.n);
  c.feed = in.array<float>(c.n);
  c.speed = in.array<float>(c.n);
  c.motion = in.array<std::uint32_t>(c.n);
  c.line = in.array<std::uint32_t>(c.n);
  c.file = in.array<std::uint16_t>(c.n);
  c.kind = in.array<std::uint8_t>(c.n);
  c.tool = in.array<std::uint8_t>(c.n);
  c.power = in.array<std::uint8_t>(c.n);
  if ((c.version & 0x100U) != 0) c.rotary = in.array<float>(2 * std::size_t{c.n});
  EXPECT_TRUE(in.at_end());
  return c;
}

struct Ran {
  std::vector<Chunk> chunks;
  PathTotals totals;
  double time_s = 0;
};

Ran run(const std::string& text, const std::string& machine_name = "mill3") {
  const auto definition = machine::find_machine(machine_name);
  machine::BatchRun machine(*definition, control::Memory(definition->parameters.n_offsets));
  Ran ran;
  PathChunks chunks(*definition, PathChunks::Source::preview, 7,
                    [&](const std::string& bytes) { ran.chunks.push_back(read(bytes)); });
  machine.load(base::SourceFile::from_text("test.nc", text));
  machine.add_sink(chunks);
  machine.add_point_sink(chunks);
  machine.run_to_end();
  chunks.finish();
  ran.totals = chunks.totals();
  ran.time_s = machine.time_s();
  return ran;
}

TEST(PathChunks, LinesEndInOneVertexEach) {
  const Ran ran = run("G90 G21\nG01 X10. F600\nG01 Y5. F1200\nG00 Z1.\nM30\n");
  ASSERT_EQ(ran.chunks.size(), 1U);
  const Chunk& c = ran.chunks[0];
  ASSERT_EQ(c.n, 4U);
  EXPECT_EQ(c.run, 7U);
  EXPECT_EQ(c.xyz, (std::vector<float>{0, 0, 0, 10, 0, 0, 10, 5, 0, 10, 5, 1}));
  EXPECT_EQ(c.line[1], 2U);
  EXPECT_EQ(c.line[3], 4U);
  EXPECT_EQ(c.kind[1], 1);
  EXPECT_EQ(c.kind[3], 0);
  EXPECT_EQ(c.feed[1], 600);
  EXPECT_EQ(c.feed[2], 1200);
  EXPECT_EQ(c.feed[3], 0);
  EXPECT_LT(c.motion[1], c.motion[2]);
}

TEST(PathChunks, TheLastVertexHasTheTimeOfTheRun) {
  const Ran ran = run("G90 G21\nG01 X10. F600\nG04 P250\nG01 Y5. F1200\nM30\n");
  const Chunk& c = ran.chunks[0];
  EXPECT_NEAR(c.time_s.back(), ran.time_s, 1e-5);
  // The dwell stands between the moves, and takes its time.
  ASSERT_EQ(c.n, 4U);
  EXPECT_EQ(c.kind[2], 2);
  EXPECT_NEAR(c.time_s[2] - c.time_s[1], 0.25, 0.0011);
  EXPECT_EQ(c.speed[2], 0);
}

TEST(PathChunks, TheSpeedIsTheWayByTheTime) {
  const Ran ran = run("G90 G21\nG01 X100. F3000\nG02 X120. Y-20. J-20. F2000\nG01 X0. F500\nM30\n");
  for (const Chunk& c : ran.chunks) {
    for (std::size_t i = 1; i < c.n; ++i) {
      double way = 0;
      for (std::size_t k = 0; k < 3; ++k)
        way += std::pow(c.xyz[3 * i + k] - c.xyz[3 * i - 3 + k], 2);
      const double lasted = c.time_s[i] - c.time_s[i - 1];
      EXPECT_NEAR(std::sqrt(way) / lasted * 60, c.speed[i], 0.02 * c.speed[i]) << i;
      EXPECT_LE(c.speed[i], c.feed[i] * 1.005) << i;
    }
  }
}

TEST(PathChunks, ArcsKeepTheirChordError) {
  for (const double radius : {0.005, 0.5, 10.0, 300.0}) {
    const std::string r = std::to_string(radius);
    const Ran ran = run("G90 G21\nG02 I" + r + " F1000\nM30\n");
    const Chunk& c = ran.chunks[0];
    double most = 0;
    for (std::size_t i = 1; i < c.n; ++i) {
      EXPECT_NEAR(std::hypot(c.xyz[3 * i] - radius, c.xyz[3 * i + 1]), radius, 1e-4);
      const double x = (c.xyz[3 * i] + c.xyz[3 * i - 3]) / 2.0 - radius;
      const double y = (c.xyz[3 * i + 1] + c.xyz[3 * i - 2]) / 2.0;
      most = std::max(most, radius - std::hypot(x, y));
    }
    EXPECT_LE(most, PathChunks::kChordError_mm + 1e-4) << radius;
    // Not many more than needed, either.
    const double least = radius >= 0.5 ? PathChunks::kChordError_mm / 4 : 0;
    EXPECT_GE(most, least) << radius;
  }
}

TEST(PathChunks, EachChunkBeginsWhereTheOneBeforeEnds) {
  std::string text =
      "G90 G21\n#1=0\nWHILE [#1 LT 70000] DO1\nG01 X[0.1*SIN[#1]] Y[#1/1000.] "
      "F6000\n#1=#1+1\nEND1\nM30\n";
  const Ran ran = run(text);
  ASSERT_EQ(ran.chunks.size(), 2U);
  std::uint64_t segments = 0;
  for (const Chunk& c : ran.chunks) {
    EXPECT_LE(c.n, PathChunks::kMostVertices);
    segments += c.n - 1;
  }
  EXPECT_EQ(segments + 1, ran.totals.vertices);
  const Chunk& a = ran.chunks[0];
  const Chunk& b = ran.chunks[1];
  EXPECT_EQ(b.number, 1U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(b.xyz[k], a.xyz[3 * (a.n - 1) + k]);
  EXPECT_NEAR(b.base_s + b.time_s[0], a.base_s + a.time_s.back(), 1e-3);
  EXPECT_EQ(b.first_motion, b.motion[1]);
  for (std::size_t i = 1; i < a.n; ++i) ASSERT_GE(a.time_s[i], a.time_s[i - 1]);
}

TEST(PathChunks, RotaryAxesAreToldAndAMoveOfThemAloneHasAVertex) {
  const Ran ran = run("TEACH 1\n", "mill5");  // no program: no vertices
  EXPECT_TRUE(ran.chunks.empty());
  const Ran turned = run("G90 G21\nG01 X10. F1000\nG01 C90. F3600\nM30\n", "mill5");
  ASSERT_EQ(turned.chunks.size(), 1U);
  const Chunk& c = turned.chunks[0];
  EXPECT_EQ(c.version, 0x101);
  ASSERT_EQ(c.n, 3U);
  const std::vector<float> last(c.rotary.end() - 2, c.rotary.end());
  EXPECT_TRUE(last[0] == 90 || last[1] == 90);
  EXPECT_GT(c.speed[2], 0);
}

TEST(PathChunks, MotionsOfMacrosAreNumberedInTheOrderOfTheRun) {
  const Ran ran = run("G90 G21\nG65 P2 L3\nM30\nO2\nG91 G01 X1. F600\nM99\n");
  const Chunk& c = ran.chunks[0];
  ASSERT_EQ(c.n, 4U);
  EXPECT_LT(c.motion[1], c.motion[2]);
  EXPECT_LT(c.motion[2], c.motion[3]);
  EXPECT_EQ(c.line[1], 5U);
  EXPECT_EQ(c.line[3], 5U);
}

}  // namespace
}  // namespace kerf::output
