#include "output/reports/stock_rows.hpp"

#include <array>
#include <utility>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"

namespace kerf::output {
namespace {

constexpr std::string_view kHeader =
    "motion,line,file,tool,kind,start_s,end_s,length_mm,removed_mm3,mrr_mm3_s,ae_mm,ap_mm,phi_deg,"
    "side,fz_mm,hm_mm,vc_m_min,power_kw,torque_nm\n";

// In the order of stock::CuttingSide.
constexpr std::array<std::string_view, 4> kSideNames = {"", "climb", "conventional", "slot"};

}  // namespace

StockRows::StockRows(std::unique_ptr<base::OutputFile> file, const base::SourceSet& sources)
    : file_(std::move(file)), sources_(sources) {
  file_->write(kHeader);
}

void StockRows::take(const stock::TimedCut& timed) {
  const stock::MotionCut& cut = timed.cut;
  row_ = std::to_string(cut.motion) + "," + std::to_string(cut.block.line) + ",";
  append_text(sources_.contains(cut.block.file) ? sources_[cut.block.file].name() : "");
  row_ += "," + std::to_string(cut.tool) + ",";
  row_ += stock::kMoveNames[static_cast<std::size_t>(cut.move)];
  append(timed.start_s, true);
  append(timed.end_s, true);
  append(cut.length_mm, true);
  append(cut.removed_mm3, cut.is_looked_at);
  append_data(timed);
  row_ += "\n";
  file_->write(row_);
}

void StockRows::append_data(const stock::TimedCut& timed) {
  const stock::CuttingData& data = timed.cut.data;
  const stock::Engagement& engaged = data.engagement;
  const bool cuts = timed.cut.removed_mm3 > 0;
  append(timed.mrr_mm3_s, timed.cut.is_looked_at);
  append(engaged.ae_mm, engaged.ae_mm > 0);
  append(engaged.ap_mm, engaged.ap_mm > 0);
  append(geometry::degrees(engaged.phi_rad), engaged.phi_rad > 0);
  row_ += ",";
  row_ += kSideNames[static_cast<std::size_t>(engaged.side)];
  append(data.fz_mm, data.fz_mm > 0);
  append(data.hm_mm, data.hm_mm > 0);
  append(data.vc_m_min, cuts && data.vc_m_min > 0);
  append(timed.power_kw, timed.power_kw > 0);
  append(timed.torque_nm, timed.torque_nm > 0);
}

void StockRows::append(double value, bool is_known) {
  row_ += ",";
  if (is_known) base::append_number(row_, base::tidy(value));
}

// A text that would look like two fields stands in quotes.
void StockRows::append_text(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    row_ += text;
    return;
  }
  row_ += '"';
  for (const char c : text) row_ += c == '"' ? std::string("\"\"") : std::string(1, c);
  row_ += '"';
}

}  // namespace kerf::output
