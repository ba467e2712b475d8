// The story of the accumulation buffer: one picture per pass, their sum, and the mean.

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

#include "stories/antialiasing/accumulation_buffer/greys_story.hpp"
#include "stories/antialiasing/accumulation_buffer/lens_story.hpp"
#include "stories/antialiasing/accumulation_buffer/motion_story.hpp"
#include "stories/antialiasing/accumulation_buffer/pictures.hpp"
#include "stories/antialiasing/accumulation_buffer/subject.hpp"
#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::accumulation_buffer {
namespace {

/// One pixel large with the places that the passes look at; the picture of this pass; the sums.
class Story {
 public:
  Story(const Words& words, const Subject& subject, Picture& sums)
      : words_(words), subject_(subject), sums_(sums) {}

  static constexpr ivec2 paper{28, 20};

  void show(Board& board, const Started&) { board.milestone(drawing()); }
  Event say(const Started& s) const {
    return {.text = "started",
            .facts = {{"passes", s.passes}, {"area", subject_.area()}},
            .words = {{"a", subject_.grid.x}, {"b", subject_.grid.y}, {"pixel", subject_.pixel}},
            .count = s.passes,
            .key = "started"};
  }

  void show(Board& board, const PassAdded& p) {
    place_ = p.place;
    ++passes_;
    board.milestone(drawing());
  }
  Event say(const PassAdded& p) const {
    const double value = value_at(*place_);
    const auto sum = static_cast<std::int64_t>(this->sum());
    return {.text = value > 0 ? "added.in" : "added.out",
            .facts = {{"pass", p.pass + 1}, {"place", figure_place(p.place)}, {"value", value}, {"sum", sum}},
            .words = {{"place", p.place}, {"pixel", subject_.pixel}, {"before", sum - 1}},
            .row = {p.pass + 1, p.place.x, p.place.y, value, sum,
                    static_cast<double>(sum) / static_cast<double>(p.pass + 1)},
            .key = fmt::format("pass {}", p.pass + 1),
            .phase = words_.say("phase.passes"),
            .decides = yes_or_no(words_, "question", {{"place", p.place}}, value > 0, "inside", "outside")};
  }

  void show(Board& board, const Averaged&) {
    done_ = true;
    place_.reset();
    board.milestone(drawing());
  }
  Event say(const Averaged& a) const {
    const double mean = sum();
    return {.text = "averaged",
            .facts = {{"passes", a.passes}, {"mean", mean}, {"area", subject_.area()}},
            .words = {{"pixel", subject_.pixel},
                      {"sum", static_cast<std::int64_t>(std::llround(mean * static_cast<double>(a.passes)))}},
            .count = a.passes,
            .key = "mean",
            .ends = true};
  }

  /// Where the picture of a pass has a place, if it reaches as far; a pixel by its upper left corner.
  static std::optional<dvec2> shown_at(dvec2 place) {
    const bool shown = Extent{{0, 0}, dvec2(Subject::size)}.holds(place);
    return shown ? std::optional(pass.on_paper(place)) : std::nullopt;
  }

 private:
  static constexpr int side = 16;  ///< of the pixel that is shown large
  static constexpr Frame large{{1, 2}, {side, side}}, pass{{19, 2}, Subject::size},
      buffer{{19, 12}, Subject::size};

  double sum() const { return sums_.at(subject_.pixel); }
  double value_at(dvec2 place) const { return subject_.colour()(dvec2(subject_.pixel) + place); }
  static dvec2 in_large(dvec2 place) { return large.on_paper(double(side) * place); }

