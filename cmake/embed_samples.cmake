# Writes OUTPUT, a C++ source that holds the programs FILES.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"sample(${text})sample\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include \"server/samples.hpp\"

namespace kerf::server {

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = {
${entries}  };
  return all;
}

}  // namespace kerf::server
")
