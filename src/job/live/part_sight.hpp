#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "job/live/cutting.hpp"

namespace kerf::job {

/// What somebody wants to see of a part.
struct PartWish {
  std::optional<double> time_s{};  ///< of the run; none: as far as it is cut
  std::uint32_t level = 0;         ///< or the finest that there is
  bool deviation = false;          ///< with how far places are from the design, if there is one

  friend bool operator==(const PartWish&, const PartWish&) = default;
};

/// A place of the part with who left it.
struct PartAnswer {
  PartPlace place;
  PartOwner owner;                       ///< line 0: nobody
  std::optional<double> deviation_mm{};  ///< none: there is no design
};
/// Of what somebody wants to see; none: nothing is there.
[[nodiscard]] std::optional<PartAnswer> answer_at(Cutting& cutting, const PartWish& wish,
                                                  stock::Vec3 at);

/// What is there to see now.
struct PartLook {
  std::vector<std::string> frames{};  ///< of what has changed since: shape, then what it is told of
  bool has_more = false;              ///< there is more to see than these
  bool is_partial = false;            ///< of the shape, too
  bool is_behind = false;             ///< the part is not cut as far as was asked for
  double time_s = 0;                  ///< that is shown
  double removed_mm3 = 0;             ///< up to then
  std::vector<OwnerRow> owners{};     ///< of numbers from `first_owner` on, where they are new
  std::size_t first_owner = 0;
};

/// One who looks at a part: what he has been sent is not sent again, and where he has been away
/// only the newest is. For one thread at a time, and of all sights at a cutting one at a time.
class PartSight {
 public:
  static constexpr std::size_t kFrameBytes = std::size_t{1} << 20U;  ///< about, of a frame
  /// About, of which a look tells how far they are from a design: a tenth of a second.
  static constexpr std::size_t kPlacesAtOnce = std::size_t{1} << 16U;

  /// None: `unwanted` came first.
  [[nodiscard]] std::optional<PartLook> look(const std::shared_ptr<Cutting>& cutting,
                                             const PartWish& wish, const std::stop_token& unwanted);

 private:
  /// Of a tile of the picture.
  struct Seen {
    std::uint64_t version = 0;  // when it was looked at last; 0: it never was
    std::uint64_t sent = 0;     // which bytes; 0: none
    bool lacks_owners = false;  // which of what was sent were not told
    bool lacks_deviations = false;
  };

  void begin(const std::shared_ptr<Cutting>& cutting, std::uint32_t level);
  void tell_owners(PartLook& look);
  [[nodiscard]] Picture::Parts changed(const Picture& picture, PartLook& look);
  static void add(const Picture::Parts& tile, Seen& seen, Picture::Parts& all);
  void put(output::PartKind kind, const Picture::Parts& parts, PartLook& look);
  [[nodiscard]] Picture::Parts facts(const Picture& picture, bool with_deviation,
                                     const std::stop_token& unwanted, PartLook& look);
  std::size_t tell(const std::vector<Picture::Places>& places, const DesignInSight* design,
                   Seen& seen, Picture::Parts& all);

  std::shared_ptr<Cutting> cutting_;
  std::uint32_t level_ = 0;
  std::uint32_t frames_ = 0;   // that were made
  std::uint32_t edition_ = 0;  // of the owners
  std::uint64_t owners_ = 0;   // their change that was told last
  std::optional<double> shown_s_;
  std::vector<Seen> seen_;  // of the picture's tiles
};

}  // namespace kerf::job
