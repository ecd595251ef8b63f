#include "face/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace kerf::cli {
namespace {

constexpr std::chrono::milliseconds kFirst{500};
constexpr std::chrono::milliseconds kPeriod{100};
constexpr std::size_t kBarWidth = 30;

}  // namespace

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) == 1), next_(Clock::now() + kFirst) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::uint64_t done, std::uint64_t total, std::uint64_t motions) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kPeriod;
  shown_ = true;
  const double part =
      total == 0 ? 0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  const auto filled = static_cast<std::size_t>(part * kBarWidth);
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  fmt::print(stderr, "\r[{}] {:3.0f} %  {} motions\033[K", bar, part * 100, motions);
  std::fflush(stderr);
}

}  // namespace kerf::cli
