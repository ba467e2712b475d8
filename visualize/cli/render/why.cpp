// `gradus render SCENE --why C,R`: the story of a pixel, printed or drawn.

#include "cli/render/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/render/plan_flags.hpp"
#include "cli/terminal/progress.hpp"
#include "core/shown.hpp"
#include "figure/tone_of.hpp"
#include "pipeline.hpp"
#include "plan/planned.hpp"
#include "request/names.hpp"
#include "theme/theme.hpp"
#include "why/why_text.hpp"

namespace gradus::cli {
namespace {

using pipeline::FragmentStory;
using pipeline::PixelStory;
using pipeline::Scene;
using pipeline::told_colour;

// --- What covers it --------------------------------------------------------------------------------

/// "Spot, face 143"
std::string face_name(const Scene& scene, const FragmentStory& story) {
  const pipeline::PieceId id = story.tested.fragment.id;
  return fmt::format("{}, face {}", visible(object_at(scene, id.object).name), id.face + 1);
}

std::vector<plot::Cover> covers_of(const Scene& scene, const PixelStory& story) {
  std::vector<plot::Cover> covers;
  for (const FragmentStory& fragment : story.fragments) {
    const auto corner = [&](std::size_t i) { return in_pixels(fragment.snapped.corners[i]); };
    const double depth = fragment.tested.fragment.depth;
    covers.push_back({face_name(scene, fragment),
                      {corner(0), corner(1), corner(2)},
                      depth,
                      pipeline::told_number(depth),
                      fragment.share > 0});
  }
  return covers;
}

// --- Its light -------------------------------------------------------------------------------------

/// From the least to the most of what places have.
class Spread {
 public:
  explicit Spread(std::string name) : factor_{std::move(name), 0, 0} {}

  void add(double value) {
    factor_.least = known_ ? std::min(factor_.least, value) : value;
    factor_.most = known_ ? std::max(factor_.most, value) : value;
    known_ = true;
  }
  const plot::Factor& factor() const { return factor_; }

