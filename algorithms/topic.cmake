# What makes a topic, and what installs it.

# Makes a target installable and usable as gradus::<name>, here and after find_package(gradus).
function(gradus_export target name set)
  add_library(gradus::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT ${set} COMPONENT library)
  set_property(GLOBAL APPEND PROPERTY gradus_installed ${target})
endfunction()

# The header T_notes.hpp of a topic that writes its faults as differences, algorithms/F/T/T.faults: made into this folder of
# headers, before whatever includes headers of the target is compiled, and installed beside them.
set(gradus_made_headers ${PROJECT_BINARY_DIR}/generated/algorithms)
function(gradus_make_faults target path)
  get_filename_component(topic ${path} NAME)
  set(faults ${PROJECT_SOURCE_DIR}/algorithms/${path}/${topic}.faults)
  set(header ${gradus_made_headers}/${path}/${topic}_notes.hpp)
  set(script ${PROJECT_SOURCE_DIR}/algorithms/apply_faults.cmake)
  add_custom_command(
    OUTPUT ${header}
    COMMAND ${CMAKE_COMMAND} -D FAULTS=${faults} -D ROOT=${PROJECT_SOURCE_DIR}/algorithms -D OUTPUT=${header}
            -D DEPENDENCIES=${header}.d -P ${script}
    DEPENDS ${faults} ${script}
    DEPFILE ${header}.d
    COMMENT "Applying ${topic}.faults" VERBATIM)
  add_custom_target(${target}_faults DEPENDS ${header})
  add_dependencies(${target} ${target}_faults)
  set_property(GLOBAL APPEND PROPERTY gradus_installed ${target}_faults)
  set_property(GLOBAL APPEND PROPERTY gradus_installed_headers ${header})
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gradus/${path} COMPONENT library)
endfunction()

# gradus_add_topic(F/T [DEPENDS topic...] [PARTIAL]): all that belongs to the topic in algorithms/F/T/: the target
#   gradus::T, a check that its headers compile alone, the story visualize/stories/F/T_story.cpp and what it says beside
#   it. Its tests and its example are found by tests/CMakeLists.txt.
#   DEPENDS: other topics whose headers it may include. PARTIAL: not all of its five files exist yet.
# tests/architecture reads these calls too: keep each on one line.
function(gradus_add_topic path)
  cmake_parse_arguments(PARSE_ARGV 1 arg "PARTIAL" "" "DEPENDS")
  get_filename_component(topic ${path} NAME)
  file(GLOB headers RELATIVE ${PROJECT_SOURCE_DIR}/algorithms CONFIGURE_DEPENDS algorithms/${path}/*.hpp)
  if(NOT headers)
    message(FATAL_ERROR "gradus_add_topic(${path}): there is no header in algorithms/${path}/")
  endif()
  file(GLOB batch CONFIGURE_DEPENDS algorithms/${path}/${topic}_batch.cpp)
  # A batch that needs Highway is a target of its own, gradus::T_batch: a topic alone needs GLM and fmt only
  set(highway_batch)
  if(batch)
    file(STRINGS ${batch} highway REGEX "#include <hwy/")
    if(highway)
      set(highway_batch ${batch})
      set(batch)
    endif()
  endif()
  if(batch)
    add_library(gradus_${topic} STATIC ${batch})
    set(scope PUBLIC)
  else()
    add_library(gradus_${topic} INTERFACE)
    set(scope INTERFACE)
  endif()
  list(TRANSFORM arg_DEPENDS PREPEND gradus::)
  target_link_libraries(gradus_${topic} ${scope} gradus::core ${arg_DEPENDS})
  gradus_export(gradus_${topic} ${topic} gradusTargets)
  file(GLOB faults CONFIGURE_DEPENDS algorithms/${path}/${topic}.faults)
  if(faults)
    target_include_directories(gradus_${topic} ${scope} $<BUILD_INTERFACE:${gradus_made_headers}>)
    gradus_make_faults(gradus_${topic} ${path})
    list(APPEND headers ${path}/${topic}_notes.hpp)
  endif()
  if(highway_batch AND TARGET hwy::hwy)
    add_library(gradus_${topic}_batch STATIC ${highway_batch})
    target_link_libraries(gradus_${topic}_batch PUBLIC gradus::${topic} PRIVATE hwy::hwy)
    if(GRADUS_FUZZ)
      # With both sanitizers and counted branches, Clang optimises one for a quarter of an hour and more
      target_compile_options(gradus_${topic}_batch PRIVATE -O0)
    endif()
    gradus_export(gradus_${topic}_batch ${topic}_batch gradusBatchTargets)
    set_property(GLOBAL APPEND PROPERTY gradus_batches gradus::${topic}_batch)
  endif()
  gradus_check_headers(headers_alone_${topic} algorithms gradus::${topic} ${headers})
  set_property(GLOBAL APPEND PROPERTY gradus_topics ${path})
  list(TRANSFORM headers PREPEND algorithms/)
  set_property(GLOBAL APPEND PROPERTY gradus_topic_headers ${headers})

  file(GLOB story CONFIGURE_DEPENDS visualize/stories/${path}_story.cpp)
  if(story)
    gradus_register_story(${path})
  endif()
endfunction()

# The story of F/T belongs to the catalogue, unless this build leaves it out by GRADUS_STORIES_THIRDS. That of bresenham_line
# always does: tests show by it what holds for any.
set_property(GLOBAL PROPERTY gradus_next_story_third 0)
function(gradus_register_story path)
  get_filename_component(topic ${path} NAME)
  get_property(third GLOBAL PROPERTY gradus_next_story_third)
  if(third IN_LIST GRADUS_STORIES_THIRDS OR topic STREQUAL "bresenham_line")
    set_property(GLOBAL APPEND PROPERTY gradus_story_topics ${topic})
  else()
    set_property(GLOBAL APPEND PROPERTY gradus_left_out_stories visualize/stories/${path}_story.cpp)
  endif()
  math(EXPR third "(${third} + 1) % 3")
  set_property(GLOBAL PROPERTY gradus_next_story_third ${third})
endfunction()

# gradus_add_story(C/N): a topic of the visualizer alone, with no folder of its own in algorithms/: the story
#   visualize/stories/C/N_story.cpp, which ends in gradus::N::entry() like any other.
function(gradus_add_story path)
  get_filename_component(topic ${path} NAME)
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/visualize/stories/${path}_story.cpp)
    message(FATAL_ERROR "gradus_add_story(${path}): there is no visualize/stories/${path}_story.cpp")
  endif()
  gradus_register_story(${path})
endfunction()
