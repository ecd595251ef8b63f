#include "process/internal/dots.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/decimal.hpp"
#include "process/raster.hpp"

namespace kerf::process {
namespace {

constexpr double kWhiteGrey = 255;
constexpr double kMiddleGrey = 128;

double darkness(double grey) { return (kWhiteGrey - grey) / kWhiteGrey; }

class ThresholdDots : public Dots {
 public:
  explicit ThresholdDots(double level) : level_(level) {}
  void make(std::span<const double> greys, std::span<double> powers) override {
    for (std::size_t x = 0; x < greys.size(); ++x) powers[x] = greys[x] < level_ ? 1 : 0;
  }

 private:
  double level_;
};

/// Bayer's matrix, n by n: M2 = [[0, 2], [3, 1]], M2n = 4 Mn(repeated) + M2 by quadrant.
class OrderedDots : public Dots {
 public:
  explicit OrderedDots(std::size_t n) : n_(n), thresholds_(n * n) {
    for (std::size_t y = 0; y < n; ++y) {
      for (std::size_t x = 0; x < n; ++x)
        thresholds_[y * n + x] = static_cast<double>(place_in_order(x, y, n)) + 0.5;
    }
  }
  void make(std::span<const double> greys, std::span<double> powers) override {
    const double* const row = thresholds_.data() + (row_++ % n_) * n_;
    const auto steps = static_cast<double>(n_ * n_);
    for (std::size_t x = 0; x < greys.size(); ++x)
      powers[x] = darkness(greys[x]) * steps > row[x % n_] ? 1 : 0;
  }

 private:
  static std::size_t place_in_order(std::size_t x, std::size_t y, std::size_t n) {
    constexpr std::array<std::array<std::size_t, 2>, 2> kFirst = {{{0, 2}, {3, 1}}};
    if (n == 2) return kFirst[y][x];
    const std::size_t half = n / 2;
    return 4 * place_in_order(x % half, y % half, half) + kFirst[y / half][x / half];
  }

  std::size_t n_;
  std::vector<double> thresholds_;
  std::size_t row_ = 0;
};

/// How much of an error goes to a neighbour.
struct Share {
  int right;
  std::size_t down;
  double weight;
};

constexpr std::array<Share, 4> kFloydSteinberg = {
    {{1, 0, 7.0 / 16}, {-1, 1, 3.0 / 16}, {0, 1, 5.0 / 16}, {1, 1, 1.0 / 16}}};

constexpr std::array<Share, 12> kJarvis = {{{1, 0, 7.0 / 48},
                                            {2, 0, 5.0 / 48},
                                            {-2, 1, 3.0 / 48},
                                            {-1, 1, 5.0 / 48},
                                            {0, 1, 7.0 / 48},
                                            {1, 1, 5.0 / 48},
                                            {2, 1, 3.0 / 48},
                                            {-2, 2, 1.0 / 48},
                                            {-1, 2, 3.0 / 48},
                                            {0, 2, 5.0 / 48},
                                            {1, 2, 3.0 / 48},
                                            {2, 2, 1.0 / 48}}};

constexpr std::array<Share, 12> kStucki = {{{1, 0, 8.0 / 42},
                                            {2, 0, 4.0 / 42},
                                            {-2, 1, 2.0 / 42},
                                            {-1, 1, 4.0 / 42},
                                            {0, 1, 8.0 / 42},
                                            {1, 1, 4.0 / 42},
                                            {2, 1, 2.0 / 42},
                                            {-2, 2, 1.0 / 42},
                                            {-1, 2, 2.0 / 42},
                                            {0, 2, 4.0 / 42},
                                            {1, 2, 2.0 / 42},
                                            {2, 2, 1.0 / 42}}};

/// What a pixel is too dark or too light, its neighbours behind and below make good.
template <const auto& kShares>
class DiffusedDots : public Dots {
 public:
  explicit DiffusedDots(std::size_t columns) {
    for (auto& row : errors_) row.resize(columns + 2 * kMargin);
  }
  void make(std::span<const double> greys, std::span<double> powers) override {
    for (std::size_t x = 0; x < greys.size(); ++x) {
      const double value = greys[x] + errors_[0][x + kMargin];
      const bool burns = value < kMiddleGrey;
      powers[x] = burns ? 1 : 0;
      const double error = burns ? value : value - kWhiteGrey;
      for (const Share& share : kShares)
        errors_[share.down][x + kMargin + static_cast<std::size_t>(share.right)] +=
            error * share.weight;
    }
    std::fill(errors_[0].begin(), errors_[0].end(), 0.0);
    std::rotate(errors_.begin(), errors_.begin() + 1, errors_.end());
  }

 private:
  static constexpr std::size_t kMargin = 2;  // what leaves the picture is lost there

  std::array<std::vector<double>, 3> errors_;  // of this row and those below
};

class GreyDots : public Dots {
 public:
  GreyDots(const Operation& operation, const Settled& settled)
      : curve_(operation.curve),
        least_(operation.min_power_percent.value_or(0)),
        most_(settled.power_percent) {}
  void make(std::span<const double> greys, std::span<double> powers) override {
    for (std::size_t x = 0; x < greys.size(); ++x) powers[x] = power_of(greys[x]);
  }

 private:
  [[nodiscard]] double power_of(double grey) {
    if (grey == last_grey_) return last_power_;
    last_grey_ = grey;
    return last_power_ = shared(darkness(grey));
  }
  /// In steps of 0.1 % of full power.
  [[nodiscard]] double shared(double dark) const {
    if (dark <= 0 || most_ <= 0) return 0;
    const double percent = least_ + (most_ - least_) * linear_between(curve_, dark);
    return static_cast<double>(base::round_away(10 * percent)) / 10 / most_;
  }

  std::vector<std::pair<double, double>> curve_;
  double least_;
  double most_;
  double last_grey_ = -1;
  double last_power_ = 0;
};

}  // namespace

std::unique_ptr<Dots> dots_of(const Operation& operation, const Settled& settled,
                              std::size_t columns) {
  switch (operation.mode) {
    case Dither::threshold: return std::make_unique<ThresholdDots>(operation.level);
    case Dither::ordered_2: return std::make_unique<OrderedDots>(2);
    case Dither::ordered_4: return std::make_unique<OrderedDots>(4);
    case Dither::ordered_8: return std::make_unique<OrderedDots>(8);
    case Dither::floyd_steinberg: return std::make_unique<DiffusedDots<kFloydSteinberg>>(columns);
    case Dither::jarvis: return std::make_unique<DiffusedDots<kJarvis>>(columns);
    case Dither::stucki: return std::make_unique<DiffusedDots<kStucki>>(columns);
    case Dither::grey: break;
  }
  return std::make_unique<GreyDots>(operation, settled);
}

}  // namespace kerf::process
