// The story of texture mapping: which place of the texture a pixel shows, which texels colour it, and from
// which level.

#include "shading/texture_mapping/texture_mapping.hpp"

#include "shading/texture_mapping/texture_mapping_notes.hpp"
#include "stories/parameters.hpp"
#include "stories/shading/texture_mapping/drawing.hpp"
#include "stories/shading/texture_mapping/pictures.hpp"
#include "stories/shading/texture_mapping/subject.hpp"

namespace gradus::texture_mapping {
namespace {

constexpr auto drop = [](ivec2, dvec2, const auto&) {};

/// What is told: places that are right, those of the exhibit, or what a filter takes there.
enum class Way { mapped, bent, filtered };

/// What all methods tell: the picture grows on the left, what a pixel asks the texture for is on the right.
class Story {
 public:
  Story(const Words& words, const Subject& subject, const Paper& paper, Way way)
      : words_(words),
        subject_(subject),
        paper_(paper),
        bent_(way == Way::bent),
        filters_(way == Way::filtered) {}

  const Picture& picture() const { return picture_; }
  /// The pixel whose colour is looked up next.
  void stand_at(const Place& place) { at_ = place; }
  /// The second triangle begins: its pixels tell most, as they stand in a picture that is half done.
  void half_done() { half_done_ = true; }

  void show(Board& board, const steps::Started&) {
    paper_.put_frames(base_, words_);
    paper_.put_level(base_, 0);
    board.milestone(base_);
  }
  Event say(const steps::Started&) const {
    return {.text = "started",
            .words = {{"size", subject_.size_text()},
                      {"near", least_w()},
                      {"far", most_w()},
                      {"columns", subject_.size.x},
                      {"rows", subject_.size.y}}};
  }

  void show(Board& board, const Place& m) {
    at_ = m;
    const ivec2 texel = subject_.nearest_texel(m.uv);
    View view = coloured(subject_.texel(texel));
    paper_.mark_texel(view, texel);
    paper_.mark_place(view, m.uv);
    paper_.mark_footprint(view, m.uv, looked_up(bent_).second, Role::current);
    if (subject_.nearest_texel(other_place()) != texel) paper_.mark_other(view, other_place());
    board.milestone(std::move(view));
    tells(board, std::abs(m.uv.x - other_place().x) + std::abs(m.uv.y - other_place().y));
  }
  Event say(const Place& m) const {
    const ivec2 texel = subject_.nearest_texel(m.uv), other = subject_.nearest_texel(other_place());
    Event event{.text = bent_            ? (other != texel ? "bent.off" : "bent")
                        : other != texel ? "mapped.off"
                                         : "mapped",
                .facts = {{"pixel", m.pixel}, {"u", m.uv.x}, {"v", m.uv.y}, {"texel", texel}},
                .words = {{"q", m.linear.x},
                          {"uq", m.linear.y},
                          {"vq", m.linear.z},
                          {"place", m.uv},
                          {"other", other},
                          {"right", figure_place(other_place())}},
                .row = {m.pixel.x, m.pixel.y, m.linear.x, m.linear.y, m.linear.z, m.uv.x, m.uv.y, here()},
                .key = pixel_key(m.pixel),
                .phase = phase()};
    if (bent_) event.row = {m.pixel.x, m.pixel.y, m.uv.x, m.uv.y, other_place().x, other_place().y, here()};
    if (other != texel) {
      event.decides = Decision{words_.say("question.texel", {{"pixel", m.pixel}}),
                               {texel_name(texel), texel_name(other)},
                               0,
                               bent_ ? "bent" : "correct"};
    }
    return event;
  }

  void show(Board& board, const Picked<double>& p) {
    View view = coloured(p.colour);
    paper_.mark_texel(view, p.texel);
    paper_.mark_place(view, p.uv);
    board.milestone(std::move(view));
    tells_of_middle(board);
  }
  Event say(const Picked<double>& p) const {
    return {.text = "picked",
            .facts = {{"pixel", at_.pixel}, {"texel", p.texel}, {"colour", p.colour}},
            .words = {{"u", p.uv.x},
                      {"v", p.uv.y},
                      {"across", p.uv.x * subject_.texels},
                      {"up", p.uv.y * subject_.texels},
                      {"column", p.texel.x},
                      {"row", p.texel.y},
                      {"I", p.colour}},
            .row = {at_.pixel.x, at_.pixel.y, p.uv.x, p.uv.y, texel_name(p.texel), p.colour},
            .key = pixel_key(at_.pixel),
            .phase = phase(),
            .decides = which_texel(p.uv, p.texel)};
  }

