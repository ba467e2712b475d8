# What makes a layer of the visualizer, and what puts texts into the program.

# A C++ file with the contents of these files (paths from `root` or, if they are made by the build, from its folder of made
# files), looked up by `std::string_view function(path)`.
function(gradus_embed output function root)
  cmake_parse_arguments(PARSE_ARGV 3 arg "LISTED" "" "JOIN")
  set(files ${arg_UNPARSED_ARGUMENTS})
  set(made_root ${PROJECT_BINARY_DIR}/generated)
  set(inputs)
  foreach(file IN LISTS files)
    if(EXISTS ${root}/${file})
      list(APPEND inputs ${root}/${file})
    else()
      list(APPEND inputs ${made_root}/${file})
    endif()
  endforeach()
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${output} -D FUNCTION=${function} -D ROOT=${root} -D MADE_ROOT=${made_root} "-DFILES=${files}"
            "-DJOIN=${arg_JOIN}" -DLISTED=${arg_LISTED} -P ${PROJECT_SOURCE_DIR}/visualize/embed.cmake
    DEPENDS ${inputs} visualize/embed.cmake
    COMMENT "Embedding for ${function}()" VERBATIM)
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # each numbers its texts
endfunction()

# A layer of the visualizer: the static library gradus_<name> from the .cpp files in visualize/<name>, in folders of it too, and more
# sources.
function(gradus_add_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;PRIVATE_LINK")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS visualize/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/(cli/(main|live_pages)|live/(module|runtime))\\.cpp$")  # programs of their own
  get_property(left_out GLOBAL PROPERTY gradus_left_out_stories)
  list(TRANSFORM left_out PREPEND ${PROJECT_SOURCE_DIR}/)
  list(REMOVE_ITEM sources ${left_out})
  list(APPEND sources ${arg_SOURCES})
  if(sources)
    add_library(gradus_${name} STATIC ${sources})
    if(name STREQUAL "cairo")
      gradus_precompile(gradus_${name})
    elseif(name STREQUAL "figure" AND busy)
      target_compile_options(gradus_figure PRIVATE ${busy})
      gradus_allow_own_deprecations(gradus_figure)
      gradus_compile_at_once(gradus_figure)
    else()
      gradus_compile_quickly(gradus_${name})
      gradus_compile_at_once(gradus_${name})
    endif()
    if(name MATCHES "^(stories|check|json|request)$")
      target_compile_options(gradus_${name} PRIVATE ${small})
    endif()
    # Pictures of surfaces are most of what figures with them take; -O1 doubles that
    set(surfaces visualize/stories/rendered_surface.cpp)
    if(name STREQUAL "stories" AND swift)
      set_source_files_properties(visualize/stories/hidden_lines.cpp visualize/stories/space_drawing.cpp ${surfaces}
                                  PROPERTIES COMPILE_OPTIONS ${swift} SKIP_PRECOMPILE_HEADERS ON)
    elseif(name STREQUAL "stories" AND quickly)
      set_source_files_properties(${surfaces} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O2>
                                  SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    target_include_directories(gradus_${name} PUBLIC visualize)
    target_link_libraries(gradus_${name} PUBLIC ${arg_LINK} PRIVATE fmt::fmt ${arg_PRIVATE_LINK})
  else()
    add_library(gradus_${name} INTERFACE)
    target_include_directories(gradus_${name} INTERFACE visualize)
    target_link_libraries(gradus_${name} INTERFACE ${arg_LINK})
  endif()
  file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/visualize CONFIGURE_DEPENDS visualize/${name}/*.hpp)
  # What is compiled with the one story that it belongs to, and what is a text for others
  list(FILTER headers EXCLUDE REGEX "^(stories/[^/]+|source/parts)/")
  gradus_check_headers(headers_alone_${name} visualize "gradus_${name};${arg_PRIVATE_LINK}" ${headers})
endfunction()
