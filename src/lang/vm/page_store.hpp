#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lang/vm/code_page.hpp"

namespace kerf::vm {

/// How the code of programs is cut into pages, and how many of them are kept.
struct PageSettings {
  std::uint32_t lines_per_page = 256;
  std::size_t fresh_pages = 8;         ///< kept while a program runs straight on
  std::size_t most_pages = 1024;       ///< kept at most, some 30 MiB
  std::size_t most_bytes = 64U << 20;  ///< of pages, when they are larger than usual
};

/// A bounded store of pages. A program that runs straight on uses the same few over and over, so
/// its length costs nothing; a program that comes back to a page that had to go keeps more of them
/// from then on, so that no loop reads its text twice per pass.
///
/// `Page` is a CodePage with `std::size_t bytes() const`.
template <typename Page>
class PageStore {
 public:
  explicit PageStore(const PageSettings& settings)
      : settings_(settings), allowed_(settings.fresh_pages) {}

  /// The page, if it is kept; it counts as used.
  [[nodiscard]] Page* find(CodeId code, std::uint32_t number) {
    const auto holds = [&](const Slot& slot) {
      return slot.page->code == code && slot.page->number == number;
    };
    if (newest_ >= slots_.size() || !holds(slots_[newest_])) {
      const auto found = std::find_if(slots_.begin(), slots_.end(), holds);
      if (found == slots_.end()) return nullptr;
      newest_ = static_cast<std::size_t>(found - slots_.begin());
    }
    slots_[newest_].used = ++clock_;
    return slots_[newest_].page.get();
  }

  /// A page for this code to be compiled into, in place of the one that was not used for longest.
  /// `seen_before`: it has been compiled before and had to go, so the program loops.
  [[nodiscard]] Page& make_room(CodeId code, std::uint32_t number, bool seen_before) {
    if (seen_before && slots_.size() >= allowed_)
      allowed_ = std::min(allowed_ * 2, settings_.most_pages);
    if (slots_.empty() || (slots_.size() < allowed_ && bytes_held() < settings_.most_bytes)) {
      slots_.push_back({std::make_unique<Page>(), 0});
      newest_ = slots_.size() - 1;
    } else {
      const auto oldest =
          std::min_element(slots_.begin(), slots_.end(),
                           [](const Slot& a, const Slot& b) { return a.used < b.used; });
      newest_ = static_cast<std::size_t>(oldest - slots_.begin());
    }
    Slot& slot = slots_[newest_];
    slot.used = ++clock_;
    slot.page->code = code;
    slot.page->number = number;
    return *slot.page;
  }

 private:
  struct Slot {
    std::unique_ptr<Page> page;
    std::uint64_t used = 0;
  };

  [[nodiscard]] std::size_t bytes_held() const {
    std::size_t bytes = 0;
    for (const Slot& slot : slots_) bytes += slot.page->bytes();
    return bytes;
  }

  PageSettings settings_;
  std::vector<Slot> slots_;
  std::size_t newest_ = 0;   // slot that was asked for last
  std::size_t allowed_ = 0;  // slots in use at most, for now
  std::uint64_t clock_ = 0;
};

}  // namespace kerf::vm
