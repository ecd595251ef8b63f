#pragma once

#include "lang/teach/page_compiler.hpp"
#include "lang/vm/straight_program.hpp"

namespace kerf::teach {

/// One .tch file as a program of the virtual machine.
class TeachLibrary final : public vm::StraightProgram<TeachPage> {
 public:
  TeachLibrary(const base::SourceSet& sources, const vm::PageSettings& settings);

 private:
  // vm::StraightProgram
  void rewind() override { next_ = {}; }
  void compile(TeachPage& page) override;

  const base::SourceSet& sources_;
  PageCompiler compiler_;
  RecordReader::Position next_;  // where the next page begins
};

}  // namespace kerf::teach
