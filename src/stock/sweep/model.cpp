#include "stock/sweep/model.hpp"

namespace kerf::stock {

void Model::use(base::Helper* /*helper*/) {}

Stretch Model::material_on(const StraightWay& /*line*/) const { return {}; }

std::vector<Piece> Model::pieces() const {
  if (!(left_mm3() > 0)) return {};
  return {{left_mm3(), extents(), true}};
}

}  // namespace kerf::stock
