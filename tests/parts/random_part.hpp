#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "features/tree/tree.hpp"
#include "outline.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::parts {

/// What something of a part shall be recognised as; what is not said is not looked at.
struct WantedFeature {
  features::FeatureType type = features::FeatureType::pocket;
  double top = 0;
  std::vector<double> layers{};  ///< their z
  Contour outline{};
  std::vector<Contour> islands{};
  std::optional<Contour> nominal{};
  bool is_round = false;
  std::optional<features::Strategy> strategy{};
  std::optional<features::Order> order{};
  std::optional<features::Milling> milling{};
  std::optional<features::Entry::Kind> entry{};
  std::optional<std::pair<std::size_t, features::RelationKind>> parent{};
  std::size_t cuts = 1;
};
struct WantedHole {
  Vec2 at{};
  double diameter = 0;
  double top = 0;
  double bottom = 0;
  features::Hole::Form form = features::Hole::Form::plain;
  std::optional<std::pair<std::size_t, features::RelationKind>> parent{};
};

/// A part of random things, programmed in a random way.
struct RandomPart {
  std::string program{};
  std::vector<stock::Tool> tools{};
  std::optional<Vec2> stock{};  ///< a box from the zero of the part to here; none: nobody says
  double stock_depth = 0;
  Vec2 zero{};  ///< of the part, machine coordinates
  std::vector<WantedFeature> features{};
  std::vector<WantedHole> holes{};
  double rounding_mm = 0;  ///< of its words, at most
  std::string made_of{};   ///< what things, for people
};

[[nodiscard]] RandomPart random_part(std::uint64_t seed);

}  // namespace kerf::parts
