# kerf_embed(NAME HEADER… FUNCTION… TYPE… KEY… FILES…): makes ${NAME}.cpp, which defines FUNCTION() of HEADER, a
# const std::vector<TYPE>& with an entry {key, text} for each of FILES. KEY says which part of a file's path the key is,
# as get_filename_component names it. The path of the source is left in the variable NAME. TYPE and FUNCTION are
# qualified, kerf::room::it.
#
# With -P this file is the script that writes the source.
if(CMAKE_SCRIPT_MODE_FILE)
  set(entries "")
  foreach(file IN LISTS FILES)
    get_filename_component(key ${file} ${KEY})
    file(READ ${file} text)
    string(APPEND entries "      {\"${key}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE ${OUTPUT}
"#include \"${HEADER}\"

// Every compiler of ours takes them; the standard promises 65536 characters alone.
#pragma GCC diagnostic ignored \"-Woverlength-strings\"

const std::vector<${TYPE}>& ${FUNCTION}() {
  static const std::vector<${TYPE}> entries = {
${entries}  };
  return entries;
}
")
  return()
endif()

set(KERF_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(kerf_embed name)
  cmake_parse_arguments(EMBED "" "HEADER;FUNCTION;TYPE;KEY" "FILES" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DHEADER=${EMBED_HEADER} -DFUNCTION=${EMBED_FUNCTION}
            -DTYPE=${EMBED_TYPE} -DKEY=${EMBED_KEY} "-DFILES=${EMBED_FILES}" -P ${KERF_EMBED_SCRIPT}
    DEPENDS ${EMBED_FILES} ${KERF_EMBED_SCRIPT}
    VERBATIM)
  set(${name} ${source} PARENT_SCOPE)
endfunction()