  void show(Board& board, const Blended<double>& b) {
    if (mip_) return show_in_level(board, b);
    View view = coloured(b.colour);
    mark_four(view, b, 0);
    board.milestone(std::move(view));
    tells_of_middle(board);
  }
  Event say(const Blended<double>& b) const {
    const std::array<double, 4> w = weights(b.parts);
    Event event{.text = mip_ ? "blended.level" : "blended",
                .facts = {{"pixel", at_.pixel}, {"s", b.parts.x}, {"t", b.parts.y}, {"colour", b.colour}},
                .words = {{"level", shown_level_},
                          {"w0", w[0]},
                          {"w1", w[1]},
                          {"w2", w[2]},
                          {"w3", w[3]},
                          {"c0", b.colours[0]},
                          {"c1", b.colours[1]},
                          {"c2", b.colours[2]},
                          {"c3", b.colours[3]},
                          {"I", b.colour}},
                .key = pixel_key(at_.pixel),
                .phase = phase()};
    if (mip_) return event;
    event.row = {at_.pixel.x, at_.pixel.y, b.uv.x, b.uv.y, b.parts.x, b.parts.y, b.colour};
    event.decides = which_texel(b.uv, subject_.nearest_texel(b.uv));
    return event;
  }

  void show(Board& board, const LevelChosen& c) {
    mip_ = c;
    blended_ = 0;
    shown_level_ = c.level.lower;
    paper_.put_level(base_, c.level.lower);
    View view = base_;
    paper_.mark_pixel(view, at_.pixel);
    paper_.mark_sample(view, at_.uv);
    paper_.mark_footprint(view, at_.uv, c.footprint, Role::accepted);
    board.milestone(std::move(view));
    if (c.level.lower >= 1 && c.level.part > 0 && at_.pixel.x >= subject_.size.x / 2 - 1)
      tells(board, c.level.lower == 1 ? 2 : 1);
  }
  Event say(const LevelChosen& c) const {
    const int levels = subject_.chain().levels();
    std::vector<std::string> answers;
    for (int k = 0; k < levels; ++k) answers.push_back(words_.say("level", {{"k", k}}));
    const bool magnified = c.length <= 1;
    return {
        .text = magnified           ? "level.magnified"
                : c.level.part == 0 ? "level.one"
                                    : "level.between",
        .facts = {{"pixel", at_.pixel}, {"length", c.length}, {"level", c.level.lower}},
        .words = {{"coarser", c.level.lower + 1},
                  {"wide", 1 << c.level.lower},
                  {"wider", 2 << c.level.lower},
                  {"part", c.level.part}},
        .row = {at_.pixel.x, at_.pixel.y, at_.uv.x, at_.uv.y, c.length, c.level.lower + c.level.part},
        .key = pixel_key(at_.pixel),
        .phase = phase(),
        .decides = Decision{words_.say("question.level", {{"length", c.length}}), answers,
                            static_cast<std::size_t>(c.level.lower), magnified ? "magnified" : "minified"}};
  }

  void show(Board& board, const LevelsMixed<double>& m) { board.detail(coloured(m.colour)); }
  Event say(const LevelsMixed<double>& m) const {
    return {.text = "mixed",
            .facts = {{"pixel", at_.pixel}, {"part", m.level.part}, {"colour", m.colour}},
            .words = {{"rest", 1 - m.level.part},
                      {"part_", m.level.part},
                      {"rest_", 1 - m.level.part},
                      {"finer", m.finer},
                      {"coarser", m.coarser},
                      {"level", m.level.lower},
                      {"next", m.level.lower + 1},
                      {"I", m.colour}},
            .key = pixel_key(at_.pixel),
            .phase = phase(),
            .level = gradus::Level::step};
  }

  void show(Board& board, const steps::Finished&) {
    if (mip_) paper_.put_level(base_, 0);
    if (!filters_) paper_.put_diagonal(base_, bent_);
    board.milestone(base_);
    if (bent_) board.tells(std::numeric_limits<double>::infinity());
  }
  Event say(const steps::Finished&) const {
    return {.text = filters_ ? "finished"
                    : bent_  ? "finished.bent"
                             : "finished.mapped",
            .facts = {{"pixels", std::ssize(picture_)}}};
  }

 private:
  std::string phase() const { return words_.say("phase", {{"number", half_done_ ? 2 : 1}}); }
  /// The drawing with the pixel's colour.
  View coloured(double grey) {
    picture_[{at_.pixel.x, at_.pixel.y}] = grey;
    paper_.put_pixel(base_, at_.pixel, tone_of(grey));
    View view = base_;
    paper_.mark_pixel(view, at_.pixel);
    return view;
  }
  void tells(Board& board, double how_much) const {
    if (half_done_) board.tells(how_much);
  }
  /// The pixel in the middle of the picture tells as much as any.
  void tells_of_middle(Board& board) const {
    tells(board, 1 / (1 + glm::length(dvec2(at_.pixel) + 0.5 - 0.5 * dvec2(subject_.size))));
  }

