#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kerf::server {

/// A file of the page, compressed by gzip.
struct Asset {
  std::string path;          ///< "/assets/index-3f2a.js"; that of the page itself is "/"
  std::string content_type;  ///< "text/javascript; charset=utf-8"
  std::string etag;          ///< with its quotes
  std::string_view gzip;
};

/// The files of the page as tools/pack_web.mjs has packed them: a line `path TAB content type TAB
/// etag TAB bytes` for each, an empty line, then the bytes one after the other. The pack must
/// outlive the table. A pack that is cut short gives the files that are whole.
class AssetTable {
 public:
  explicit AssetTable(std::string_view pack);

  [[nodiscard]] bool empty() const { return assets_.empty(); }
  /// Null: the page has no such file.
  [[nodiscard]] const Asset* find(std::string_view path) const;

 private:
  std::vector<Asset> assets_;
};

/// The pack that was linked into the program; empty when the page had not been built.
[[nodiscard]] std::string_view embedded_page();

}  // namespace kerf::server
