# Writes OUTPUT, a C++ source that holds the text of FILES.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include \"machine/machine_definition.hpp\"

namespace kerf::machine {

const std::vector<BuiltinMachine>& builtin_machines() {
  static const std::vector<BuiltinMachine> machines = {
${entries}  };
  return machines;
}

}  // namespace kerf::machine
")
