#pragma once

#include "lang/teach/page.hpp"

namespace kerf::teach {

/// Compiles a stretch of a .tch file into a page of code: `do_block` for each record, `fail` for
/// each mistake, which then is an alarm when it is reached.
///
/// The page with END reads the file to its end. If text follows, that is an alarm in place of END:
/// a program that is more than it says is not over.
class PageCompiler {
 public:
  explicit PageCompiler(std::uint32_t lines_per_page) : lines_per_page_(lines_per_page) {}

  void compile(const base::SourceFile& file, base::FileId id, const RecordReader::Position& start,
               TeachPage& page);

 private:
  bool compile_next(TeachPage& page);
  void add_block(TeachPage& page);
  void add_failure(const base::Diagnostic& mistake, TeachPage& page);
  void compile_end(TeachPage& page);

  std::uint32_t lines_per_page_;
  RecordReader reader_;
  RecordReader::Line line_;
};

}  // namespace kerf::teach
