# Writes a C++ file that holds the contents of text files; run by gradus_embed in CMakeLists.txt.
#   cmake -D OUTPUT=x.cpp -D FUNCTION=source_text -D ROOT=/project -D MADE_ROOT=/build "-DFILES=a.hpp;b.hpp" -P embed.cmake
# The file defines std::string_view gradus::FUNCTION(std::string_view path): the content by its path from ROOT, where it
# isn't there from MADE_ROOT, or an empty text for a path that is not among FILES.
# With "-DJOIN=en;de" the text "en.txt" is all files of that name, or that end so (a.en.txt), one after the other.
# With -DLISTED=ON lines that begin with a comment or a directive are empty: no listing of a function shows them.
# Contents become string literals: as arrays of bytes the pages alone took compiler and CMake ten seconds.

cmake_minimum_required(VERSION 3.25)

set(arrays)
set(lookups)
set(number 0)
foreach(path IN LISTS FILES)
  set(file ${ROOT}/${path})
  if(NOT EXISTS ${file})
    set(file ${MADE_ROOT}/${path})
  endif()
  file(READ ${file} text)
  string(LENGTH "${text}" length)
  file(SIZE ${file} size)
  if(NOT length EQUAL size)
    message(FATAL_ERROR "embed.cmake: ${path} is not a text with Unix line ends (${length} of its ${size} bytes are)")
  endif()
  if(LISTED)
    string(REGEX REPLACE "\n(//|#)[^\n]*" "\n" text "${text}")
  endif()
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "?" "\\?" text "${text}")  # "??=" and the like have been other letters once
  string(REPLACE "\n" "\\n\"\n\"" text "${text}")
  set(joined OFF)
  foreach(key IN LISTS JOIN)
    if(path MATCHES "(^|[/.])${key}\\.txt$")
      string(APPEND text_${key} "\n\"${text}\"")
      set(joined ON)
    endif()
  endforeach()
  if(joined)
    continue()
  endif()
  string(APPEND arrays "constexpr char file_${number}[] =\n\"${text}\";\n")
  string(APPEND lookups "  if (path == \"${path}\") return {file_${number}, sizeof file_${number} - 1};\n")
  math(EXPR number "${number} + 1")
endforeach()

foreach(key IN LISTS JOIN)
  string(APPEND arrays "constexpr char text_${key}[] =${text_${key}};\n")
  string(APPEND lookups "  if (path == \"${key}.txt\") return {text_${key}, sizeof text_${key} - 1};\n")
endforeach()

file(WRITE ${OUTPUT} "// Made by visualize/embed.cmake
#include <string_view>

// Longer than the standard asks compilers to take
#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace gradus {
namespace {

${arrays}
}  // namespace

std::string_view ${FUNCTION}(std::string_view path);
std::string_view ${FUNCTION}([[maybe_unused]] std::string_view path) {
${lookups}  return {};
}

}  // namespace gradus
")