 private:
  plot::Factor factor_;
  bool known_ = false;
};

/// What a light adds: the lamps of an area together, and of Gouraud's corners as much as the pixel has of
/// each.
plot::LightSource source_of(const Scene& scene, const pipeline::Layer& layer, std::size_t light) {
  const pipeline::Shaded& lit = layer.shaded;
  const dvec3 texel = lit.texel ? dvec3(*lit.texel) : dvec3(1);
  const bool corners = scene.shading == pipeline::Shading::gouraud;
  const std::size_t a_place = layer.lamps.size() / (corners ? 3 : 1);
  Spread n_dot_l("N·L"), r_dot_v("R·V"), arrives("arrives");
  dvec3 diffuse{0}, specular{0};
  for (std::size_t place = 0; a_place > 0 && place < layer.lamps.size() / a_place; ++place) {
    const double share = corners ? lit.fragment.weights[static_cast<int>(place)] : 1;
    double arriving = 0;
    for (std::size_t i = place * a_place; i < (place + 1) * a_place; ++i) {
      const auto& added = layer.lamps[i].added;
      if (added.light != light) continue;
      n_dot_l.add(added.n_dot_l), r_dot_v.add(added.cosine);
      arriving += added.arrival.share();
      diffuse += share * texel * added.diffuse, specular += share * added.specular;
    }
    arrives.add(arriving);
  }
  return {pipeline::light_name(scene, light),
          {{"diffuse", LinearRgb(diffuse), n_dot_l.factor()},
           {"highlight", LinearRgb(specular), r_dot_v.factor()}},
          arrives.factor()};
}

/// Several surfaces that are seen through one another, each with its share.
std::vector<plot::LightSource> mixed_sources(const Scene& scene, const PixelStory& story) {
  std::vector<plot::LightSource> sources;
  const auto add = [&](const std::string& name, double share, const LinearRgb& light) {
    sources.push_back(
        {name, {{"light", LinearRgb(share * dvec3(light)), plot::Factor{"share", share, share}}}});
  };
  for (const pipeline::Layer& layer : story.layers)
    add(face_name(scene, fragment_of(story, layer)), layer.share, layer.shaded.colour);
  if (story.background > 0) add("background", story.background, scene.background);
  return sources;
}

std::vector<plot::LightSource> sources_of(const Scene& scene, const PixelStory& story) {
  if (is_mixed(story)) return mixed_sources(scene, story);
  if (story.layers.empty()) return {{"", {{"background", story.written.light}}}};
  if (scene.shading == pipeline::Shading::wireframe) return {{"", {{"ink", story.written.light}}}};
  const pipeline::Layer& layer = story.layers.front();
  std::vector<plot::LightSource> sources{{"", {{"ambient", LinearRgb(layer.shaded.ambient)}}}};
  for (std::size_t light = 0; light < scene.lights.size(); ++light)
    sources.push_back(source_of(scene, layer, light));
  return sources;
}

std::string light_title(const Scene& scene, const PixelStory& story) {
  if (story.layers.empty()) return "light";
  if (is_mixed(story)) return "light of what is seen through one another, from the eye on";
  std::string text = fmt::format("light, {}", pipeline::lit_where(scene.shading));
  if (const auto& texel = story.layers.front().shaded.texel)
    text += fmt::format("; the texture there, {}, times ambient and diffuse",
                        told_colour(tone_of(dvec3(*texel))));
  return text;
}

// --- In words --------------------------------------------------------------------------------------

/// Three digits; what no eye sees is 0.
std::string short_text(double value) { return fmt::format("{:.3g}", std::abs(value) < 5e-4 ? 0.0 : value); }
std::string short_text(dvec3 v) {
  return fmt::format("({}, {}, {})", short_text(v.x), short_text(v.y), short_text(v.z));
}

/// "0.4 of the nearest surface + 0.24 of what is behind it + 0.36 of the background = …"
std::string mixed_sentence(const PixelStory& story) {
  const double nearest = story.layers.front().share, behind = 1 - nearest - story.background;
  std::string text = fmt::format("{} of the nearest surface", short_text(nearest));
  if (story.layers.size() > 1) text += fmt::format(" + {} of what is behind it", short_text(behind));
  if (story.background > 0) text += fmt::format(" + {} of the background", short_text(story.background));
  return text + fmt::format(" = {}, which is {} in sRGB.", short_text(dvec3(story.written.light)),
                            told_colour(story.written.colour));
}

std::string sentence_of(const Scene& scene, const PixelStory& story) {
  const std::string colour = told_colour(story.written.colour);
  if (story.layers.empty())
    return fmt::format("No triangle covers its centre, so it shows the background, {}.", colour);
  if (scene.shading == pipeline::Shading::wireframe)
    return fmt::format("An edge covers its centre, and edges have the colour of ink, {}.", colour);
  if (is_mixed(story)) return mixed_sentence(story);
  const pipeline::Shaded& lit = story.layers.front().shaded;
  return fmt::format("Ambient {} + diffuse {} + highlight {} = {}, which is {} in sRGB.",
                     short_text(lit.ambient), short_text(lit.diffuse), short_text(lit.specular),
                     short_text(dvec3(lit.colour)), colour);
}

std::vector<std::string> colour_notes(const PixelStory& story) {
  std::vector<std::string> notes;
  if (story.written.cut_off) notes.emplace_back("cut off at white");
  if (story.picture != story.written.colour)
    notes.push_back(fmt::format("all samples {}", told_colour(story.picture)));
  return notes;
}

std::string covered_text(const Scene& scene, const PixelStory& story) {
  const std::size_t count = story.fragments.size(), seen = story.layers.size();
  if (count == 0) return "no triangle covers its centre";
  const std::string name = pipeline::triangle_name(scene, fragment_of(story, story.layers.front()));
  if (count == 1) return name + " alone covers its centre";
  if (seen > 1)
    return fmt::format("{} of {} triangles over its centre are seen: {} lets light through", seen, count,
                       name);
  return fmt::format("seen of {} triangles over its centre: {}", count, name);
}

}  // namespace

plot::PixelFigure pixel_figure(const std::string& name, const Scene& scene, const PixelStory& story,
                               Image picture) {
  plot::PixelFigure figure;
  figure.title = fmt::format("{}: why pixel {},{} is {}", visible(name), story.pixel.x, story.pixel.y,
                             told_colour(story.picture));
  figure.subtitle = covered_text(scene, story);
  figure.sentence = sentence_of(scene, story);
  figure.picture = std::move(picture);
  figure.pixel = story.pixel;
  figure.covers = covers_of(scene, story);
  figure.depth_name =
      fmt::format("{}: the least is {}", pipeline::depth_name(scene), is_mixed(story) ? "nearest" : "seen");
  figure.empty = "no triangle: the background";
  figure.light_name = light_title(scene, story);
  figure.sources = sources_of(scene, story);
  figure.colour = story.written.colour;
  figure.colour_text = told_colour(story.written.colour);
  figure.colour_notes = colour_notes(story);
  return figure;
}

void check_why_output(const std::string& output) {
  const std::string ending = folded(std::filesystem::path(output).extension().string());
  if (ending != ".svg" && ending != ".png" && ending != ".pdf")
    throw UsageError(
        fmt::format("-o: expected a name that ends in .svg, .png or .pdf, found {}", shown(output)));
}

namespace {

/// Where --why asks for: of the whole picture.
ivec2 place_of(const Request& request, const RenderJob& job) {
  return pixel_flag("why", request.flags.at("why"), job.size);
}

void refuse_beside_why(const Request& request) {
  for (const auto& [flag, spelled] : {std::pair{"report", "--report"}, {"part", "--part"}}) {
    if (request.has(flag))
      throw UsageError(
          fmt::format("--why: expected alone, without {0}: it tells of one pixel, found {0}", spelled));
  }
}

void note_remarks(const Request& request, const RenderJob& job) {
  if (request.quiet()) return;
  for (const std::string& remark : job.brief.remarks) note(remark);
}

/// As the name's ending says.
std::string bytes_of(const Sheet& sheet, const Colophon& colophon, const std::string& output) {
  Finish finish = themes().front();
  const std::string ending = folded(std::filesystem::path(output).extension().string());
  if (ending == ".svg") return svg_of(sheet, finish, colophon);
  if (ending == ".pdf") return pdf_of(1, [&](std::size_t) { return sheet; }, finish, colophon);
  finish.scale = 2;
  return png_of(sheet, finish, colophon);
}

}  // namespace

void print_why(const Request& request) {
  refuse_beside_why(request);
  const RenderJob job = render_job(request);
  const ivec2 place = place_of(request, job);
  note_remarks(request, job);
  write_stream(Stream::out,
               why_text(scene_name(job.brief), job.scene, job.size, why(job.scene, job.size, place)));
}

void draw_why(const Request& request, const Output& output, const FindFile& find,
              const std::function<void(const RenderBrief&)>& on_read) {
  refuse_beside_why(request);
  const RenderJob job = render_job(request, find);
  on_read(job.brief);
  const ivec2 place = place_of(request, job);
  note_remarks(request, job);
  pipeline::Plan plan = plan_of(job.scene, job.size, job.plan.rules);
  pipeline::Ledger ledger;
  Image picture = pipeline::output(over_background(
      antialiased_by_plan(job.scene, plan, ledger, {}, Working::reached), job.scene.background));
  Working::reached(0);
  const plot::PixelFigure figure =
      pixel_figure(scene_name(job.brief), job.scene, why(job.scene, job.size, place), std::move(picture));
  const Colophon colophon{figure.title, figure.subtitle + ". " + figure.sentence,
                          fmt::format("{} --why {},{}", job.brief.colophon.command, place.x, place.y),
                          job.brief.colophon.input_hash};
  write_output(output.path, bytes_of(sheet_of(figure), colophon, output.path), output.replace);
  if (!output.quiet) note(shown_name(output.path));
}

}  // namespace gradus::cli
