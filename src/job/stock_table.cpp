#include "job/stock_table.hpp"

#include <fmt/format.h>

#include <utility>

#include "job/part_file.hpp"
#include "job/stock_part.hpp"
#include "machine/definition/stock_comment.hpp"
#include "motion/feed.hpp"
#include "stock/cutting/placement.hpp"
#include "stock/cutting/saved_part.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using machine::SetUp;
using machine::StockWord;
using stock::Placing;
using stock::Workpiece;

std::size_t bytes_of(const mesh::TriangleMesh& mesh) {
  return mesh.points.size() * sizeof(mesh.points[0]) +
         mesh.triangles.size() * sizeof(mesh.triangles[0]);
}

Outcome<Workpiece> read_solid(const base::SourceFile& file, machine::MeshUnit unit, StockJob& job) {
  auto solid = machine::mesh_in(file, unit, job.memory_for_model());
  if (!solid) return tl::unexpected(solid.error());
  job.mesh_bytes += bytes_of(solid->mesh);
  stock::MeshShape shape = stock::mesh_shape(std::move(*solid));
  for (const std::string& change : shape.solid->changes)
    job.notes.push_back(file.name() + ": " + change);
  return Workpiece(std::move(shape));
}

/// The part and its model share the memory.
Outcome<Workpiece> read_saved(const base::SourceFile& file, StockJob& job) {
  auto read = part_in(file, job.memory_for_model() / 2);
  if (!read) return tl::unexpected(read.error());
  job.mesh_bytes += read->part->bytes();
  job.made_by = std::move(read->label.made_by);
  job.threads = std::move(read->label.threads);
  if (!job.threads.empty())
    job.notes.push_back(file.name() +
                        ": of its threads only the measures are known, a tool that "
                        "goes into one of them meets material");
  return Workpiece(stock::SavedShape{std::move(read->part)});
}

/// What is in a file, which takes its part of the memory.
Outcome<Workpiece> read_shape(const machine::StockFile& file, StockJob& job) {
  constexpr std::uint64_t kLargestShapePipe = std::uint64_t{4} << 30U;
  const auto open =
      base::SourceFile::open(file.path, {.most_bytes = kLargestShapePipe, .seconds = 60});
  if (!open) return tl::unexpected(open.error());
  return is_part(**open) ? read_saved(**open, job) : read_solid(**open, file.unit, job);
}

stock::CylinderShape round_of(const machine::StockBar& bar) {
  return {
      .from = bar.z0, .to = bar.z1, .diameter = bar.diameter, .inner_diameter = bar.inner_diameter};
}

/// The word as a piece of material, where it is one on this machine.
Outcome<std::optional<Workpiece>> piece_of(const StockWord& word, StockJob& job) {
  if (const auto* const piece = std::get_if<Workpiece>(&word)) return *piece;
  if (const auto* const bar = std::get_if<machine::StockBar>(&word);
      bar != nullptr && job.job.definition.turns())
    return Workpiece(round_of(*bar));
  const auto* const file = std::get_if<machine::StockFile>(&word);
  if (file == nullptr) return std::optional<Workpiece>{};
  auto read = read_shape(*file, job);
  if (!read) return tl::unexpected(read.error());
  return std::optional(std::move(*read));
}

/// A sheet stays flat, and its sides along X and Y.
Outcome<StockWord> placed_sheet(const machine::StockSheet& sheet, const stock::Placement& place) {
  const Placing placing(place);
  const bool is_flat = placing.turned({0, 0, 1}) == stock::Vec3{0, 0, 1} && place.move.z == 0;
  if (!placing.is_square() || !is_flat)
    return base::usage(
        "--stock-place: a sheet is moved along X and Y, and turned about Z by multiples of 90°");
  const stock::Bounds box = stock::bounds(
      stock::placed(stock::BoxShape{{sheet.x0, sheet.y0, 0}, {sheet.x1, sheet.y1, 1}}, place));
  return StockWord(
      machine::StockSheet{box.low.x, box.low.y, box.high.x, box.high.y, sheet.thickness});
}

const stock::SavedShape* saved_in(const StockWord& word) {
  const auto* const piece = std::get_if<Workpiece>(&word);
  return piece != nullptr ? std::get_if<stock::SavedShape>(piece) : nullptr;
}

/// A part that was cut before, where the machine or its cells want another kind of model.
void sample_anew(StockJob& job) {
  using Kind = stock::SavedPart::Kind;
  const stock::SavedShape* const saved = saved_in(job.shape);
  if (saved == nullptr) return;
  const stock::SavedPart& part = *saved->part;
  const machine::MachineDefinition& machine = job.job.definition;
  const bool is_finer = job.cell_mm && *job.cell_mm < part.cell_mm() * (1 - 1e-9);
  const bool is_sheet = part.kind() == Kind::sheet;
  const bool is_other =
      is_sheet ? !machine.axes.beam : (part.kind() == Kind::turned) != machine.turns();
  if (!is_other && (is_sheet || !is_finer)) return;
  job.notes.push_back(job.said + ": its surface is sampled anew, with other cells");
  job.shape = Workpiece(part.solid());
}

