#pragma once
// Traces of real runs, for tests of what is made from them.

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "stories/topic.hpp"
#include "support/sanitized.hpp"

namespace gradus::test {

inline const TopicEntry& topic(std::string_view name) {
  for (const TopicEntry* entry : catalogue()) {
    if (entry->name == name) return *entry;
  }
  throw std::invalid_argument("no topic of that name");
}

/// The topic's arguments: these, and the defaults of all others. Mazes are given as rows joined by "/".
inline Arguments complete(const TopicEntry& entry, const std::map<std::string, std::string>& given) {
  Arguments arguments;
  const auto method = given.find("method");
  arguments.set({"method", method == given.end() ? entry.default_method : method->second});
  for (const Parameter& parameter : entry.parameters) {
    const auto found = given.find(parameter.name);
    const std::string& text = found == given.end() ? parameter.default_value : found->second;
    Arguments::Entry argument{.name = parameter.name, .text = text};
    const bool is_file = parameter.type == ParameterType::maze || parameter.type == ParameterType::picture ||
                         parameter.type == ParameterType::model;
    if (!text.empty() && !is_file) argument = read_argument(parameter, text);
    argument.given = found != given.end();
    if (parameter.type == ParameterType::maze) {
      argument.content = argument.text;
      std::ranges::replace(argument.content, '/', '\n');
    }
    if (parameter.type == ParameterType::picture && !argument.text.empty()) {
      argument.image = std::make_shared<const Image>(read_png(argument.text));
    }
    arguments.set(std::move(argument));
  }
  return arguments;
}

inline Trace trace_of(std::string_view name, const std::map<std::string, std::string>& given = {},
                      Recording recording = {}) {
  const TopicEntry& entry = topic(name);
  return entry.run(complete(entry, given), recording);
}

/// One trace of every method of every topic, and the inputs that strain a figure most.
/// only: of this topic alone. brief: without some of the longest, and under a sanitizer one in three, since
/// golden/trace_hash runs them all there.
inline std::vector<Trace> telling_traces(const Wording& wording = {}, std::string_view only = {},
                                         bool brief = sanitized) {
  std::vector<Trace> traces;
  int next = 0;
  const auto tell = [&](std::string_view name, const std::map<std::string, std::string>& given,
                        std::int64_t most = Recording::default_most) {
    if (!only.empty() && name != only) return;
    if (sanitized && brief && only.empty() && next++ % 3 != 0) return;
    traces.push_back(trace_of(name, given, {0, most, wording}));
  };
  for (const TopicEntry* entry : catalogue()) {
    for (const Method& method : entry->methods) tell(entry->name, {{"method", method.name}});
  }
  tell("octree_order", {{"points", "1,1,1"}});
  tell("octree_order", {{"points", "1,1,1"}, {"far", "yes"}});
  tell("octree_order", {{"far", "yes"}, {"method", "back_to_front"}});
  const auto shading = [&](std::map<std::string, std::string> given) { tell("polygon_shading", given); };
  const std::string roof = "A: -5,-5,0 0,-5,4 0,5,4 -5,5,0; B: 0,-5,4 5,-5,0 5,5,0 0,5,4";
  for (const char* method : {"gouraud", "phong", "flat", "all_three", "vertex_normals"})
    shading({{"faces", roof}, {"method", method}, {"columns", "6"}, {"rows", "6"}, {"weighting", "plain"}});
  shading({{"faces", roof}, {"method", "vertex_normals"}, {"weighting", "area"}});
  shading({{"faces", roof}, {"intensities", "0 1 0.5"}, {"columns", "6"}, {"rows", "6"}});
  shading({{"intensities", "0 0.5 1"}, {"window", "-0.5,-0.5,11.5,11.5"}});
  shading({{"method", "flat"}, {"light", "0,0,1000000"}, {"eye", "0,0,1000000"}});
  const auto lit = [&](const std::map<std::string, std::string>& given) { tell("illumination", given); };
  lit({{"lights", "0,3,4 0,-4,2 0,2,-1"}, {"eye", "0,-3,4"}});
  lit({{"lights", "0,3,4 0,30,4"}, {"range", "8"}});
  lit({{"lights", "0,0,0"}});
  lit({{"ks", "0"}});
  lit({{"kind", "directional"}});
  lit({{"kind", "spot"}, {"lights", "0,3,4 0,6,1"}, {"aim", "0,2,0"}, {"cone", "15,30"}});
  lit({{"kind", "spot"}, {"lights", "0,3,4"}, {"aim", "0,9,0"}, {"cone", "15,30"}});
  lit({{"kind", "area"}, {"samples", "2"}});
  lit({{"kind", "area"}, {"samples", "1"}, {"aim", "0,6,8"}});
  lit({{"method", "lights_side_by_side"}, {"samples", "1"}});
  lit({{"method", "highlight_lobes"}, {"exponents", "0 4"}});
  lit({{"method", "tinted_highlight"}, {"colour", "#ff0000"}, {"eye", "0,-3,4"}});
  lit({{"method", "light_minus_normal"},
       {"place", "6,0,0"},
       {"lights", "3,4,0"},
       {"normal", "0,1,0"},
       {"eye", "7,9,0"}});
  lit({{"method", "light_behind"}, {"lights", "3,0,-4"}, {"eye", "-10,0,1.4"}, {"shininess", "1"}});
  lit({{"method", "light_behind"}, {"lights", "3,0,-4"}, {"eye", "10,0,1.4"}, {"shininess", "0"}});
  lit({{"method", "unclamped"}, {"lights", "0,3,4"}, {"eye", "0,2,-4"}, {"shininess", "2"}, {"kd", "0"}});
  lit({{"method", "unclamped"}, {"lights", "0,3,4"}, {"eye", "0,2,-4"}, {"shininess", "0.5"}});
  lit({{"method", "unclamped"}, {"lights", "0,-3,4 3,0,-2"}, {"kd", "0.5"}, {"eye", "0,2,5"}});
  const auto smooth = [&](std::string to, std::string method) {
    tell("antialiased_line", {{"to", to}, {"method", method}});
  };
  for (const char* to : {"0,0", "5,0", "4,2", "8,6"}) {
    for (const char* method : {"wu", "gupta_sproull", "exact_area", "distance_along_column"})
      smooth(to, method);
  }
  for (const char* method : {"jittered", "uniform", "regular", "n_rooks", "correlated_multi_jittered",
                             "sobol", "all_patterns", "pictures", "whole_coordinates", "divided_by_asked"})
    tell("jittered", {{"method", method}, {"samples", "1"}});
  tell("jittered", {{"method", "n_rooks"}, {"samples", "8"}});
  tell("jittered", {{"method", "pictures"}, {"samples", "4"}, {"scene", "zone_plate"}});
  tell("jittered", {{"method", "divided_by_asked"}, {"samples", "8"}});
  const auto listed = [&](std::string polygons, std::string depths, std::string surfaces = "") {
    std::map<std::string, std::string> given{{"polygons", polygons}, {"depths", depths}};
    if (!surfaces.empty()) given["surfaces"] = surfaces;
    tell("a_buffer", given);
  };
  const std::string whole = "-1,-1 2,-1 2,2 -1,2", corner = "0,0 0.13,0 0,0.26",
                    two_bits = "0,0 0.26,0 0.26,0.25 0,0.25", strip = "-1,-1 0.5,-1 0.5,2 -1,2",
                    right = "0.5,-1 2,-1 2,2 0.5,2";
  listed(corner, "0,0,1");
  listed("3,3 4,3 4,4", "0,0,1");
  listed(whole + "; " + corner, "0,0,1 1,1,1");
  listed(corner + "; " + two_bits, "0,0,1 1,1,1");
  listed(two_bits + "; " + corner, "0,0,1 1,1,1");
  listed(whole + "; " + strip, "0.2,0.8,1 0.3,0.9,1");
  listed(strip + "; " + whole, "0.2,0.2,0.5 0.3,0.9,1");
  listed(strip + "; " + right, "0.2,0.2,1 0.3,0.3,1", "1 1");
  listed(two_bits + "; 0.26,0 0.5,0 0.5,0.25 0.26,0.25; 0.5,0 1,0 1,0.25 0.5,0.25",
         "0.2,0.2,1 0.3,0.3,1 0.4,0.4,1", "1 1 1");
  tell("a_buffer", {{"method", "mask_of"}, {"polygons", corner}, {"depths", "0,0,1"}});
  for (const char* method : {"sum_of_areas", "divided_by_covered"})
    tell("a_buffer", {{"method", method}, {"polygons", strip}, {"depths", "0,0,1"}});
  tell("a_buffer",
       {{"method", "by_ranges"}, {"polygons", whole + "; " + whole}, {"depths", "0.2,0.3,1 0.25,0.35,1"}});
  listed(whole + "; " + whole, "0.2,0.4,1 0.35,0.25,1");
  listed(whole + "; " + whole + "; " + whole, "0.2,0.4,1 0.4,0.2,1 0.3,0.3,1");
  for (const char* filter : {"tent", "gaussian"})
    tell("supersampling", {{"filter", filter}, {"samples", "2"}});
  tell("supersampling", {{"method", "rays"}, {"samples", "1"}});
  for (const char* method : {"bridson", "dart_throwing"}) {
    tell("poisson_disc", {{"method", method}, {"radius", "2"}, {"tries", "1"}});
    tell("poisson_disc", {{"method", method}, {"radius", "0.8"}, {"tries", "1"}});
    tell("poisson_disc", {{"method", method}, {"tile", "yes"}, {"area", "1,1"}, {"radius", "0.4"}});
  }
  for (const char* samples : {"1", "2"})
    tell("poisson_disc", {{"method", "best_candidate"}, {"samples", samples}, {"candidates", "1"}});
  const auto accumulated = [&](std::string method, std::map<std::string, std::string> given) {
    given["method"] = method;
    tell("accumulation_buffer", given);
  };
  for (const char* method : {"accumulate", "eight_bits", "wide_sums"})
    accumulated(method, {{"a", "1"}, {"b", "1"}});
  accumulated("accumulate", {{"a", "8"}, {"b", "8"}, {"pixel", "0,0"}});
  accumulated("accumulate", {{"triangle", "1,1 1,1 3,3"}});
  accumulated("eight_bits", {{"a", "8"}, {"b", "8"}, {"value", "255"}});
  accumulated("motion_blur", {{"passes", "1"}});
  accumulated("motion_blur", {{"passes", "64"}, {"speed", "0"}});
  accumulated("depth_of_field", {{"eyes", "1"}});
  accumulated("depth_of_field", {{"focus", "8"}});
  tell("texture_mapping", {{"method", "mip_mapped"}, {"texels", "16"}});
  tell("texture_mapping", {{"method", "mip_mapped"}, {"texels", "2"}});
  tell("texture_mapping", {{"method", "mip_mapped"},
                           {"corners", "0,12,1 12,12,1 12,0,1 0,0,1"},
                           {"texels", "12"},
                           {"tiles", "2"}});
  tell("texture_mapping", {{"corners", "0,12,1 12,12,1 12,0,1 0,0,1"}});
  for (const char* texels : {"1", "2", "3"})
    tell("texture_mapping", {{"method", "mip_chain"}, {"texels", texels}});
  for (const char* method : {"adaptive", "each_sample"}) {
    tell("adaptive", {{"method", method}, {"faces", "A: 0.3,0.4,1 7,1,1 2,7,1"}, {"pixel", "4,4"}});
    // One behind the other, one that pierces both where no edge crosses
    tell("adaptive", {{"method", method},
                      {"faces",
                       "A: -20,-20,0.5 30,-20,0.5 0,30,0.5; B: -20,-20,0.7 30,-20,0.7 0,30,0.7; "
                       "C: -20,-20,-0.4 30,-20,1.6 0,30,0.4"},
                      {"samples", "4"},
                      {"columns", "5"},
                      {"rows", "4"},
                      {"pixel", "3,2"}});
  }
  tell("adaptive", {{"method", "adaptive_contrast"}, {"surface", "chequered"}, {"threshold", "60"}});
  for (const char* thickness : {"0.1", "0.2", "1"})
    tell("adaptive", {{"method", "thin"}, {"thickness", thickness}});
  const auto line = [&](std::string from, std::string to, std::string method = "decision_parameter") {
    tell("bresenham_line", {{"from", from}, {"to", to}, {"method", method}}, 200);
  };
  line("0,0", "0,0");
  line("2,5", "-3,-4");
  line("0,0", "2,1");
  line("3,-2", "3,9");
  line("0,0", "60,23");
  line("0,0", "60,23", "dda");
  line("-2147483648,-2147483648", "2147483647,2147483647");
  line("2147483647,-2147483648", "-2147483648,2147483646");
  line("0,0", "4,-2", "first_octant");
  tell("bresenham_line", {{"to", "12,10"}, {"method", "dda"}, {"exact", "yes"}});
  tell("liang_barsky", {{"line", "-1,2,11,7"}, {"exact", "yes"}});
  tell("affine_2d", {{"exact", "yes"}});
  tell("bresenham_line", {{"from", "262,23"}, {"to", "91618510,-54756195"}, {"window", "270,0,299,19"}});
  tell("bresenham_line", {{"window", "20,20,30,30"}});
  tell("pipeline", {{"turn", "50"}, {"near", "1.8"}});
  tell("pipeline",
       {{"turn", "-65"}, {"fov", "70"}, {"columns", "33"}, {"rows", "21"}, {"stage", "visibility"}});
  tell("pipeline", {{"face", "1"}, {"eye", "0.9,0.9,0.9"}});
  const auto divide_first = [&](std::string face, std::string eye, std::string target) {
    tell("pipeline", {{"method", "cull_after_division"}, {"face", face}, {"eye", eye}, {"target", target}});
  };
  divide_first("0", "1,1,3", "0.4,0.6,0");
  divide_first("1", "1,1,3", "0.4,0.6,0");
  divide_first("11", "0,0.6,3", "0,0.6,0");
  divide_first("0", "0.5,0.3,0", "0.3,0.6,0");
  for (const char* radius : {"0", "1", "5", "29"}) {
    tell("bresenham_circle", {{"radius", radius}});
    tell("bresenham_circle", {{"radius", radius}, {"method", "late_update"}});
    tell("bresenham_circle", {{"radius", radius}, {"method", "eight_plots"}});
  }
  tell("bresenham_circle", {{"radius", "10"}, {"window", "-3,2,11,11"}});
  tell("bresenham_circle", {{"radius", "10"}, {"window", "-3,-3,3,3"}});
  tell("bresenham_circle", {{"radius", "6"}, {"window", "-7,-7,7,7"}});
  tell("bresenham_circle",
       {{"center", "-960383883,-1920767765"}, {"radius", "2147483647"}, {"window", "-8,-6,8,6"}});
  if (only.empty() || only == "bresenham_circle") {
    traces.push_back(trace_of("bresenham_circle", {{"radius", "2147483647"}}, {1'000'000'000, 60, wording}));
  }
  for (const char* frequency : {"3", "5", "-9"})
    tell("sampling_theorem", {{"frequency", frequency}, {"phase", "30"}});
  for (const char* frequency : {"3", "5"}) {
    tell("sampling_theorem", {{"method", "reconstruction"}, {"frequency", frequency}, {"phase", "30"}});
    tell("sampling_theorem", {{"method", "at_least_twice"}, {"frequency", frequency}, {"phase", "30"}});
  }
  for (const char* revolutions : {"1", "1.5", "3", "30", "13"}) {
    for (const char* spokes : {"1", "8"}) {
      for (const char* method : {"wagon_wheel", "half_frame_rate"}) {
        tell("sampling_theorem",
             {{"method", method}, {"revolutions", revolutions}, {"spokes", spokes}, {"shown", "2"}});
      }
    }
  }
  tell("sampling_theorem", {{"method", "zone_plate"}, {"pixels", "16"}, {"distance", "4"}});
  const auto triangles = [&](std::string method, std::string given, std::string samples = "centres") {
    tell("triangle_coverage", {{"method", method}, {"triangles", given}, {"samples", samples}});
  };
  const std::string halves = "0,0 6,0 6,6; 0,0 6,6 0,6", pixel_sized = "1,1 2.2,1 1,2.2";
  for (const char* method : {"cover", "closed_half_planes", "expanded_edges"}) {
    triangles(method, halves);
    triangles(method, pixel_sized);
    triangles(method, "1,1 2,2 4,4");
    triangles(method, "1,4 4,4 2,1");
    triangles(method, "1,1 1.25,1 1,1.25");
    triangles(method, "1.5,1.5 5.5,1.5 1.5,5.5");
    for (const char* given : {"1,3 4,1 2,5", "1,3 2,5 4,1", "0.6,0.6 1.4,0.6 0.6,1.4"})
      triangles(method, given, "lattice");
    triangles(method, halves, "lattice");
    triangles(method, "0,0 1,0 1,1; 0,0 1,1 0,1");
    tell("triangle_coverage",
         {{"method", method}, {"triangles", "-9,4 20,3.5 7,90"}, {"window", "0,0,11,9"}});
  }
  for (const char* polygon : {"0,0 3,0 3,2 0,2", "0.5,0.5 4.5,0.5 4.5,3.5 2.5,1.25 0.5,3.5",
                              "0.25,0.25 0.75,0.25 0.5,0.75", "1,1 1,1 3,2", "7,7 9,7 9,9"}) {
    tell("area_sampling", {{"polygon", polygon}});
    tell("area_sampling", {{"method", "area_as_tone"}, {"polygon", polygon}});
  }
  for (const char* method : {"visible_areas", "areas_without_visibility"}) {
    for (const char* layers : {"A: 0,0,1 1,0,1 0,1,1", "A: -1,-1,1 3,-1,1 -1,3,1; B: 0,0,2 1,0,2 0,1,2",
                               "A: 0,0,1 1,0,1 0,1,1; B: 1,0,0 1,1,0 0.5,1,0; C: 0,0,0 1,0,3 1,1,3",
                               "A: 0,0,0 1,0,1 0,1,0; B: 1,0,0 1,1,0 0.75,1,2"}) {
      tell("area_sampling", {{"method", method}, {"triangles", layers}});
    }
  }
  for (const char* thin : {"0.1,0.2 6,0.3 0.1,0.6", "0.3,0.3 0.7,0.3 0.5,0.7"})
    tell("area_sampling", {{"method", "moving"}, {"thin", thin}});
  const auto z_buffer = [&](std::string method, std::string faces, std::string order, std::string depth,
                            std::string far) {
    tell("z_buffer",
         {{"method", method}, {"faces", faces}, {"order", order}, {"depth", depth}, {"far", far}});
  };
  const std::string level = "A: 0,0,3 5,0,3 5,6,3 0,6,3; B: 3,2,3 8,2,3 8,8,3 3,8,3; C: 0,0,1 4,0,2 9,0,3.25",
                    close =
                        "A: 0,0,500 8,0,500.4 8,8,500.64 0,8,500.24; B: 0,0,499.98 8,0,500.38 8,8,500.62 "
                        "0,8,500.22",
                    pixel = "A: 0,0,5 1,0,5 1,1,5 0,1,5";
  for (const char* method : {"per_polygon", "scanline"}) {
    for (const char* order : {"1,2,3", "2,1,3"}) z_buffer(method, level, order, "exact", "10");
    for (const char* depth : {"float", "fixed24", "reversed_float"}) {
      z_buffer(method, close, "1,2", depth, "1000000");
      z_buffer(method, pixel, "given", depth, "10");
    }
    z_buffer(method, pixel, "given", "exact", "10");
  }
  z_buffer("first_come", level, "2,1,3", "exact", "10");
  const std::string behind =
      "A: 0,0,500 1,0,500 1,1,500 0,1,500; B: 0,0,499.999 1,0,499.999 1,1,499.999 0,1,499.999";
  z_buffer("per_polygon", behind, "given", "fixed24", "1000000");
  z_buffer("first_come", pixel + "; B: 0,0,5 1,0,5 1,1,5 0,1,5", "2,1", "exact", "10");
  z_buffer("integer_colours", pixel, "given", "exact", "10");
  tell("z_buffer", {{"eye", "3,3,-6"}, {"faces", "A: 0,0,1 6,0,1 6,6,1 0,6,1"}});
  tell("z_buffer", {{"eye", "3,3,-6"},
                    {"faces", "B: -1,0,3 7,0,3 7,6,3 -1,6,3; C: 0,0,0 5.667,0.333,10 5.667,5.667,10 0,6,0"},
                    {"columns", "6"},
                    {"rows", "6"}});
  tell("flood_fill", {{"method", "breadth_first"}, {"window", "1,1,4,4"}});
  for (const char* method : {"depth_first", "breadth_first", "span"}) {
    tell("flood_fill", {{"method", method}, {"connectivity", "8"}});
    tell("flood_fill", {{"method", method}, {"maze", "aab/#.b/.##"}, {"at", "2,1"}});
    tell("flood_fill", {{"method", method}, {"at", "0,0"}});
    if (brief && std::string_view(method) != "span") continue;
    tell("flood_fill",
         {{"method", method},
          {"image", std::string(GRADUS_SOURCE_DIR) + "/examples/images/camera.png"},
          {"at", "300,60"},
          {"tolerance", "20"}},
         300);
  }
  for (const char* receding : {"45,1", "30,0.7", "150,0.5"}) tell("parallel", {{"receding", receding}});
  for (const char* from : {"top", "side"}) tell("parallel", {{"method", "orthographic"}, {"from", from}});
  tell("parallel", {{"method", "along"}, {"plane", "0,1,0,-2"}, {"direction", "1,-2,1"}, {"solid", "box"}});
  tell("parallel", {{"direction", "-1,-1,2"}, {"turn", "30,20"}});
  tell("perspective", {{"solid", "box"}, {"turn", "0,0"}});
  tell("perspective", {{"at", "0,-1,1.2"}});
  tell("perspective", {{"turn", "-60,30"}, {"distance", "8"}});
  for (const char* turn : {"0,0", "35,25", "80,0"}) {
    tell("perspective", {{"method", "vanishing_points"}, {"turn", turn}});
  }
  for (const char* method : {"transformation", "keep_z"}) {
    tell("perspective", {{"method", method}, {"samples", "15"}});
  }
  tell("perspective", {{"method", "keep_z"}, {"from", "-1,0,5"}, {"to", "2,0,5"}});
  tell("perspective", {{"method", "depth_precision"}, {"range", "0.1,250"}});
  for (const char* method : {"divide_tested", "divide_untested"}) {
    tell("perspective", {{"method", method}, {"points", "1,0,2 1,0,-2 0,1,0"}, {"zoom", "0"}});
  }
  tell("perspective", {{"method", "zoom_minus_z"},
                       {"points", "600,300,-1000 600,300,0 600,300,999 600,300,1001 600,300,2000"},
                       {"centre", "400,300"},
                       {"scales", "500,500"},
                       {"zoom", "1000"}});
  for (const char* method : {"vanishing_points", "parallel_by_plane"}) {
    tell("perspective", {{"method", method}, {"turn", "-45,0"}, {"direction", "1,0,1"}, {"at", "0.4,-2,6"}});
  }
  const auto part = [&](std::string method, std::string faces, std::string towards = "1,2,3") {
    tell("bsp_tree", {{"method", method}, {"faces", faces}, {"towards", towards}});
  };
  const std::string floors =
      "A: 0,0,0 4,0,0 4,3,0; B: 4,0,0 8,0,0 8,3,0; C: 0,0,2 4,0,2 4,3,2; D: 0,0,-2 4,0,-2 4,3,-2";
  const std::string bars =
      "A: -6.2,-3.6,-1.2 6.2,-3.6,1.2 6.2,-1.6,1.2 -6.2,-1.6,-1.2; "
      "B: 6.2,-3.6,-1.2 0,7.1,1.2 -1.7,6.1,1.2 4.5,-4.6,-1.2; "
      "C: 0,7.2,-1.2 -6.2,-3.5,1.2 -4.5,-4.5,1.2 1.7,6.2,-1.2";
  for (const char* method : {"build", "back_to_front", "uncut"}) part(method, "A: 0,0,0 4,0,0 4,3,0");
  part("build", floors);
  part("back_to_front", floors, "0,0,-1");
  part("back_to_front", floors, "1,0,0");
  part("uncut", "A: 0,0,0 4,0,0 4,3,0; B: 1,1,2 3,1,-2 3,2,-2 1,2,2");
  const auto paint = [&](std::string method, std::string faces, std::string towards = "1,2,3") {
    tell("painter", {{"method", method}, {"faces", faces}, {"towards", towards}});
  };
  for (const char* method : {"newell", "farthest_vertex", "centroid", "mean_depth", "descending_mean_z"}) {
    paint(method, "A: 0,0,0 4,0,0 4,3,0");
    paint(method, floors, "0,0,1");
  }
  paint("newell", "A: 0,0,0 4,0,0 4,3,0 0,3,0; B: 1,1,-2 3,1,-2 3,1,2 1,1,2");
  paint("newell", bars, "0.2,-0.4,1");
  // Moved once already, another of the cycle, and one moved that ends before
  paint("newell", "A: -1,-5,-3 5,4,2 1,-5,-1; B: -1,2,-3 1,2,0 2,1,3; C: -2,1,3 1,5,3 0,-5,-3", "0,0,1");
  paint("newell", "A: -5,-5,2 2,5,-3 -4,-3,-3; B: -2,1,-2 3,-3,3 0,4,-3; C: -1,2,-1 3,1,-3 -5,4,-1", "0,0,1");
  paint("newell", "A: 5,1,1 -1,-5,-2 5,4,3; B: -2,-1,2 2,3,-3 1,-5,2; C: -2,-3,-2 3,-1,-2 0,4,-2", "0,0,1");
  paint("newell", "A: -5,0,-4 5,0,4 5,2,4 -5,2,-4; B: -5,4,-1 5,4,-1 5,6,-1 -5,6,-1", "0,0,1");
  tell("painter", {{"faces", "A: 0,-10,10 50,-10,10 50,10,10 0,10,10; B: 0,-5,20 8,-5,20 8,5,20 0,5,20"},
                   {"eye", "0,0,0"}});
  const auto cull = [&](std::string method, std::map<std::string, std::string> more) {
    more["method"] = method;
    tell("back_face_culling", more);
  };
  const std::string triangle = "A: 4,0,-2 4,1,-2 5,0,-3", other = "A: -4,0,-2 -4,1,-2 -5,0,-3";
  const std::string through_the_eye = "A: 0,0,2 -1,0,2 0,1,-2; B: 0,0,2 0,1,-2 -1,0,2",
                    sheet = "A: 0,0,0 4,0,0 4,3,0";
  for (const auto& [eye, target] : {std::pair("0,0,0", "0,0,1"), std::pair("0,0,9", "0,0,0")}) {
    for (const char* method : {"homogeneous", "after_division", "normal_and_view"})
      cull(method, {{"faces", through_the_eye}, {"eye", eye}, {"target", target}});
  }
  for (const std::string& faces : {triangle, other, triangle + "; B: 4,0,-2 5,0,-3 4,1,-2"}) {
    for (const char* method : {"eye_space_normal", "homogeneous", "screen_area", "normal_and_view"})
      cull(method, {{"faces", faces}, {"eye", "0,0,0"}, {"target", "0,0,-1"}});
  }
  for (const char* method :
       {"normal_and_view", "screen_area", "homogeneous", "eye_space_normal", "after_division", "six_products",
        "misprinted_shoelace", "first_three_corners"}) {
    cull(method, {{"faces", sheet}, {"towards", "1,0,0"}});
    cull(method, {{"faces", sheet}, {"towards", "0,0,1"}});
    cull(method, {});
  }
  cull("first_three_corners", {{"faces", "A: 0,0,0 1,0,0 2,0,0 2,2,0"}, {"towards", "0,0,1"}});
  cull("first_three_corners", {{"faces", "A: 2,1,0 1,1,0 1,2,0 0,2,0 0,0,0 2,0,0"}, {"towards", "0,0,1"}});
  cull("normal_and_view", {{"faces", "A: -3,2,3 3,-2,0 3,3,3 1,-3,3"}, {"eye", "0,0,6"}});
  cull("normal_and_view", {{"faces", "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 3,1,-1 3,2,-1"}, {"towards", "0,0,1"}});
  cull("screen_area",
       {{"faces", "A: 100000000,100000000,0 100000001,100000000.1,0 100000000.5,100000000.875,0"},
        {"towards", "0,0,1"}});
  cull("screen_area",
       {{"faces", "A: 0.5000000000000001,0.5000000000000002,0 12,12,0 24,24,9"}, {"towards", "0,0,1"}});
  const auto clip = [&](std::string polygon, std::map<std::string, std::string> more = {}) {
    more["polygon"] = polygon;
    tell("sutherland_hodgman", more);
  };
  clip("5,-5 15,5 5,15 -5,5");
  clip("11,1 19,1 15,9");
  clip("-10,-10 30,-10 10,40", {{"method", "containing_left_whole"}});
  clip("-5,2 5,2 5,8", {{"method", "previous_left_behind"}});
  clip("2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4", {{"order", "bottom,top,right,left"}});
  clip("2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4",
       {{"method", "separate_pieces"}, {"hole", "7,1 7.5,1 7.5,3 7,3"}});
  clip("-4,3 3,-4 6,-3 13,5 7,8 6,-1 4,-1 4,7",
       {{"method", "separate_pieces"}, {"window_polygon", "5,-3 12,3 8,10 -2,7"}});
  clip("-4,3 3,-4 6,-3 13,5 7,8 6,-1 4,-1 4,7", {{"window_polygon", "5,-3 12,3 8,10 -2,7"}});
  clip("-4,3 3,-4 6,-3 13,5 7,8 6,-1 4,-1 4,7",
       {{"window_polygon", "5,-3 12,3 8,10 -2,7"}, {"order", "3,1,4,2"}});
  clip("-5,1 15,1 15,9 -5,9", {{"method", "separate_pieces"}, {"hole", "2,2 4,2 3,4; 6,5 12,5 12,7 6,7"}});
  for (const char* corners :
       {"0.5,0.5,0.5,1 -0.5,0.5,0.5,1 0,-0.5,0.5,1", "4,0,2,3 9,1,2,3 8,5,2,3",
        "-3,-1,0.5,2 5,-2,3,4 1,6,2.5,3 -1,1,0,0", "1,1,-2,-1 -1,2,-3,-2 0,-1,-1,-0.5"}) {
    tell("sutherland_hodgman", {{"method", "homogeneous"}, {"homogeneous", corners}});
  }
  for (const char* axes : {"1,0,0 0,2,0 0.5,0,-1", "0,0,-1 0,1,0 1,0,0"}) {
    tell("viewing", {{"method", "inverse_of_any_frame"}, {"eye", "2,1,3"}, {"axes", axes}});
  }
  for (const char* method : {"spare_up", "cross_products"}) {
    tell("viewing", {{"method", method}, {"eye", "0.4,5,0"}, {"target", "0.4,0.6,0"}, {"up", "1e-17,1,0"}});
  }
  return traces;
}

}  // namespace gradus::test
