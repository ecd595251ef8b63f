#include "face/server/hub/internal/background_work.hpp"

#include "face/server/hub/guarded.hpp"

namespace kerf::server {

void BackgroundWork::do_on_disk(const Reply& reply, std::stop_token unwanted, DiskAction action) {
  disk_.post({.work =
                  [this, reply, action = std::move(action)] {
                    answers_.answer(reply, guarded([&] { return action(library_); }));
                  },
              .unwanted = std::move(unwanted)});
}

void BackgroundWork::read_disk(const Request& request, DiskAction action) {
  do_on_disk(request.reply, request.unwanted(), std::move(action));
}

void BackgroundWork::change_disk(const Request& request, DiskAction action) {
  do_on_disk(request.reply, {}, std::move(action));
}

void BackgroundWork::compute(const Request& request, Computation action) {
  const std::stop_token unwanted = request.unwanted();
  aside_.post({.work =
                   [this, reply = request.reply, action = std::move(action), unwanted] {
                     const base::WorkLimit limit(limits::kAsideSeconds, unwanted);
                     answers_.answer(reply, guarded([&] { return action(limit); }));
                   },
               .unwanted = unwanted,
               .owner = request.client.get()});
}

}  // namespace kerf::server
