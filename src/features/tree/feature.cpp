#include "features/tree/feature.hpp"

namespace kerf::features {

double Feature::volume() const {
  double sum = turned_volume;
  for (const Layer& layer : layers) sum += layer.volume();
  return sum;
}

}  // namespace kerf::features
