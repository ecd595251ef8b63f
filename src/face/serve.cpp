#include "face/serve.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "base/source_file.hpp"
#include "face/cli/failure.hpp"
#include "face/server/hub/protocol_page.hpp"
#include "face/server/transport/server.hpp"

namespace kerf {
namespace {

using cli::ExitStatus;
using cli::fail;
using cli::ServeOptions;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

// Empty: the environment names no place.
std::string usual_data_folder() {
  if (const std::string data = environment("XDG_DATA_HOME"); !data.empty()) return data + "/kerf";
  if (const std::string home = environment("HOME"); !home.empty())
    return home + "/.local/share/kerf";
  return "";
}

// Of the command line, which others on this computer see, of a file, or of the environment.
base::Outcome<std::string> token_of(const ServeOptions& options) {
  constexpr std::size_t kLargest = 4096;
  if (options.token_file.empty())
    return options.token.empty() ? environment("KERF_TOKEN") : options.token;
  auto text = base::read_whole(options.token_file, kLargest, "a token");
  if (!text)
    return tl::unexpected(base::Failure{text.error().kind, "--token-file " + text.error().message});
  text->erase(text->find_last_not_of(" \t\r\n") + 1);
  if (text->empty())
    return cli::usage("--token-file " + options.token_file + ": the file is empty");
  return text;
}

void tell(const server::Server& server, const std::string& data) {
  fmt::print("kerf: the panel is at {}\n", server.address_line());
  fmt::print("kerf: programs and machines are in {}; Ctrl-C ends the server\n", data);
  if (!server.has_page())
    fmt::print("kerf: the page is not part of this program; `tools/build_web` builds it\n");
  std::fflush(stdout);
}

}  // namespace

ExitStatus serve(const ServeOptions& options) {
  if (options.protocol) {
    fmt::print("{}", server::protocol_markdown());
    return ExitStatus::well;
  }
  const std::string data = options.data.empty() ? usual_data_folder() : options.data;
  if (data.empty())
    return fail({base::Failure::Kind::usage,
                 "--data is needed: neither XDG_DATA_HOME nor HOME "
                 "says where programs and machines are kept"});
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  const auto token = token_of(options);
  if (!token) return fail(token.error());
  // A limit of the size of files is a disk that takes no more, and nothing to die of.
  std::signal(SIGXFSZ, SIG_IGN);
  ::umask(0077);  // what the server writes is for its account alone
  auto server = server::Server::open({{options.host, options.port, *token}, data, threads});
  if (!server) return fail(server.error());
  tell(**server, data);
  (*server)->run();
  return ExitStatus::well;
}

}  // namespace kerf
