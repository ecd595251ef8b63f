#include "drawing/dxf/internal/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/colour_index.hpp"
#include "drawing/dxf/internal/kinds.hpp"
#include "drawing/dxf/internal/sweep.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kDeepest = 32;
constexpr Affine kMirrored{{-1, 0}, {0, 1}, {}};

void refuse_insert(const Record& record, Sheet& sheet, std::string_view why) {
  tell(record, sheet, base::Severity::error, base::Code::dxf_block, why);
}

/// The block's plane into that of the INSERT, without its rows and columns.
struct Placement {
  Affine shape;  // turned and scaled about the base point
  Affine turn;
  Vec2 at;
  Vec2 step;  // from column to column, from row to row

  [[nodiscard]] Affine at_cell(double column, double row) const {
    const Vec2 cell{column * step.u, row * step.v};
    return then(shape, Affine::moved(at + turn.direction(cell)));
  }
};

Placement placement_of(const Block& block, const Record& insert) {
  constexpr double kRadian = std::numbers::pi / 180;
  const Affine turn = Affine::turned(kRadian * std::fmod(insert.number(50), 360));
  const Affine size = Affine::scaled(insert.number(41, 1), insert.number(42, 1));
  return {then(then(Affine::moved(-block.base), size), turn),
          turn,
          insert.point(10),
          {insert.number(44), insert.number(45)}};
}

}  // namespace

bool Run::is_finite(const Record& record) {
  for (const Group& group : record.groups()) {
    if (std::isfinite(group.number)) continue;
    tell(record, sheet_, base::Severity::error, base::Code::draw_nan,
         fmt::format("has a number that is none or too large (group {})", group.code), group.line);
    return false;
  }
  return true;
}

bool Run::is_usable(const Record& record) {
  const Record::Fault& fault = record.fault();
  if (fault.line == 0) return is_finite(record);
  tell(record, sheet_, base::Severity::error, base::Code::dxf_group,
       fmt::format("is not drawn: {}", fault.what), fault.line);
  return false;
}

Run::Looks Run::looks_of(const Record& record) {
  const std::string_view name = record.has(8) ? record.text(8) : "0";
  const bool is_of_block = around_.layer != nullptr && name == "0";
  const Layer& layer = is_of_block ? *around_.layer : sheet_.layers.find(name);
  if (const auto own = own_colour(record)) return {layer, *own};
  const bool is_by_block = record.integer(62, kByLayer) == kByBlock;
  return {layer, is_by_block ? around_.colour : layer.colour};
}

void Run::ignore_hidden(const Record& record, const Layer& layer, bool is_off) {
  sheet_.canvas.ignore(fmt::format("layer {}", sheet_.canvas.text_of(layer.name)), record.line(),
                       is_off ? "the layer is off" : "the layer is frozen");
}

bool Run::is_seen(const Record& record, const Layer& layer) {
  if (record.integer(67) == 1) {
    sheet_.canvas.ignore("paper space", record.line(), "the model alone is drawn");
    return false;
  }
  if (record.integer(60) == 1) {
    sheet_.canvas.ignore("invisible", record.line(), "it is hidden in the drawing");
    return false;
  }
  const bool is_hidden = layer.is_off || layer.is_frozen;
  // A layer that is off hides what is drawn on it, not the blocks that are inserted on it.
  const bool is_insert = record.kind() == "INSERT";
  if (is_hidden && !layer.is_named && (layer.is_frozen || !is_insert)) {
    ignore_hidden(record, layer, layer.is_off);
    return false;
  }
  return is_insert || layer.is_wanted;
}

std::optional<Affine> Run::out_of_own_plane(const Record& record) {
  switch (facing_of(record)) {
    case Facing::up: return around_.to_mm;
    case Facing::down: return then(kMirrored, around_.to_mm);
    case Facing::aside: break;
  }
  tell(record, sheet_, base::Severity::warning, base::Code::dxf_plane,
       fmt::format("is not drawn: its extrusion is ({}, {}, {})", record.number(210),
                   record.number(220), record.number(230, 1)));
  return std::nullopt;
}

void Run::take(const Record& record) {
  if (sheet_.canvas.is_over()) return;
  const bool is_vertex = record.kind() == "VERTEX";
  if (polyline_ && is_vertex) return add_vertex(record);
  end();
  if (record.kind() == "SEQEND" || !is_usable(record)) return;
  if (record.kind() == "POLYLINE") {
    Polyline begun;
    begun.head = record.compact();
    polyline_ = std::move(begun);
    return;
  }
  draw(record);
}

