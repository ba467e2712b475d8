// The story of a parallel projection: how every corner of a solid goes to the picture plane along one
// direction, and what the picture keeps.

#include "projection/parallel/parallel.hpp"

#include "projection/parallel/parallel_notes.hpp"
#include "stories/parameters.hpp"
#include "stories/projection/solids.hpp"
#include "stories/side_by_side.hpp"
#include "stories/telling.hpp"

namespace gradus::parallel {
namespace {

using solids::full_place_text;
using solids::place_text;
using solids::real;
using solids::vector_of;

using Images = solids::Scenery::Images;

/// What is projected, how, and in which words.
struct Subject {
  solids::Solid solid;
  double d = 0;
  Axis axis = Axis::z;
  Slant<double> slant{};
  Plane<double> plane{};
  dvec3 direction{0};  ///< of the projectors, away from the viewer
  dvec3 shown{0};      ///< the direction that the picture is seen along; a wrong method has one of its own
  solids::Sheet sheet{};
  std::vector<dvec3> right{};  ///< where the corners should go; empty: where they do
  std::string_view started{}, cast{}, projected{}, done{};
  bool all_digits = false;  ///< of the image, in a sentence that a reader may check
};

// --- The steps

/// In brackets where a negative number is a factor or taken away.
std::string factor(double value) { return figure_factor(real(value)); }

class Story {
 public:
  Story(const Words& words, const Subject& subject, const Images& images)
      : words_(words),
        subject_(subject),
        progress_({words.wording(),
                   subject.solid,
                   subject.sheet,
                   facing_along(subject.solid, subject.shown),
                   {},
                   images,
                   subject.right}) {}

  void turn_to(std::size_t corner) { progress_.turn_to(corner); }
  const solids::Scenery& scenery() const { return progress_.scenery(); }

  void show(Board& board, const steps::Started&) { board.milestone(progress_.drawing(false)); }
  Event say(const steps::Started&) const {
    return {.text = subject_.started,
            .words = {{"d", real(subject_.d)},
                      {"normal", place_text(subject_.plane.normal)},
                      {"direction", place_text(subject_.direction)}},
            .level = Level::idea};
  }

  void show(Board& board, const Cast<double>& c) {
    t_ = c.t;
    board.detail(progress_.with_corner());
  }
  Event say(const Cast<double>& c) const {
    const dvec3 n = subject_.plane.normal;
    return {.text = subject_.cast,
            .facts = {{"corner", progress_.number()}, {"t", c.t}},
            .words = {{"d", real(subject_.d)},
                      {"coordinate", factor(c.point[static_cast<int>(subject_.axis)])},
                      {"offset", real(subject_.plane.offset)},
                      {"product", factor(glm::dot(n, c.point))},
                      {"slope", factor(glm::dot(n, subject_.direction))},
                      {"t", real(c.t)}},
            .key = progress_.key(),
            .phase = words_.wording().say(progress_.phase())};
  }

  void show(Board& board, const Projected<double>& p) {
    progress_.arrive(p.image);
    board.milestone(progress_.with_corner());
  }
  Event say(const Projected<double>& p) const {
    const dvec3 right = subject_.right.empty() ? p.image : subject_.right[progress_.corner()];
    const std::string image = subject_.all_digits ? full_place_text(p.image) : place_text(p.image);
    const dvec2 shift = dvec2(subject_.slant.a, subject_.slant.b) * (t_ < 0 ? -1.0 : 1.0);
    return {.text = !subject_.projected.empty() ? subject_.projected
                    : t_ < 0                    ? "projected.before"
                    : t_ > 0                    ? "projected.behind"
                                                : "projected.within",
            .facts = {{"corner", progress_.number()}, {"x", p.image.x}, {"y", p.image.y}, {"z", p.image.z}},
            .words = {{"d", real(subject_.d)},
                      {"x", real(p.point.x)},
                      {"y", real(p.point.y)},
                      {"t", factor(t_)},
                      {"gap", real(std::abs(t_))},
                      {"shift", figure_place(shift, real)},
                      {"a", factor(shift.x)},
                      {"b", factor(shift.y)},
                      {"image_x", real(p.image.x)},
                      {"image_y", real(p.image.y)},
                      {"point", full_place_text(p.point)},
                      {"direction", full_place_text(subject_.direction)},
                      {"image", image},
                      {"right", place_text(right)}},
            .row = {progress_.number(), place_text(p.point), real(t_), place_text(p.image)},
            .key = progress_.key(),
            .phase = words_.wording().say(progress_.phase())};
  }

