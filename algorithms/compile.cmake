# How everything is compiled: precompiled headers, optimisation, headers alone.

# Headers of ours that many others include, the longest first: compiled once for the check of those.
set(gradus_anchors stories/telling.hpp figure/recording.hpp core/raster.hpp core/arithmetic/exact.hpp core/contract.hpp)

# Where a header of ours lies, or the file that it is made of: that has the same includes.
function(gradus_file_of header output)
  string(REGEX REPLACE "_notes\\.hpp$" ".faults" faults ${PROJECT_SOURCE_DIR}/algorithms/${header})
  set(${output} ${faults} PARENT_SCOPE)
  foreach(root algorithms pipeline visualize)
    if(EXISTS ${PROJECT_SOURCE_DIR}/${root}/${header})
      set(${output} ${PROJECT_SOURCE_DIR}/${root}/${header} PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# The headers of ours that this one includes, and those that they include.
function(gradus_included_by header output)
  get_property(known GLOBAL PROPERTY "gradus_included_by ${header}" SET)
  if(NOT known)
    gradus_file_of(${header} file)
    file(STRINGS ${file} lines REGEX "^#include \"")
    set(all)
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" name "${line}")
      gradus_included_by(${name} below)
      list(APPEND all ${name} ${below})
    endforeach()
    list(REMOVE_DUPLICATES all)
    set_property(GLOBAL PROPERTY "gradus_included_by ${header}" "${all}")
  endif()
  get_property(all GLOBAL PROPERTY "gradus_included_by ${header}")
  set(${output} "${all}" PARENT_SCOPE)
endfunction()

# The anchor that a header includes anyway, or nothing: with that alone precompiled, all else that it lacks still shows.
function(gradus_anchor_of header output)
  set(${output} "" PARENT_SCOPE)
  if(GRADUS_PRECOMPILE)
    gradus_included_by(${header} included)
    foreach(anchor IN LISTS gradus_anchors)
      if(anchor IN_LIST included)
        set(${output} ${anchor} PARENT_SCOPE)
        break()
      endif()
    endforeach()
  endif()
endfunction()

# Compiles each of these headers (paths from `root`, its include folder) as the only include of a file: by the target
# headers_alone, and a share of them, of which ./bootstrap takes another with each commit, by headers_alone_0 to _8.
add_custom_target(headers_alone)
foreach(share RANGE 8)
  add_custom_target(headers_alone_${share})
endforeach()
set_property(GLOBAL PROPERTY gradus_next_share 0)
function(gradus_check_headers target root link)
  set(targets)
  foreach(header IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "${header}" name)
    set(source ${PROJECT_BINARY_DIR}/headers_alone/${name}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"  // IWYU pragma: keep\n")
    gradus_anchor_of(${header} anchor)
    string(MAKE_C_IDENTIFIER "${target}${anchor}" checks)
    if(NOT TARGET ${checks})
      add_library(${checks} OBJECT)
      target_include_directories(${checks} PRIVATE ${root})
      target_link_libraries(${checks} PRIVATE ${link})
      gradus_precompile_anchor(${checks} "${anchor}")
      gradus_allow_own_deprecations(${checks})
      set_target_properties(${checks} PROPERTIES EXCLUDE_FROM_ALL ON)
      add_dependencies(headers_alone ${checks})
      get_property(share GLOBAL PROPERTY gradus_next_share)
      add_dependencies(headers_alone_${share} ${checks})
      math(EXPR share "(${share} + 1) % 9")
      set_property(GLOBAL PROPERTY gradus_next_share ${share})
    endif()
    target_sources(${checks} PRIVATE ${source})
  endforeach()
endfunction()

function(gradus_precompile_anchor target anchor)
  if(anchor)
    string(MAKE_C_IDENTIFIER "gradus_precompiled_${anchor}" from)
    if(NOT TARGET ${from})
      add_library(${from} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/generated/empty.cpp)
      target_include_directories(${from} PRIVATE ${PROJECT_SOURCE_DIR}/visualize)
      target_link_libraries(${from} PRIVATE gradus::core)
      gradus_file_of(${anchor} file)
      target_precompile_headers(${from} PRIVATE ${file})
    endif()
    target_precompile_headers(${target} REUSE_FROM ${from})
  endif()
endfunction()

# What takes longer to optimise than to run is compiled with -O1 in a release build: the programs of tests, and of the
# visualizer all but cairo/ (drawing the gallery, 84 % of the time are zlib's, Cairo's and the C library's, with -O1, too).
set(quickly)
if(CMAKE_CXX_FLAGS_RELEASE MATCHES "-O[23]")
  set(quickly $<$<CONFIG:Release>:-O1>)
endif()

# The module of live pages is fetched: what is most of it is compiled for size alone, which takes a fifth from it; the
# little that its answers wait for, for speed.
set(small)
set(swift)
if(GRADUS_LIVE)
  set(small -Oz)
  set(swift -O2)
endif()

# What the sanitized tests spend their time in is compiled with -O1 in a build that else is not optimised (preset asan-ubsan),
# and without the precompiled headers, which are compiled with its -O0.
set(busy)
if(CMAKE_CXX_FLAGS_RELWITHDEBINFO MATCHES "-O0")
  set(busy $<$<CONFIG:RelWithDebInfo>:-O1>)
endif()

# The standard library's and the packages' headers, compiled once for libraries and once, with GoogleTest's and Boost's,
# for the programs of tests. What a header of ours lacks still shows: headers_alone goes without.
if(GRADUS_PRECOMPILE)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(--param=ggc-min-heapsize=524288)  # precompiled headers fill the heap; GCC would clear it up all the time
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/empty.cpp CONTENT "")
  add_library(gradus_precompiled OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/generated/empty.cpp)
  target_compile_options(gradus_precompiled PRIVATE ${quickly})
  target_link_libraries(gradus_precompiled PRIVATE glm::glm fmt::fmt)
  target_precompile_headers(gradus_precompiled PRIVATE
    <algorithm> <array> <atomic> <bit> <cmath> <compare> <concepts> <cstdint> <cstdio> <cstdlib> <filesystem> <fstream>
    <functional> <limits> <map> <memory> <mutex> <numeric> <optional> <ranges> <set> <span> <sstream> <string>
    <string_view> <tuple> <unordered_map> <utility> <variant> <vector>
    <fmt/format.h> <fmt/ranges.h> <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp> <glm/mat4x4.hpp> <glm/geometric.hpp>)
  if(GRADUS_TESTS)
    add_library(gradus_precompiled_tests OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/generated/empty.cpp)
    target_compile_options(gradus_precompiled_tests PRIVATE ${quickly})
    target_link_libraries(gradus_precompiled_tests PRIVATE glm::glm fmt::fmt Boost::headers GTest::gmock)
    get_target_property(headers gradus_precompiled PRECOMPILE_HEADERS)
    target_precompile_headers(gradus_precompiled_tests PRIVATE ${headers} <random> <gmock/gmock.h> <gtest/gtest.h>
      <boost/multiprecision/cpp_bin_float.hpp> <boost/multiprecision/cpp_int.hpp>)
  endif()
