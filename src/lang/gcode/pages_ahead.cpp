#include "lang/gcode/pages_ahead.hpp"

#include <system_error>
#include <utility>

namespace kerf::gcode {

PagesAhead::~PagesAhead() { stop(); }

void PagesAhead::stop() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  room_.notify_one();
  thread_.join();
}

// A thread for each stretch: there is hardly ever more than one.
void PagesAhead::begin(const Stretch& stretch) {
  stop();
  next_ = stretch;
  code_ = stretch.code;
  number_ = stretch.number;
  made_ = taken_ = 0;
  is_stopped_ = is_over_ = false;
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
    is_over_ = true;  // the system gives none
  }
}

bool PagesAhead::take(vm::CodeId code, std::uint32_t number, GcodePage& page) {
  if (code != code_ || number != number_) return false;
  bool wakes = false;
  {
    std::unique_lock lock(mutex_);
    made_one_.wait(lock, [this] { return taken_ < made_ || is_over_; });
    if (taken_ == made_) return false;
    std::swap(page, ring_[taken_ % kPages]);
    ++taken_;
    wakes = made_ - taken_ == kPages / 2;
  }
  ++number_;
  page.code = code;
  page.number = number;
  if (wakes) room_.notify_one();
  return true;
}

void PagesAhead::work() {
  bool goes_on = true;
  while (goes_on) {
    GcodePage* page = nullptr;
    {
      std::unique_lock lock(mutex_);
      // Woken for one page at a time the thread would cost more than it saves.
      if (made_ - taken_ == kPages)
        room_.wait(lock, [this] { return made_ - taken_ <= kPages / 2 || is_stopped_; });
      if (is_stopped_) return;
      page = &ring_[made_ % kPages];
    }
    const bool made = compile_next(*page);
    goes_on = made && !page->last;
    {
      const std::lock_guard lock(mutex_);
      if (made) ++made_;
      is_over_ = !goes_on;
    }
    made_one_.notify_one();
  }
}

// Names of variables are numbered in the order in which the program comes to them: not here.
bool PagesAhead::compile_next(GcodePage& page) {
  NameTable names;
  page.number = next_.number;
  try {
    compiler_.compile(*next_.file, next_.id, next_.start, next_.end, names, page);
  } catch (...) {
    return false;  // the caller meets it, too
  }
  ++next_.number;
  next_.start = {page.text_end, page.next_line, page.text_end};
  return names.size() == 0;
}

}  // namespace kerf::gcode
