#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "job/stock_run.hpp"
#include "output/reports/stock_facts.hpp"
#include "training/exercise.hpp"

namespace kerf::training {

/// The part that a program of an exercise has made.
struct PartTrial {
  job::StockResult cut;
  output::StockFacts facts;          ///< of it
  std::vector<std::uint32_t> lines;  ///< of motions, in the program of the exercise, by number

  /// 0: the motion has none.
  [[nodiscard]] std::uint32_t line_of(std::uint64_t motion) const {
    return motion < lines.size() ? lines[motion] : 0;
  }
};

/// Cuts the stock of the exercise, with at most so many motions of the program, 0: with as many as
/// it has. Failure (usage):
/// this machine cannot have such a stock, or cannot cut it with such tools. Failure (input): the
/// exercise itself is wrong. Precondition: it has a part.
[[nodiscard]] base::Outcome<PartTrial> part_trial(const Exercise& exercise,
                                                  const machine::MachineDefinition& definition,
                                                  const std::string& program,
                                                  std::uint64_t most_motions,
                                                  const std::stop_token& unwanted);

}  // namespace kerf::training
