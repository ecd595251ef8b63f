#include "drawing/svg/internal/xml_reader.hpp"

// Declares the limits of what entities become, which every Debian library has.
#define XML_DTD 1
#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace kerf::drawing::svg {
namespace {

constexpr char kNameSpaceMark = ' ';
constexpr std::string_view kSvg = "http://www.w3.org/2000/svg";
constexpr std::uint64_t kMostExpanded = 1U << 20U;
constexpr std::uint64_t kMostBytes = 512U << 20U;

struct FullName {
  std::string_view name_space;
  std::string_view name;
};

FullName parted(const XML_Char* written) {
  const std::string_view all(written);
  const std::size_t mark = all.find(kNameSpaceMark);
  if (mark == std::string_view::npos) return {{}, all};
  return {all.substr(0, mark), all.substr(mark + 1)};
}

/// What expat calls while it reads. Where entities are expanded it counts them: bytes of events
/// that are not in the file.
class XmlReader {
 public:
  XmlReader(const base::SourceFile& file, Canvas& canvas)
      : file_(file), canvas_(canvas), parser_(XML_ParserCreateNS(nullptr, kNameSpaceMark)) {
    XML_Parser parser = parser_.get();
    if (parser == nullptr) return;
    XML_SetUserData(parser, this);
    XML_SetElementHandler(parser, begin_element, end_element);
    XML_SetCharacterDataHandler(parser, take_words);
    XML_SetCommentHandler(parser, take_comment);
    XML_SetExternalEntityRefHandler(parser, refuse_external);
    XML_SetSkippedEntityHandler(parser, skip_entity);
    // What is between two events is bounded by expat: twice of what was read, if more than 2 MiB.
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(parser, 2);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(parser, 2 * kMostExpanded);
  }

  Tree read() {
    if (parser_ == nullptr) return std::move(tree_);
    if (file_.size() > kMostBytes)
      tell(base::Code::svg_xml, fmt::format("it has more than {} MiB", kMostBytes >> 20U));
    else
      feed();
    tree_.index();
    return std::move(tree_);
  }

 private:
  struct Freed {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };
  using Parser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, Freed>;

  /// In pieces that double: expat begins a tag anew with each piece, until it has all of it.
  void feed() {
    std::uint64_t at = 0;
    std::uint64_t piece = 1U << 16U;
    while (!is_stopped_) {
      const auto count = static_cast<std::size_t>(std::min(piece, file_.size() - at));
      void* into = XML_GetBuffer(parser_.get(), static_cast<int>(std::max<std::size_t>(count, 1)));
      if (into == nullptr) return tell(base::Code::svg_xml, "there is no memory for it");
      const std::size_t read = file_.read(at, {static_cast<char*>(into), count});
      at += read;
      const bool is_last = at >= file_.size() || read < count;
      if (XML_ParseBuffer(parser_.get(), static_cast<int>(read), is_last ? 1 : 0) != XML_STATUS_OK)
        return tell_fault();
      if (is_last) return;
      piece = std::max(piece, at);
    }
  }

  void tell(base::Code code, const std::string& detail) {
    canvas_.find(base::Severity::error, code, place(), detail);
  }

  void tell_fault() {
    const XML_Error error = XML_GetErrorCode(parser_.get());
    if (error == XML_ERROR_ABORTED) return;  // told where it was stopped
    if (error == XML_ERROR_AMPLIFICATION_LIMIT_BREACH)
      return tell(base::Code::svg_entity, "more than 1 MiB");
    tell(base::Code::svg_xml, XML_ErrorString(error));
  }

