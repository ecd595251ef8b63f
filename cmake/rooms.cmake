# kerf_room(NAME SOURCES… LINKS…): one static library per room. A room sees the headers of src/, but
# links only what it names here, and tools/check_rooms.py holds the include lines against the same list.
function(kerf_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS" ${ARGN})
  add_library(kerf_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(kerf_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_compile_options(kerf_${name} PRIVATE ${KERF_LTO_COMPILE})
  target_link_libraries(kerf_${name} PUBLIC ${ROOM_LINKS} PRIVATE kerf_options)
endfunction()
