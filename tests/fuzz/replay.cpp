// Feeds the fuzzer's corpus to the fuzz target, one file after the other, without libFuzzer: what
// was found once is looked at by every compiler and every sanitizer.
//   replay FOLDER…    prints how many inputs passed; a failing one aborts, its name is printed
//   first
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::filesystem::path> inputs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void replay(const std::filesystem::path& path, bool verbose) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (verbose) {
    std::printf("%s\n", path.c_str());
    std::fflush(stdout);
  }
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** words) {
  const bool verbose = count > 1 && std::string_view(words[1]) == "-v";
  std::size_t passed = 0;
  for (int i = verbose ? 2 : 1; i < count; ++i) {
    for (const auto& path : inputs_in(words[i])) {
      replay(path, verbose);
      ++passed;
    }
  }
  std::printf("%zu inputs passed\n", passed);
  return passed > 0 ? 0 : 1;
}
