// A line from above, before and after the transformation: straight, or bent, when z stays as it is. A wall
// stands behind its middle.

#include "projection/perspective/perspective_notes.hpp"
#include "stories/past.hpp"
#include "stories/projection/perspective/stories.hpp"

namespace gradus::perspective {
namespace {

struct BentSubject {
  bool bent;  ///< the notes' transformation
  double near, far, wall;
  dvec3 from, to;
  int samples;  ///< between the ends

  Projection<double> projection() const { return projection_of(near, near, near, far); }
  dvec3 image_of(dvec3 p) const { return bent ? *keep_z(near, p) : divide(transform(projection(), p)); }
  double depth_of_wall() const { return image_of({0, 0, wall}).z; }
};

BentSubject subject_of(const Arguments& arguments, bool bent) {
  const BentSubject subject{.bent = bent,
                            .near = distance_of(arguments),
                            .far = *arguments.number("far"),
                            .wall = *arguments.number("wall"),
                            .from = vector_of(arguments, "from"),
                            .to = vector_of(arguments, "to"),
                            .samples = static_cast<int>(arguments.integer("samples"))};
  if (!(subject.far > subject.near)) {
    refuse(arguments, {"far", "distance"},
           fmt::format("expected a far plane beyond the distance {}, not at {}", subject.near, subject.far));
  }
  const auto between = [&](std::string_view name, double z) {
    if (subject.near <= z && z <= subject.far) return;
    refuse(arguments, {name, "distance", "far"},
           fmt::format("expected a depth z of {} from the distance {} to the far plane {}, not {}", name,
                       subject.near, subject.far, z));
  };
  between("from", subject.from.z);
  between("to", subject.to.z);
  between("wall", subject.wall);
  const double a = subject.image_of(subject.from).x, b = subject.image_of(subject.to).x;
  if (std::abs(a - b) < 1e-6 * (std::abs(a) + std::abs(b))) {
    refuse(arguments, {"to", "from"}, "expected a line whose ends are seen at two different x");
  }
  return subject;
}

/// A point of the line.
struct Sample {
  std::string name;
  dvec3 point;
};

/// The ends first, for the straight line runs between them.
std::vector<Sample> samples_of(const BentSubject& subject) {
  std::vector<Sample> samples{{"A", subject.from}, {"B", subject.to}};
  for (int i = 1; i <= subject.samples; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(subject.samples + 1);
    samples.push_back({fmt::format("M{}", i), subject.from + share * (subject.to - subject.from)});
  }
  return samples;
}

class BentStory
    : public Past<steps::Started, Finer<Multiplied<double>>, Divided<double>, Finer<Scaled<double>>,
                  Projected<double>, Untold<Unseen<double>>, steps::Finished> {
 public:
  BentStory(const Words& words, const BentSubject& subject)
      : words_(words),
        subject_(subject),
        a_(subject.image_of(subject.from)),
        b_(subject.image_of(subject.to)) {
    Extent space, image;
    for (const dvec3 p : {subject.from, subject.to}) space.add({p.x, p.z});
    space.add({0, 0});
    space.add({0, std::min(subject.far, std::max({subject.from.z, subject.to.z, subject.wall}) * 1.1)});
    space_ = Panel(space_place, widened(space, 0.02));
    const double least = std::min(a_.x, b_.x), most = std::max(a_.x, b_.x), margin = 0.12 * (most - least);
    for (const double z : {a_.z, b_.z, subject.depth_of_wall()}) {
      image.add({least - margin, depth(z)});
      image.add({most + margin, depth(z)});
    }
    image.lower.y -= 0.1 * image.size().y;
    image.upper.y += 0.1 * image.size().y;
    image_ = Panel({{21.8, 2.6}, {35.2, 21.4}}, image, Panel::Fit::stretched);
  }

  const Panel& image_panel() const { return image_; }
  const Panel& space_panel() const { return space_; }
  const std::vector<Sample>& samples() const { return samples_; }
  /// The largest error so far.
  double worst() const { return worst_at() ? error_at(image(*worst_at())) : 0; }

  Event say(const steps::Started&) const {
    return {.text = subject_.bent ? "started.keep_z" : "started.transformation",
            .words = {{"wall", real(subject_.wall)},
                      {"near", real(subject_.near)},
                      {"far", real(subject_.far)},
                      {"first", depth(0)},
                      {"last", depth(1)}},
            .level = Level::idea};
  }

  Event say(const Multiplied<double>& m) const {
    return {.text = "multiplied",
            .facts = {{"point", at_hand().name}, {"clip_z", m.clip.z, "z"}, {"w", m.clip.w}},
            .words = {{"name", at_hand().name},
                      {"x", real(m.clip.x)},
                      {"z", real(words_.notation().clip_depth_of(m.clip.z, m.clip.w))}},
            .key = at_hand().name};
  }
  Event say(const Divided<double>&) const { return told(); }

  Event say(const Scaled<double>& s) const {
    return {.text = "scaled_point",
            .facts = {{"point", at_hand().name}, {"factor", s.factor}},
            .words = {{"name", at_hand().name},
                      {"d", real(subject_.near)},
                      {"z", s.point.z},
                      {"factor", real(s.factor)}},
            .key = at_hand().name,
            .decides = before_eye(words_, s.point.z)};
  }
  Event say(const Projected<double>& p) const {
    Event event = told();
    if (!event.decides) event.decides = before_eye(words_, p.point.z);
    return event;
  }

  Event say(const steps::Finished&) const {
    const double wall = subject_.depth_of_wall();
    bool wrong_surface = false;
    for (std::size_t i = 2; i < arrived(); ++i)
      wrong_surface |= (image(i).z < wall) != (interpolated(image(i).x).z < wall);
    return {.text = is_off(worst()) ? (wrong_surface ? "done.wrong_surface" : "done.bent")
                    : subject_.bent ? "done.level"
                                    : "done.transformation",
            .facts = {{"largest_error", worst(), "error"}},
            .words = {{"error", real(difference(worst()))}, {"wall", real(subject_.wall)}}};
  }

  View draw() const {
    View seen = view();
    if (now<steps::Finished>() && worst_at()) add_error(seen, image(*worst_at()));
    if (now<steps::Started>() || now<steps::Finished>()) return seen;
    const auto& [name, point] = at_hand();
    seen.add({"d ray", Role::current, Stroke{space_.at({0, 0}), in_space(point), false, true}});
    seen.add_named("e space " + name, "f space name " + name, Role::current, in_space(point), name);
    if (arrived() <= turn()) return seen;
    const dvec3 here = image(turn());
    seen.add_named("e image " + name, "f image name " + name, Role::current, in_image(here), name + "′");
    if (turn() >= 2) add_error(seen, here);
    return seen;
  }

 private:
  /// Beside rounding, which depths of this line's size have.
  bool is_off(double error) const {
    return std::abs(error) > 1e-9 * std::max({std::abs(a_.z), std::abs(b_.z), 1e-3});
  }
  dvec2 in_space(dvec3 p) const { return space_.at({p.x, p.z}); }
  dvec2 in_image(dvec3 p) const { return image_.at({p.x, depth(p.z)}); }
  /// A depth after the transformation, and a difference of two, in the reader's notation; the notes keep z.
  double depth(double z) const { return subject_.bent ? z : words_.notation().depth_of(z); }
  double difference(double z) const { return depth(z) - depth(0); }
  /// What stands between A and B at this x: a scan line's depth.
  dvec3 interpolated(double x) const { return {x, 0, interpolated_depth(a_, b_, x)}; }
  double error_at(dvec3 image) const { return interpolated(image.x).z - image.z; }

  // --- A point has its image

  const Sample& at_hand() const { return samples_[turn()]; }
  /// How many have theirs.
  std::size_t arrived() const { return all<Divided<double>>().size() + all<Projected<double>>().size(); }
  dvec3 image(std::size_t i) const {
    return subject_.bent ? all<Projected<double>>()[i].image : all<Divided<double>>()[i].ndc;
  }
  std::optional<std::size_t> worst_at() const {
    std::optional<std::size_t> worst;
    double most = 0;
    for (std::size_t i = 2; i < arrived(); ++i) {
      const double error = std::abs(error_at(image(i)));
      if (error > most) worst = i, most = error;
    }
    return worst;
  }

  Event told() const {
    const dvec3 point = at_hand().point, image = this->image(turn());
    const std::string place =
        fmt::format("{} ({},\u00a0{})", at_hand().name, short_real(point.x), short_real(point.z));
    Event event{.text = "end_point",
                .facts = {{"point", at_hand().name}, {"x", image.x}, {"z", image.z}},
                .words = {{"name", at_hand().name}, {"x", real(image.x)}, {"z", real(depth(image.z))}},
                .row = {place, real(image.x), real(depth(image.z))},
                .key = at_hand().name};
    if (turn() < 2) return event;
    const double guess = interpolated(image.x).z, error = error_at(image);
    event.text = is_off(error) ? "off_the_line" : "on_the_line";
    event.facts.push_back({"error", error});
    event.words.push_back({"guess", real(depth(guess))});
    event.row.insert(event.row.end(), {real(depth(guess)), real(difference(error))});
    event.decides = before_wall(guess);
    return event;
  }

  /// The depth that a scan line has there.
  Decision before_wall(double guess) const {
    const double wall = subject_.depth_of_wall();
    const bool grows = depth(0) < depth(1);
    return yes_or_no(words_, grows ? "question.before_wall" : "question.before_wall_falling",
                     {{"name", at_hand().name}, {"guess", real(depth(guess))}, {"wall", real(depth(wall))}},
                     guess < wall, "nearer", "farther");
  }

  // --- The drawing

  View view() const {
    View view;
    add_captions(view, words_, words_.say("transformed"));
    add_axes(view, space_, "space", {words_.symbol("x"), words_.symbol("z")}, 5);
    add_axes(view, image_, "image", {words_.symbol("x′"), words_.symbol("z′")}, 5);
    add_space(view);
    add_wall_in_image(view);
    if (arrived() >= 2) add_line_in_image(view);
    for (std::size_t i = 0; i < arrived(); ++i) {
      const auto& [name, point] = samples_[i];
      view.add({"e space " + name, Role::past, Dot{in_space(point)}});
      view.add({"e image " + name, Role::past, Dot{in_image(image(i))}});
      if (i >= 2) continue;
      view.add({"f space name " + name, Role::input, Label{in_space(point), name}});
      view.add({"f image name " + name, Role::input, Label{in_image(image(i)), name + "′"}});
    }
    return view;
  }

  void add_space(View& view) const {
    const Extent shown = space_.shown();
    const auto level = [&](double depth) {
      return Stroke{space_.at({shown.lower.x, depth}), space_.at({shown.upper.x, depth})};
    };
    view.add({"a plane", Role::guide, level(subject_.near)});
    view.add({"b wall", Role::boundary, level(subject_.wall)});
    view.add({"f wall name in space", Role::boundary,
              Label{space_.at({shown.upper.x - 0.1 * shown.size().x, subject_.wall}), words_.say("wall")}});
    view.add({"c line", Role::input, Stroke{in_space(subject_.from), in_space(subject_.to)}});
    view.add_named("e eye", "f eye name", Role::input, space_.at({0, 0}), words_.shared("projection", "eye"));
  }

  void add_wall_in_image(View& view) const {
    const Extent shown = image_.shown();
    const double wall = depth(subject_.depth_of_wall());
    view.add({"b wall image", Role::boundary,
              Stroke{image_.at({shown.lower.x, wall}), image_.at({shown.upper.x, wall})}});
    view.add({"f wall name", Role::boundary,
              Label{image_.at({shown.upper.x - 0.08 * shown.size().x, wall}), words_.say("wall")}});
  }

  /// What became of the line, and where it was bent what a scan line draws.
  void add_line_in_image(View& view) const {
    const Stroke chord{in_image(a_), in_image(b_)};
    if (!subject_.bent) return view.add({"d curve", Role::result, chord});
    view.add({"c chord", Role::candidate, chord});
    std::vector<dvec2> curve;
    constexpr int pieces = 64;
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      curve.push_back(in_image(subject_.image_of(subject_.from + share * (subject_.to - subject_.from))));
    }
    view.add({"d curve", Role::result, Path{curve, false}});
  }

