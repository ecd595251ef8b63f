# Compiler options of every target of ours.
add_library(kerf_options INTERFACE)
target_compile_options(kerf_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough
  -ffp-contract=off)  # the same sums on every compiler and target: same input, same bytes
# x86 with 32 bits would compute doubles in registers of 80.
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(i.86|x86)")
  target_compile_options(kerf_options INTERFACE -msse2 -mfpmath=sse)
endif()
# Without this g++ fills and copies whatever has more than some 100 bytes, as a curve has, with string instructions of x86
# that take longer to begin than the copy. It chooses among the same instructions as before, so every result stays the same.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  target_compile_options(kerf_options INTERFACE "$<$<CONFIG:Release>:-mtune=skylake>")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 warns of its own std::string operator+ (GCC bug 105651).
  target_compile_options(kerf_options INTERFACE -Wno-restrict)
endif()
if(KERF_WERROR)
  target_compile_options(kerf_options INTERFACE -Werror)
endif()
# What reads foreign bytes is guarded: functions with arrays check their frame, copies into them their size, and all
# addresses are bound before the program runs. The loops of the interpreter have nothing of it: it is at their entry.
if(NOT KERF_SANITIZE)
  target_compile_options(kerf_options INTERFACE
    "$<$<CONFIG:Release>:-fstack-protector-strong;-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
endif()
target_link_options(kerf_options INTERFACE LINKER:-z,relro,-z,now)
# The program is optimised across its files. The libraries carry ordinary code as well, so that tests
# link quickly.
set(KERF_LTO_COMPILE "")
set(KERF_LTO_LINK "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT KERF_SANITIZE)
  set(KERF_LTO_COMPILE -flto=auto -ffat-lto-objects)
  set(KERF_LTO_LINK -flto=auto -O3)
endif()
if(KERF_SANITIZE)
  target_compile_options(kerf_options INTERFACE -fsanitize=${KERF_SANITIZE}
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(kerf_options INTERFACE -fsanitize=${KERF_SANITIZE})
endif()
# A release build compiles a dozen files of a target as one, two dozen of a COLD room: half of the time went into headers
# that every file reads anew.
# The other presets compile file by file, and so hold that each file includes what it uses.
option(KERF_TOGETHER "Compile files of a target together" OFF)
function(kerf_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KERF_TOGETHER} UNITY_BUILD_BATCH_SIZE 12)
endfunction()
find_program(KERF_MOLD mold)
find_program(KERF_CCACHE ccache)
if(KERF_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${KERF_CCACHE})
endif()
