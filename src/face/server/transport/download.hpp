#pragma once

#include <boost/beast/http.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/source_file.hpp"
#include "face/server/transport/site.hpp"

namespace kerf::server {

class HttpSession;

/// `GET /library/NAME`: sends a program piece by piece; memory stays at one piece however large it
/// is. Files are opened and read where files are, the thread of the sockets does not wait for them.
class Download : public std::enable_shared_from_this<Download> {
 public:
  Download(std::shared_ptr<HttpSession> session, std::string name);

  void start();

 private:
  using Response = boost::beast::http::response<boost::beast::http::buffer_body>;

  void begin(const base::Outcome<std::shared_ptr<base::SourceFile>>& file);
  void read_piece();
  void send_piece(std::size_t bytes);

  std::shared_ptr<HttpSession> session_;
  std::string name_;
  std::shared_ptr<base::SourceFile> file_;
  Response response_;
  boost::beast::http::response_serializer<boost::beast::http::buffer_body> serializer_{response_};
  std::vector<char> piece_;
  std::uint64_t sent_ = 0;
};

}  // namespace kerf::server
