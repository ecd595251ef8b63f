#pragma once

#include <string>

#include "seeded_random.hpp"

namespace kerf::test {

/// A program that does not end by itself, or not for a long time.
struct EndlessProgram {
  std::string name;     ///< its ending says its language
  std::string machine;  ///< built in
  std::string text;
};

/// One of any language: loops of every kind around and within each other, calls, stops, messages,
/// dwells, moves and questions in them.
[[nodiscard]] EndlessProgram endless_program(SeededRandom& random);

}  // namespace kerf::test
