// Any bytes as a program whose features are told: recognition must end with what it was allowed,
// and what cuts must be part of exactly one thing that is told. The first byte chooses the machine
// and what lies on its table.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "job/features_run.hpp"

namespace {

using namespace kerf;

void require(bool condition) {
  if (!condition) std::abort();
}

const machine::MachineDefinition& machine_of(std::uint8_t choice) {
  static const machine::MachineDefinition mill = *machine::find_machine("mill3");
  static const machine::MachineDefinition swivel = *machine::find_machine("mill5");
  static const machine::MachineDefinition lathe = *machine::find_machine("lathe2");
  if ((choice & 1U) != 0) return lathe;
  return (choice & 2U) != 0 ? swivel : mill;
}

job::StockJob job_of(std::uint8_t choice, std::string program) {
  const machine::MachineDefinition& machine = machine_of(choice);
  job::StockJob job{
      .job = {.definition = machine, .memory = control::Memory(machine.parameters.n_offsets)}};
  job.job.program = base::ProgramText::of("-", std::move(program));
  job.job.budget = {.seconds = 1, .motions = 1000, .steps = 20000};
  job.memory_bytes = std::size_t{(choice & 4U) != 0 ? 1U : 64U} << 20U;
  job.knows_stock = (choice & 8U) != 0;
  if (!job.knows_stock) return job;
  if (machine.turns()) {
    job.shape = machine::StockBar{.diameter = 50, .z0 = -100, .z1 = 0};
  } else {
    job.shape = stock::Workpiece{stock::BoxShape{{0, 0, -20}, {100, 60, 0}}};
  }
  return job;
}

/// The rows that things of the tree are made of, each counted as often as it is told.
class Told {
 public:
  explicit Told(const features::Recording& recording) : times_(recording.count()) {}

  void add(const std::vector<features::Span>& spans) {
    for (const features::Span& span : spans) add(span);
  }
  void add(const features::Span& span) {
    require(span.first <= span.last && span.last < times_.size());
    for (std::uint32_t row = span.first; row <= span.last; ++row) ++times_[row];
  }
  [[nodiscard]] int times(std::uint32_t row) const { return times_[row]; }

 private:
  std::vector<int> times_;
};

void add_features(const features::Tree& tree, Told& told) {
  for (const features::Feature& feature : tree.features) {
    require(!feature.layers.empty() || feature.turned);
    for (const features::Layer& layer : feature.layers) {
      require(std::isfinite(layer.area) && layer.area > -1e-3);
      told.add(layer.cuts);
      told.add(layer.entries);
    }
    if (feature.parent) require(feature.parent->feature < tree.features.size());
  }
}

// A mill's rows; those of a lathe may be part of a feature in more than one way.
void check(const features::Recording& recording, const features::Tree& tree) {
  Told told(recording);
  add_features(tree, told);
  for (const features::Hole& hole : tree.holes) {
    for (const features::HoleStep& step : hole.steps) told.add(step.rows);
  }
  for (const features::Unrecognised& rest : tree.unrecognised) told.add(rest.rows);
  for (const features::OperationFacts& facts : tree.operations) {
    const features::Span rows = facts.operation.rows;
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
      if (recording.is_at_feed(row) && !recording.turns) require(told.times(row) == 1);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto text = std::string(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto result = job::recognise_features(job_of(data[0], text), features::Method::both);
  require(result.has_value());
  check(result->recording, result->tree);
  return 0;
}
