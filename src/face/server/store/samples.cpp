#include "face/server/store/samples.hpp"

namespace kerf::server {

const std::vector<FirstMachine>& first_machines() {
  static const std::vector<FirstMachine> machines = {
      {"mill", "mill3", "flanges.nc"},        {"laser", "laser3", "cardioid.bas"},
      {"laser-xtz", "laser-xtz", "lens.bas"}, {"five-axis", "laser5", "tube.tch"},
      {"arm", "arm4", "flower.nc"},           {"lathe", "lathe2", "shaft.nc"},
  };
  return machines;
}

}  // namespace kerf::server