  void show(Board& board, const steps::Finished&) {
    if (subject_.right.empty()) return board.milestone(progress_.picture());
    View view = progress_.drawing(true);
    add_right_picture(view);
    board.milestone(std::move(view));
  }
  Event say(const steps::Finished&) const {
    return {.text = subject_.done,
            .words = {{"length", real(glm::length(dvec2{subject_.slant.a, subject_.slant.b}))},
                      {"worst", real(largest_error())}}};
  }

  double largest_error() const {
    double largest = 0;
    for (std::size_t i = 0; i < subject_.right.size(); ++i) largest = std::max(largest, error(i));
    return largest;
  }

 private:
  double error(std::size_t i) const { return glm::distance(subject_.right[i], *progress_.images()[i]); }

  /// Beside the notes' picture, the one that its slant asks for, and how far a corner is off.
  void add_right_picture(View& view) const {
    const solids::Scenery& scenery = progress_.scenery();
    const solids::Facing facing = facing_along(subject_.solid, subject_.direction);
    for (std::size_t i = 0; i < subject_.solid.edges.size(); ++i) {
      const solids::Edge& edge = subject_.solid.edges[i];
      const dvec2 a = scenery.in_picture(subject_.right[edge.a]),
                  b = scenery.in_picture(subject_.right[edge.b]);
      Stroke stroke{a, b, false, facing.hidden[i]};
      stroke.thin = stroke.dashed;
      view.add({fmt::format("d right {:02}", i), Role::accepted, stroke});
    }
    std::size_t worst = 0;
    for (std::size_t i = 1; i < subject_.right.size(); ++i) {
      if (error(i) > error(worst) + 1e-9) worst = i;
    }
    const dvec2 from = scenery.in_picture(*progress_.images()[worst]);
    view.add({"e off", Role::measure, Stroke{from, scenery.in_picture(subject_.right[worst])}});
  }

