#include "machine/definition/tools/internal/zip_archive.hpp"

#include <zip.h>

#include <array>
#include <memory>

namespace kerf::machine {
namespace {

constexpr zip_int64_t kMostFiles = 1000;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

Archive open(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* const archive =
      source != nullptr ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
  if (archive == nullptr && source != nullptr) zip_source_free(source);
  zip_error_fini(&error);
  return Archive(archive);
}

// The size that the archive claims is not believed.
tl::expected<std::string, std::string> unpacked(zip_t* archive, zip_uint64_t index,
                                                std::size_t most_bytes) {
  const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(archive, index, 0));
  if (!file) return tl::unexpected(std::string("the archive's library cannot be unpacked"));
  std::string text;
  std::array<char, 1 << 16> piece{};
  for (;;) {
    const zip_int64_t n = zip_fread(file.get(), piece.data(), piece.size());
    if (n < 0) return tl::unexpected(std::string("the archive is damaged"));
    if (n == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(n));
    if (text.size() > most_bytes)
      return tl::unexpected("its library is larger than " + std::to_string(most_bytes >> 20U) +
                            " MiB");
  }
}

}  // namespace

tl::expected<std::string, std::string> json_in_zip(const std::string& bytes,
                                                   std::size_t most_bytes) {
  const Archive archive = open(bytes);
  if (!archive) return tl::unexpected(std::string("the archive is damaged"));
  const zip_int64_t files = std::min(zip_get_num_entries(archive.get(), 0), kMostFiles);
  for (zip_int64_t i = 0; i < files; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const char* const name = zip_get_name(archive.get(), index, 0);
    if (name != nullptr && std::string_view(name).ends_with(".json"))
      return unpacked(archive.get(), index, most_bytes);
  }
  return tl::unexpected(std::string("the archive holds no library, a .json"));
}

}  // namespace kerf::machine
