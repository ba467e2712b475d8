#pragma once
// Pictures side by side: the levels of a texture, and the same quad through three filters.

#include "stories/paper.hpp"
#include "stories/picture_shelf.hpp"
#include "stories/shading/texture_mapping_subject.hpp"

namespace gradus::texture_mapping {

/// A level is done.
struct LevelBuilt {
  int level;
};

/// The levels beside each other, each texel made of those before it.
class ChainStory {
 public:
  ChainStory(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}

  Window paper() const {
    const int last = levels_of(subject_.texture.size) - 1;
    return {{0, 0}, {corner(last).x + std::max(side_of(last), 2), subject_.texels * scale() + heading}};
  }

  /// The first texel of level 2, where three levels stand beside each other.
  StepNumber telling() const { return {telling_, 0}; }

  void show(Board& board, const steps::Started&) {
    put_level(0);
    board.milestone(base_);
  }
  Event say(const steps::Started&) const {
    return {.text = "chain.started",
            .words = {{"size", subject_.size_text()}},
            .count = levels_of(subject_.texture.size)};
  }
  void show(Board& board, const Averaged<double>& a) {
    const ivec2 from = size_of_level(subject_.texture.size, a.level - 1);
    const int side = scale_of(a.level), before = scale_of(a.level - 1);
    put_texel(a.level, a.texel, a.colour);
    put_name(a.level);
    View view = base_;
    view.add({"t texel", Role::current, square(corner(a.level) + a.texel * side, ivec2(side))});
    const Covered x = covered(a.texel.x, from.x), y = covered(a.texel.y, from.y);
    const ivec2 many(count(x), count(y));
    const ivec2 first = corner(a.level - 1) + ivec2(x.first, y.first) * before;
    view.add({"c covered", Role::candidate, square(first, many * before)});
    many_ = many.x * many.y;
    board.milestone(std::move(view));
    ++milestones_;
    if (a.level <= 2 && a.texel == ivec2(a.level == 1 ? 1 : 0, 0)) telling_ = milestones_;
  }
  Event say(const Averaged<double>& a) const {
    return {.text = "chain.averaged",
            .facts = {{"level", a.level}, {"texel", a.texel}, {"colour", a.colour}},
            .words = {{"level", a.level},
                      {"texel", a.texel},
                      {"before", a.level - 1},
                      {"many", many_},
                      {"I", a.colour}},
            .row = {a.level, texel_name(a.texel), many_, a.colour},
            .key = fmt::format("{}: {},{}", a.level, a.texel.x, a.texel.y),
            .phase = fmt::format("level {}", a.level)};
  }
  void show(Board& board, const steps::Finished&) { board.milestone(base_); }
  Event say(const steps::Finished&) const {
    const std::size_t all = subject_.levels.size(), own = begin_of_level(subject_.texture.size, 1);
    return {.text = "chain.finished",
            .words = {{"own", own}, {"more", all - own}, {"mean", subject_.levels.back()}}};
  }

 private:
  static constexpr int heading = 2, gap = 2;

