#include "features/turning/turning.hpp"

#include "features/turning/lathe_work.hpp"

namespace kerf::features {

void recognise_turning(const Recording& recording, const Blank& blank, Allowance& allowance,
                       Tree& tree) {
  LatheWork work(recording, blank, allowance);
  for (std::size_t i = 0; i < tree.operations.size(); ++i)
    work.follow(i, tree.operations[i].operation);
  allowance.begin_telling();
  work.finish(tree);
}

}  // namespace kerf::features
