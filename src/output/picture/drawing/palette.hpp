#pragma once

#include <array>
#include <cstddef>

#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

inline constexpr Color kWhite{255, 255, 255};
inline constexpr Color kDark{34, 34, 34};     // text, holes
inline constexpr Color kSoft{105, 105, 105};  // less important text
inline constexpr Color kFrame{150, 150, 150};
inline constexpr Color kAxis{190, 190, 190};  // zero lines, edges of the box
inline constexpr Color kGrid{233, 233, 233};
inline constexpr Color kTravel{140, 140, 140};
inline constexpr Color kFaintTravel{200, 200, 200};  // where there is much of it

/// Colours that people who see colours differently can tell apart on white: Okabe and Ito's without
/// the yellow, then the same ones darker. From the thirteenth tool on they repeat; labels tell.
inline constexpr std::array<Color, 13> kToolColors{{{0, 114, 178},
                                                    {213, 94, 0},
                                                    {0, 158, 115},
                                                    {204, 121, 167},
                                                    {230, 159, 0},
                                                    {86, 180, 233},
                                                    {0, 0, 0},
                                                    {0, 57, 89},
                                                    {130, 50, 0},
                                                    {0, 84, 61},
                                                    {128, 62, 99},
                                                    {133, 92, 0},
                                                    {38, 105, 145}}};

}  // namespace kerf::output::plot
