// Parts of random things, programmed by a small CAM, run by the control and recognised: what is
// told is what was meant, whatever the seed. KERF_PARTS=N makes as many, KERF_PARTS_FIRST the first
// seed, KERF_PARTS_ALL=1 goes on behind one that fails; it is written into the folder
// KERF_PARTS_TEXT, with its tools.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "features/tree/words.hpp"
#include "geometry/contour/contour.hpp"
#include "job/features_run.hpp"
#include "random_part.hpp"

namespace kerf::parts {
namespace {

constexpr double kBorder_mm = 1e-3;  // beside what words are rounded to

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

job::StockJob job_of(const RandomPart& part) {
  const machine::MachineDefinition mill = *machine::find_machine("mill3");
  job::StockJob job{
      .job = {.definition = mill, .memory = control::Memory(mill.parameters.n_offsets)}};
  job.job.program = base::ProgramText::of("part.nc", part.program);
  job.tools = machine::ToolChoice(part.tools);
  job.knows_stock = part.stock.has_value();
  if (!part.stock) {
    job.shape = machine::StockAround{};
    return job;
  }
  job.shape = stock::Workpiece{
      stock::BoxShape{.low = {0, 0, -part.stock_depth}, .high = {part.stock->u, part.stock->v, 0}}};
  return job;
}

/// How far a contour is at most from another one, at its corners and the middles of its edges.
double farthest(const Contour& from, const Contour& to) {
  double most = 0;
  for (std::size_t i = 0; i < contour::edge_count(from); ++i) {
    for (const double share : {0.0, 0.25, 0.5})
      most = std::max(most,
                      contour::distance(to, contour::point_at(contour::edge_of(from, i), share)));
  }
  return most;
}

void expect_contour(const Contour& found, const Contour& wanted, double border_mm,
                    const char* what) {
  ASSERT_FALSE(found.vertices.empty()) << what;
  EXPECT_LE(farthest(found, wanted), border_mm) << what;
  EXPECT_LE(farthest(wanted, found), border_mm) << what;
}

template <typename Word>
void expect_word(Word found, std::optional<Word> wanted) {
  EXPECT_EQ(features::word_of(found), features::word_of(wanted.value_or(found)));
}

void expect_parent(const std::optional<features::Relation>& found,
                   const std::optional<std::pair<std::size_t, features::RelationKind>>& wanted) {
  ASSERT_EQ(found.has_value(), wanted.has_value());
  if (!found) return;
  EXPECT_EQ(found->feature, wanted->first);
  EXPECT_EQ(features::word_of(found->kind), features::word_of(wanted->second));
}

void expect_layers(const features::Feature& found, const WantedFeature& wanted, double border_mm) {
  ASSERT_EQ(found.layers.size(), wanted.layers.size());
  for (std::size_t i = 0; i < wanted.layers.size(); ++i) {
    const features::Layer& layer = found.layers[i];
    EXPECT_NEAR(layer.z, wanted.layers[i], border_mm);
    expect_contour(layer.contour, wanted.outline, border_mm, "contour");
    ASSERT_EQ(layer.islands.size(), wanted.islands.size());
    for (std::size_t k = 0; k < wanted.islands.size(); ++k)
      expect_contour(layer.islands[k], wanted.islands[k], 2 * border_mm, "island");
  }
}

void expect_feature(const features::Feature& found, const WantedFeature& wanted, double border_mm) {
  EXPECT_EQ(features::word_of(found.type), features::word_of(wanted.type));
  EXPECT_NEAR(found.top, wanted.top, border_mm);
  expect_layers(found, wanted, border_mm);
  EXPECT_EQ(found.measures.round.has_value() || !wanted.is_round, true) << "round";
  if (wanted.nominal)
    expect_contour(found.layers.front().nominal, *wanted.nominal, 3 * border_mm, "nominal");
  expect_word(found.strategy, wanted.strategy);
  expect_word(found.order, wanted.order);
  expect_word(found.milling, wanted.milling);
  expect_word(found.entry.kind, wanted.entry);
  EXPECT_EQ(found.cuts.size(), wanted.cuts);
  expect_parent(found.parent, wanted.parent);
}

void expect_hole(const features::Hole& found, const WantedHole& wanted, double border_mm) {
  EXPECT_NEAR(geometry::length(found.at - wanted.at), 0, border_mm);
  EXPECT_NEAR(found.diameter, wanted.diameter, border_mm);
  EXPECT_NEAR(found.top, wanted.top, border_mm);
  EXPECT_NEAR(found.bottom, wanted.bottom, border_mm);
  EXPECT_EQ(features::word_of(found.form), features::word_of(wanted.form));
  expect_parent(found.parent, wanted.parent);
}

void expect_tree(const features::Tree& tree, const RandomPart& part) {
  const double border_mm = kBorder_mm + part.rounding_mm;
  EXPECT_EQ(tree.unrecognised.size(), 0U);
  ASSERT_EQ(tree.features.size(), part.features.size());
  ASSERT_EQ(tree.holes.size(), part.holes.size());
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    SCOPED_TRACE("F" + std::to_string(i + 1));
    expect_feature(tree.features[i], part.features[i], border_mm);
  }
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    SCOPED_TRACE("H" + std::to_string(i + 1));
    expect_hole(tree.holes[i], part.holes[i], border_mm);
  }
}

// As files that `kerf features` takes.
void print(const RandomPart& part) {
  const char* const folder = std::getenv("KERF_PARTS_TEXT");
  if (folder == nullptr) return;
  std::ofstream(std::string(folder) + "/part.nc") << part.program;
  std::ofstream tools(std::string(folder) + "/tools.toml");
  for (const stock::Tool& tool : part.tools) {
    tools << "[[tool]]\nnumber = " << tool.number << "\ntype = \""
          << (tool.kind == stock::ToolKind::drill ? "drill" : "flat")
          << "\"\ndiameter = " << tool.value(stock::Measure::diameter).value_or(0) << "\n";
  }
}

TEST(GeneratedPrograms, AreRecognisedAsWhatTheyWereMadeOf) {
  const std::uint64_t first = from_environment("KERF_PARTS_FIRST", 1);
  const std::uint64_t count = from_environment("KERF_PARTS", 120);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const RandomPart part = random_part(seed);
    SCOPED_TRACE("KERF_PARTS_FIRST=" + std::to_string(seed) + " KERF_PARTS=1: " + part.made_of);
    auto result = job::recognise_features(job_of(part), features::Method::both);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->status, machine::RunStatus::end);
    expect_tree(result->tree, part);
    if (!HasFailure()) continue;
    print(part);
    if (std::getenv("KERF_PARTS_ALL") == nullptr) return;
  }
}

}  // namespace
}  // namespace kerf::parts
