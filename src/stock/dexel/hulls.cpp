#include "stock/dexel/hulls.hpp"

namespace kerf::stock::dexel {

void Hulls::look() {
  rows_ = std::make_unique<Rows>();
  rows_->fill(Four{Glance::Four{1, 1, 1, 1}, Glance::Four{-1, -1, -1, -1}, 0});
  for (std::size_t i = 0; i < tile_.count(); ++i) look_at(i);
}

void Hulls::look_at(std::size_t dexel) {
  const int column = static_cast<int>(dexel) % tile_.columns();
  Four& four = (*rows_)[place(column, static_cast<int>(dexel) / tile_.columns())];
  const int i = column % Glance::kLines;
  const auto ends = tile_.ends(dexel);
  const unsigned bit = 1U << static_cast<unsigned>(i);
  four.low[i] = ends.empty() ? 1 : ends.front().at;
  four.high[i] = ends.empty() ? -1 : ends.back().at;
  four.single = ends.size() == 2 ? four.single | bit : four.single & ~bit;
}

}  // namespace kerf::stock::dexel
