#include "why/why_text.hpp"

#include <fmt/format.h>

#include <array>

#include "core/colour.hpp"
#include "core/shown.hpp"

namespace gradus::pipeline {
namespace {

// --- Values ----------------------------------------------------------------------------------------

std::string text_of(double value) { return told_number(value); }
std::string text_of(dvec2 v) { return fmt::format("({}, {})", text_of(v.x), text_of(v.y)); }
std::string text_of(dvec3 v) { return fmt::format("({}, {}, {})", text_of(v.x), text_of(v.y), text_of(v.z)); }
std::string text_of(const glm::dvec4& v) {
  return fmt::format("({}, {}, {}, {})", text_of(v.x), text_of(v.y), text_of(v.z), text_of(v.w));
}

/// The name of a file without its folders.
std::string base_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// --- A triangle ------------------------------------------------------------------------------------

std::string facing_text(const FragmentStory& story) {
  if (story.faced.facing == back_face_culling::Facing::front) return "front: det[x y w] > 0";
  return story.faced.two_sided ? "back, and its object shows both sides" : "back";
}

std::string clipping_text(const Clipped& clipped) {
  if (!clipped.changed) return "nothing is cut";
  return fmt::format("cut: {} corners become {}", clipped.before.size(), clipped.after.size());
}

/// Whether what comes last in an order is seen, and not what has the least depth.
bool by_order(const Scene& scene) { return scene.hidden_surfaces != HiddenSurfaces::z_buffer; }

/// Whether that need not be the nearest.
bool by_sort(const Scene& scene) { return scene.hidden_surfaces == HiddenSurfaces::farthest_vertex; }

/// What became of a fragment whose pixel held another.
std::string_view outcome_of(const Scene& scene, const DepthTested& tested) {
  if (by_order(scene)) return tested.nearer ? "drawn later, takes its place" : "drawn earlier, painted over";
  if (tested.fragment.depth == tested.before->depth)
    return tested.nearer ? "as deep and of a lower face, takes its place"
                         : "as deep and of a higher face, thrown away";
  return tested.nearer ? "nearer, takes its place" : "not nearer, thrown away";
}

std::string depth_text(const Scene& scene, const FragmentStory& story) {
  const bool keeps_all = draws_opacity(scene);
  const DepthTested& tested = story.tested;
  const std::string depth = text_of(tested.fragment.depth);
  if (keeps_all) {
    if (story.share == 0) return depth + ": hidden at the centre by what lets nothing through";
    return depth + ": seen" + (story.share < 1 ? ", with a share of " + text_of(story.share) : "");
  }
  if (!tested.before) return fmt::format("{}, the first: kept", depth);
  return fmt::format("{}, before it {}: {}", depth, text_of(tested.before->depth), outcome_of(scene, tested));
}

std::string line_of(std::string_view stage, std::string_view what) {
  return fmt::format("  {:<17}{}\n", stage, what);
}

/// What is the same wherever the triangle is seen: stages 1 to 6.
std::string triangle_text(const Scene& scene, const FragmentStory& story) {
  std::string text = triangle_name(scene, story) + "\n";
  const auto line = [&text](std::string_view stage, std::string_view what) { text += line_of(stage, what); };
  const auto corners = [&](std::string_view stage, const auto& of) {
    for (std::size_t i = 0; i < 3; ++i) line(i == 0 ? stage : "", of(i));
  };
  corners("1 model", [&](std::size_t i) { return text_of(story.corners[i].placed.from.at); });
  corners("2 world", [&](std::size_t i) { return text_of(story.corners[i].placed.to.at); });
  if (story.mirrored) line("", "mirrored: two corners change places");
  corners("3 perspective",
          [&](std::size_t i) { return text_of(story.corners[i].projected.clip.at) + " before w divides"; });
  line("4 facing", facing_text(story));
  line("5 clipping", clipping_text(story.clipped));
  corners("6 rasterization", [&](std::size_t i) {
    return text_of(in_pixels(story.snapped.corners[i])) + ", snapped to 1/256 pixel";
  });
  return text;
}

/// Stages 6 and 7 at the pixel.
std::string fragment_text(const Scene& scene, const FragmentStory& story) {
  return line_of("", fmt::format("shares of the corners {}", text_of(story.tested.fragment.weights))) +
         line_of(fmt::format("7 {}", depth_name(scene)), depth_text(scene, story));
}

// --- The light -------------------------------------------------------------------------------------

std::string_view kind_of(const Light& light) {
  constexpr std::array<std::string_view, 4> names{"point", "directional", "spot", "area"};
  return names[static_cast<std::size_t>(light.kind)];
}

std::string named(std::size_t number, const Light& light, std::string_view point) {
  return fmt::format("light {} ({}{})", number + 1, kind_of(light), point);
}

std::string lamp_text(const Scene& scene, const LampStory& lamp) {
  const auto& [number, sample, arrival, mirror, n_dot_l, cosine, diffuse, specular] = lamp.added;
  const Light& light = scene.lights[number];
  const std::string point = light.kind == Light::Kind::area ? fmt::format(", point {}", sample + 1) : "";
  std::string text =
      fmt::format("{}: N.L {}, R.V {}, ", named(number, light, point), text_of(n_dot_l), text_of(cosine));
  text += fmt::format("arrives {} (distance {}, attenuation {}, range {}, cone {})", text_of(arrival.share()),
                      text_of(arrival.distance), text_of(arrival.attenuation), text_of(arrival.window),
                      text_of(arrival.cone));
  if (n_dot_l <= 0) return text + ": behind the surface, adds nothing";
  return text + fmt::format(": diffuse {}, highlight {}", text_of(diffuse), text_of(specular));
}

/// The light of one of the surfaces seen. whose: says which, where they are several.
std::string light_of(const Scene& scene, const Layer& layer, const std::string& whose) {
  const Shaded& lit = layer.shaded;
  std::string text = fmt::format("light{}, {}\n", whose, lit_where(scene.shading));
  const auto line = [&text](const std::string& what) { text += fmt::format("  {}\n", what); };
  line(fmt::format("place {}, normal {}", text_of(lit.place.at), text_of(lit.normal)));
  const Mesh& mesh = *object_at(scene, lit.fragment.id.object).mesh;
  const Material& m = mesh.materials[static_cast<std::size_t>(lit.material)];
  const std::string opacity = draws_opacity(scene) ? ", opacity " + text_of(layer.opacity) : "";
  line(fmt::format("material {}: k_a {}, k_d {}, k_s {}, n {}{}", visible(m.name), text_of(dvec3(m.ambient)),
                   text_of(dvec3(m.diffuse)), text_of(dvec3(m.specular)), text_of(m.shininess), opacity));
  if (lit.texel)
    line(fmt::format("texture at {}: {}, times ambient and diffuse", text_of(lit.texture),
                     text_of(dvec3(*lit.texel))));
  for (const LampStory& lamp : layer.lamps) line(lamp_text(scene, lamp));
  line(fmt::format("ambient {} + diffuse {} + highlight {} = {}", text_of(lit.ambient), text_of(lit.diffuse),
                   text_of(lit.specular), text_of(dvec3(lit.colour))));
  return text;
}

/// What is seen through one another, each with its share.
std::string mixed_text(const Scene& scene, const PixelStory& story) {
  std::string text = "seen through one another, from the eye on\n";
  const auto line = [&text](double share, const std::string& what) {
    text += fmt::format("  {} of {}\n", text_of(share), what);
  };
  for (const Layer& layer : story.layers) line(layer.share, text_of(dvec3(layer.shaded.colour)));
  if (story.background > 0)
    line(story.background, fmt::format("the background, {}", text_of(dvec3(scene.background))));
  return text;
}

/// Of all that is seen.
std::string light_of(const Scene& scene, const PixelStory& story) {
  std::string text;
  for (const Layer& layer : story.layers) {
    const std::string whose = is_mixed(story) ? " of " + triangle_name(scene, fragment_of(story, layer)) : "";
    text += light_of(scene, layer, whose);
  }
  return is_mixed(story) ? text + mixed_text(scene, story) : text;
}

std::string covered_text(const Scene& scene, const PixelStory& story) {
  const std::size_t count = story.fragments.size(), seen = story.layers.size();
  if (count == 0) return "No triangle covers its centre: it shows the background.";
  if (count == 1) return "One triangle covers its centre.";
  if (seen == 1)
    return fmt::format("{} triangles cover its centre; {} is seen.", count,
                       by_sort(scene) ? "the one drawn last" : "the nearest");
  return fmt::format(
      "{} triangles cover its centre; {} are seen, for light goes through.", count,
      seen == count ? "all" : fmt::format("the {} {}", seen, by_sort(scene) ? "drawn last" : "nearest"));
}

std::string colour_text(const PixelStory& story, Antialiasing method) {
  const std::string centre =
      fmt::format("8 output: light {} is {} in sRGB{}", text_of(dvec3(story.written.light)),
                  told_colour(story.written.colour), story.written.cut_off ? ", cut off at full white" : "");
  if (method == Antialiasing::none) return centre + "\n";
  return fmt::format("{}; with the pixel's other samples ({}) the picture has {}\n", centre, name_of(method),
                     told_colour(story.picture));
}

}  // namespace

std::string told_number(double value) { return fmt::format("{:.6g}", value == 0 ? 0.0 : value); }

std::string told_colour(const Rgba8& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

std::string triangle_name(const Scene& scene, const FragmentStory& story) {
  const PieceId id = story.tested.fragment.id;
  const std::string file = visible(base_of(file_of(scene, story.face)));
  // Imported faces know no line
  const std::string line = story.face.line == 0 ? "" : fmt::format(":{}", story.face.line);
  const std::string from = file.empty() ? "" : fmt::format(" ({}{})", file, line);
  return fmt::format("{}, face {}{}, triangle {} of {}", visible(object_at(scene, id.object).name),
                     id.face + 1, from, id.piece + 1, story.face.pieces.size());
}

std::string_view depth_name(const Scene& scene) { return by_order(scene) ? "drawing order" : "depth"; }

std::string lit_where(Shading shading) {
  if (shading == Shading::wireframe) return "none: an edge has the colour of ink";
  if (shading == Shading::flat) return "flat: in the middle of the face";
  if (shading == Shading::gouraud) return "Gouraud: at the three corners, mixed by their shares";
  return "Phong: at the pixel";
}

std::string light_name(const Scene& scene, std::size_t number) {
  return named(number, scene.lights[number], "");
}

std::vector<StoryPart> why_parts(const std::string& name, const Scene& scene, Size size,
                                 const PixelStory& story, TriangleTexts& known) {
  std::vector<StoryPart> parts;
  parts.push_back({fmt::format("Pixel {},{} of {}, {} x {}. {}\n\n", story.pixel.x, story.pixel.y,
                               visible(name), size.width, size.height, covered_text(scene, story))});
  for (const FragmentStory& fragment : story.fragments) {
    const auto [text, is_new] = known.try_emplace(fragment.tested.fragment.triangle);
    if (is_new) text->second = triangle_text(scene, fragment);
    parts.push_back({text->second, true});
    parts.push_back({fragment_text(scene, fragment) + "\n"});
  }
  const std::string light = light_of(scene, story);
  parts.push_back({(light.empty() ? "" : light + "\n") + colour_text(story, scene.antialiasing)});
  return parts;
}

std::string why_text(const std::string& name, const Scene& scene, Size size, const PixelStory& story) {
  std::string text;
  TriangleTexts known;
  for (const StoryPart& part : why_parts(name, scene, size, story, known)) text += part.text;
  return text;
}

}  // namespace gradus::pipeline
