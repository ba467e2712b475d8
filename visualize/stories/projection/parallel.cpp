// The story of a parallel projection: how every corner of a solid goes to the picture plane along one
// direction, and what the picture keeps.

#include "projection/parallel/parallel.hpp"

#include "projection/parallel/parallel_notes.hpp"
#include "stories/projection/solids.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::parallel {
namespace {

using fmt::arg;
using solids::full_place_text;
using solids::place_text;
using solids::real;
using solids::vector_of;

constexpr std::string_view folder = "algorithms/projection/parallel/";

/// What is projected, and how.
struct Task {
  solids::Solid solid;
  std::string method;
  Axis axis = Axis::z;
  double d = 0;
  Slant<double> slant{};
  double foreshortening = 0;
  Plane<double> plane{};
  dvec3 direction{0};  ///< of the projectors, away from the viewer
  solids::Sheet sheet{};
};

/// Any direction of the sheet as it stands upright for whoever looks along `forward`.
solids::Sheet sheet_for(dvec3 origin, dvec3 forward) {
  const bool level = std::abs(forward.x) + std::abs(forward.z) > 1e-9 * std::abs(forward.y);
  const dvec3 right = unit_vector(glm::cross(level ? dvec3{0, 1, 0} : dvec3{0, 0, 1}, forward));
  return {origin, right, unit_vector(glm::cross(forward, right))};
}

/// The arguments' slant: from a direction if there is one, else from angle and foreshortening.
Slant<double> slant_in(const Arguments& arguments) {
  if (!arguments.numbers("direction").empty()) {
    const dvec3 direction = vector_of(arguments, "direction");
    if (!(std::abs(direction.z) > 1e-6 * (std::abs(direction.x) + std::abs(direction.y)))) {
      throw ArgumentError("direction",
                          "expected a direction that meets the plane z = d, its z is 0 or far too small");
    }
    return slant_of(direction);
  }
  const std::vector<double> receding = arguments.numbers("receding");
  if (!(0 <= receding[1] && receding[1] <= 10)) {
    throw ArgumentError("receding",
                        fmt::format("expected a foreshortening from 0 to 10, not {}", receding[1]));
  }
  const auto [sine, cosine] = sin_cos_degrees(receding[0]);
  return {-(receding[1] * cosine), -(receding[1] * sine)};
}

void read_plane(Task& task, const Arguments& arguments) {
  const std::vector<double> numbers = arguments.numbers("plane");
  task.plane = {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  const dvec3 normal = task.plane.normal;
  if (normal == dvec3{0}) throw ArgumentError("plane", "expected a normal that is not 0,0,0");
  const bool upright = arguments.numbers("direction").empty();
  task.direction = upright ? normal : vector_of(arguments, "direction");
  if (!meets(task.plane, task.direction)) {
    throw ArgumentError("direction", "expected a direction that meets the plane, not one parallel to it");
  }
  // The viewer looks forward, or else down
  const dvec3 v = task.direction;
  if (v.z < 0 || (v.z == 0 && v.y > 0)) task.direction = -v;
  const double sense = glm::dot(normal, task.direction) < 0 ? -1 : 1;
  task.sheet = sheet_for(task.plane.offset / glm::dot(normal, normal) * normal, sense * normal);
}

Task task_of(const Arguments& arguments) {
  Task task;
  task.method = arguments.text("method");
  task.d = *arguments.number("d");
  const std::vector<double> turn = arguments.numbers("turn");
  const solids::Solid solid = arguments.text("solid") == "box" ? solids::box() : solids::house();
  task.solid = solids::placed(solid, solids::turned_axes(turn[0], turn[1]), vector_of(arguments, "at"));
  if (task.method == "along") {
    read_plane(task, arguments);
  } else if (task.method == "orthographic") {
    const std::string& view = arguments.text("from");
    task.axis = view == "side" ? Axis::x : view == "top" ? Axis::y : Axis::z;
    if (task.axis == Axis::x) task.sheet = {{task.d, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    if (task.axis == Axis::y) task.sheet = {{0, task.d, 0}, {1, 0, 0}, {0, 0, 1}};
    if (task.axis == Axis::z) task.sheet = {{0, 0, task.d}, {1, 0, 0}, {0, 1, 0}};
    task.direction = task.axis == Axis::x   ? dvec3{-1, 0, 0}
                     : task.axis == Axis::y ? dvec3{0, -1, 0}
                                            : dvec3{0, 0, 1};
  } else {
    task.slant = slant_in(arguments);
    task.sheet = {{0, 0, task.d}, {1, 0, 0}, {0, 1, 0}};
    task.direction = {task.slant.a, task.slant.b, 1};
    task.foreshortening = glm::length(dvec2{task.slant.a, task.slant.b});
  }
  return task;
}

template <class O = Unobserved>
dvec3 image_of(const Task& task, dvec3 point, O&& observer = {}) {
  if (task.method == "orthographic") return orthographic(task.axis, task.d, point, observer);
  if (task.method == "along") return along(task.plane, task.direction, point, observer);
  if (task.method == "keep_x_and_y") return keep_x_and_y(task.d, task.slant, point, observer);
  return oblique(task.d, task.slant, point, observer);
}

using Images = solids::Scenery::Images;

Images images_of(const Task& task) {
  Images images;
  for (const dvec3 p : task.solid.corners) images.push_back(image_of(task, p));
  return images;
}

/// Where a slant takes the corners, whatever the method.
std::vector<dvec3> right_images(const Task& task) {
  std::vector<dvec3> images;
  if (task.method != "keep_x_and_y") return images;
  for (const dvec3 p : task.solid.corners) images.push_back(oblique(task.d, task.slant, p));
  return images;
}

class Teller {
 public:
  Teller(TraceWriter& writer, const Task& task)
      : writer_(writer),
        words_(writer.wording()),
        task_(task),
        right_(right_images(task)),
        scenery_(words_, task.solid, task.sheet, solids::hidden_along(task.solid, direction_seen()), {},
                 images_of(task), right_),
        images_(task.solid.corners.size()) {
    writer.trace().columns = {{"corner"}, {"point", false}, {"t"}, {"image", false}};
  }

  void begin() {
    show(view(), 0, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.level = Level::idea;
      step.sentence = opening();
    });
  }

  void project(std::size_t corner) {
    corner_ = corner;
    image_of(task_, task_.solid.corners[corner], *this);
  }

  void operator()(const Cast<double>& c, int line = __builtin_LINE(), const char* = nullptr) {
    t_ = c.t;
    View seen = view();
    scenery_.point_at(seen, corner_, {});
    fine(std::move(seen), line, [&](TraceStep& step) {
      step.type = "Cast";
      step.phase = words_.say("words.main_loop");
      step.key = fmt::format("{}", corner_);
      step.fields = {{"corner", corner_number()}, {"t", c.t}};
      step.sentence = casting(c);
    });
  }

  void operator()(const Projected<double>& p, int line = __builtin_LINE(), const char* = nullptr) {
    images_[corner_] = p.image;
    View seen = view();
    scenery_.point_at(seen, corner_, p.image);
    show(std::move(seen), line, [&](TraceStep& step) {
      step.type = "Projected";
      step.phase = words_.say("words.main_loop");
      step.key = fmt::format("{}", corner_);
      step.fields = {{"corner", corner_number()}, {"x", p.image.x}, {"y", p.image.y}, {"z", p.image.z}};
      step.sentence = projecting(p);
      step.row = {figure_number(corner_number()), place_text(p.point), real(t_), place_text(p.image)};
    });
  }

  void finish() {
    View seen = scenery_.empty();
    scenery_.add_images(seen, images_, Role::result);
    double worst = 0;
    for (std::size_t i = 0; i < right_.size(); ++i) {
      worst = std::max(worst, glm::distance(right_[i], *images_[i]));
    }
    add_right_picture(seen);
    show(std::move(seen), 0, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.sentence = ending(worst);
    });
    writer_.trace().result = {{"corners", static_cast<std::int64_t>(images_.size())}};
    if (!right_.empty()) writer_.trace().result.push_back({"largest_error", worst});
  }

 private:
  std::int64_t corner_number() const { return static_cast<std::int64_t>(corner_) + 1; }

  /// The notes' matrix looks straight ahead, whatever it was told.
  dvec3 direction_seen() const { return task_.method == "keep_x_and_y" ? dvec3{0, 0, 1} : task_.direction; }

  View view() const {
    View seen = scenery_.empty();
    scenery_.add_images(seen, images_, Role::past);
    return seen;
  }

  /// Beside the notes' picture, the one that its slant asks for, and how far a corner is off.
  void add_right_picture(View& seen) const {
    if (right_.empty()) return;
    const std::vector<bool> hidden = solids::hidden_along(task_.solid, task_.direction);
    for (std::size_t i = 0; i < task_.solid.edges.size(); ++i) {
      const solids::Edge& edge = task_.solid.edges[i];
      const dvec2 a = scenery_.in_picture(right_[edge.a]), b = scenery_.in_picture(right_[edge.b]);
      seen.add({fmt::format("f right {:02}", i), Role::accepted, Stroke{a, b, false, hidden[i]}});
    }
    const auto off = [&](std::size_t i) { return glm::distance(right_[i], *images_[i]); };
    std::size_t worst = 0;
    for (std::size_t i = 1; i < right_.size(); ++i) {
      if (off(i) > off(worst) + 1e-9) worst = i;
    }
    seen.add({"d off", Role::measure,
              Stroke{scenery_.in_picture(*images_[worst]), scenery_.in_picture(right_[worst])}});
  }

  std::string opening() const {
    const std::string d = real(task_.d), direction = place_text(task_.direction);
    if (task_.method == "orthographic") {
      constexpr std::string_view keys[] = {"parallel.started.side", "parallel.started.top",
                                           "parallel.started.front"};
      return words_.say(keys[static_cast<int>(task_.axis)], arg("d", d));
    }
    if (task_.method == "along") {
      return words_.say("parallel.started.along", arg("normal", place_text(task_.plane.normal)),
                        arg("direction", direction));
    }
    const bool notes = task_.method == "keep_x_and_y";
    return words_.say(notes ? "parallel.started.keep_x_and_y" : "parallel.started.oblique", arg("d", d),
                      arg("direction", direction));
  }

  std::string casting(const Cast<double>& c) const {
    if (task_.method == "along") {
      const dvec3 n = task_.plane.normal;
      return words_.say("parallel.cast.along", arg("corner", corner_number()),
                        arg("offset", real(task_.plane.offset)), arg("product", factor(glm::dot(n, c.point))),
                        arg("slope", factor(glm::dot(n, task_.direction))), arg("t", real(c.t)));
    }
    const double coordinate = c.point[static_cast<int>(task_.axis)];
    return words_.say("parallel.cast.axis", arg("corner", corner_number()), arg("d", real(task_.d)),
                      arg("coordinate", factor(coordinate)), arg("t", real(c.t)));
  }

  std::string projecting(const Projected<double>& p) const {
    const std::string image = place_text(p.image);
    if (task_.method == "orthographic") {
      constexpr std::string_view keys[] = {"parallel.projected.side", "parallel.projected.top",
                                           "parallel.projected.front"};
      return words_.say(keys[static_cast<int>(task_.axis)], arg("corner", corner_number()),
                        arg("d", real(task_.d)), arg("image", image));
    }
    if (task_.method == "along") {
      return words_.say("parallel.projected.along", arg("corner", corner_number()),
                        arg("point", full_place_text(p.point)), arg("t", factor(t_)),
                        arg("direction", full_place_text(task_.direction)),
                        arg("image", full_place_text(p.image)));
    }
    if (task_.method == "keep_x_and_y") {
      return words_.say("parallel.projected.keep_x_and_y", arg("image", image),
                        arg("right", place_text(right_[corner_])), arg("corner", corner_number()));
    }
    return words_.say("parallel.projected.oblique", arg("x", real(p.point.x)), arg("y", real(p.point.y)),
                      arg("t", factor(t_)), arg("a", factor(task_.slant.a)), arg("b", factor(task_.slant.b)),
                      arg("image_x", real(p.image.x)), arg("image_y", real(p.image.y)));
  }

  std::string ending(double worst) const {
    if (task_.method == "orthographic") return words_.say("parallel.done.orthographic");
    if (task_.method == "along") return words_.say("parallel.done.along");
    if (task_.method == "keep_x_and_y") {
      return words_.say("parallel.done.keep_x_and_y", arg("worst", real(worst)));
    }
    const double f = task_.foreshortening;
    const bool cavalier = std::abs(f - 1) < 1e-9, cabinet = std::abs(f - 0.5) < 1e-9;
    return words_.say(cavalier  ? "parallel.done.cavalier"
                      : cabinet ? "parallel.done.cabinet"
                                : "parallel.done.oblique",
                      arg("length", real(f)));
  }

  static std::string factor(double value) { return value < -1e-9 ? "(" + real(value) + ")" : real(value); }

  template <class Describe>
  void show(View seen, int line, Describe describe) {
    writer_.step(shown_.change_to(std::move(seen)), {}, line, describe);
  }
  template <class Describe>
  void fine(View seen, int line, Describe describe) {
    writer_.fine(shown_.change_to(std::move(seen)), {}, line, describe);
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Task& task_;
  std::vector<dvec3> right_;
  solids::Scenery scenery_;
  Images images_;
  Shown shown_;
  std::size_t corner_ = 0;
  double t_ = 0;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("parallel", std::move(name), standing);
  };
  static const std::vector<Method> methods{
      method("oblique", Standing::taught), method("orthographic", Standing::plain),
      method("along", Standing::plain), method("keep_x_and_y", Standing::faulty)};
  return methods;
}

/// What a projection's steps hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Cast<T>& c) const {
    to.type = "Cast";
    to.number("t", c.t);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Projected<T>& p) const {
    to.type = "Projected";
    to.point("image", p.image);
  }
};

