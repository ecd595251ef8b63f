#pragma once

#include <boost/asio/ip/address.hpp>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>

namespace kerf::server {

/// The open connections of a server: how many there are, of which address, and which of them wait
/// for a request and may be closed when others need the room. Belongs to the thread of the sockets.
class Connections {
 public:
  using Address = boost::asio::ip::address;

  Connections(std::size_t most, std::size_t most_of_an_address)
      : most_(most), most_of_an_address_(most_of_an_address) {}

  /// One connection that is open, for as long as this lives.
  class Entry {
   public:
    Entry(Connections& all, const Address& address);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

    [[nodiscard]] const Address& address() const { return address_; }
    /// It has nothing to do but to wait for a request: make_room() may call `close`.
    void wait(std::function<void()> close);
    void stop_waiting();

   private:
    friend class Connections;
    Connections& all_;
    Address address_;
    std::function<void()> close_;  // empty: it does not wait
    std::list<Entry*>::iterator place_;
  };

  [[nodiscard]] std::size_t most() const { return most_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::unique_ptr<Entry> add(const Address& address) {
    return std::make_unique<Entry>(*this, address);
  }
  /// Where there is no room for one more of this address, closes the one that has waited longest:
  /// of the same address, if that has its share. False: none of them waits.
  [[nodiscard]] bool make_room(const Address& address);

 private:
  bool close_oldest(const std::function<bool(const Entry&)>& may_go);

  std::size_t most_;
  std::size_t most_of_an_address_;
  std::size_t count_ = 0;
  std::map<Address, std::size_t> of_address_;
  std::list<Entry*> waiting_;  // the one that has waited longest first
};

}  // namespace kerf::server