  static int count(const Covered& c) {
    return static_cast<int>(std::ranges::count_if(c.parts, [](int part) { return part > 0; }));
  }
  static Path square(ivec2 at, ivec2 size) {
    const dvec2 a = dvec2(at) - 0.5, s(size);
    return {{a, a + dvec2{s.x, 0}, a + s, a + dvec2{0, s.y}}, true};
  }
  /// Cells to a texel of level 0; all levels have texels that keep their size.
  int scale() const { return std::max(1, 16 / subject_.texels); }
  int scale_of(int) const { return scale(); }
  int side_of(int level) const { return size_of_level(subject_.texture.size, level).x * scale_of(level); }
  ivec2 corner(int level) const {
    int x = 0;
    for (int k = 0; k < level; ++k) x += std::max(side_of(k), 3) + gap;
    return {x, heading};
  }
  void put_texel(int level, ivec2 texel, double grey) {
    const int side = scale_of(level);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const ivec2 at = corner(level) + texel * side + ivec2{x, y};
        base_.cells.insert_or_assign({at.y, at.x}, CellLook{Role::result, "", tone_of(grey)});
      }
    }
  }
  void put_name(int level) {
    const dvec2 at = dvec2(corner(level)) + dvec2{0.5 * side_of(level) - 0.5, -1.2};
    base_.add({fmt::format("a name {}", level), Role::guide,
               Text{at, level == 0 ? words_.say("level", {{"k", 0}}) : fmt::format("{}", level)}});
  }
  void put_level(int level) {
    put_name(level);
    for (int y = 0; y < subject_.texels; ++y) {
      for (int x = 0; x < subject_.texels; ++x) put_texel(level, {x, y}, subject_.texel({x, y}));
    }
  }

  const Words& words_;
  const Subject& subject_;
  View base_{};
  int many_ = 4;
  std::int64_t milestones_ = 0, telling_ = 0;
};

inline void tell_mip_chain(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const Subject subject = subject_of(given);
  ChainStory story(narrator.words(), subject);
  narrator.whole_grid(story.paper());
  narrator.subtitle("chain.subtitle", {{"size", subject.size_text()}});
  narrator.columns({{"level"}, {"texel", false}, {"covered"}, {"I"}});
  narrator.legend({{Role::current, "new"}, {Role::candidate, "covered"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::vector<double> chain(texels_of_chain(subject.texture.size));
  build_mip_chain(subject.texture.size, subject.look_up(), std::span(chain), only<Averaged<double>>(watch));
  watch(steps::Finished{}, 0);
  narrator.telling(story.telling());
  narrator.result({{"texels", std::ssize(chain)}, {"mean", chain.back()}});
}

inline void tell_all_filters(Narrator& narrator) {
  const Words& words = narrator.words();
  const Subject subject = subject_of(narrator.arguments());
  const Picture right = supersampled(subject);
  narrator.subtitle("subtitle",
                    {{"size", subject.size_text()}, {"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.columns({{"filter", false}, {"most"}, {"off"}});
  const std::vector<std::string> names{words.say("method.nearest"), words.say("method.bilinear"),
                                       words.say("method.mip_mapped")};
  PictureShelf shelf(narrator, {.size = subject.size, .names = names});
  shelf.start({.text = "three.started",
               .words = {{"columns", subject.size.x},
                         {"rows", subject.size.y},
                         {"tiles", fmt::format("{0} × {0}", subject.tiles)}}});
  const auto texel = subject.look_up();
  const MipChain<double> chain = subject.chain();
  std::vector<double> off;
  const auto filter = [&](std::string_view text, int texels, const auto& look_up) {
    const Picture picture = picture_of(subject, look_up);
    const double before = off.empty() ? 0 : off.back();
    const std::string key(text.substr(6)), &name = names[off.size()];
    off.push_back(mean_difference(picture, right));
    shelf.show("PictureFiltered", 0, tones_in(picture),
               {.text = text,
                .facts = {{"off", off.back()}},
                .words = {{"before", before}},
                .row = {name, texels, off.back()},
                .key = key,
                .phase = key});
  };
  filter("three.nearest", 1, [&](dvec2 uv, const auto&) { return nearest(uv, subject.texture, texel); });
  filter("three.bilinear", 4, [&](dvec2 uv, const auto&) { return bilinear(uv, subject.texture, texel); });
  filter("three.mip_mapped", 8,
         [&](dvec2 uv, const auto& area) { return mip_mapped(uv, area, chain, subject.texture.wrap); });
  shelf.finish(
      {.text = "three.finished", .words = {{"nearest", off[0]}, {"bilinear", off[1]}, {"mip", off[2]}}});
  narrator.telling({4, 0});  // all three beside each other, in one sentence
  narrator.result({{"nearest", off[0]}, {"bilinear", off[1]}, {"mip_mapped", off[2]}});
}

}  // namespace gradus::texture_mapping
