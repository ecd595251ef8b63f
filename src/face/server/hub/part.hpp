#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/program_text.hpp"
#include "base/result.hpp"
#include "face/server/protocol/state_document.hpp"
#include "job/job.hpp"
#include "job/live/live_part.hpp"

namespace kerf::server {

/// What the part of a machine is cut from: what its preview runs.
struct PartSource {
  std::string program;  ///< its name
  job::Job job;         ///< but for its text, which may have to wait for the disk:
  std::function<base::Outcome<base::ProgramText>()> text;
};

/// The part of what a machine has loaded. The document belongs to the thread of the sockets.
struct Part {
  explicit Part(job::LivePart::Order order) : live(std::move(order)) {}

  job::LivePart live;
  StateDocument document;  ///< what all who look are told
};

}  // namespace kerf::server
