#pragma once

#include <iconv.h>

#include <string>
#include <string_view>

namespace kerf::drawing::dxf {

/// The words of a file as UTF-8, in which bytes that mean nothing are U+FFFD: by the code page that
/// its header names, or as UTF-8; `\U+XXXX` is the character of that number.
class CodePage {
 public:
  CodePage() = default;
  ~CodePage() { close(); }
  CodePage(const CodePage&) = delete;
  CodePage& operator=(const CodePage&) = delete;

  /// False: nobody knows this one; words stay what they would be without it.
  bool choose(std::string_view name);
  /// As files from AC1021 on are.
  void choose_utf8();

  /// Valid as long as `raw` and until the next call.
  [[nodiscard]] std::string_view operator()(std::string_view raw);

 private:
  void close();
  void convert(std::string_view raw);

  static inline const iconv_t kNone = reinterpret_cast<iconv_t>(-1);
  iconv_t from_ = kNone;
  bool is_utf8_ = false;
  std::string text_;
};

/// What a sentence shows of bytes of a file: in quotes, shortened, printable.
[[nodiscard]] std::string quoted(std::string_view bytes);

/// Appends a character; what is none is U+FFFD.
void append_utf8(std::string& text, char32_t character);
/// Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string sound_utf8(std::string_view text);
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace kerf::drawing::dxf
