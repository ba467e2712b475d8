# Writes a C++ file that holds the contents of files; run by gradus_embed in CMakeLists.txt.
#   cmake -D OUTPUT=x.cpp -D FUNCTION=source_text -D ROOT=/project "-DFILES=a.hpp;b.hpp" -P embed.cmake
# The file defines std::string_view gradus::FUNCTION(std::string_view path): the content by its path from ROOT, or
# an empty text for a path that is not among FILES.
# Contents become arrays of bytes: a string literal has a length limit, and no escape is safe for every text.

set(arrays)
set(lookups)
set(number 0)
foreach(path IN LISTS FILES)
  file(READ ${ROOT}/${path} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  # The closing zero keeps an empty file's array legal; it is not part of the content
  string(APPEND arrays "constexpr char file_${number}[] = {${bytes}'\\0'};\n")
  string(APPEND lookups "  if (path == \"${path}\") return {file_${number}, sizeof file_${number} - 1};\n")
  math(EXPR number "${number} + 1")
endforeach()

file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [=[
// Made by visualize/embed.cmake
#include <string_view>

namespace gradus {
namespace {

@arrays@
}  // namespace

std::string_view @FUNCTION@(std::string_view path);
std::string_view @FUNCTION@([[maybe_unused]] std::string_view path) {
@lookups@  return {};
}

}  // namespace gradus
]=])
# Also when nothing changed: the build asks for the output to be newer than the inputs
file(TOUCH ${OUTPUT})
