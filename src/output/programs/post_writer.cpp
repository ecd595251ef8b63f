#include "output/programs/post_writer.hpp"

#include "output/programs/lathe_post.hpp"
#include "output/programs/post.hpp"

namespace kerf::output {

std::unique_ptr<PostWriter> make_post(const machine::MachineDefinition& machine,
                                      std::string program, base::OutputFile& file,
                                      const PostSettings& settings) {
  if (!machine.axes.turns())
    return std::make_unique<Post>(machine, std::move(program), file, settings);
  if (settings.flavour.lathe_modes.empty()) return nullptr;
  return std::make_unique<LathePost>(machine, std::move(program), file, settings);
}

}  // namespace kerf::output
