// What is divided, and what should not be: points where the eye may be among them, from above and in the
// picture.

#include "projection/perspective/perspective_notes.hpp"
#include "stories/past.hpp"
#include "stories/projection/perspective/stories.hpp"

namespace gradus::perspective {
namespace {

enum class Way { tested, untested, zoom_minus_z };

bool finite(dvec2 p) { return gradus::perspective::finite(p.x) && gradus::perspective::finite(p.y); }

struct DivisionSubject {
  Way way;
  std::vector<dvec3> points;
  double zoom;
  dvec2 scales{1, 1}, centre{0, 0};
  Projection<double> projection{};

  bool zooms() const { return way == Way::zoom_minus_z; }
  WireScreen<double> screen() const { return {centre, scales.x, zoom}; }
  /// From a point as it is given, with the eye `zoom` before z = 0, to view space.
  dvec3 in_view(dvec3 p) const { return p - dvec3{centre, -zoom}; }
  dvec2 right_image(dvec3 p) const { return dvec2(divide_untested(projection, in_view(p))) + centre; }
  dvec2 image_of(dvec3 p) const { return zooms() ? zoom_minus_z(screen(), p) : right_image(p); }
  bool behind(dvec3 p) const { return !(zoom + p.z > 0); }
  /// Where the formula has the eye, from above; it looks towards the plane.
  dvec2 eye() const { return {centre.x, zooms() ? zoom : -zoom}; }
  double plane() const { return eye().y + (zooms() ? -scales.x : scales.x); }
};

DivisionSubject subject_of(const Arguments& arguments, Way way) {
  DivisionSubject subject{
      .way = way, .points = arguments.places("points"), .zoom = *arguments.number("zoom")};
  const std::vector<double> scales = arguments.numbers("scales");
  const std::vector<double> centre = arguments.numbers("centre");
  const std::vector<double> range = arguments.numbers("range");
  subject.scales = {scales[0], subject.zooms() ? scales[0] : scales[1]};
  subject.centre = {centre[0], centre[1]};
  if (!(std::min(subject.scales.x, subject.scales.y) > 0))
    refuse("scales", "expected scales above 0, not {},{}", scales[0], scales[1]);
  if (!(0 < range[0] && range[0] < range[1] && range[1] <= 1e12))
    refuse("range", "expected 0 < near < far, not {},{}", range[0], range[1]);
  subject.projection = projection_of(subject.scales.x, subject.scales.y, range[0], range[1]);
  return subject;
}

class DivisionStory : public Past<steps::Started, Finer<Multiplied<double>>, Divided<double>,
                                  LeftUndivided<double>, LeftAlone<double>, steps::Finished> {
 public:
  /// multiplied_line: of the listing, where it has a call of transform rather than transform itself.
  DivisionStory(const Words& words, const DivisionSubject& subject, std::optional<int> multiplied_line)
      : words_(words), subject_(subject), multiplied_line_(multiplied_line) {
    lay_out();
  }

  const Panel& space() const { return space_; }
  /// Of the plane as it is drawn, from above.
  dvec2 end_of_plane(double side) const { return {subject_.centre.x + side * half_, subject_.plane()}; }

  template <class Step>
  void take(const Step& step) {
    Past::take(step);
    if constexpr (std::same_as<Step, Divided<double>>)
      images_.push_back(subject_.zooms() ? dvec2(step.ndc) : dvec2(step.ndc) + subject_.centre);
    if constexpr (std::same_as<Step, LeftUndivided<double>>) images_.push_back(std::nullopt);
    if constexpr (std::same_as<Step, LeftAlone<double>>) images_.push_back(dvec2(step.node));
  }

  Event say(const steps::Started&) const {
    return {.text = by_way("started.divide_tested", "started.divide_untested", "started.zoom_minus_z"),
            .words = {{"zoom", real(subject_.zoom)}},
            .level = Level::idea};
  }

  Event say(const Multiplied<double>& m) const {
    return {.text = "multiplied",
            .facts = {{"point", name()}, {"clip_z", m.clip.z, "z"}, {"w", m.clip.w}},
            .words = {{"name", name()},
                      {"x", real(m.clip.x)},
                      {"z", real(words_.notation().clip_depth_of(m.clip.z, m.clip.w))}},
            .key = name(),
            .decides = divisible(m.clip.w),
            .line = multiplied_line_};
  }

  Event say(const Divided<double>& d) const {
    const double w = d.clip.w;
    if (subject_.zooms()) return zoomed(w);
    return arrived({.text = w > 0    ? "divided"
                            : w == 0 ? "divided_by_zero"
                                     : "divided_behind",
                    .decides = divisible(w)},
                   w, d.ndc.z);
  }

  Event say(const LeftUndivided<double>& l) const {
    return {.text = "left_undivided",
            .facts = {{"point", name()}, {"w", l.clip.w}},
            .words = {{"name", name()}},
            .row = {point_text(), l.clip.w, words_.say("no_image")},
            .key = name(),
            .decides = divisible(l.clip.w)};
  }

  Event say(const LeftAlone<double>&) const {
    return arrived({.text = "left_alone", .decides = has_no_depth(true)}, std::nullopt, std::nullopt);
  }

  Event say(const steps::Finished&) const {
    const std::int64_t behind =
        std::ranges::count_if(subject_.points, [&](dvec3 p) { return subject_.behind(p); });
    if (subject_.zooms()) return {.text = "done.zoom_minus_z"};
    if (behind == 0) return {.text = "done.before_the_eye"};
    return {.text = by_way("done.divide_tested", "done.divide_untested", ""), .count = behind};
  }

  View draw() const {
    View view;
    add_captions(view, words_, words_.shared("projection", "picture"));
    add_axes(view, space_, "space", {words_.symbol("x"), words_.symbol("z")}, 4);
    add_axes(view, picture_, "picture", {words_.symbol("x′"), words_.symbol("y′")}, 4);
    add_stroke(view, space_, "a plane", Role::boundary, end_of_plane(-1), end_of_plane(1));
    view.add_named("e eye", "f eye name", Role::input, space_.at(subject_.eye()),
                   words_.shared("projection", "eye"));
    for (std::size_t i = 0; i + 1 < subject_.points.size(); ++i)
      add_stroke(view, space_, fmt::format("c line {}", i), Role::input, from_above(i), from_above(i + 1));
    for (std::size_t i = 0; i < subject_.points.size(); ++i) add_point(view, i, Role::input);
    add_images(view);
    if (now<steps::Started>() || now<steps::Finished>()) return view;
    add_point(view, turn(), Role::current);
    if (turn() < images_.size()) add_projector(view, turn(), Role::current);
    return view;
  }

  std::vector<Field> result() const {
    std::vector<Field> result;
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (!has_image(i)) continue;
      result.push_back({letter(i) + ".x", images_[i]->x, "x"});
      result.push_back({letter(i) + ".y", images_[i]->y, "y"});
    }
    return result;
  }