/// The slant is the doubles' in all three.
void put_side_by_side(Trace& trace, const Task& task) {
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    for (const dvec3 corner : task.solid.corners) {
      const auto point = in_scalar<T>(corner);
      if (task.method == "orthographic") {
        orthographic(task.axis, T(task.d), point, observer);
      } else {
        oblique(T(task.d), Slant<T>{T(task.slant.a), T(task.slant.b)}, point, observer);
      }
    }
  });
}

Trace run(const Arguments& arguments, Recording recording) {
  const Task task = task_of(arguments);
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  const Wording& words = writer.wording();
  trace.subtitle = words.say("parallel.subtitle." + arguments.text("solid"));
  const bool faulty = task.method == "keep_x_and_y";
  introduce(trace, "parallel", arguments, faulty);
  trace.source_file = std::string(folder) + (faulty ? "parallel_notes.hpp" : "parallel.hpp");
  trace.listing = listing_of(source_text(trace.source_file), task.method);
  trace.grid = paper_grid(solids::paper_width, solids::paper_height);
  trace.legend = {{Role::input, words.say("parallel.legend.input")},
                  {Role::boundary, words.say("parallel.legend.boundary")},
                  {Role::current, words.say("parallel.legend.current")},
                  {Role::past, words.say("parallel.legend.past")},
                  {Role::result, words.say("parallel.legend.result")},
                  {Role::accepted, words.say("parallel.legend.right")},
                  {Role::measure, words.say("parallel.legend.off")}};
  Teller teller(writer, task);
  teller.begin();
  for (std::size_t i = 0; i < task.solid.corners.size(); ++i) teller.project(i);
  teller.finish();
  Trace told = std::move(writer).finish();
  told.telling = told.whole() ? StepNumber{told.last, 0} : middle_step(told);
  if (side_by_side(arguments)) {
    require_method(arguments, {"oblique", "orthographic"});
    put_side_by_side(told, task);
  }
  return told;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "parallel",
      .title = Wording().say("parallel.title"),
      .chapter = "projection",
      .aliases = {"parallel projection", "oblique projection", "orthographic projection", "cavalier",
                  "cabinet", "isometric"},
      .summary = "every point goes to the picture plane along one direction: orthographic and oblique",
      .methods = all_methods(),
      .default_method = "oblique",
      .parameters =
          {{.name = "solid",
            .type = ParameterType::choice,
            .default_value = "house",
            .example = "box",
            .help = "what is projected: 2 wide, 2 high, 3 deep",
            .choices = {"house", "box"}},
           {.name = "at",
            .type = ParameterType::numbers,
            .default_value = "2,2,4",
            .example = "0,0,5",
            .help = "where its middle stands: x right, y up, z forward",
            .parts = {"x", "y", "z"},
            .sizes = solids::modest_sizes},
           {.name = "turn",
            .type = ParameterType::numbers,
            .default_value = "0,0",
            .example = "30,0",
            .help = "degrees by which it is turned: round the upright, then round x",
            .parts = {"yaw", "pitch"},
            .sizes = solids::modest_sizes},
           {.name = "d",
            .type = ParameterType::number,
            .default_value = "0",
            .example = "1",
            .help = "where the picture plane crosses its axis: z = d, for the top view y = d, for the side x "
                    "= d",
            .sizes = solids::modest_sizes},
           {.name = "receding",
            .type = ParameterType::numbers,
            .default_value = "45,0.5",
            .example = "45,1",
            .help = "method oblique: the angle of receding edges in degrees, and how long a unit of depth is "
                    "drawn: 0.5 cabinet, 1 cavalier",
            .parts = {"angle", "foreshortening"},
            .sizes = solids::modest_sizes},
           {.name = "direction",
            .type = ParameterType::numbers,
            .default_value = "",
            .example = "1,-1,2",
            .help = "methods oblique and along: the projectors' direction instead",
            .parts = {"x", "y", "z"},
            .instead_of = "receding",
            .sizes = solids::modest_sizes},
           {.name = "from",
            .type = ParameterType::choice,
            .default_value = "front",
            .example = "top",
            .help = "method orthographic: from where one looks",
            .choices = {"front", "top", "side"}},
           {.name = "plane",
            .type = ParameterType::numbers,
            .default_value = "1,-1,1,-3",
            .example = "1,-2,2,-6",
            .help = "method along: the plane nx x + ny y + nz z = offset; without a direction seen upright, "
                    "which "
                    "is isometric for 1,-1,1",
            .parts = {"nx", "ny", "nz", "offset"},
            .sizes = solids::modest_sizes},
           exact_parameter()},
      .examples = {"--receding 45,1", "--method orthographic --from top", "--method along --plane 1,-1,1,-3"},
      .run = run};
  return topic;
}

}  // namespace gradus::parallel
