#include "job/internal/round_fixture.hpp"

#include <utility>

namespace kerf::job {

RoundFixture::RoundFixture(std::string name, const stock::Workpiece& shape, contour::Region section,
                           double cell_mm)
    : dexels_(std::move(name), shape, cell_mm), whole_(std::move(section)) {
  put_back();
}

void RoundFixture::put_back() {
  section_ = std::make_unique<stock::turned::TurnedPart>(whole_);
  bodies_.clear();
}

stock::BodyId RoundFixture::known(stock::BodyId number, const stock::Body& body) {
  const auto place = bodies_.find(number);
  if (place != bodies_.end()) return place->second;
  return bodies_.emplace(number, section_->add_body(body)).first->second;
}

stock::Obstacle::Contacts RoundFixture::meet(std::span<const stock::Sweep> sweeps,
                                             const stock::Body& body) {
  Contacts contacts{};
  bool is_met = false;
  for (stock::Sweep sweep : sweeps) {
    sweep.body = known(sweep.body, body);
    if (!sweep.is_turned || !section_->can_cut(sweep)) return dexels_.meet(sweeps, body);
    sweep.kind = stock::SweepKind::rapid;
    sweep.lead_mm = 0;
    stock::Outcome outcome;
    section_->cut({&sweep, 1}, {&outcome, 1});
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      contacts[i].add(outcome.contacts[i]);
      is_met = is_met || outcome.contacts[i].is_one();
    }
  }
  if (is_met) put_back();
  return contacts;
}

}  // namespace kerf::job