 private:
  std::string_view by_way(std::string_view tested, std::string_view untested, std::string_view zoom) const {
    return subject_.way == Way::tested ? tested : subject_.way == Way::untested ? untested : zoom;
  }
  std::string name() const { return letter(turn()); }
  std::string point_text() const { return name() + " " + figure_place(subject_.points[turn()]); }
  std::string image_text(dvec2 p) const { return finite(p) ? place_text(p) : words_.say("no_number"); }
  bool has_image(std::size_t i) const { return images_[i] && finite(*images_[i]); }

  // --- A point has its image, or none

  /// The event with what all of them tell.
  Event arrived(Event event, std::optional<double> w, std::optional<double> z) const {
    const dvec2 image = *images_[turn()];
    const bool has_z = z && gradus::perspective::finite(*z);
    event.key = name();
    event.facts = {{"point", name()}};
    if (w) event.facts.push_back({"w", *w});
    if (finite(image)) event.facts.insert(event.facts.end(), {{"x", image.x}, {"y", image.y}});
    if (has_z) event.facts.push_back({"z", *z});
    event.words.insert(event.words.end(),
                       {{"name", name()},
                        {"image", image_text(image)},
                        {"right", image_text(subject_.right_image(subject_.points[turn()]))}});
    event.row = {point_text(), w ? Said(*w) : "", image_text(image),
                 has_z ? real(words_.notation().depth_of(*z)) : ""};
    return event;
  }
  Event zoomed(double w) const {
    const double depth = subject_.zoom + subject_.points[turn()].z;
    return arrived({.text = depth > 0 ? "zoomed" : "zoomed_behind",
                    .words = {{"zoom", real(subject_.zoom)}, {"depth", real(depth)}},
                    .decides = has_no_depth(false)},
                   w, std::nullopt);
  }

