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

void replay(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::printf("\r%s ", path.filename().c_str());  // the last name is that of the one that failed
  std::fflush(stdout);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** folders) {
  std::size_t passed = 0;
  for (int i = 1; i < count; ++i) {
    for (const auto& path : inputs_in(folders[i])) {
      replay(path);
      ++passed;
    }
  }
  std::printf("\r%zu inputs passed\n", passed);
  return passed > 0 ? 0 : 1;
}