void Run::end() {
  if (!polyline_) return;
  draw_polyline();
  polyline_.reset();
}

void Run::draw(const Record& record) {
  const Looks looks = looks_of(record);
  if (!is_seen(record, looks.layer)) return;
  if (record.kind() == "INSERT") return insert(record);
  const Kind* const kind = find_kind(record.kind());
  if (kind == nullptr) {
    const std::string name(sheet_.words(record.kind()));
    return sheet_.canvas.ignore(name, record.line(), why_not_drawn(name));
  }
  std::optional<Affine> to_mm = around_.to_mm;
  if (kind->frame != Frame::world) to_mm = out_of_own_plane(record);
  if (!to_mm) return;
  Subject subject(sheet_, record, kind->frame == Frame::own ? *to_mm : around_.to_mm, looks.layer,
                  looks.colour);
  kind->draw(subject);
}

void Run::add_vertex(const Record& vertex) {
  constexpr int kControl = 16;
  if (!is_usable(vertex)) polyline_->is_sound = false;
  if (vertex.flag(70, kControl)) return;
  const double height = vertex.number(30);
  if (polyline_->vertices.empty()) polyline_->height = height;
  if (std::abs(height - polyline_->height) > kSameHeight) polyline_->is_level = false;
  polyline_->vertices.push_back({vertex.point(10), vertex.number(42)});
}

void Run::draw_polyline() {
  constexpr int kClosed = 1;
  constexpr int kSpatial = 8;
  constexpr int kMeshes = 16 | 64;
  const Record& head = polyline_->head;
  const Looks looks = looks_of(head);
  if (!is_seen(head, looks.layer) || !polyline_->is_sound) return;
  if (head.flag(70, kMeshes))
    return sheet_.canvas.ignore("mesh", head.line(), "a POLYLINE that is a mesh has no outline");
  const bool is_spatial = head.flag(70, kSpatial);
  const auto to_mm = is_spatial ? std::optional(around_.to_mm) : out_of_own_plane(head);
  if (!to_mm) return;
  Subject subject(sheet_, head, *to_mm, looks.layer, looks.colour);
  if (polyline_->vertices.empty()) return subject.refuse("has no vertices");
  if (is_spatial && !polyline_->is_level) subject.tell_heights();
  Pen pen(sheet_.canvas, subject.entity(), *to_mm);
  draw_bulges(polyline_->vertices, head.flag(70, kClosed), pen);
}

void Run::insert(const Record& record) {
  const Looks looks = looks_of(record);
  const Block* const block = sheet_.blocks.find(record.text(2));
  if (block == nullptr)
    return refuse_insert(
        record, sheet_,
        fmt::format("inserts {}, which is not there", quoted(sheet_.words(record.text(2)))));
  if (around_.depth >= kDeepest)
    return refuse_insert(record, sheet_, fmt::format("is more than {} blocks deep", kDeepest));
  if (block->is_elsewhere)
    return sheet_.canvas.ignore("external reference", record.line(),
                                "it is another file: bind it into the drawing");
  if (!block->entries.empty()) insert(*block, record, looks);
}

void Run::insert(const Block& block, const Record& record, const Looks& looks) {
  const auto to_mm = out_of_own_plane(record);
  if (!to_mm) return;
  const Grid grid = grid_of(record);
  const double expected = grid.rows * grid.columns * block.weight;
  if (!sheet_.canvas.has_room_for(expected + sheet_.undrawn, record.line())) return;
  const std::size_t before = sheet_.canvas.count();
  const Placement placement = placement_of(block, record);
  Around inside{{}, &looks.layer, looks.colour, around_.depth + 1};
  for (double row = 0; row < grid.rows; ++row) {
    for (double column = 0; column < grid.columns; ++column) {
      inside.to_mm = then(placement.at_cell(column, row), *to_mm);
      Run run(sheet_, inside);
      for (const Block::Entry& entry : block.entries) {
        if (entry.is_circular)
          refuse_insert(entry.record, sheet_, "would hold itself");
        else
          run.take(entry.record);
      }
      run.end();
      if (sheet_.canvas.is_over()) return;
    }
  }
  const auto drawn = static_cast<double>(sheet_.canvas.count() - before);
  if (around_.depth == 0) sheet_.undrawn += std::max(0.0, expected - drawn);
}

}  // namespace kerf::drawing::dxf
