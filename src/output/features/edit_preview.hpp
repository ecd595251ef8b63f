#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/contour/region.hpp"
#include "output/features/edit_facts.hpp"

namespace kerf::output {

/// What edits would make of a program, for who edits it: contours, ways, areas, text. Coordinates
/// as contours are told; features, layers and holes as the unedited tree has them.
struct EditPreview {
  struct Problem {
    std::optional<std::size_t> edit;  ///< its place in the edits file, from 0; none: the file's
    std::uint32_t line = 0;           ///< of the edits file; 0: no place
    std::uint32_t column = 0;
    std::string code;
    std::string message;
    std::string hint;
    std::optional<geometry::Vec2> at;  ///< where the contour fails
  };
  /// A layer, from 1, of a feature or a hole.
  struct Place {
    std::string feature;
    std::size_t layer = 0;
  };
  struct Element {
    std::size_t id = 0;
    contour::Edge edge;
  };
  struct Outline {
    Place of;
    std::optional<std::size_t> island;  ///< none: the outer contour
    bool is_closed = true;              ///< shall be
    std::vector<Element> elements;
  };
  struct Paths {
    Place of;
    double z = 0;
    std::vector<contour::Contour> paths;  ///< of the tool's centre
  };
  struct Areas {
    Place of;
    contour::Region region;
  };
  /// What there is if a tool can cut it.
  struct Cut {
    std::vector<Paths> loops;
    std::vector<Areas> added;    ///< that is cut more
    std::vector<Areas> removed;  ///< less
    std::vector<Areas> rest;     ///< of what is asked for, that no tool reaches
    std::string diff;
    EditFacts edit;  ///< not verified
  };

  std::optional<Problem> problem;
  std::vector<Outline> contours;
  std::optional<Cut> cut;
  std::string report;  ///< of an edit that is verified, JSON; empty: none
};

/// Members of a JSON object, apart by commas, as docs/panel-protocol.md has them.
[[nodiscard]] std::string edit_preview_members(const EditPreview& preview);

}  // namespace kerf::output
