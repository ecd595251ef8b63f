#include "output/features/edit_report.hpp"

#include <algorithm>
#include <cmath>

#include "base/checksum.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using Text = std::vector<std::string>;

template <typename Item, typename Write>
std::string array_of(const std::vector<Item>& items, Write&& write) {
  Text all;
  all.reserve(items.size());
  for (const Item& item : items) all.push_back(write(item));
  return json_array(all);
}

std::string count_json(std::size_t count) { return std::to_string(count); }

const char* truth(bool value) { return value ? "true" : "false"; }

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string dumped(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// What is not UTF-8 reads back as something else.
bool is_utf8(const std::string& text) {
  return is_ascii(text) || nlohmann::json::parse(dumped(text)) == text;
}

std::string as_latin1(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += {static_cast<char>(0xc0U | (byte >> 6U)), static_cast<char>(0x80U | (byte & 63U))};
    }
  }
  return text;
}

std::string change_json(const EditFacts::Change& change) {
  const auto readable = [](const Text& lines) {
    return std::all_of(lines.begin(), lines.end(), is_utf8);
  };
  const bool in_bytes = !readable(change.old_lines) || !readable(change.new_lines);
  const auto line = [&](const std::string& text) {
    return dumped(in_bytes ? as_latin1(text) : text);
  };
  JsonObject object;
  object.text("file", change.file).raw("first", count_json(change.first));
  object.raw("old", array_of(change.old_lines, line)).raw("new", array_of(change.new_lines, line));
  if (in_bytes) object.text("encoding", "latin-1");
  return object.done();
}

std::string block_counts(const EditFacts::Blocks& blocks) {
  return JsonObject()
      .raw("kept", count_json(blocks.kept))
      .raw("patched", count_json(blocks.patched))
      .raw("inserted", count_json(blocks.inserted))
      .raw("removed", count_json(blocks.removed))
      .done();
}

std::string regenerated_json(const EditFacts::Regenerated& one) {
  return JsonObject()
      .text("feature", one.feature)
      .raw("layers", array_of(one.layers, count_json))
      .done();
}

std::string layer_json(const std::string& id, std::size_t layer) {
  return "[" + quoted(id) + "," + count_json(layer) + "]";
}

std::string renamed_json(const EditFacts::Renamed& one) {
  return JsonObject()
      .raw("was", layer_json(one.was, one.was_layer))
      .raw("is", layer_json(one.is, one.is_layer))
      .done();
}

std::string verified_json(const EditFacts::Verified& one) {
  return JsonObject()
      .raw("recognised", truth(one.recognised))
      .raw("others_unchanged", truth(one.others_unchanged))
      .raw("contour_error_mm", rounded(one.contour_error_mm))
      .raw("difference_mm3", rounded(one.difference_mm3))
      .raw("outside_mm3", rounded(one.outside_mm3))
      .raw("corner_rest_mm2", rounded(one.corner_rest_mm2))
      .raw("new_findings", array_of(one.new_findings, quoted))
      .raw("time_s", pair_json(one.time_before_s, one.time_after_s))
      .done();
}

std::string warning_json(const EditFacts::Warning& one) {
  return JsonObject()
      .raw("edit", count_json(one.edit))
      .text("code", std::string(base::text_of(one.code).number))
      .text("message", one.sentence)
      .done();
}

std::string library_json(const EditFacts::Library& one) {
  return JsonObject().text("file", one.file).text("crc32", base::hex_text(one.crc32)).done();
}

std::string removal_text(double difference_mm3) {
  if (difference_mm3 == 0) return "removes as much as before";
  return "removes " + base::rounded_text(std::abs(difference_mm3), 3) + " mm³ " +
         (difference_mm3 > 0 ? "more" : "less") + " than before";
}

}  // namespace

std::string text_json(const std::string& text) {
  return dumped(is_utf8(text) ? text : as_latin1(text));
}

std::string changes_json(const EditFacts& facts) { return array_of(facts.changes, change_json); }

std::string blocks_json(const EditFacts& facts) { return block_counts(facts.blocks); }

std::string warnings_json(const EditFacts& facts) { return array_of(facts.warnings, warning_json); }

std::string edit_report_json(const EditFacts& facts) {
  JsonObject object;
  object.raw("kerf", "\"edit\"").raw("version", "1").raw("edits", count_json(facts.edits));
  object.raw("changes", changes_json(facts));
  object.raw("bytes_changed", count_json(facts.bytes_changed));
  object.raw("blocks", blocks_json(facts));
  object.raw("regenerated", array_of(facts.regenerated, regenerated_json));
  object.raw("ids", array_of(facts.ids, renamed_json));
  object.raw("verified", verified_json(facts.verified));
  object.raw("warnings", warnings_json(facts));
  object.text("crc32", base::hex_text(facts.crc32));
  if (!facts.libraries.empty()) object.raw("libraries", array_of(facts.libraries, library_json));
  return object.done() + "\n";
}

std::string edit_report_text(const EditFacts& facts) {
  const EditFacts::Verified& verified = facts.verified;
  std::string text = count_json(facts.blocks.patched) + " blocks patched, " +
                     count_json(facts.blocks.inserted) + " inserted, " +
                     count_json(facts.blocks.removed) + " removed, " +
                     count_json(facts.blocks.kept) + " kept\n";
  text += "  " + removal_text(verified.difference_mm3);
  if (verified.corner_rest_mm2 > 0)
    text += ", leaves " + base::rounded_text(verified.corner_rest_mm2, 3) + " mm² in corners";
  text += "\n  takes " + base::rounded_text(verified.time_after_s, 3) + " s, " +
          base::rounded_text(verified.time_before_s, 3) + " s before\n";
  return text;
}

}  // namespace kerf::output
