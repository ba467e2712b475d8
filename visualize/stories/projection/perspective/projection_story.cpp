// A solid's perspective picture, corner by corner.

#include "stories/past.hpp"
#include "stories/projection/perspective/stories.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::perspective {
namespace {

solids::Scenery::Images images_of(const solids::Solid& solid, double d) {
  solids::Scenery::Images images;
  for (const dvec3 p : solid.corners) images.push_back(project(d, p));
  return images;
}

/// x′ and y′ in a table: with two decimals, but three where they are small.
std::string picture_text(dvec3 image) {
  return figure_place(dvec2(image), [](double x) { return std::abs(x) < 1 ? real(x) : short_real(x); });
}

class ProjectionStory
    : public Past<steps::Started, Finer<Scaled<double>>, Projected<double>, Unseen<double>, steps::Finished> {
 public:
  ProjectionStory(const Words& words, double d, const solids::Solid& solid)
      : words_(words),
        d_(d),
        progress_({words.wording(),
                   solid,
                   {{0, 0, d}, {1, 0, 0}, {0, 1, 0}},
                   facing_origin(solid),
                   dvec3{0},
                   images_of(solid, d)}) {}

  void turn_to(std::size_t corner) { progress_.turn_to(corner); }
  std::int64_t unseen() const { return std::ssize(all<Unseen<double>>()); }
  const solids::Scenery& scenery() const { return progress_.scenery(); }

  template <class Step>
  void take(const Step& step) {
    Past::take(step);
    if constexpr (std::same_as<Step, Projected<double>>) progress_.arrive(step.image);
  }
  View draw() const {
    if (now<steps::Started>()) return progress_.drawing(false);
    if (!now<steps::Finished>()) return progress_.with_corner();
    return unseen() == 0 ? progress_.picture() : progress_.drawing(true);
  }

  Event say(const steps::Started&) const {
    return {.text = "started.projection", .words = {{"d", real(d_)}}, .level = Level::idea};
  }

  Event say(const Scaled<double>& s) const {
    return {.text = "scaled",
            .facts = {{"corner", progress_.number()}, {"factor", s.factor}},
            .words = {{"z", s.point.z}, {"d", real(d_)}, {"factor", real(s.factor)}},
            .key = progress_.key(),
            .phase = words_.wording().say(progress_.phase()),
            .decides = before_eye(words_, s.point.z)};
  }

  Event say(const Projected<double>& p) const {
    return {.text = "projected",
            .facts = {{"corner", progress_.number()}, {"x", p.image.x}, {"y", p.image.y}, {"z", p.image.z}},
            .words = {{"x", figure_factor(real(p.point.x))},
                      {"y", figure_factor(real(p.point.y))},
                      {"factor", real(last<Scaled<double>>()->factor)},
                      {"image_x", real(p.image.x)},
                      {"image_y", real(p.image.y)}},
            .row = {progress_.number(), place_text(p.point), real(last<Scaled<double>>()->factor),
                    picture_text(p.image)},
            .key = progress_.key(),
            .phase = words_.wording().say(progress_.phase()),
            .decides = before_eye(words_, p.point.z)};
  }

  Event say(const Unseen<double>& u) const {
    return {.text = "unseen",
            .facts = {{"corner", progress_.number()}},
            .words = {{"z", real(u.point.z)}},
            .row = {progress_.number(), place_text(u.point), "", words_.say("no_image")},
            .key = progress_.key(),
            .phase = words_.wording().say(progress_.phase()),
            .decides = before_eye(words_, u.point.z)};
  }

  Event say(const steps::Finished&) const {
    if (unseen() == 0) return {.text = "done.projection"};
    return {.text = "done.unseen", .count = unseen()};
  }

 private:
  const Words& words_;
  const double d_;
  solids::Progress progress_;
};

/// What the steps of a projection hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Scaled<T>& s) const {
    to.number("factor", s.factor);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Projected<T>& p) const {
    to.point("image", p.image);
  }
  template <class T>
  void operator()(NumericStep<T>&, const Unseen<T>&) const {}
};

}  // namespace

void tell_projection(Narrator& narrator) {
  const Arguments& arguments = narrator.arguments();
  const double d = distance_of(arguments);
  const bool house = arguments.text("solid") == "house";
  const solids::Solid solid =
      placed(house ? solids::house() : solids::box(), axes_of(arguments), vector_of(arguments, "at"));
  say_turn(narrator, house ? "subtitle.house" : "subtitle.box");
  narrator.paper(solids::paper_width, solids::paper_height);
  narrator.columns({{"corner"}, {"point", false}, {"factor"}, {"image", false}});
  narrator.legend({{Role::input, "solid"}, {Role::boundary, "plane"}, Role::result});
  ProjectionStory story(narrator.words(), d, solid);
  const solids::Scenery& scenery = story.scenery();
  const dvec3 at = vector_of(arguments, "at");
  narrator.handles("at", [&](dvec3 p) { return scenery.moved_in_space(at, p); });
  // All images, and the plane with them, grow from the eye
  const dvec3 lower = scenery.lower_corner(scenery.sheet());
  narrator.handle("distance", 0, scenery.in_space(lower),
                  scenery.in_space(lower / d) - scenery.in_space(dvec3{0}));
  narrator.tell_each(story, solid.corners.size(),
                     [&](std::size_t i, const auto& watch) { project(d, solid.corners[i], watch); });
  narrator.result({{"images", std::ssize(solid.corners) - story.unseen()}});
  tell_side_by_side<Numbers>(narrator, [d, solid]<class T>(T, const auto& observer) {
    for (const dvec3 corner : solid.corners) project(T(d), in_scalar<T>(corner), observer);
  });
}

}  // namespace gradus::perspective
