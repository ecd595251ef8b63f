#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>

#include "lang/gcode/page_compiler.hpp"

namespace kerf::gcode {

/// Compiles the pages of a program that runs straight on, on a thread of its own, beside whoever
/// executes them:
///
///            this one's thread          │         caller's thread
///   compile ──▶ a ring of pages that wait ──▶ take()
///
/// A page is the same whoever compiles it: nothing depends on the clock. Bounded memory; the thread
/// waits while the ring is full. All functions are for one caller.
class PagesAhead {
 public:
  /// The rest of a program, from a page on.
  struct Stretch {
    const base::SourceFile* file = nullptr;
    base::FileId id = base::kNoFile;
    std::uint64_t end = 0;  ///< of the program, in its file
    vm::CodeId code{};
    std::uint32_t number = 0;  ///< of the page
    PageStart start;           ///< of the page
  };

  explicit PagesAhead(std::uint32_t lines_per_page) : compiler_(lines_per_page) {}
  ~PagesAhead();
  PagesAhead(const PagesAhead&) = delete;
  PagesAhead& operator=(const PagesAhead&) = delete;

  /// Goes on from here; what is left of another stretch is dropped. The file must outlive this.
  void begin(const Stretch& stretch);
  /// The next page of the stretch, in exchange for one that is free. False: that is another one, or
  /// it is not to be had here, because it names variables or something went wrong: the caller
  /// compiles it himself, and the stretch is over. `code` and `number` of the page stay the
  /// caller's.
  [[nodiscard]] bool take(vm::CodeId code, std::uint32_t number, GcodePage& page);

 private:
  static constexpr std::size_t kPages = 16;

  void stop();
  void work();
  [[nodiscard]] bool compile_next(GcodePage& page);

  vm::CodeId code_{};         // of the stretch
  std::uint32_t number_ = 0;  // of the page that is taken next
  PageCompiler compiler_;     // the thread's while there is one, as
  Stretch next_;              // what it compiles next

  std::mutex mutex_;  // of what follows; the thread has the pages that are not counted as made
  std::condition_variable room_;
  std::condition_variable made_one_;
  std::array<GcodePage, kPages> ring_;
  std::uint64_t made_ = 0;   // pages of this stretch that are compiled,
  std::uint64_t taken_ = 0;  // and that are taken
  bool is_over_ = true;      // no more will be made
  bool is_stopped_ = false;
  std::thread thread_;  // last: it sees all the others
};

}  // namespace kerf::gcode
