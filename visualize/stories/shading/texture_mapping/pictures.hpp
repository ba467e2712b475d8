#pragma once
// Pictures side by side: the levels of a texture, and the same quad through three filters.

#include "stories/listing.hpp"
#include "stories/past.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/shading/texture_mapping/drawing.hpp"

namespace gradus::texture_mapping {

/// The levels beside each other, each texel made of those before it.
class ChainStory : public Past<steps::Started, Averaged<double>, steps::Finished> {
 public:
  ChainStory(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}

  Window paper() const {
    const int last = levels_of(subject_.texture.size) - 1;
    return {{0, 0}, {corner(last).x + std::max(side_of(last), 2), subject_.texels * scale() + heading}};
  }

  /// The first texel of level 2, where three levels stand beside each other; without it one of level 1.
  double tells(const Averaged<double>& a) const {
    if (a.level == 1) return a.texel == ivec2(1, 0) ? 1 : 0;
    return a.level == 2 && a.texel == ivec2(0) ? 2 : 0;
  }

  Event say(const steps::Started&) const {
    return {.text = "chain.started",
            .words = {{"size", subject_.size_text()}},
            .count = levels_of(subject_.texture.size)};
  }
  Event say(const Averaged<double>& a) const {
    const Path covered = covered_by(a);
    const ivec2 texels = ivec2(covered.points[2] - covered.points[0]) / scale();
    const int many = texels.x * texels.y;
    return {.text = "chain.averaged",
            .facts = {{"level", a.level}, {"texel", a.texel}, {"colour", a.colour}},
            .words = {{"before", a.level - 1}, {"many", many}, {"I", a.colour}},
            .row = {a.level, texel_name(a.texel), many, a.colour},
            .key = fmt::format("{}: {},{}", a.level, a.texel.x, a.texel.y),
            .phase = fmt::format("level {}", a.level)};
  }
  Event say(const steps::Finished&) const {
    const std::size_t all = subject_.levels.size(), own = begin_of_level(subject_.texture.size, 1);
    return {.text = "chain.finished",
            .words = {{"own", own}, {"more", all - own}, {"mean", subject_.levels.back()}}};
  }

  View draw() const {
    View view;
    for (int y = 0; y < subject_.texels; ++y) {
      for (int x = 0; x < subject_.texels; ++x) add_texel(view, 0, {x, y}, subject_.texel({x, y}));
    }
    add_name(view, 0);
    for (const Averaged<double>& a : all<Averaged<double>>()) {
      add_texel(view, a.level, a.texel, a.colour);
      add_name(view, a.level);
    }
    if (const auto* a = now<Averaged<double>>()) {
      view.add({"t texel", Role::current, square(corner(a->level) + a->texel * scale(), ivec2(scale()))});
      view.add({"c covered", Role::candidate, covered_by(*a)});
    }
    return view;
  }

 private:
  static constexpr int heading = 2, gap = 2;

  static int count(const Covered& c) {
    return static_cast<int>(std::ranges::count_if(c.parts, [](int part) { return part > 0; }));
  }
  static Path square(ivec2 at, ivec2 size) { return rectangle(dvec2(at) - 0.5, dvec2(size)); }
  /// The texels of the level before that a texel is the mean of.
  Path covered_by(const Averaged<double>& a) const {
    const ivec2 from = size_of_level(subject_.texture.size, a.level - 1);
    const Covered x = covered(a.texel.x, from.x), y = covered(a.texel.y, from.y);
    const ivec2 first = corner(a.level - 1) + ivec2(x.first, y.first) * scale();
    return square(first, ivec2(count(x), count(y)) * scale());
  }
  /// Cells to a texel of level 0; all levels have texels that keep their size.
  int scale() const { return std::max(1, 16 / subject_.texels); }
  int side_of(int level) const { return size_of_level(subject_.texture.size, level).x * scale(); }
  ivec2 corner(int level) const {
    int x = 0;
    for (int k = 0; k < level; ++k) x += std::max(side_of(k), 3) + gap;
    return {x, heading};
  }
  void add_texel(View& view, int level, ivec2 texel, double grey) const {
    for (int y = 0; y < scale(); ++y) {
      for (int x = 0; x < scale(); ++x) {
        const ivec2 at = corner(level) + texel * scale() + ivec2{x, y};
        view.cells.insert_or_assign({at.y, at.x}, CellLook{Role::result, "", tone_of(grey)});
      }
    }
  }
  void add_name(View& view, int level) const {
    const dvec2 at = dvec2(corner(level)) + dvec2{0.5 * side_of(level) - 0.5, -1.2};
    view.add({fmt::format("a name {}", level), Role::guide,
              Text{at, level == 0 ? words_.say("level", {{"k", 0}}) : fmt::format("{}", level)}});
  }

