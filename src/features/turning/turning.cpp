#include "features/turning/turning.hpp"

#include "features/turning/lathe_work.hpp"

namespace kerf::features {

void recognise_turning(const Recording& recording, const Blank& blank, Tree& tree) {
  LatheWork work(recording, blank);
  for (std::size_t i = 0; i < tree.operations.size(); ++i)
    work.follow(i, tree.operations[i].operation);
  work.finish(tree);
}

}  // namespace kerf::features
