#pragma once

#include <string>

namespace kerf::server {

/// A line on the standard error output, for whoever runs the server. From any thread.
void tell_console(const std::string& sentence);

}  // namespace kerf::server