  View drawing() const {
    View view;
    put_large(view);
    pass.put(view, "b pass",
             passes_ == 0 ? words_.say("heading.scene")
             : done_      ? words_.say("heading.scene")
                          : words_.say("heading.pass", {{"pass", passes_}}));
    if (place_) pass.put_picture(view, picture_at(Subject::size, *place_, subject_.colour()));
    put_triangle(view, pass, "c triangle");
    buffer.put(view, "d buffer",
               words_.say(passes_ == 0 ? "heading.empty"
                          : done_      ? "heading.done"
                                       : "heading.sums"));
    put_sums(view);
    pass.mark(view, "e pixel", subject_.pixel);
    buffer.mark(view, "f pixel", subject_.pixel);
    return view;
  }
  void put_large(View& view) const {
    large.put(view, "a pixel", words_.say("heading.pixel", {{"pixel", subject_.pixel}}));
    const auto [a, b] = std::pair{subject_.grid.x, subject_.grid.y};
    std::vector<dvec2> part;
    for (const dvec2 p : part_in(subject_.triangle, subject_.pixel))
      part.push_back(in_large(p - dvec2(subject_.pixel)));
    if (part.size() > 2) {
      view.add({"g part", Role::input, Area{{part}, 2}});
      view.add({"g part outline", Role::measure, Path{part, true}});
    }
    for (int i = 1; i < a; ++i)
      view.add({fmt::format("h column {}", i), Role::guide,
                Stroke{in_large({double(i) / a, 0}), in_large({double(i) / a, 1}), false, true, true}});
    for (int j = 1; j < b; ++j)
      view.add({fmt::format("h row {}", j), Role::guide,
                Stroke{in_large({0, double(j) / b}), in_large({1, double(j) / b}), false, true, true}});
    for (int k = 0; k < a * b; ++k) put_place(view, k);
  }
  /// A place with the number of its pass.
  void put_place(View& view, int k) const {
    const dvec2 place = place_of(k % subject_.grid.x, k / subject_.grid.x, subject_.grid);
    const bool in = value_at(place) > 0, now = k + 1 == passes_ && !done_, taken = k < passes_;
    const Role role = now ? Role::current : !taken ? Role::candidate : in ? Role::accepted : Role::rejected;
    view.add({fmt::format("p place {:02}", k), role, Dot{in_large(place), !(taken && in)}});
    const dvec2 beside{0, std::min(1.2, 0.45 * side / subject_.grid.y)};
    view.add({fmt::format("q number {:02}", k), role, Text{in_large(place) + beside, std::to_string(k + 1)}});
  }
  void put_triangle(View& view, const Frame& frame, const std::string& id) const {
    Path path{{}, true};
    for (const dvec2 p : inside()) path.points.push_back(frame.on_paper(p));
    if (path.points.size() > 1) view.add({id, Role::measure, path});
  }
  /// What of the triangle lies in the picture.
  std::vector<dvec2> inside() const {
    std::vector<dvec2> scaled;
    for (const dvec2 p : subject_.triangle) scaled.push_back(p / dvec2(Subject::size));
    std::vector<dvec2> part = ring_within(scaled, dvec2(0), dvec2(1));
    for (dvec2& p : part) p *= dvec2(Subject::size);
    return part;
  }
  void put_sums(View& view) const {
    if (passes_ == 0) return;
    for (int y = 0; y < Subject::size.y; ++y) {
      for (int x = 0; x < Subject::size.x; ++x) {
        const double value = sums_.at({x, y});
        const double mean = done_ ? value : value / static_cast<double>(passes_);
        const bool counts = !done_ && value > 0;
        buffer.put_pixel(view, {x, y}, Frame::shade(mean), counts ? figure_real(value) : "");
      }
    }
  }

