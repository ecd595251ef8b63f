#include "face/server/transport/descriptors.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <string>

#include "face/server/hub/commands.hpp"

namespace kerf::server {
namespace {

// Besides connections: what listens, wakes, and stands on the disk; and the path of each machine.
constexpr rlim_t kOtherFiles = 40;
constexpr rlim_t kFewestConnections = 8;
constexpr rlim_t kWanted = kOtherFiles + limits::kMachines + limits::kConnections;

// Most files that may be open at once.
rlim_t raised_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return kWanted;
  if (limit.rlim_cur >= kWanted) return kWanted;
  rlimit more = limit;
  more.rlim_cur = std::min(limit.rlim_max, kWanted);
  return ::setrlimit(RLIMIT_NOFILE, &more) == 0 ? more.rlim_cur : limit.rlim_cur;
}

}  // namespace

base::Outcome<std::size_t> connections_that_fit() {
  const rlim_t most = raised_limit();
  if (most < kOtherFiles + kFewestConnections)
    return tl::unexpected(base::Failure{
        base::Failure::Kind::output, "only " + std::to_string(most) +
                                         " files may be open at once (ulimit -n); a server needs " +
                                         std::to_string(kOtherFiles + kFewestConnections)});
  return static_cast<std::size_t>(std::min<rlim_t>(limits::kConnections, most - kOtherFiles));
}

}  // namespace kerf::server
