# Packages of headers alone, for WebAssembly. The C library's headers lie beside theirs in /usr/include and are another
# system's, so each package is reached through a link of its own.
function(gradus_headers_of target header)
  cmake_path(GET header PARENT_PATH name)
  find_path(found_${name} ${header} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
  file(CREATE_LINK ${found_${name}}/${name} ${PROJECT_BINARY_DIR}/packages/${name} SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/packages)
endfunction()

gradus_headers_of(fmt::fmt fmt/core.h)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY "FMT_STATIC_THOUSANDS_SEPARATOR=','")
gradus_headers_of(glm::glm glm/glm.hpp)
gradus_headers_of(nlohmann_json::nlohmann_json nlohmann/json.hpp)
gradus_headers_of(Boost::headers boost/version.hpp)
target_compile_definitions(Boost::headers INTERFACE BOOST_NO_CXX98_FUNCTION_BASE)
