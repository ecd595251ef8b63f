#pragma once

#include <functional>
#include <string>

#include "base/result.hpp"
#include "face/server/hub/request.hpp"

namespace kerf::server {

/// Hands something to the thread of the sockets. From any thread.
using ToSockets = std::function<void(std::function<void()>)>;

/// The way back to the thread of the sockets. From any thread.
class Answers {
 public:
  /// `folder`: where the server keeps its data.
  Answers(ToSockets to_sockets, const std::string& folder)
      : to_sockets_(std::move(to_sockets)), folder_(folder + "/") {}

  void to_sockets(std::function<void()> action) const { to_sockets_(std::move(action)); }
  /// The answer is made here and sent there.
  void answer(const Reply& reply, const base::Outcome<Json>& outcome) const;
  /// A sentence of the disk as a client may read it: where the server keeps its data is nobody's
  /// business.
  [[nodiscard]] std::string without_folder(std::string sentence) const;

 private:
  ToSockets to_sockets_;
  std::string folder_;
};

}  // namespace kerf::server
