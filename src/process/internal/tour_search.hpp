#pragma once

#include <cstdint>
#include <vector>

#include "process/internal/neighbours.hpp"
#include "process/internal/tour.hpp"

namespace kerf::process::ordering {

/// Makes a tour shorter, by changes of which each one does, until there is none among items that
/// are near each other:
///
///   2-opt    a stretch is made backwards       … a│b c d│e …  →  … a d c b e …
///   Or-opt   one to three items go elsewhere   … a│b c│d … x│y …  →  … a d … x c b y …
///   entry    an item is begun elsewhere
///
/// then, from places here and there, by a change that costs and what becomes better behind it
/// (which is taken back where nothing does). What must be made before stays before.
class TourSearch {
 public:
  TourSearch(Tour& tour, const Neighbours& neighbours);

  /// Until nothing is better, but for what a fixed amount of work leaves.
  void settle();
  void shake(std::size_t times);

 private:
  /// A stretch of places, both included.
  struct Stretch {
    std::uint32_t first, last;
    [[nodiscard]] bool has(std::uint32_t place) const { return place >= first && place <= last; }
    [[nodiscard]] std::uint32_t size() const { return last - first + 1; }
  };
  /// How much shorter the tour becomes, and what is to be done for it.
  struct Placing {
    double gain = 0;
    Stretch stretch{};
    std::uint32_t target = 0;  ///< between this place and the next
    bool is_turned = false;
  };

  void queue(std::uint32_t place);
  double work_off();
  double improve(std::uint32_t item);

  double better_entry(std::uint32_t item);
  double better_reversal(std::uint32_t item);
  double reversal_between(std::uint32_t one, std::uint32_t other);
  [[nodiscard]] double saved_by_turning(Stretch stretch) const;

  double better_place(std::uint32_t item);
  void place_near(Stretch stretch, bool by_first, Placing& best) const;
  void compare(Stretch stretch, std::uint32_t target, bool is_turned, double freed,
               Placing& best) const;
  void carry_out(const Placing& placing);

  [[nodiscard]] bool may_turn(Stretch stretch) const;
  [[nodiscard]] bool may_swap(std::uint32_t first, std::uint32_t middle, std::uint32_t end) const;
  [[nodiscard]] bool may_place(const Placing& placing) const;
  void shake_at(std::uint32_t first, std::uint32_t one, std::uint32_t other);

  Tour& tour_;
  const FlatItems& items_;
  const Neighbours& neighbours_;
  std::uint32_t longest_;  // stretch that is turned or gone over
  std::size_t budget_ = 0;
  std::vector<std::uint32_t> waiting_;  // a queue: items from next_ on
  std::size_t next_ = 0;
  std::vector<bool> waits_;
};

}  // namespace kerf::process::ordering