  void add_error(View& view, dvec3 image) const {
    const dvec3 on_chord = interpolated(image.x);
    const double error = on_chord.z - image.z;
    if (!is_off(error)) return;
    view.add({"d error", Role::measure, Stroke{in_image(image), in_image(on_chord), false, false, true}});
    view.add({"f error name", Role::measure,
              Label{0.5 * (in_image(image) + in_image(on_chord)),
                    words_.say("error", {{"error", real(difference(error))}})}});
  }

  const Words& words_;
  const BentSubject& subject_;
  const dvec3 a_, b_;  ///< the ends' images
  Panel space_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}}, image_ = space_;
  const std::vector<Sample> samples_ = samples_of(subject_);
};

/// The ends of the line, the plane at its left end and the wall at its right one.
void let_drag(Narrator& narrator, const BentSubject& subject, const Panel& space) {
  for (const std::string_view end : {"from", "to"})
    narrator.handles(end, [&](dvec3 p) { return space.at({p.x, p.z}); });
  const auto [lower, upper] = space.shown();
  const dvec2 along{0, space.scale().y};
  narrator.handle("distance", 0, space.at({lower.x, subject.near}), along);
  narrator.handle("wall", 0, space.at({upper.x, subject.wall}), along);
}

/// take(point, observer): what the method does with a point.
template <class Take>
void tell_line(Narrator& narrator, const BentSubject& subject, const Take& take) {
  BentStory story(narrator.words(), subject);
  require_scale(story.image_panel(), narrator.arguments(), {"from", "to", "wall", "distance", "far"});
  let_drag(narrator, subject, story.space_panel());
  narrator.subtitle("subtitle.line", {{"from", place_text(subject.from)}, {"to", place_text(subject.to)}});
  narrator.paper(solids::paper_width, paper_height);
  narrator.columns({{"point", false}, {"x_image"}, {"z_image"}, {"interpolated"}, {"error"}});
  narrator.legend({{Role::current, "point"},
                   {Role::result, "true_line"},
                   {Role::candidate, "interpolated"},
                   {Role::measure, "error"}});
  narrator.tell_each(story, story.samples().size(),
                     [&](std::size_t i, const auto& watch) { take(story.samples()[i].point, watch); });
  narrator.result({{"largest_error", story.worst(), "error"}});
}

}  // namespace

void tell_transformation(Narrator& narrator) {
  const BentSubject subject = subject_of(narrator.arguments(), false);
  narrator.list_below("divide");
  narrator.shows_depths();
  tell_line(narrator, subject, [&subject](dvec3 point, const auto& watch) {
    divide(transform(subject.projection(), point, watch), watch);
  });
}

void tell_keep_z(Narrator& narrator) {
  const BentSubject subject = subject_of(narrator.arguments(), true);
  tell_line(narrator, subject,
            [&subject](dvec3 point, const auto& watch) { keep_z(subject.near, point, watch); });
}

}  // namespace gradus::perspective
