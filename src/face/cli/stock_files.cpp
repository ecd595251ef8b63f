#include "face/cli/stock_files.hpp"

#include "face/cli/ready_run.hpp"
#include "job/facts_of_stock.hpp"
#include "job/part_comparison.hpp"
#include "job/part_file.hpp"
#include "job/stock_part.hpp"
#include "output/part/part_picture.hpp"
#include "output/part/part_solids.hpp"
#include "output/part/profile_writer.hpp"
#include "output/picture/drawing/png_writer.hpp"
#include "output/picture/drawing/svg_writer.hpp"
#include "output/solid/glb_writer.hpp"
#include "output/solid/stl_writer.hpp"
#include "output/solid/three_mf_writer.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;
using base::OutputFile;

constexpr auto kPartRecord = OutputFiles::Kind::record;
// Of a solid that can be looked at, and of what a file can count.
constexpr std::size_t kFewestTriangles = 4;
constexpr std::size_t kMostTriangles = 1'000'000'000;
// More points than these along an axis show nothing more in a picture.
constexpr std::size_t kPicturePoints = 900;
constexpr double kPictureChord_mm = 0.01;

}  // namespace

void add_stock_files(CLI::App& stock, StockFileOptions& o) {
  stock.add_option("--stl", o.stl, "the part as a closed surface of triangles, binary STL, mm")
      ->type_name("FILE");
  stock.add_option("--glb", o.glb, "likewise as GLB, in the colours of the tools")
      ->type_name("FILE");
  stock.add_option("--3mf", o.three_mf, "likewise as 3MF")->type_name("FILE");
  stock
      .add_option("--mesh", o.mesh,
                  "surface of a height field: its own steps (exact) or smooth with edges; default "
                  "smooth")
      ->type_name("KIND")
      ->check(CLI::IsMember({"exact", "smooth"}));
  stock
      .add_option("--triangles", o.triangles,
                  "at most so many triangles in these files: edges are drawn together where it "
                  "changes the part least")
      ->type_name("N")
      ->check(CLI::Range(kFewestTriangles, kMostTriangles));
  stock
      .add_option("--profile", o.profile,
                  "of a lathe the contour of the part, of a sheet what is left: exact lines and "
                  "arcs, .svg, .dxf or .csv")
      ->type_name("FILE");
  stock
      .add_option("--picture", o.picture,
                  "a picture of part, fixtures and findings, .png or .svg; of a lathe a half "
                  "section, of a sheet what the beam burned")
      ->type_name("FILE");
  stock
      .add_option(
          "--view", o.view,
          "from where the picture is seen: iso, top, front, left or X,Y,Z towards who looks; "
          "default iso")
      ->type_name("VIEW");
  stock
      .add_option("--save", o.save,
                  "what is left of the part, a .kstock for --stock of the next set-up")
      ->type_name("FILE");
  stock.add_flag("--keep-partial", o.keep_partial,
                 "writes --save also when the run does not reach its end");
}

Outcome<void> StockFiles::open(const job::StockJob& job) {
  if (!options_.view.empty()) {
    view_ = output::part_view(options_.view);
    if (!view_)
      return base::usage("--view " + options_.view +
                         ": iso, top, front, left or a direction X,Y,Z is expected");
    if (options_.picture.empty()) return base::usage("--view: without --picture nothing is seen");
  }
  if (auto fits = check_picture("--picture", options_.picture); !fits) return fits;
  for (const auto& [path, place] :
       {std::pair{&options_.stl, &stl_}, std::pair{&options_.glb, &glb_},
        std::pair{&options_.three_mf, &three_mf_}}) {
    if (auto opened =
            files_.open(*path, kPartRecord, [&place = place](OutputFile& file) { *place = &file; });
        !opened)
      return opened;
  }
  if (options_.mesh == "exact" && job.model != job::StockModel::automatic &&
      job.model != job::StockModel::zmap)
    return base::usage("--mesh exact: only a height field has steps, --model zmap");
  if (!options_.profile.empty()) {
    const bool is_known = options_.profile.ends_with(".svg") ||
                          options_.profile.ends_with(".dxf") || options_.profile.ends_with(".csv");
    if (!is_known)
      return base::usage("--profile " + options_.profile +
                         ": an outline ends in .svg, .dxf or .csv");
    const machine::MachineDefinition& machine = job.job.definition;
    if (!machine.turns() && !machine.axes.beam)
      return base::usage(
          "--profile: only parts of lathes and sheets under a laser have an outline");
  }
  if (options_.triangles > 0 && stl_ == nullptr && glb_ == nullptr && three_mf_ == nullptr)
    return base::usage("--triangles: without --stl, --glb or --3mf there are none");
  if (auto opened =
          files_.open(options_.profile, kPartRecord, [&](OutputFile& file) { profile_ = &file; });
      !opened)
    return opened;
  constexpr auto kPart = OutputFiles::Kind::drives_a_machine;
  if (auto opened = files_.open(options_.save, kPart, [&](OutputFile& file) { save_ = &file; });
      !opened)
    return opened;
  return files_.open(options_.picture, kPartRecord, [&](OutputFile& file) { picture_ = &file; });
}

