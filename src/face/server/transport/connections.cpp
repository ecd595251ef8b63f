#include "face/server/transport/connections.hpp"

#include <algorithm>
#include <utility>

namespace kerf::server {

Connections::Entry::Entry(Connections& all, const Address& address) : all_(all), address_(address) {
  ++all_.count_;
  ++all_.of_address_[address_];
}

Connections::Entry::~Entry() {
  stop_waiting();
  --all_.count_;
  const auto of_address = all_.of_address_.find(address_);
  if (--of_address->second == 0) all_.of_address_.erase(of_address);
}

void Connections::Entry::wait(std::function<void()> close) {
  stop_waiting();
  close_ = std::move(close);
  place_ = all_.waiting_.insert(all_.waiting_.end(), this);
}

void Connections::Entry::stop_waiting() {
  if (std::exchange(close_, nullptr)) all_.waiting_.erase(place_);
}

bool Connections::close_oldest(const std::function<bool(const Entry&)>& may_go) {
  const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const Entry* entry) { return may_go(*entry); });
  if (found == waiting_.end()) return false;
  const auto close = (*found)->close_;
  (*found)->stop_waiting();
  close();
  return true;
}

bool Connections::make_room(const Address& address) {
  const auto of_address = of_address_.find(address);
  if (of_address != of_address_.end() && of_address->second >= most_of_an_address_)
    return close_oldest([&](const Entry& entry) { return entry.address() == address; });
  return count_ < most_ || close_oldest([](const Entry&) { return true; });
}

}  // namespace kerf::server