  const Words& words_;
  const Subject& subject_;
  solids::Progress progress_;
  double t_ = 0;
};

// --- The arguments

Subject subject_of(const Arguments& arguments) {
  Subject subject;
  subject.d = *arguments.number("d");
  subject.cast = "cast.axis";
  const std::vector<double> turn = arguments.numbers("turn");
  const solids::Solid solid = arguments.text("solid") == "box" ? solids::box() : solids::house();
  subject.solid = placed(solid, solids::turned_axes(turn[0], turn[1]), vector_of(arguments, "at"));
  return subject;
}

/// The arguments' slant: from a direction if there is one, else from angle and foreshortening.
Slant<double> slant_in(const Arguments& arguments) {
  if (!arguments.numbers("direction").empty()) {
    const dvec3 direction = vector_of(arguments, "direction");
    if (!(std::abs(direction.z) > 1e-6 * (std::abs(direction.x) + std::abs(direction.y)))) {
      refuse("direction", "expected a direction that meets the plane z = d, its z is 0 or far too small");
    }
    return slant_of(direction);
  }
  const std::vector<double> receding = arguments.numbers("receding");
  if (!(0 <= receding[1] && receding[1] <= 10)) {
    refuse("receding", "expected a foreshortening from 0 to 10, not {}", receding[1]);
  }
  const auto [sine, cosine] = sin_cos_degrees(receding[0]);
  return {-(receding[1] * cosine), -(receding[1] * sine)};
}

/// Projectors that lean, onto z = d.
Subject leaning(const Arguments& arguments) {
  Subject subject = subject_of(arguments);
  subject.slant = slant_in(arguments);
  subject.sheet = {{0, 0, subject.d}, {1, 0, 0}, {0, 1, 0}};
  subject.direction = subject.shown = {subject.slant.a, subject.slant.b, 1};
  return subject;
}

/// Projectors that stand upright on a plane across an axis.
Subject upright(const Arguments& arguments) {
  Subject subject = subject_of(arguments);
  const std::string& view = arguments.text("from");
  subject.axis = view == "side" ? Axis::x : view == "top" ? Axis::y : Axis::z;
  const dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const solids::Sheet sheets[] = {{dvec3(0), z, y}, {dvec3(0), x, z}, {dvec3(0), x, y}};
  const dvec3 directions[] = {{-1, 0, 0}, {0, -1, 0}, z};
  const int axis = static_cast<int>(subject.axis);
  subject.sheet = sheets[axis];
  subject.sheet.origin[axis] = subject.d;
  subject.direction = subject.shown = directions[axis];
  return subject;
}

/// Any direction of the sheet as it stands upright for a viewer who looks along `forward`.
solids::Sheet sheet_for(dvec3 origin, dvec3 forward) {
  const bool level = std::abs(forward.x) + std::abs(forward.z) > 1e-9 * std::abs(forward.y);
  const dvec3 right = unit_vector(glm::cross(level ? dvec3{0, 1, 0} : dvec3{0, 0, 1}, forward));
  return {origin, right, unit_vector(glm::cross(forward, right))};
}

/// The sheet of a plane, seen by who looks along `direction`.
solids::Sheet sheet_of(dvec3 normal, double offset, dvec3 direction) {
  const double sense = glm::dot(normal, direction) < 0 ? -1 : 1;
  return sheet_for(offset / glm::dot(normal, normal) * normal, sense * normal);
}

/// Onto any plane.
Subject onto_plane(const Arguments& arguments) {
  Subject subject = subject_of(arguments);
  const std::vector<double> numbers = arguments.numbers("plane");
  subject.plane = {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  const dvec3 normal = subject.plane.normal;
  if (normal == dvec3{0}) refuse("plane", "expected a normal that is not 0,0,0");
  const bool upright = arguments.numbers("direction").empty();
  const dvec3 v = upright ? normal : vector_of(arguments, "direction");
  if (!meets(subject.plane, v)) {
    refuse("direction", "expected a direction that meets the plane, not one parallel to it");
  }
  // The viewer looks forward, or else down
  subject.direction = subject.shown = v.z < 0 || (v.z == 0 && v.y > 0) ? -v : v;
  subject.sheet = sheet_of(normal, subject.plane.offset, subject.direction);
  return subject;
}

// --- The methods

/// What of the scene can be dragged: the solid; and the plane, whose corners go where the images go.
void let_drag(Narrator& narrator, const Subject& subject, const solids::Scenery& scenery) {
  const dvec3 at = vector_of(narrator.arguments(), "at");
  narrator.handles("at", [&](dvec3 p) { return scenery.moved_in_space(at, p); });
  const dvec3 corner = scenery.lower_corner(subject.sheet), normal = subject.plane.normal;
  const bool any = normal != dvec3{0};
  const double speed = any ? glm::dot(normal, subject.shown) : subject.shown[static_cast<int>(subject.axis)];
  const dvec2 along = scenery.in_space(corner + subject.shown / speed) - scenery.in_space(corner);
  narrator.handle(any ? "plane" : "d", any ? 3 : 0, scenery.in_space(corner), along);
  if (!any) return;
  narrator.handles("plane", [&](dvec3 n) {
    const solids::Sheet sheet = sheet_of(n, subject.plane.offset, subject.direction);
    return scenery.in_space(scenery.upper_corner(sheet));
  });
}

/// project(point, observer...): where the method takes a point.
template <class Project>
void tell_corners(Narrator& narrator, const Subject& subject, const Project& project) {
  narrator.trace().subtitle = narrator.words().say("subtitle." + narrator.arguments().text("solid"));
  narrator.paper(solids::paper_width, solids::paper_height);
  narrator.legend(
      {Role::input, Role::boundary, Role::result, {Role::accepted, "right"}, {Role::measure, "off"}});
  Images images;
  for (const dvec3 p : subject.solid.corners) images.push_back(project(p));
  Story story(narrator.words(), subject, images);
  let_drag(narrator, subject, story.scenery());
  narrator.tell_each(story, images.size(),
                     [&](std::size_t i, const auto& watch) { project(subject.solid.corners[i], watch); });
  std::vector<Field> result{{"corners", std::ssize(images)}};
  if (!subject.right.empty()) result.push_back({"largest_error", story.largest_error(), "error"});
  narrator.result(std::move(result));
}

/// What a projection's steps hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Cast<T>& c) const {
    to.number("t", c.t);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Projected<T>& p) const {
    to.point("image", p.image);
  }
};

/// The same, in other arithmetics too. The slant is the doubles' in all three.
template <class Project>
void tell_exact_corners(Narrator& narrator, const Subject& subject, const Project& project) {
  tell_corners(narrator, subject, project);
  tell_side_by_side<Numbers>(narrator,
                             [corners = subject.solid.corners, project]<class T>(T, const auto& observer) {
                               for (const dvec3 corner : corners) project(in_scalar<T>(corner), observer);
                             });
}

void tell_oblique(Narrator& narrator) {
  Subject subject = leaning(narrator.arguments());
  const double foreshortening = glm::length(dvec2{subject.slant.a, subject.slant.b});
  const bool cavalier = std::abs(foreshortening - 1) < 1e-9, cabinet = std::abs(foreshortening - 0.5) < 1e-9;
  subject.started = "started.oblique";
  subject.done = cavalier ? "done.cavalier" : cabinet ? "done.cabinet" : "done.oblique";
  tell_exact_corners(
      narrator, subject,
      [d = subject.d, slant = subject.slant]<class T>(const glm::vec<3, T>& point, const auto&... observer) {
        return oblique(T(d), Slant<T>{T(slant.a), T(slant.b)}, point, observer...);
      });
}

void tell_orthographic(Narrator& narrator) {
  Subject subject = upright(narrator.arguments());
  constexpr std::string_view started[]{"started.side", "started.top", "started.front"};
  constexpr std::string_view projected[]{"projected.side", "projected.top", "projected.front"};
  subject.started = started[static_cast<int>(subject.axis)];
  subject.projected = projected[static_cast<int>(subject.axis)];
  subject.done = "done.orthographic";
  tell_exact_corners(
      narrator, subject,
      [d = subject.d, axis = subject.axis]<class T>(const glm::vec<3, T>& point, const auto&... observer) {
        return orthographic(axis, T(d), point, observer...);
      });
}

void tell_along(Narrator& narrator) {
  Subject subject = onto_plane(narrator.arguments());
  subject.started = "started.along";
  subject.cast = "cast.along";
  subject.projected = "projected.along";
  subject.all_digits = true;
  subject.done = "done.along";
  tell_corners(narrator, subject, [&subject](dvec3 point, const auto&... observer) {
    return along(subject.plane, subject.direction, point, observer...);
  });
}

/// The notes' matrix looks straight ahead, for any direction.
void tell_keep_x_and_y(Narrator& narrator) {
  Subject subject = leaning(narrator.arguments());
  subject.shown = {0, 0, 1};
  for (const dvec3 p : subject.solid.corners) subject.right.push_back(oblique(subject.d, subject.slant, p));
  subject.started = "started.keep_x_and_y";
  subject.projected = "projected.keep_x_and_y";
  subject.done = "done.keep_x_and_y";
  tell_corners(narrator, subject, [&subject](dvec3 point, const auto&... observer) {
    return keep_x_and_y(subject.d, subject.slant, point, observer...);
  });
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "parallel",
       .chapter = "projection",
       .aliases = {"parallel projection", "oblique projection", "orthographic projection", "cavalier",
                   "cabinet", "isometric"},
       .summary = "every point goes to the picture plane along one direction: orthographic and oblique",
       .methods = {{.name = "oblique", .standing = Standing::taught, .tell = tell_oblique, .exact = true},
                   {.name = "orthographic", .tell = tell_orthographic, .exact = true},
                   {.name = "along", .tell = tell_along},
                   {.name = "keep_x_and_y", .standing = Standing::faulty, .tell = tell_keep_x_and_y}},
       .columns = {{"corner"}, {"point", false}, {"t"}, {"image", false}},
       .parameters =
           {choice("solid", {"house", "box"}, "house", "box", "what is projected: 2 wide, 2 high, 3 deep"),
            numbers("at", "2,2,4", "0,0,5", "where its middle stands: x right, y up, z forward", xyz,
                    solids::modest_sizes),
            numbers("turn", "0,0", "30,0", "degrees by which it is turned: round the upright, then round x",
                    {"yaw", "pitch"}, solids::modest_sizes),
            number(
                "d", "0", "1",
                "where the picture plane crosses its axis: z = d, for the top view y = d, for the side x = d",
                solids::modest_sizes),
            numbers("receding", "45,0.5", "45,1",
                    "method oblique: the angle of receding edges in degrees, and how long a unit of depth is "
                    "drawn: 0.5 cabinet, 1 cavalier",
                    {"angle", "foreshortening"}, solids::modest_sizes),
            instead_of("receding", numbers("direction", "", "1,-1,2",
                                           "methods oblique and along: the projectors' direction instead",
                                           xyz, solids::modest_sizes)),
            choice("from", {"front", "top", "side"}, "front", "top",
                   "method orthographic: from where one looks"),
            numbers("plane", "1,-1,1,-3", "1,-2,2,-6",
                    "method along: the plane nx x + ny y + nz z = offset; without a direction seen upright, "
                    "which is isometric for 1,-1,1",
                    {"nx", "ny", "nz", "offset"}, solids::modest_sizes),
            exact_parameter()},
       .examples = {"--receding 45,1", "--method orthographic --from top",
                    "--method along --plane 1,-1,1,-3"}});
  return topic;
}

}  // namespace gradus::parallel
