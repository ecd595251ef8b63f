#pragma once

#include <array>
#include <cstdint>

namespace kerf::stock::surface {

/// A cell is a cube of the lattice. Corner number: bit 0 is its place along X, 1 along Y, 2 along
/// Z. Edge number: 4 axis + b + 2 c, where b and c are its places on the next axis and the one
/// after. Face number: 2 axis + side. Its eight corners, inside or not, are its form.
inline constexpr int kCellEdges = 12;
inline constexpr int kCellFaces = 6;

/// How the surface runs through a cell: as closed lines around the cube, each crossing some edges,
/// from face to face. Each becomes one corner of the surface's triangles.
///
/// A face that is crossed on all its four edges is doubtful: its two inside corners hang together
/// or they do not. Here they do not, so that what touches at an edge is two things. If then on both
/// sides of a face one and the same line crosses it twice, four triangles would meet in one edge;
/// there they do hang together after all, and each line becomes two (`turned`).
struct CellCycles {
  static constexpr std::uint8_t kNone = 0xff;

  std::uint8_t count = 0;
  std::array<std::uint8_t, kCellEdges> of_edge{};  ///< number of the line, kNone: not crossed
  std::uint8_t doubled = 0;                        ///< faces, as bits, that one line crosses twice
};

/// `turned`: faces, as bits, on which doubtful corners hang together.
[[nodiscard]] CellCycles make_cycles(std::uint8_t form, std::uint8_t turned);
/// make_cycles(form, 0), from a table.
[[nodiscard]] const CellCycles& cycles_of(std::uint8_t form);

/// The edge of a cell: along `axis`, at b and c on the next axis and the one after that.
[[nodiscard]] constexpr int edge_number(int axis, int b, int c) { return 4 * axis + b + 2 * c; }
/// Its lower corner.
[[nodiscard]] constexpr std::array<int, 3> edge_begin(int edge) {
  std::array<int, 3> at{};
  const int axis = edge / 4;
  at[static_cast<std::size_t>((axis + 1) % 3)] = edge & 1;
  at[static_cast<std::size_t>((axis + 2) % 3)] = (edge >> 1) & 1;
  return at;
}
[[nodiscard]] constexpr int corner_number(std::array<int, 3> at) {
  return at[0] + 2 * at[1] + 4 * at[2];
}

}  // namespace kerf::stock::surface
