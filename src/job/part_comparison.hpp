#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "job/stock_run.hpp"
#include "stock/compare/mesh_solid.hpp"
#include "stock/cutting/placement.hpp"

namespace kerf::job {

/// What a part shall be, frame of the stock.
struct Design {
  explicit Design(mesh::SolidMesh read)
      : solid(std::move(read.mesh)), changes(std::move(read.changes)) {}

  stock::compare::MeshSolid solid;
  std::vector<std::string> changes;  ///< what of its file was not taken as it was
};

/// Reads the design of a job from an STL file, mm, and counts its memory. Failure (input): as
/// machine::read_mesh() has them.
[[nodiscard]] base::Outcome<void> read_design(const std::string& path,
                                              const stock::Placement& place, StockJob& job);

/// Compares what is left with the design of the job: fills in StockResult::compare, and adds a
/// finding for each region beyond tolerance to those of the run. Nothing without a design. Failure
/// (input): the two have no place in common.
[[nodiscard]] base::Outcome<void> compare_with_design(const StockJob& job, StockResult& result);

/// How far places are from the design of the job, mm, as Comparison has it. Precondition: there is
/// one.
[[nodiscard]] std::vector<float> deviations_mm(const StockJob& job,
                                               std::span<const stock::Vec3> places);

}  // namespace kerf::job
