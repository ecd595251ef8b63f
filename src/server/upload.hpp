#pragma once

#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "server/site.hpp"

namespace kerf::server {

class HttpSession;

/// `PUT /library/NAME`: streams the body of a request to the disk, under a temporary name until it
/// is whole. Memory stays at one buffer however large it is. Beyond Library::kMostBytes it is
/// refused (413) and nothing is kept; so is one that breaks off, or stands still for kStill_s.
class Upload : public std::enable_shared_from_this<Upload> {
 public:
  static constexpr std::size_t kMostAtOnce = 8;
  static constexpr int kStill_s = 30;

  Upload(std::shared_ptr<HttpSession> session, std::string name)
      : session_(std::move(session)), name_(std::move(name)) {}

  void start();

 private:
  void ask_to_go_on();
  void read_some();
  void keep(std::size_t bytes);
  void finish();
  void refuse(boost::beast::http::status status, const std::string& sentence);

  std::shared_ptr<HttpSession> session_;
  std::string name_;
  std::optional<Counted> counted_;
  std::shared_ptr<base::OutputFile> file_;
  std::vector<char> buffer_;
  std::uint64_t bytes_ = 0;
};

}  // namespace kerf::server
