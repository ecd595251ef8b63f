#pragma once

#include <functional>
#include <stop_token>

#include "base/result.hpp"
#include "base/work_limit.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/request.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// What requests have done that is no machine's: where the library is read and written, and where
/// texts are computed with. The answer is what comes back.
class BackgroundWork {
 public:
  using DiskAction = std::function<base::Outcome<Json>(Library&)>;
  using Computation = std::function<base::Outcome<Json>(const base::WorkLimit& limit)>;

  /// `library` and `answers` must outlive the workers, and the workers the last call.
  BackgroundWork(Library& library, Worker& disk, Worker& aside, const Answers& answers)
      : library_(library), disk_(disk), aside_(aside), answers_(answers) {}

  /// Where files are read. Not done for a client who has left.
  void read_disk(const Request& request, DiskAction action);
  /// The same where they are changed: what was taken is done, whoever leaves.
  void change_disk(const Request& request, DiskAction action);
  /// For work that may take long and touches nothing of the server: one at a time of each client.
  /// It is to keep to its limit, limits::kAsideSeconds of computing; a client who leaves ends it.
  void compute(const Request& request, Computation action);

 private:
  void do_on_disk(const Reply& reply, std::stop_token unwanted, DiskAction action);

  Library& library_;
  Worker& disk_;
  Worker& aside_;
  const Answers& answers_;
};

}  // namespace kerf::server
