#pragma once
// Points alone, nearer and nearer: each is one dot, and between dots there is nothing.

#include <array>

#include "stories/modeling/point_cloud/subject.hpp"
#include "stories/past.hpp"

namespace gradus::point_cloud {

/// A picture of the cloud: which pixels its points cover, and which its surface would.
struct ZoomPicture {
  int zoom;
  Screen screen;
  Raster<Index> front{};
  std::vector<bool> surface{};
  std::int64_t whole = 0, bare = 0;  ///< pixels of the surface, and those of them without a point

  bool is_surface(ivec2 pixel) const {
    return surface[static_cast<std::size_t>(pixel.y * screen.pixels + pixel.x)];
  }
};

/// What drawing one has told in the end, and where.
struct Report {
  Finished step;
  int line;
  const char* file;
};

/// "3 × 3".
inline std::string dots_of(int radius) { return fmt::format("{} × {}", 2 * radius + 1, 2 * radius + 1); }

inline ZoomPicture zoom_picture_of(const Subject& subject, const Extent& cloud, int zoom) {
  constexpr int pixels = 60;
  const double side = 1.04 * longer_side(cloud) / zoom;
  // Nearer round the point that is told
  const dvec2 towards = subject.reader.flat(subject.own());
  const dvec2 middle = zoom == 1 ? cloud.centre() : towards;
  ZoomPicture made{zoom, {middle - 0.5 * side, side, pixels}};
  const auto picture = rendered_surface(subject.corners, subject.faces,
                                        {.right = subject.reader.right,
                                         .up = subject.reader.up,
                                         .towards = subject.reader.towards,
                                         .shown = {made.screen.lower, made.screen.lower + side},
                                         .width = pixels});
  for (const Rgba8& pixel : picture->cells()) made.surface.push_back(pixel.a >= 128);
  return made;
}

class ZoomStory : public Past<steps::Started, Finished> {
 public:
  ZoomStory(const Words& words, const Subject& subject, int zooms, int radius)
      : words_(words), subject_(subject), radius_(radius) {
    for (const dvec3 p : subject.points) cloud_.add(subject.reader.flat(p));
    for (int i = 0; i < zooms; ++i) pictures_.push_back(zoom_picture_of(subject, cloud_, 1 << i));
    const Cloud<double> all{subject.points, std::vector<Rgba8>(1), subject.points};
    attributes_ = attributes(all);
    for (std::size_t i = 0; i < subject.points.size(); ++i)
      normals_.push_back(normal(subject.tree, static_cast<Index>(i), subject.k, subject.eye).way);
  }

  std::vector<ZoomPicture>& pictures() { return pictures_; }
  /// Once its points are drawn.
  static void count(ZoomPicture& picture) {
    for (int y = 0; y < picture.screen.pixels; ++y) {
      for (int x = 0; x < picture.screen.pixels; ++x) {
        if (!picture.is_surface({x, y})) continue;
        ++picture.whole;
        if (picture.front[{x, y}] == none) ++picture.bare;
      }
    }
  }

  /// The first picture with gaps.
  double tells(const Finished&) const {
    const auto has_gaps = [](const ZoomPicture& picture) { return picture.bare > 0; };
    return std::ranges::count_if(std::span(pictures_).first(at_hand() + 1), has_gaps) == 1 ? 2 : 1;
  }
  Event say(const steps::Started&) const {
    return {.text = "zoom.started",
            .words = {{"bytes", bytes_each()}, {"dots", dots_of(radius_)}},
            .count = std::ssize(subject_.points)};
  }
  Event say(const Finished&) const {
    const ZoomPicture& picture = pictures_[at_hand()];
    return {.text = picture.bare == 0 ? "zoom.closed" : "zoom.gaps",
            .facts = {{"zoom", picture.zoom}, {"surface", picture.whole}, {"bare", picture.bare}},
            .words = {{"part", percent(bare_part(picture))}},
            .row = {picture.zoom, picture.whole, picture.whole - picture.bare, picture.bare},
            .key = fmt::format("{}", picture.zoom),
            .phase = words_.say("zoom.heading", {{"zoom", picture.zoom}}),
            .decides = yes_or_no(words_, "question.closed", {{"zoom", picture.zoom}}, picture.bare == 0,
                                 "closed", "gaps")};
  }

  View draw() const {
    View view;
    const std::size_t reached = all<Finished>().size();
    if (reached > 0) add_picture(view, "a", large, pictures_[reached - 1], false);
    if (reached > 1) add_picture(view, "b", small, pictures_[reached - 2], true);
    if (reached > 1) add_frame(view, pictures_[reached - 2], pictures_[reached - 1]);
    int line = 0;
    for (const Attribute& its : attributes_)
      add_line(view, line++, Role::input,
               words_.say("attribute", {{"name", words_.say(fmt::format("attribute.{}", its.name))},
                                        {"bytes", its.bytes}}));
    add_line(view, line++, Role::guide,
             words_.say("zoom.bytes", {{"bytes", bytes_each() * subject_.points.size()}}));
    add_line(view, line, Role::guide, words_.say("zoom.faces"));
    return view;
  }

 private:
  static constexpr Extent large{{0.4, 0.4}, {24, 24}}, small{{25.6, 10.6}, {39, 24}};

  std::size_t at_hand() const { return all<Finished>().size() - 1; }
  std::size_t bytes_each() const {
    std::size_t sum = 0;
    for (const Attribute& its : attributes_) sum += its.bytes;
    return sum;
  }
  static double bare_part(const ZoomPicture& picture) {
    return picture.whole == 0 ? 0 : static_cast<double>(picture.bare) / static_cast<double>(picture.whole);
  }
  static Panel panel(const Extent& place, const ZoomPicture& picture) {
    return Panel(place, {picture.screen.lower, picture.screen.lower + picture.screen.side});
  }
  void add_picture(View& view, const std::string& id, const Extent& place, const ZoomPicture& picture,
                   bool aside) const {
    constexpr Rgba8 gap{226, 226, 226};
    const auto image = picture_of(picture.front, 8, [&](ivec2 pixel) {
      const Index i = picture.front[pixel];
      if (i == none) return picture.is_surface(pixel) ? gap : Rgba8{0, 0, 0, 0};
      return lit(colour_of(subject_, i), normals_[i], subject_.eye - subject_.points[i]);
    });
    view.add({id + " picture", Role::past, Picture{place.lower, place.upper, image, aside}});
    view.add({id + " frame", aside ? Role::past : Role::current, Path{place.corners(), true, false, aside}});
    view.add({id + " heading", Role::guide,
              Text{{place.centre().x, place.upper.y + 1.2},
                   words_.say("zoom.heading", {{"zoom", picture.zoom}}),
                   Align::centre,
                   aside}});
  }
  /// Which part of the picture before is shown.
  void add_frame(View& view, const ZoomPicture& before, const ZoomPicture& now) const {
    const Panel shown = panel(small, before);
    const Extent part{shown.at(now.screen.lower), shown.at(now.screen.lower + now.screen.side)};
    view.add({"c part", Role::current, Path{part.corners(), true, false, true}});
  }
  void add_line(View& view, int line, Role role, const std::string& text) const {
    view.add({fmt::format("y {:02}", line), role, Text{{26, 8.9 - 1.9 * line}, text, Align::left, true}});
  }

  const Words& words_;
  const Subject& subject_;
  const int radius_;
  Extent cloud_{};
  std::vector<ZoomPicture> pictures_{};
  std::vector<Attribute> attributes_{};
  std::vector<dvec3> normals_{};
};

}  // namespace gradus::point_cloud