  std::optional<Decision> divisible(double w) const {
    if (subject_.way != Way::tested) return std::nullopt;  // it isn't asked
    return yes_or_no(words_, "question.before_w", {{"w", w}}, w > 0, "before", "behind");
  }
  Decision has_no_depth(bool yes) const {
    return yes_or_no(words_, "question.left_alone", {{"z", subject_.points[turn()].z}}, yes, "left alone",
                     "divided");
  }

  // --- The drawing

  /// The picture has room for all images but those that fly off.
  void lay_out() {
    const double scale = std::max(subject_.scales.x, subject_.scales.y);
    half_ = 0.3 * scale;
    for (const dvec3 p : subject_.points) {
      const dvec2 away = glm::abs(subject_.image_of(p) - subject_.centre);
      const double most = std::max(away.x, away.y);
      if (finite(away) && most <= 2.2 * scale) half_ = std::max(half_, 1.5 * most);
    }
    Extent space;
    for (const dvec3 p : subject_.points) space.add({p.x, p.z});
    space.add(subject_.eye());
    for (const double side : {-half_, half_}) space.add({subject_.centre.x + side, subject_.plane()});
    space_ = Panel(space_place, widened(space, 0.02), Panel::Fit::stretched);
    picture_ = Panel({{21.8, 5.2}, {35.2, 18.6}}, {subject_.centre - half_, subject_.centre + half_});
  }
  dvec2 from_above(std::size_t i) const { return {subject_.points[i].x, subject_.points[i].z}; }

  static void add_stroke(View& view, const Panel& panel, std::string id, Role role, dvec2 a, dvec2 b,
                         bool dashed = false) {
    const std::optional<Stroke> part = shown_part(panel.shown(), a, b);
    if (part) view.add({std::move(id), role, Stroke{panel.at(part->a), panel.at(part->b), false, dashed}});
  }

  /// The whole projector of a point: it, the eye and the image, as far as the drawing reaches.
  void add_projector(View& view, std::size_t i, Role role) const {
    const dvec2 point = from_above(i), eye = subject_.eye();
    if (!has_image(i) || point == eye) return;
    if (subject_.zooms() && subject_.points[i].z == 0) return;  // left alone
    std::array<dvec2, 3> line{eye, point, dvec2{images_[i]->x, subject_.plane()}};
    std::ranges::sort(line, {}, [](dvec2 p) { return std::pair(p.y, p.x); });
    add_stroke(view, space_, fmt::format("b projector {}", i), role, line[0], line[2], true);
  }

  /// A point's image: a dot, or where it lies outside an arrow to the border.
  void add_image(View& view, std::size_t i, Role role) const {
    if (!has_image(i)) return;
    const dvec2 centre = subject_.centre, away = *images_[i] - centre;
    const double most = std::max(std::abs(away.x), std::abs(away.y));
    const bool inside = most <= half_;
    const dvec2 end = picture_.at(inside ? *images_[i] : centre + away * (half_ / most));
    const std::string id = fmt::format("e image {}", i);
    if (inside) {
      view.add({id, role, Dot{end}});
    } else {
      view.add({id, role, Stroke{picture_.at(centre + away * (0.85 * half_ / most)), end, true}});
    }
    view.add({fmt::format("f image name {}", i), role, Label{end, letter(i) + "′"}});
  }

  /// The picture of the line between a point and the next.
  void add_line(View& view, std::size_t i, Role role) const {
    const std::string id = fmt::format("d image line {}", i);
    if (images_[i] && images_[i + 1]) {
      if (has_image(i) && has_image(i + 1))
        add_stroke(view, picture_, id, role, *images_[i], *images_[i + 1]);
      return;
    }
    if (!images_[i] && !images_[i + 1]) return;
    // It runs to infinity, towards where it passes beside the eye
    const std::size_t seen = images_[i] ? i : i + 1, other = images_[i] ? i + 1 : i;
    const glm::dvec4 a = transform(subject_.projection, subject_.in_view(subject_.points[seen]));
    const glm::dvec4 b = transform(subject_.projection, subject_.in_view(subject_.points[other]));
    const dvec2 from = *images_[seen], way = dvec2(a + a.w / (a.w - b.w) * (b - a));
    const Extent shown{subject_.centre - half_, subject_.centre + half_};
    const bool inside = glm::all(glm::lessThanEqual(glm::abs(from - subject_.centre), dvec2{half_}));
    if (!inside || way == dvec2{0}) return;
    view.add({id, role, Stroke{picture_.at(from), picture_.at(last_inside(shown, from, way)), true}});
  }

