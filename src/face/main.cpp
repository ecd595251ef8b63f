#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "base/output_file.hpp"
#include "face/cli/arguments.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/serve.hpp"

namespace {

using namespace kerf::cli;

// Ctrl-C and its like: no half-written file stays behind.
void stop(int signal) {
  kerf::base::remove_unfinished_outputs();
  _exit(128 + signal);
}

struct Execute {
  ExitStatus operator()(const RunOptions& options) const { return run(options); }
  ExitStatus operator()(const TimeOptions& options) const { return kerf::cli::time(options); }
  ExitStatus operator()(const StockOptions& options) const { return stock(options); }
  ExitStatus operator()(const FeaturesOptions& options) const { return features(options); }
  ExitStatus operator()(const EditOptions& options) const { return edit(options); }
  ExitStatus operator()(const CheckOptions& options) const { return check(options); }
  ExitStatus operator()(const DrawOptions& options) const { return draw(options); }
  ExitStatus operator()(const PatternOptions& options) const { return pattern(options); }
  ExitStatus operator()(const ReplayOptions& options) const { return replay(options); }
  ExitStatus operator()(const ServeOptions& options) const { return kerf::serve(options); }
  ExitStatus operator()(const ToolsOptions& options) const { return tools(options); }
  ExitStatus operator()(const MachinesOptions& options) const { return machines(options.name); }
  ExitStatus operator()(const MaterialsOptions& options) const { return materials(options.name); }
  ExitStatus operator()(const Answer& answer) const {
    std::fputs(answer.text.c_str(), stdout);
    return ExitStatus::well;
  }
};

ExitStatus guarded_main(int argc, char** argv) {
  const auto request = parse_arguments({argv + 1, argv + argc});
  if (!request) {
    return fail(request.error());
  }
  const ExitStatus status = std::visit(Execute{}, *request);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  if (status == ExitStatus::files) return status;  // a sentence has been said
  return fail({kerf::base::Failure::Kind::output, "standard output: cannot be written"});
}

// No file may be opened under the number of a stream that the caller has closed: INPUT would read
// the program. What stands there instead can be neither read nor written.
void keep_numbers_of_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool closed = fcntl(stream, F_GETFD) < 0;
    if (closed && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

// What nohup or a shell's background job has told to ignore stays ignored.
void stop_at(int signal) {
  if (std::signal(signal, stop) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
  keep_numbers_of_streams();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) stop_at(signal);
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return static_cast<int>(guarded_main(argc, argv));
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "kerf: out of memory\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kerf: fault of Kerf itself: %s\n", error.what());
  }
  kerf::base::remove_unfinished_outputs();
  return static_cast<int>(ExitStatus::fault);
}