  double here() const { return picture_.at({at_.pixel.x, at_.pixel.y}); }
  double least_w() const { return std::ranges::min(subject_.corners, {}, &dvec3::z).z; }
  double most_w() const { return std::ranges::max(subject_.corners, {}, &dvec3::z).z; }
  /// Where the other way would look: linear in the picture for the right one, on the surface for the exhibit.
  dvec2 other_place() const { return looked_up(!bent_).first; }
  /// The place of the pixel at hand in the texture, and what it covers there.
  std::pair<dvec2, Footprint<double>> looked_up(bool bent) const {
    std::pair<dvec2, Footprint<double>> found{at_.uv, {}};
    const auto take = [&](ivec2, dvec2 uv, const Footprint<double>& footprint) { found = {uv, footprint}; };
    const Window pixel{at_.pixel, at_.pixel};
    each_place(subject_, [&](const Triangle& triangle, const Corners<double>& corners) {
      if (bent) {
        affine(triangle, corners, pixel, take);
      } else {
        perspective_correct(triangle, corners, pixel, take);
      }
    });
    return found;
  }
  /// Of lower left, lower right, upper left, upper right.
  static std::array<double, 4> weights(dvec2 t) {
    return {(1 - t.x) * (1 - t.y), t.x * (1 - t.y), (1 - t.x) * t.y, t.x * t.y};
  }
  /// The texels round the place, the one that holds it among them.
  Decision which_texel(dvec2 uv, ivec2 taken) const {
    const auto [parts, four] = middles(uv, subject_.texture);
    Decision decision{words_.say("question.nearest"), {}, 0, "texel"};
    for (const ivec2 texel : four) {
      if (texel == taken) decision.answer = decision.answers.size();
      decision.answers.push_back(texel_name(texel));
    }
    return decision;
  }
  void mark_four(View& view, const Blended<double>& b, int level) const {
    const std::array<double, 4> w = weights(b.parts);
    for (std::size_t k = 0; k < 4; ++k)
      paper_.mark_weight(view, k, b.texels[k], level, figure_real(std::round(100 * w[k]) / 100));
    paper_.mark_sample(view, b.uv);
  }
  void show_in_level(Board& board, const Blended<double>& b) {
    shown_level_ = mip_->level.lower + blended_++;
    paper_.put_level(base_, shown_level_);
    View view = coloured(b.colour);
    mark_four(view, b, shown_level_);
    board.detail(std::move(view));
  }