  const Words& words_;
  const Subject& subject_;
  Picture& sums_;
  std::optional<dvec2> place_{};
  std::int64_t passes_ = 0;
  bool done_ = false;
};

// --- The methods

void tell_accumulate(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.subtitle("subtitle", {{"a", subject.grid.x}, {"b", subject.grid.y}, {"pixel", subject.pixel}});
  set_paper(narrator, Story::paper);
  narrator.columns({{"pass"}, {"place_x"}, {"place_y"}, {"value"}, {"sum"}, {"mean"}});
  narrator.legend({{Role::measure, "triangle"},
                   {Role::candidate, "to_come"},
                   {Role::current, "now"},
                   {Role::accepted, "inside"},
                   {Role::rejected, "outside"}});
  narrator.trace().legend.front().sample = Sample::line;
  Picture sums{Subject::size};
  Story story(narrator.words(), subject, sums);
  for (const std::string_view drawn : {"triangle", "pixel"}) narrator.handles(drawn, Story::shown_at);
  const auto render = [&](dvec2 place, const Sums<double>& plot) {
    draw(Subject::size, place, subject.colour(), plot);
  };
  accumulate(subject.grid, render, sums.sums(), narrator.watcher(story));
  narrator.telling({(3 * subject.passes() + 3) / 4, 0});
  narrator.result({{"mean", sums.at(subject.pixel)}, {"area", subject.area()}});
}

/// The parameters that a method takes no notice of: all but these.
std::vector<std::string> all_but(const std::vector<std::string>& read) {
  std::vector<std::string> unread;
  for (const char* name :
       {"a", "b", "triangle", "pixel", "value", "passes", "speed", "shutter", "eyes", "radius", "focus"}) {
    if (std::ranges::find(read, name) == read.end()) unread.emplace_back(name);
  }
  return unread;
}

Parameter whole(std::string name, std::string value, std::string example, std::string help, int least,
                int most) {
  return {.name = std::move(name),
          .type = ParameterType::integer,
          .default_value = std::move(value),
          .example = std::move(example),
          .help = std::move(help),
          .least = least,
          .most = most};
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "accumulation_buffer",
       .chapter = "antialiasing",
       .aliases = {"motion blur", "depth of field", "multipass antialiasing", "circle of confusion"},
       .summary = "the mean of many renderings, each from another place, moment or eye",
       .methods = {{.name = "accumulate",
                    .standing = Standing::taught,
                    .tell = tell_accumulate,
                    .unread = all_but({"a", "b", "triangle", "pixel"})},
                   {.name = "motion_blur",
                    .tell = tell_motion_blur,
                    .unread = all_but({"passes", "speed", "shutter"})},
                   {.name = "depth_of_field",
                    .tell = tell_depth_of_field,
                    .unread = all_but({"eyes", "radius", "focus"})},
                   {.name = "passes_side_by_side",
                    .tell = tell_side_by_side,
                    .function = "accumulate",
                    .unread = all_but({})},
                   {.name = "wide_sums",
                    .tell = tell_wide_sums,
                    .function = "accumulate",
                    .unread = all_but({"a", "b", "value"})},
                   {.name = "eight_bits",
                    .standing = Standing::faulty,
                    .tell = tell_eight_bits,
                    .unread = all_but({"a", "b", "value"})}},
       .default_method = "accumulate",
       .parameters = {whole("a", "2", "4", "columns of places in a pixel", 1, 8),
                      whole("b", "2", "4", "rows of places in a pixel; there are a times b passes", 1, 8),
                      points(3, 3, "triangle", "0.5,6.3 5.4,0.6 6.6,5.2", "0.2,6.5 6.8,0.4 6.8,2.2",
                             "the triangle: corners in a picture of 7 x 7 pixels, y down", xy, {1e-3, 4096}),
                      {.name = "pixel",
                       .type = ParameterType::cell,
                       .default_value = "1,5",
                       .example = "3,2",
                       .help = "the pixel that is shown large: column,row"},
                      whole("value", "200", "60", "the lightest byte that every pass adds", 0, 255),
                      whole("passes", "8", "16", "moments in which the shutter is open", 1, 64),
                      number("speed", "16", "24", "how fast the disc flies to the right, in pixels a second",
                             {1e-3, 1e4}),
                      number("shutter", "0.5", "0.25", "how long the shutter is open, in seconds",
                             {1e-4, 1e4}),
                      whole("eyes", "4", "6",
                            "eyes on a side of the grid on the lens; there are as many squared", 1, 8),
                      number("radius", "0.8", "0.4", "the lens's radius, up to 0.8", {1e-3, 0.8}),
                      number("focus", "4", "8",
                             "the depth that is sharp, from 3 to 8; lamps stand at 2, 4 and 8", {3, 8})},
       .examples = {"--a 4 --b 4", "--method motion_blur --passes 16", "--method depth_of_field --focus 8",
                    "--method eight_bits"}});
  return topic;
}

}  // namespace gradus::accumulation_buffer