bool StockFiles::needs_ways() const {
  return save_ != nullptr || stl_ != nullptr || glb_ != nullptr || three_mf_ != nullptr ||
         picture_ != nullptr || profile_ != nullptr;
}

Outcome<void> StockFiles::write_solids(const job::StockResult& result,
                                       const output::StockFacts& facts, const job::StockJob& job,
                                       const job::OtherPart* other) {
  if (stl_ == nullptr && glb_ == nullptr && three_mf_ == nullptr) return {};
  const stock::surface::Surface part = job::surface_of(
      result,
      {.steps = options_.mesh == "exact", .triangles = options_.triangles, .jobs = job.jobs});
  if (stl_ != nullptr)
    output::write_stl(part.mesh, [&](std::string_view bytes) { stl_->write(bytes); });
  if (glb_ == nullptr && three_mf_ == nullptr) return {};
  output::SolidFile file =
      output::solid_file(job::title_of(result), facts, result.tool_spans, part);
  if (job.design || other != nullptr) {
    for (output::SolidPiece& piece : file.pieces)
      piece.deviations = output::Deviations{
          job::deviations_mm(job, other, piece.surface.mesh.points), job.tolerance.larger()};
  }
  if (glb_ != nullptr) glb_->write(output::glb_of(file));
  if (three_mf_ == nullptr) return {};
  const auto archive = output::three_mf_of(file);
  if (!archive) return tl::unexpected(archive.error());
  three_mf_->write(*archive);
  return {};
}

void StockFiles::write_profile(const job::StockResult& result) {
  if (profile_ == nullptr) return;
  const contour::Region outline = job::outline_of(result).value_or(contour::Region{});
  const auto of = result.sheet ? output::ProfileOf::sheet : output::ProfileOf::lathe;
  const std::string& path = options_.profile;
  profile_->write(path.ends_with(".csv")   ? output::profile_csv(outline, of)
                  : path.ends_with(".dxf") ? output::profile_dxf(outline)
                                           : output::profile_svg(outline, of));
}

output::PartScene StockFiles::scene_of(const job::StockResult& result,
                                       const output::StockFacts& facts,
                                       const job::StockJob& job) const {
  output::PartScene scene;
  scene.title = job::title_of(result);
  scene.facts = &facts;
  scene.tools = result.tool_spans;
  scene.jobs = job.jobs;
  scene.profile = job::profile_of(result);
  const bool needs_solid = view_ || (scene.profile == nullptr && !result.sheet);
  if (needs_solid) {
    scene.part = job::surface_of(result, {.steps = options_.mesh == "exact",
                                          .most_along = kPicturePoints,
                                          .chord_mm = kPictureChord_mm,
                                          .jobs = job.jobs});
    for (const job::StockJob::NamedShape& fixture : job.fixtures)
      scene.fixtures.push_back(job::surface_of(fixture.shape, kPictureChord_mm));
  }
  for (const job::StockJob::NamedShape& fixture : job.fixtures) {
    if (const auto section = job::profile_of(fixture.shape))
      scene.fixture_profiles.push_back(*section);
  }
  scene.sheet = result.sheet.get();
  if (result.sheet && !view_) scene.pieces = job::pieces_of(result);
  return scene;
}

output::plot::DisplayList StockFiles::picture(const job::StockResult& result,
                                              const output::StockFacts& facts,
                                              const job::StockJob& job) const {
  const output::PartScene scene = scene_of(result, facts, job);
  if (!view_ && scene.profile != nullptr) return output::draw_turned(scene);
  if (!view_ && scene.sheet != nullptr) return output::draw_burnt(scene);
  return output::draw_solid(
      scene, view_.value_or(facts.turns ? output::lathe_view() : output::PartView{}));
}

Outcome<void> StockFiles::write(const job::StockResult& result, const output::StockFacts& facts,
                                const job::StockJob& job, const job::OtherPart* other) {
  if (auto written = write_solids(result, facts, job, other); !written) return written;
  write_profile(result);
  if (picture_ != nullptr) {
    const output::plot::DisplayList drawn = picture(result, facts, job);
    constexpr double kPixelsPerUnit = 1.5;
    picture_->write(is_png(options_.picture) ? output::plot::write_png(drawn, kPixelsPerUnit)
                                             : output::plot::write_svg(drawn));
  }
  if (auto saved = write_part(result, facts, job); !saved) return saved;
  return files_.commit(is_partial_ ? OutputFiles::Which::records_only : OutputFiles::Which::all);
}

// Whoever mounts it next would not know that something is missing.
Outcome<void> StockFiles::write_part(const job::StockResult& result,
                                     const output::StockFacts& facts, const job::StockJob& job) {
  if (save_ == nullptr) return {};
  const bool has_ended = exit_status_of(result.status) == ExitStatus::well && !result.is_stopped;
  is_partial_ = !has_ended && !options_.keep_partial;
  return is_partial_ ? Outcome<void>{} : job::save_part(job, result, facts, *save_);
}

std::string StockFiles::remarks() const {
  if (!is_partial_) return {};
  return "  " + output::printable(options_.save) +
         " was not written: the run did not reach its end (--keep-partial)\n";
}

}  // namespace kerf::cli