  const Words& words_;
  const Subject& subject_;
};

inline void tell_mip_chain(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const Subject subject = subject_of(given);
  ChainStory story(narrator.words(), subject);
  narrator.whole_grid(story.paper());
  narrator.subtitle("chain.subtitle", {{"size", subject.size_text()}});
  narrator.columns({{"level"}, {"texel", false}, {"covered"}, {"I"}});
  narrator.legend({{Role::current, "new"}, {Role::candidate, "covered"}});
  narrator.telling({0, 0});  // of one texel
  std::vector<double> chain(texels_of_chain(subject.texture.size));
  narrator.tell_whole(story, [&](const auto& watch) {
    build_mip_chain(subject.texture.size, subject.look_up(), std::span(chain), only<Averaged<double>>(watch));
  });
  narrator.result({{"texels", std::ssize(chain)}, {"mean", chain.back()}});
}

inline void tell_all_filters(Narrator& narrator) {
  const Words& words = narrator.words();
  narrator.list_below("bilinear");
  narrator.list_below("mip_mapped");
  const Subject given = subject_of(narrator.arguments());
  const int finer = std::max(1, 80 / std::max(given.size.x, given.size.y));
  const Subject subject = in_finer_pixels(given, finer);
  const Picture right = supersampled(subject, std::max(4, 16 / finer));
  narrator.subtitle("subtitle",
                    {{"size", subject.size_text()}, {"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.columns({{"filter", false}, {"most"}, {"off"}});
  const std::vector<std::string> names{words.say("method.nearest"), words.say("method.bilinear"),
                                       words.say("method.mip_mapped")};
  PictureShelf shelf(narrator, {.size = subject.size, .names = names, .gap = 4, .heading = 9});
  narrator.trace().grid.lines = 1;  // its cells may be as fine as on a screen
  shelf.start({.text = "three.started",
               .words = {{"columns", subject.size.x},
                         {"rows", subject.size.y},
                         {"tiles", fmt::format("{0} × {0}", subject.tiles)}}});
  const auto texel = subject.look_up();
  const MipChain<double> chain = subject.chain();
  std::vector<double> off;
  // decides: the line that makes a filter's colour
  const auto filter = [&](std::string_view text, std::string_view decides, int texels, const auto& look_up) {
    const Picture picture = picture_of(subject, look_up);
    const double before = off.empty() ? 0 : off.back();
    const std::string key(text.substr(6)), &name = names[off.size()];
    off.push_back(mean_difference(picture, right));
    shelf.show("PictureFiltered", line_with(narrator.trace().listing, decides), tones_in(picture),
               {.text = text,
                .facts = {{"off", off.back()}},
                .words = {{"before", before}},
                .row = {name, texels, off.back()},
                .key = key,
                .phase = name});
  };
  filter("three.nearest", "= texel(at)", 1,
         [&](dvec2 uv, const auto&) { return nearest(uv, subject.texture, texel); });
  filter("three.bilinear", "lerp(low, high, t.y)", 4,
         [&](dvec2 uv, const auto&) { return bilinear(uv, subject.texture, texel); });
  filter("three.mip_mapped", "lerp(fine, coarse, t)", 8,
         [&](dvec2 uv, const auto& area) { return mip_mapped(uv, area, chain, subject.texture.wrap); });
  shelf.finish(
      {.text = "three.finished", .words = {{"nearest", off[0]}, {"bilinear", off[1]}, {"mip", off[2]}}});
  narrator.telling({4, 0});  // all three beside each other, in one sentence
  narrator.result({{"nearest", off[0]}, {"bilinear", off[1]}, {"mip_mapped", off[2]}});
}

}  // namespace gradus::texture_mapping
