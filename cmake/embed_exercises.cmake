# Writes OUTPUT, a C++ source that holds the text of FILES, exercises of the training mode.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include \"training/exercise.hpp\"

namespace kerf::training {

const std::vector<ExerciseFile>& exercise_files() {
  static const std::vector<ExerciseFile> files = {
${entries}  };
  return files;
}

}  // namespace kerf::training
")