/// Puts the stock where it is clamped. Cells that cannot keep their places are told.
Outcome<StockWord> placed_word(StockWord word, const stock::Placement& place) {
  if (auto* const piece = std::get_if<Workpiece>(&word))
    return StockWord(stock::placed(*piece, place));
  if (const auto* const sheet = std::get_if<machine::StockSheet>(&word))
    return placed_sheet(*sheet, place);
  return base::usage("--stock-place: where the stock stands that is placed is not said: --stock");
}

/// Failure (usage): there is no such stock on this machine.
Outcome<void> suits(const SetUp::Piece& stock, const machine::MachineDefinition& machine) {
  if (std::holds_alternative<machine::StockBar>(stock.word) && !machine.turns())
    return base::usage("--stock " + stock.said + ": only a lathe holds a bar");
  return {};
}

Outcome<void> lay_stock(const SetUp::Piece& stock, const std::optional<stock::Placement>& place,
                        StockJob& job) {
  if (auto suited = suits(stock, job.job.definition); !suited) return suited;
  job.said = stock.said;
  job.shape = stock.word;
  auto piece = piece_of(stock.word, job);
  if (!piece) return tl::unexpected(piece.error());
  if (*piece) job.shape = std::move(**piece);
  if (place) {
    const bool was_saved = saved_in(job.shape) != nullptr;
    auto placed = placed_word(std::move(job.shape), *place);
    if (!placed) return tl::unexpected(placed.error());
    job.shape = std::move(*placed);
    if (was_saved && saved_in(job.shape) == nullptr)
      job.notes.push_back(job.said +
                          ": it is turned by other than multiples of 90°, so its surface is "
                          "sampled anew");
  }
  sample_anew(job);
  return {};
}

Outcome<void> lay_fixture(const SetUp::Piece& fixture, StockJob& job) {
  auto piece = piece_of(fixture.word, job);
  if (!piece) return tl::unexpected(piece.error());
  if (!*piece)
    return base::usage("--fixture " + fixture.said +
                       ": a box, a cylinder, a tube or a mesh is expected, on a lathe also a bar");
  if (std::holds_alternative<stock::SavedShape>(**piece))
    return base::usage("--fixture " + fixture.said + ": a part that was cut is a stock");
  if (job.job.definition.turns() && !profile_of(**piece))
    job.notes.push_back("fixture " + fixture.title() +
                        " is not round about the spindle: no insert is compared with it");
  job.fixtures.push_back({fixture.title(), std::move(**piece)});
  return {};
}

/// What the program itself says lies there; nothing: it does not, or not so that it is understood.
std::optional<SetUp::Piece> commented_stock(const base::SourceFile& program, StockJob& job) {
  const bool in_inches = job.job.definition.parameters.power_on_inch;
  const auto stock =
      machine::stock_in_comments(program, in_inches ? motion::kMillimetresPerInch : 1);
  if (!stock) return std::nullopt;
  if (!stock->word) {
    job.notes.push_back(
        fmt::format("the comment of line {} is no stock: {}", stock->line, stock->wrong));
    return std::nullopt;
  }
  return SetUp::Piece{*stock->word, stock->said, {}};
}

void choose_checks(const SetUp& set_up, StockJob& job) {
  job.material = set_up.material;
  job.left_out = set_up.left_out;
  job.has_real_lengths = set_up.has_real_lengths.value_or(false);
  if (set_up.touch_mm) job.touch_mm = *set_up.touch_mm;
}

void note_what_is_left_out(const SetUp& set_up, StockJob& job) {
  if (set_up.design)
    job.notes.push_back("the part is not compared with " + set_up.design->file.path);
  if (set_up.energy_j_mm3 && job.job.definition.axes.beam)
    job.notes.emplace_back("energy_j_mm3 of the material is not used");
}

}  // namespace

Outcome<void> lay(const SetUp& set_up, const base::SourceFile& program, StockJob& job) {
  job.zero = set_up.zero.value_or(machine::StockZero{});
  choose_checks(set_up, job);
  const auto stock = set_up.stock ? set_up.stock : commented_stock(program, job);
  const bool is_around = !stock || std::holds_alternative<machine::StockAround>(stock->word);
  job.knows_stock = stock.has_value();
  const SetUp::Piece assumed{machine::StockAround{}, "extents", {}};
  if (is_around && set_up.place)
    return base::usage(
        "--stock-place: what lies around the cuts has its place; --stock says another shape");
  if (auto laid = lay_stock(stock.value_or(assumed), set_up.place, job); !laid) return laid;
  for (const SetUp::Piece& fixture : set_up.fixtures) {
    if (auto laid = lay_fixture(fixture, job); !laid) return laid;
  }
  note_what_is_left_out(set_up, job);
  return {};
}

void tell_notes(const StockJob& job, StockResult& result) {
  for (const std::string& note : job.notes) result.assumed.push_back({0, note});
}

}  // namespace kerf::job
