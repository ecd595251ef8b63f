#include "features/milling/milling.hpp"

#include "features/milling/finish.hpp"
#include "features/milling/workshop.hpp"

namespace kerf::features {

void recognise_milling(const Recording& recording, const Blank& blank, Allowance& allowance,
                       Tree& tree) {
  Workshop shop(recording, blank, allowance);
  for (std::size_t i = 0; i < tree.operations.size(); ++i)
    shop.follow(i, tree.operations[i].operation);
  for (std::size_t i = 0; i < tree.operations.size(); ++i)
    tree.operations[i].air_mm = shop.air_mm(i);
  allowance.begin_telling();
  finish(recording, shop, allowance, tree);
}

}  // namespace kerf::features