  void add_point(View& view, std::size_t i, Role role) const {
    view.add_named(fmt::format("e point {}", i), fmt::format("f point name {}", i), role,
                   space_.at(from_above(i)), letter(i));
  }
  void add_images(View& view) const {
    const auto wrong = [&](std::size_t i) {
      return subject_.way != Way::tested && (subject_.zooms() || subject_.behind(subject_.points[i]));
    };
    const Role right = now<steps::Finished>() ? Role::result : Role::past;
    for (std::size_t i = 0; i < images_.size(); ++i) {
      add_projector(view, i, Role::guide);
      add_image(view, i, wrong(i) ? Role::rejected : right);
      if (i > 0) add_line(view, i - 1, wrong(i) || wrong(i - 1) ? Role::rejected : right);
    }
  }

  const Words& words_;
  const DivisionSubject& subject_;
  const std::optional<int> multiplied_line_;
  double half_ = 1;  ///< of the picture's side
  Panel space_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}}, picture_ = space_;
  std::vector<std::optional<dvec2>> images_;
};

/// The points, the eye with its plane for the middle of the picture, an end of the plane for its distance.
void let_drag(Narrator& narrator, const DivisionSubject& subject, const DivisionStory& story) {
  const Panel& space = story.space();
  narrator.handles("points", [&](dvec3 p) { return space.at({p.x, p.z}); });
  narrator.handles("centre", [&](dvec2 middle) { return space.at({middle.x, subject.eye().y}); });
  const dvec2 up{0, space.scale().y}, from_plane = subject.zooms() ? up : -up;
  narrator.handle("zoom", 0, space.at(story.end_of_plane(-1)), from_plane);
  narrator.handle("scales", 0, space.at(story.end_of_plane(1)), -from_plane);
}

/// take(point, observer): what the method does with a point.
template <class Take>
void tell_points(Narrator& narrator, const DivisionSubject& subject, std::optional<int> multiplied_line,
                 const Take& take) {
  std::string list;
  for (const dvec3 p : subject.points) list += (list.empty() ? "" : ", ") + figure_place(p);
  narrator.trace().subtitle =
      narrator.words().count("subtitle.points", std::ssize(subject.points), {{"points", list}});
  narrator.paper(solids::paper_width, paper_height);
  narrator.columns({{"point", false}, {"w"}, {"image", false}});
  if (!subject.zooms()) {
    narrator.trace().columns.push_back({"z_image"});
    narrator.shows_depths();
  }
  narrator.legend({{Role::input, "points"}, {Role::current, "point"}, Role::result});
  if (subject.way != Way::tested) narrator.add_to_legend(Role::rejected, "wrong");
  DivisionStory story(narrator.words(), subject, multiplied_line);
  let_drag(narrator, subject, story);
  narrator.tell_each(story, subject.points.size(),
                     [&](std::size_t i, const auto& watch) { take(subject.points[i], watch); });
  narrator.result(story.result());
}

}  // namespace

void tell_divide_tested(Narrator& narrator) {
  const DivisionSubject subject = subject_of(narrator.arguments(), Way::tested);
  narrator.list_below("divide");
  narrator.list_below("divide_tested");
  tell_points(narrator, subject, std::nullopt, [&](dvec3 point, const auto& watch) {
    divide_tested(subject.projection, subject.in_view(point), watch);
  });
}

void tell_divide_untested(Narrator& narrator) {
  const DivisionSubject subject = subject_of(narrator.arguments(), Way::untested);
  const int call = narrator.trace().listing.front().number;
  tell_points(narrator, subject, call, [&](dvec3 point, const auto& watch) {
    divide_untested(subject.projection, subject.in_view(point), watch);
  });
}

void tell_zoom_minus_z(Narrator& narrator) {
  const DivisionSubject subject = subject_of(narrator.arguments(), Way::zoom_minus_z);
  tell_points(narrator, subject, std::nullopt,
              [&](dvec3 point, const auto& watch) { zoom_minus_z(subject.screen(), point, watch); });
}

}  // namespace gradus::perspective
