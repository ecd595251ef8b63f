#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "job/other_part.hpp"
#include "job/stock_run.hpp"
#include "machine/definition/set_up.hpp"
#include "stock/compare/mesh_solid.hpp"

namespace kerf::job {

/// What a part shall be, frame of the stock.
struct Design {
  Design(mesh::SolidMesh read, machine::MeshUnit read_in)
      : solid(std::move(read.mesh)), changes(std::move(read.changes)), unit(read_in) {}

  stock::compare::MeshSolid solid;
  std::vector<std::string> changes;  ///< what of its file was not taken as it was
  machine::MeshUnit unit;            ///< of its file
};

/// Reads the design of a job, puts it where it is said to lie, and counts its memory. Failure
/// (input): as machine::read_mesh() has them.
[[nodiscard]] base::Outcome<void> read_design(const machine::SetUp::Design& design, StockJob& job);

/// That of a set-up, with its tolerance, where it has one; read_design().
[[nodiscard]] base::Outcome<void> take_design(const std::optional<machine::SetUp::Design>& design,
                                              StockJob& job);

/// Likewise, and shows it to those who look on: StockJob::design_in_sight.
[[nodiscard]] base::Outcome<void> show_design(const std::optional<machine::SetUp::Design>& design,
                                              StockJob& job);

/// Compares what is left with the design of the job: fills in StockResult::compare, and adds a
/// finding for each region beyond tolerance to those of the run. Nothing without a design. Failure
/// (input): the two have no place in common.
[[nodiscard]] base::Outcome<void> compare_with_design(const StockJob& job, StockResult& result);

/// How far places are from the design of the job, where it has none from the other part, mm, as
/// Comparison has it. Precondition: there is one of them.
[[nodiscard]] std::vector<float> deviations_mm(const StockJob& job, const OtherPart* other,
                                               std::span<const stock::Vec3> places);

}  // namespace kerf::job