endif()

# Clang warns of what GCC's headers use themselves, the buffer of stable sorts.
function(gradus_allow_own_deprecations target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(${target} PRIVATE -Wno-deprecated-declarations)
  endif()
endfunction()

# gradus_compile_quickly(target [_tests]): with -O1 in a release build, and with the precompiled headers (of tests).
function(gradus_compile_quickly target)
  target_compile_options(${target} PRIVATE ${quickly})
  # GCC 12 warns of its own std::string once its header is precompiled
  if(GRADUS_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  gradus_allow_own_deprecations(${target})
  if(TARGET gradus_precompiled${ARGN})
    set(from gradus_precompiled${ARGN})
  else()
    set(from gradus_precompiled)  # a build without tests
  endif()
  if(TARGET ${from})
    target_precompile_headers(${target} REUSE_FROM ${from})
    if(from STREQUAL "gradus_precompiled_tests")
      # They serve only code that defines what they were compiled with
      target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:GTest::gtest,INTERFACE_COMPILE_OPTIONS>)
      target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:Boost::headers,INTERFACE_COMPILE_DEFINITIONS>)
    endif()
  endif()
endfunction()

# The precompiled headers for what is optimised, where they were compiled with the same options.
function(gradus_precompile target)
  gradus_allow_own_deprecations(${target})
  if(TARGET gradus_precompiled AND NOT quickly)
    target_precompile_headers(${target} REUSE_FROM gradus_precompiled)
  endif()
endfunction()

# Compiles several files of the target at once, where that is asked for: quicker from scratch, slower after an edit.
function(gradus_compile_at_once target)
  if(GRADUS_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# Lets a source file of a target load this shared library by itself, when it is asked for: the file gets what the linker
# calls the library as GRADUS_<name>. More arguments: folders of headers, for the target.
function(gradus_load_on_demand target file name library)
  execute_process(COMMAND ${CMAKE_READELF} -d ${library} OUTPUT_VARIABLE section COMMAND_ERROR_IS_FATAL ANY)
  if(NOT section MATCHES "\\(SONAME\\)[^[]*\\[([^]]+)\\]")
    message(FATAL_ERROR "${library}: expected a shared library, which can be loaded")
  endif()
  set_source_files_properties(${file} PROPERTIES COMPILE_DEFINITIONS "GRADUS_${name}=\"${CMAKE_MATCH_1}\"")
  target_include_directories(${target} SYSTEM PRIVATE ${ARGN})
  target_link_libraries(${target} PRIVATE ${CMAKE_DL_LIBS})
endfunction()

# The same of an imported target.
function(gradus_load_target_on_demand target file name imported)
  get_target_property(library ${imported} LOCATION)
  get_target_property(folders ${imported} INTERFACE_INCLUDE_DIRECTORIES)
  gradus_load_on_demand(${target} ${file} ${name} ${library} ${folders})
  get_target_property(definitions ${imported} INTERFACE_COMPILE_DEFINITIONS)
  if(definitions)
    target_compile_definitions(${target} PRIVATE ${definitions})
  endif()
endfunction()