  const Words& words_;
  const Subject& subject_;
  const Paper& paper_;
  const bool bent_, filters_;  ///< filters' table tells u and v alone, not what is linear in the picture
  Place at_{};
  bool half_done_ = false;
  std::optional<LevelChosen> mip_{};
  int blended_ = 0, shown_level_ = 0;
  View base_{};  ///< what stays
  Picture picture_{};
};

// --- The methods

/// What all methods do round their run: run(story, watch, triangle, corners), for both triangles.
template <class Run>
void tell_mapping(Narrator& narrator, const Subject& subject, Story& story, const Run& run) {
  narrator.subtitle("subtitle",
                    {{"size", subject.size_text()}, {"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.tell_whole(story, [&](const auto& watch) {
    each_place(subject, [&](const Triangle& triangle, const Corners<double>& corners) {
      run(watch, triangle, corners);
      story.half_done();
    });
  });
  double sum = 0;
  for (const auto& [at, grey] : story.picture()) sum += grey;
  narrator.result({{"pixels", std::ssize(story.picture())}, {"light", sum}});
}

void tell_perspective_correct(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Paper paper(subject);
  paper.set(narrator);
  narrator.columns({{"x"}, {"y"}, {"q"}, {"uq"}, {"vq"}, {"u"}, {"v"}, {"I"}});
  narrator.legend({{Role::current, "current"}, {Role::accepted, "texel"}, {Role::rejected, "linear"}});
  Story story(narrator.words(), subject, paper, Way::mapped);
  tell_mapping(narrator, subject, story, [&](const auto& watch, const auto& triangle, const auto& corners) {
    perspective_correct(triangle, corners, subject.picture(), drop, only<Place>(watch));
  });
}

void tell_affine(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Paper paper(subject);
  paper.set(narrator);
  narrator.columns({{"x"}, {"y"}, {"u"}, {"v"}, {"ru"}, {"rv"}, {"I"}});
  narrator.legend({{Role::current, "current"},
                   {Role::accepted, "texel"},
                   {Role::rejected, "surface"},
                   {Role::measure, "diagonal"}});
  Story story(narrator.words(), subject, paper, Way::bent);
  tell_mapping(narrator, subject, story, [&](const auto& watch, const auto& triangle, const auto& corners) {
    affine(triangle, corners, subject.picture(), drop, only<Place>(watch));
  });
}

/// A filter's own steps are told, at the places that perspective gives.
template <class Filter>
void tell_filter(Narrator& narrator, const Subject& subject, const Paper& paper, const Filter& filter) {
  paper.set(narrator);
  Story story(narrator.words(), subject, paper, Way::filtered);
  tell_mapping(narrator, subject, story, [&](const auto& watch, const auto& triangle, const auto& corners) {
    const auto stand = [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Place>) story.stand_at(step);
    };
    const auto look_up = [&](ivec2, dvec2 uv, const auto& footprint) { filter(uv, footprint, watch); };
    perspective_correct(triangle, corners, subject.picture(), look_up, stand);
  });
}

void tell_nearest(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.columns({{"x"}, {"y"}, {"u"}, {"v"}, {"texel", false}, {"I"}});
  narrator.legend({{Role::current, "current"}, {Role::accepted, "texel"}});
  tell_filter(narrator, subject, Paper(subject), [&](dvec2 uv, const auto&, const auto& watch) {
    nearest(uv, subject.texture, subject.look_up(), watch);
  });
}

void tell_bilinear(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.columns({{"x"}, {"y"}, {"u"}, {"v"}, {"s"}, {"t"}, {"I"}});
  narrator.legend({{Role::current, "current"}, {Role::candidate, "four"}});
  tell_filter(narrator, subject, Paper(subject), [&](dvec2 uv, const auto&, const auto& watch) {
    bilinear(uv, subject.texture, subject.look_up(), watch);
  });
}

void tell_mip_mapped(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const MipChain<double> chain = subject.chain();
  narrator.columns({{"x"}, {"y"}, {"u"}, {"v"}, {"length"}, {"level"}});
  narrator.legend({{Role::current, "current"}, {Role::accepted, "footprint"}, {Role::candidate, "four"}});
  tell_filter(narrator, subject, Paper(subject), [&](dvec2 uv, const auto& footprint, const auto& watch) {
    mip_mapped(uv, footprint, chain, subject.texture.wrap, watch);
  });
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "texture_mapping",
       .chapter = "shading",
       .aliases = {"texture", "bilinear filtering", "mip mapping", "mipmap", "trilinear",
                   "perspective-correct", "affine texture"},
       .summary = "which place of a texture a pixel shows, and which texels colour it",
       .methods = {{.name = "perspective_correct",
                    .standing = Standing::taught,
                    .tell = tell_perspective_correct},
                   {.name = "nearest", .tell = tell_nearest, .file = "texture_filters.hpp"},
                   {.name = "bilinear", .tell = tell_bilinear, .file = "texture_filters.hpp"},
                   {.name = "mip_mapped", .tell = tell_mip_mapped, .file = "texture_filters.hpp"},
                   {.name = "mip_chain",
                    .tell = tell_mip_chain,
                    .function = "build_mip_chain",
                    .file = "texture_filters.hpp",
                    .unread = {"corners", "columns", "rows", "tiles", "wrap"}},
                   {.name = "all_filters",
                    .tell = tell_all_filters,
                    .function = "nearest",
                    .file = "texture_filters.hpp"},
                   {.name = "affine",
                    .standing = Standing::faulty,
                    .tell = tell_affine,
                    .file = "texture_mapping_notes.hpp"}},
       .default_method = "perspective_correct",
       .parameters =
           {points(4, 4, "corners", "0,12,1 12,12,1 8,1,3 4,1,3", "1,11,1 11,11,1 11,1,1 1,1,1",
                   "the quad: x and y in the picture, y down, and w; texture coordinates (0, 0), (1, 0), "
                   "(1, 1), (0, 1)",
                   {"x", "y", "w"}, {1e-3, 4096}),
            integer(3, 48, "columns", "12", "16", "how many pixels the picture is wide"),
            integer(3, 48, "rows", "12", "16", "how many pixels it is high"),
            choice("texture", {"checker", "cross", "squares", "patches"}, "checker", "cross",
                   "what the texture shows"),
            integer(1, 16, "texels", "6", "8", "how many texels it has, either way"),
            integer(
                1, 16, "tiles", "1", "2",
                "how often it lies on the quad, either way; all_filters repeats a single one as often as its "
                "pixels are finer"),
            choice("wrap", {"repeat", "clamp"}, "repeat", "clamp", "what lies beyond its border")},
       .examples = {"--method bilinear --corners '-4,16,1 16,16,1 16,-4,1 -4,-4,1' --texels 4",
                    "--method mip_mapped --texels 16", "--method all_filters --tiles 4"}});
  return topic;
}

}  // namespace gradus::texture_mapping
