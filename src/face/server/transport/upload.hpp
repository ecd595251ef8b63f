#pragma once

#include <boost/beast/http.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "face/server/transport/site.hpp"

namespace kerf::server {

class HttpSession;

/// `PUT /library/NAME`: streams the body of a request to the disk, under a temporary name until it
/// is whole. Memory stays at one buffer however large it is. Beyond Library::kMostBytes it is
/// refused (413) and nothing is kept; so is one that breaks off, or stands still for kStill_s.
/// There are at most kMostAtOnce: the next one takes the place of the slowest that has had
/// kGrace_s and brings less than kSlow_bytes_s, or is refused (503).
class Upload : public std::enable_shared_from_this<Upload> {
 public:
  static constexpr std::size_t kMostAtOnce = 8;
  static constexpr int kStill_s = 30;
  static constexpr double kGrace_s = 5;
  static constexpr double kSlow_bytes_s = 64 * 1024;

  Upload(std::shared_ptr<HttpSession> session, std::string name)
      : session_(std::move(session)), name_(std::move(name)) {}
  ~Upload() { leave(); }
  Upload(const Upload&) = delete;
  Upload& operator=(const Upload&) = delete;

  void start();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool find_place();
  [[nodiscard]] double bytes_s() const;
  void leave();
  void give_way();
  void begin(const base::Outcome<std::shared_ptr<base::OutputFile>>& file);
  void ask_to_go_on();
  void read_some();
  void keep(std::size_t bytes);
  void kept(bool good);
  void finish();
  void refuse(boost::beast::http::status status, const std::string& sentence);

  std::shared_ptr<HttpSession> session_;
  std::string name_;
  std::shared_ptr<base::OutputFile> file_;
  std::vector<char> buffer_;
  std::uint64_t bytes_ = 0;
  Clock::time_point begin_ = Clock::now();
  bool gave_way_ = false;
};

}  // namespace kerf::server
