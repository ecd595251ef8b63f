#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/work_limit.hpp"
#include "drawing/drawing.hpp"

namespace kerf::drawing {

/// What is farther from zero is drawn by no machine, and not drawn here.
inline constexpr double kFarthest_mm = 1e6;

/// How files are read, whatever their format.
struct Reading {
  std::string unit;                 ///< in place of what the file says or lacks; empty: as it says
  double dpi = 0;                   ///< px an inch; 0: as the format has it
  double tolerance_mm = 0.01;       ///< an arc in place of a curve
  double same_mm = 0.005;           ///< what is shorter is nothing
  char lens_side = 0;               ///< of a trace: R or L; 0: as the file has it
  std::vector<std::string> layers;  ///< only these, with * and ?; empty: all
  std::uint64_t max_entities = 5'000'000;
  base::WorkLimit limit;
};

/// What a reader draws on. It holds the budget: when is_over() the reader comes to its end, and
/// what it has drawn until then stays.
class Canvas {
 public:
  /// Both outlive this.
  Canvas(const Reading& reading, Drawing& drawing);

  /// The beginning of a file; what follows is of it.
  FileFacts& begin_file(base::FileId file, std::string format);
  [[nodiscard]] FileFacts& facts() { return drawing_.files.back(); }
  [[nodiscard]] const Reading& reading() const { return reading_; }
  [[nodiscard]] const Drawing& drawn() const { return drawing_; }
  [[nodiscard]] Name name(std::string_view text) { return drawing_.names.find(text); }
  [[nodiscard]] std::string_view text_of(Name name) const { return drawing_.names[name]; }

  /// Whether things of a layer are asked for.
  [[nodiscard]] bool wants(std::string_view layer);
  /// Whether --layer names it, so that it is drawn although it is off.
  [[nodiscard]] bool names(std::string_view layer) const;

  /// An entity that is drawn now; its file is the one that was begun. Counts it.
  EntityId add(Entity entity);
  /// Something that is not drawn, told once for each `what`.
  void ignore(std::string_view what, std::uint32_t line, std::string_view why);

  /// A finding about a place of the file; `layer` and `entity` may be empty. Of one code at most
  /// kMostOfACode are kept.
  void find(base::Severity severity, base::Code code, base::Place place, const std::string& detail,
            Name layer = {}, Name entity = {}, const std::string& hint = {});
  static constexpr std::size_t kMostOfACode = 100;

  void add(Point point);
  void add(Text text) { drawing_.texts.push_back(std::move(text)); }
  void add(Image image) { drawing_.images.push_back(std::move(image)); }
  /// A path of an entity: Pen draws it.
  void add(std::vector<contour::Vertex>& vertices, bool is_closed, EntityId entity);
  void allow_error(double error_mm) { drawing_.error_mm = std::max(drawing_.error_mm, error_mm); }

  /// The budget is used up (told by a finding of DRAW_LIMIT or BUDGET).
  [[nodiscard]] bool is_over();
  /// Whether the budget is enough for so many entities more, which those of a line would be; if not
  /// it is used up now, without their being made one by one.
  [[nodiscard]] bool has_room_for(double entities, std::uint32_t line);
  /// Entities that were drawn.
  [[nodiscard]] std::size_t count() const { return drawing_.entities.size(); }
  /// No more lines and arcs than this for each of the entities that are allowed.
  static constexpr std::uint64_t kVerticesOfAnEntity = 8;
  /// As is_over(), of a clone or what stands in a block: the budget of entities counts it too, also
  /// where nothing of it is drawn.
  [[nodiscard]] bool is_over_with_clone();

 private:
  void tell_over(base::Code code, const std::string& detail, std::uint32_t line = 0);
  [[nodiscard]] bool is_drawable(const std::vector<contour::Vertex>& vertices, EntityId entity);

  const Reading& reading_;
  Drawing& drawing_;
  std::unordered_map<std::string, std::size_t> ignored_;   // what -> place in the facts
  std::unordered_map<std::uint32_t, std::size_t> told_;    // code -> how often
  std::unordered_map<std::string, bool> wanted_;           // layers
  std::unordered_map<std::uint32_t, std::size_t*> kinds_;  // Name -> its count in the facts
  std::uint64_t work_ = 0;
  std::uint64_t clones_ = 0;
  bool over_ = false;
};

}  // namespace kerf::drawing
