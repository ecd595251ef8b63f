#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "job/live/owner_table.hpp"
#include "output/part/part_frame.hpp"
#include "stock/replay/player.hpp"

namespace kerf::job {

/// A place on a part.
struct PartPlace {
  stock::Vec3 at;            ///< frame of the stock
  std::uint32_t motion = 0;  ///< that left it; 0: none
  double energy_j_mm2 = 0;   ///< of a sheet
};

/// What is seen of a part as it stands, in tiles.
class Picture : public base::Interface {
 public:
  /// Some parts of a frame.
  struct Parts {
    std::string bytes{};
    std::uint32_t count = 0;
    bool is_empty = false;  ///< nothing is there: to be told where something was
  };
  /// Of one of those parts what can be told besides.
  struct Places {
    stock::surface::Place part{};         ///< by which it is named
    output::PartPlaces at{};              ///< in its order
    std::vector<std::uint16_t> owners{};  ///< who cut there, where the part itself does not tell
  };

  [[nodiscard]] virtual output::PartKind kind() const = 0;
  [[nodiscard]] virtual std::size_t tiles() const = 0;
  /// Another number than before: the tile may look different.
  [[nodiscard]] virtual std::uint64_t version(std::size_t tile) const = 0;
  [[nodiscard]] virtual Parts parts(std::size_t tile) const = 0;
  /// Of those parts; none: nothing is told besides.
  [[nodiscard]] virtual std::vector<Places> places(std::size_t /*tile*/) const { return {}; }
  /// Up to where the part stands.
  [[nodiscard]] virtual double removed_mm3() const = 0;
  /// The place of the part's surface that is nearest, or stands over this one; none: nothing is
  /// there.
  [[nodiscard]] virtual std::optional<PartPlace> nearest(stock::Vec3 at) const = 0;
  /// The part may have changed.
  virtual void look() {}
};

/// What a picture is to show.
struct PictureOf {
  const OwnerTable& owners;
  /// There are corners all along the lines of a half section, so that what is told of them holds in
  /// between.
  bool is_compared = false;
};

/// Of a model; it, its tiles and the owners outlive the picture.
[[nodiscard]] std::unique_ptr<Picture> picture_of(const stock::Model& model,
                                                  const stock::replay::Tiles& tiles,
                                                  const PictureOf& of);

}  // namespace kerf::job
