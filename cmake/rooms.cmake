# kerf_room([HOT|COLD] [SOURCES made…] [EXCEPT file…] [LINKS …]): one static library per folder below src/, of every .cpp in
# it but EXCEPT. HOT: run for every word, move or column; optimised across files. COLD: run once for a program, a command
# or a message; compiled quickly; g++ sees
# too little then to tell what is not initialised. Its target is the folder's path: kerf_machine_run. A room sees the headers of src/, but links only
# what it names here, and tools/check_rooms.py holds the include lines against the same list.
function(kerf_room)
  cmake_parse_arguments(ROOM "HOT;COLD" "" "SOURCES;EXCEPT;LINKS" ${ARGN})
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE / _ name kerf_${room})
  file(GLOB sources RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.cpp internal/*.cpp)
  list(REMOVE_ITEM sources "" ${ROOM_EXCEPT})
  add_library(${name} STATIC ${sources} ${ROOM_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PUBLIC ${ROOM_LINKS} PRIVATE kerf_options)
  kerf_compile_together(${name})
  if(ROOM_HOT)
    target_compile_options(${name} PRIVATE ${KERF_LTO_COMPILE})
  elseif(ROOM_COLD)
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>")
    set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 24)
  endif()
endfunction()
