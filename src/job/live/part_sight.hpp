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

  friend bool operator==(const PartWish&, const PartWish&) = default;
};

/// A place of the part with who left it.
struct PartAnswer {
  PartPlace place;
  PartOwner owner;  ///< line 0: nobody
};
/// Of what somebody wants to see; none: nothing is there.
[[nodiscard]] std::optional<PartAnswer> answer_at(Cutting& cutting, const PartWish& wish,
                                                  stock::Vec3 at);

/// What is there to see now.
struct PartLook {
  std::string frame{};              ///< of what has changed since; empty: all is seen
  bool has_more = false;            ///< it did not fit into one frame
  bool is_behind = false;           ///< the part is not cut as far as was asked for
  double time_s = 0;                ///< that is shown
  double removed_mm3 = 0;           ///< up to then
  std::vector<PartOwner> owners{};  ///< numbers that are new, from `first_owner` on
  std::size_t first_owner = 0;
};

/// One who looks at a part: what he has been sent is not sent again, and where he has been away
/// only the newest is. For one thread at a time, and of all sights at a cutting one at a time.
class PartSight {
 public:
  static constexpr std::size_t kFrameBytes = std::size_t{1} << 20U;  ///< about, of a frame

  /// None: `unwanted` came first.
  [[nodiscard]] std::optional<PartLook> look(const std::shared_ptr<Cutting>& cutting,
                                             const PartWish& wish, const std::stop_token& unwanted);

 private:
  /// Of a tile of the picture.
  struct Seen {
    std::uint64_t version = 0;  // when it was looked at last; 0: it never was
    std::uint64_t sent = 0;     // which bytes; 0: none
  };

  void begin(const std::shared_ptr<Cutting>& cutting, std::uint32_t level);
  void tell_owners(PartLook& look);
  [[nodiscard]] Picture::Parts changed(const Picture& picture, PartLook& look);
  static void add(const Picture::Parts& tile, Seen& seen, Picture::Parts& all);

  std::shared_ptr<Cutting> cutting_;
  std::uint32_t level_ = 0;
  std::uint32_t frames_ = 0;   // that were made
  std::uint32_t edition_ = 0;  // of the owners
  std::size_t owners_ = 0;     // that were told
  std::optional<double> shown_s_;
  std::vector<Seen> seen_;  // of the picture's tiles
};

}  // namespace kerf::job