  void stop(base::Code code, const std::string& detail) {
    if (is_stopped_) return;
    tell(code, detail);
    is_stopped_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  [[nodiscard]] base::Place place() const {
    base::Place place;
    place.line = static_cast<std::uint32_t>(XML_GetCurrentLineNumber(parser_.get()));
    place.column = static_cast<std::uint32_t>(XML_GetCurrentColumnNumber(parser_.get())) + 1;
    return place;
  }

  /// `bytes` of an event that has `in_file` bytes of the file, 0 inside of an entity.
  void count_expanded(std::uint64_t bytes) {
    const auto in_file = static_cast<std::uint64_t>(XML_GetCurrentByteCount(parser_.get()));
    if (bytes > in_file) expanded_ += bytes - in_file;
    if (expanded_ > kMostExpanded) stop(base::Code::svg_entity, "more than 1 MiB");
  }

  static XmlReader& of(void* data) { return *static_cast<XmlReader*>(data); }

  static void begin_element(void* data, const XML_Char* name, const XML_Char** attributes) {
    of(data).begin(parted(name), attributes);
  }
  static void end_element(void* data, const XML_Char*) { of(data).end(); }
  static void take_words(void* data, const XML_Char* words, int length) {
    of(data).take({words, static_cast<std::size_t>(length)});
  }
  static void take_comment(void* data, const XML_Char* words) {
    if (std::string_view(words).find("Adobe Illustrator") != std::string_view::npos)
      of(data).tree_.is_of_illustrator = true;
  }
  static int refuse_external(XML_Parser parser, const XML_Char*, const XML_Char*,
                             const XML_Char* system, const XML_Char*) {
    of(XML_GetUserData(parser))
        .tell(base::Code::svg_entity,
              fmt::format("an entity from outside, '{}'", system == nullptr ? "" : system));
    return XML_STATUS_OK;
  }
  static void skip_entity(void* data, const XML_Char* name, int is_parameter) {
    if (is_parameter != 0) return;
    of(data).canvas_.find(base::Severity::warning, base::Code::svg_ref, of(data).place(),
                          fmt::format("an entity that is not declared, '&{};'", name));
  }

  void begin(const FullName& full, const XML_Char** attributes) {
    if (is_stopped_) return;
    if (open_.size() >= kDeepest)
      return stop(base::Code::svg_xml,
                  fmt::format("elements are more than {} deep in each other", kDeepest));
    const bool is_ours = full.name_space.empty() || full.name_space == kSvg;
    Element element;
    element.tag = is_ours ? tag_of(full.name) : Tag::other;
    if (open_.empty() && element.tag != Tag::svg)
      return stop(base::Code::svg_xml, fmt::format("its root is '{}', not 'svg'", full.name));
    add(element);
    add_attributes(attributes);
  }

  void add(Element element) {
    element.parent = open_.empty() ? kNoElement : open_.back();
    const base::Place where = place();
    element.line = where.line;
    element.column = where.column;
    const ElementId id = tree_.add(element);
    open_.push_back(id);
    if (element.tag == Tag::text) ++texts_;
  }

  void add_attributes(const XML_Char** attributes) {
    std::uint64_t bytes = 0;
    for (; *attributes != nullptr; attributes += 2) {
      const FullName name = parted(attributes[0]);
      const std::string_view value(attributes[1]);
      bytes += value.size();
      const Key key =
          name.name_space.empty() ? key_of(name.name) : key_of(name.name_space, name.name);
      if (key != Key::unknown) tree_.add_attribute(key, value);
    }
    count_expanded(bytes);
  }

  void end() {
    if (is_stopped_ || open_.empty()) return;
    if (tree_[open_.back()].tag == Tag::text) --texts_;
    open_.pop_back();
  }

  void take(std::string_view words) {
    if (is_stopped_ || open_.empty()) return;
    count_expanded(words.size());
    if (tree_[open_.back()].tag == Tag::style) return tree_.add_style_sheet(words);
    if (texts_ == 0) return;
    Element element;
    element.tag = Tag::words;
    element.parent = open_.back();
    element.line = tree_[open_.back()].line;
    element.column = tree_[open_.back()].column;
    tree_.add(element);
    tree_.add_attribute(Key::words, words);
  }

  const base::SourceFile& file_;
  Canvas& canvas_;
  Parser parser_;
  Tree tree_;
  std::vector<ElementId> open_;
  std::size_t texts_ = 0;
  std::uint64_t expanded_ = 0;
  bool is_stopped_ = false;
};

}  // namespace

Tree read_tree(const base::SourceFile& file, Canvas& canvas) {
  return XmlReader(file, canvas).read();
}

}  // namespace kerf::drawing::svg
