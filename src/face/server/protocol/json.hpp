#pragma once

#include "machine/panel/argument.hpp"

namespace kerf::server {

using machine::Argument;
using machine::Arguments;
using machine::Json;

}  // namespace kerf::server
