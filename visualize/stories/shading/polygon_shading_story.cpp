// The story of flat, Gouraud and Phong shading: where light is computed, what is mixed on the way, and how
// far the picture is from light at every pixel.

#include "core/geometry.hpp"
#include "shading/polygon_shading/polygon_shading.hpp"

#include "shading/polygon_shading/polygon_shading_notes.hpp"
#include "stories/parameters.hpp"
#include "stories/shading/polygon_shading/normals_story.hpp"
#include "stories/shading/polygon_shading/pictures.hpp"
#include "stories/shading/polygon_shading/subject.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::polygon_shading {
namespace {

/// A face is about to be shaded.
struct FaceTaken {
  std::size_t face;
};

/// What the three methods have in common: faces, scan lines, pixels.
class ShadeStory {
 public:
  ShadeStory(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}

  const Worst& worst() const { return worst_; }
  std::int64_t lights() const { return lights_; }

  void show(Board& board, const steps::Started&) {
    board.milestone();
    for (std::size_t f = 0; f < subject_.rings.size(); ++f) {
      if (subject_.looks_away(f)) continue;
      board.keep(fmt::format("a face {:03}", f), Role::past, outline(f));
      for (std::size_t k = 0; k < subject_.rings[f].size(); ++k) {
        const std::size_t v = subject_.vertex(f, k);
        keep_vertex(board, v,
                    subject_.given.empty() ? std::nullopt : std::optional(subject_.lit(f, {})[k].value));
      }
    }
  }
  Event say(const steps::Started&) const {
    return {.text = subject_.given.empty() ? "started" : "started.given",
            .words = {{"faces", subject_.rings.size()},
                      {"vertices", subject_.places.size()},
                      {"light", figure_place(subject_.lamp.light.position)},
                      {"eye", figure_place(subject_.lamp.eye)}},
            .count = std::ssize(subject_.rings)};
  }

  void show(Board& board, const FaceTaken& f) {
    face_ = f.face;
    if (subject_.rings.size() == 1) return;
    board.milestone();
    board.keep("b face", Role::input, outline(f.face));
  }
  Event say(const FaceTaken&) const {
    return {.text = "face", .words = {{"face", name()}}, .key = name(), .phase = "faces"};
  }

  void show(Board& board, const VertexLit<double>& v) {
    board.milestone();
    ++lights_;
    keep_vertex(board, v.vertex, v.colour);
  }
  Event say(const VertexLit<double>& v) const {
    return {.text = "vertex",
            .facts = {{"intensity", v.colour}},
            .words = {{"vertex", letter(v.vertex)},
                      {"place", figure_place(subject_.places[v.vertex])},
                      {"normal", figure_place(subject_.normals[v.vertex])},
                      {"I", v.colour}},
            .key = letter(v.vertex),
            .phase = "vertices"};
  }

  void show(Board& board, const PolygonLit<double, double>& p) {
    board.milestone();
    ++lights_;
    middle_ = p.middle;
    const dvec2 at = drawn(subject_.on_screen(p.middle.place));
    board.mark("m middle", Role::current, Dot{at});
    board.mark("m light", Role::current, Label{at, figure_real(p.colour)});
  }
  Event say(const PolygonLit<double, double>& p) const {
    return {.text = "polygon",
            .facts = {{"intensity", p.colour}},
            .words = {{"face", name()},
                      {"place", figure_place(p.middle.place)},
                      {"normal", figure_place(p.middle.normal)},
                      {"I", p.colour}},
            .key = name(),
            .phase = "light"};
  }

  template <class Value>
  void show(Board& board, const RowBegun<double, Value>& r) {
    board.milestone();
    row_ = r.row;
    left_ = {r.left.x, r.row + 0.5};
    right_ = {r.right.x, r.row + 0.5};
    board.keep("s line", Role::measure, Stroke{drawn(left_), drawn(right_), false, false, true});
    ends_ = {value_text(r.at_left), value_text(r.at_right)};
    if constexpr (std::same_as<Value, double>) values_ = {" " + ends_[0], " " + ends_[1]};
    put_ends(board);
  }
  template <class Value>
  Event say(const RowBegun<double, Value>& r) const {
    return {.text = row_key(r.at_left),
            .facts = {{"row", r.row}, {"alpha", r.left.part}, {"beta", r.right.part}},
            .words = {{"left", edge(r.left)}, {"right", edge(r.right)}, {"l", ends_[0]}, {"r", ends_[1]}},
            .key = figure_number(r.row),
            .phase = "rows",
            .decides = left_edge(r)};
  }

  template <class Value>
  void show(Board& board, const Shaded<double, Value, double>& s) {
    board.detail(s.pixel);
    shown_[{s.pixel.x, s.pixel.y}] = s.colour;
    if constexpr (std::same_as<Value, Point>) ++lights_;
    board.put(s.pixel, Role::result, "", tone_of(s.colour));
    if (s.gamma > 0.4 && row_ >= subject_.size.y / 2 - 1) board.tells(1);  // in the middle of the picture
    put_ends(board);
    const dvec2 at(s.pixel), rest{at.x + 0.5, at.y}, right = drawn(right_);
    if (rest.x < right.x)  // what of the line is still to come
      board.keep("s line", Role::measure, Stroke{rest, right, false, false, true});
    else
      board.remove("s line");
    board.mark("p pixel", Role::current, Path{Extent{at - 0.5, at + 0.5}.corners(), true});
    board.mark("p value", Role::current, Label{at, figure_real(s.colour)});
  }
  template <class Value>
  Event say(const Shaded<double, Value, double>& s) const {
    Event event{.text = "pixel",
                .facts = {{"pixel", s.pixel}, {"gamma", s.gamma}, {"intensity", s.colour}},
                .words = {{"I", s.colour}},
                .row = {s.pixel.x, s.pixel.y, s.gamma, s.colour},
                .key = pixel_key(s.pixel),
                .phase = "pixels",
                .level = Level::step};
    if constexpr (std::same_as<Value, Point>) {
      event.text = s.length < 0.9995 ? "pixel.shorter" : "pixel.phong";
      event.words.push_back({"length", s.length});
      event.words.push_back({"normal", figure_place(s.between.normal)});
    } else if (middle_) {
      event.text = "pixel.flat";
      event.words.push_back({"face", name()});
    } else {
      event.words.push_back({"l", ends_[0]});
      event.words.push_back({"r", ends_[1]});
      event.words.push_back({"rest", 1 - s.gamma});
    }
    return event;
  }

  void show(Board&, const Finished&) {}
  Event say(const Finished&) const { return {}; }

  /// The picture is done, and compared with light at every pixel.
  void compare(const Picture& right) { worst_ = worst_of(shown_, right); }
  void show(Board& board, const steps::Finished&) {
    board.milestone();
    board.remove("s line");
    if (subject_.rings.size() > 1) board.remove("b face");
    if (worst_.difference < 0.005) return;
    const dvec2 at(worst_.pixel);
    board.mark("w worst", Role::rejected, Dot{at, true});
    board.mark("w difference", Role::rejected, Label{at, "± " + figure_real(worst_.difference)});
  }
  Event say(const steps::Finished&) const {
    if (!subject_.given.empty()) return {.text = "finished.given", .words = {{"pixels", shown_.size()}}};
    return {.text = worst_.difference < 0.005 ? "finished" : "finished.off",
            .facts = {{"pixels", std::ssize(shown_)}, {"lights", lights_}},
            .words = {{"difference", worst_.difference}, {"worst", worst_.pixel}},
            .count = lights_};
  }

 private:
  /// Cells have their centres at whole numbers.
  static dvec2 drawn(dvec2 screen) { return screen - 0.5; }
  std::string name() const { return subject_.named[face_].name; }
  Path outline(std::size_t face) const {
    Path path{{}, true};
    for (const int v : subject_.rings[face])
      path.points.push_back(drawn(subject_.on_screen(subject_.places[static_cast<std::size_t>(v)])));
    return path;
  }
  std::string vertex(std::size_t corner) const { return letter(subject_.vertex(face_, corner)); }
  /// The vertex with its name and its intensity, where there are few.
  void keep_vertex(Board& board, std::size_t vertex, std::optional<double> light) const {
    const dvec2 at = drawn(subject_.on_screen(subject_.places[vertex]));
    const std::string name = letter(vertex);
    board.keep("v " + name, Role::input, Dot{at});
    if (subject_.places.size() <= 8)
      board.keep("v " + name + " name", Role::input,
                 Label{at, light ? name + " " + figure_real(*light) : name});
  }
  std::string edge(const End<double>& end) const { return vertex(end.lower) + vertex(end.upper); }
  /// Which of the face's edges the scan line meets first.
  template <class Value>
  Decision left_edge(const RowBegun<double, Value>& r) const {
    const std::size_t n = subject_.rings[face_].size(), low = r.left.lower, high = r.left.upper;
    const std::size_t first = (low + 1) % n == high ? low : high;
    Decision decision{words_.say("question", {{"row", r.row}}),
                      {},
                      first,
                      fmt::format("edge {}", static_cast<char>('a' + first % 26))};
    for (std::size_t i = 0; i < n; ++i) decision.answers.push_back(vertex(i) + vertex((i + 1) % n));
    return decision;
  }

  std::string_view row_key(double) const { return middle_ ? "row.flat" : "row"; }
  static std::string_view row_key(const Point&) { return "row.phong"; }
  static std::string value_text(double colour) { return figure_real(colour); }
  static std::string value_text(const Point& point) { return figure_place(point.normal); }
  void put_ends(Board& board) const {
    if (middle_) return;
    for (const auto& [name, at, value] : {std::tuple{"L", left_, values_[0]}, {"R", right_, values_[1]}}) {
      board.mark(fmt::format("e {}", name), Role::measure, Dot{drawn(at)});
      board.mark(fmt::format("e {} value", name), Role::measure, Label{drawn(at), name + value});
    }
  }

  const Words& words_;
  const Subject& subject_;
  std::size_t face_ = 0;
  std::optional<Point> middle_{};  ///< of a face that is lit once
  int row_ = 0;
  dvec2 left_{}, right_{};
  std::array<std::string, 2> ends_{}, values_{};  ///< of L and R, in the sentence and in the drawing
  Picture shown_{};
  std::int64_t lights_ = 0;
  Worst worst_{};
};

// --- The methods

void set_scene(Narrator& narrator, const Subject& subject) {
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(subject.rings),
                                                     {{"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.grid(subject.picture());
  narrator.handles("faces", [&](dvec3 p) { return subject.on_screen(p) - 0.5; });
  narrator.trace().grid.whole = true;
  narrator.columns({{"x"}, {"y"}, {"gamma"}, {"I"}});
}

/// What all methods do round their run: run(story, watch) shades.
template <class Run>
void tell_shading(Narrator& narrator, const Subject& subject, const Run& run) {
  set_scene(narrator, subject);
  ShadeStory story(narrator.words(), subject);
  narrator.tell_whole(story, [&](const auto& watch) {
    run(watch);
    if (subject.given.empty()) story.compare(phong_picture(subject));
  });
  narrator.result({{"lights", story.lights()}, {"worst", story.worst().difference}});
}

constexpr auto drop = [](ivec2, const auto&) {};

/// The numbers of Gouraud's steps, for float, double and Exact beside each other.
struct GouraudNumbers {
  template <class T>
  void operator()(NumericStep<T>& step, const RowBegun<T, T>& r) const {
    step.number("alpha", r.left.part);
    step.number("I_L", r.at_left);
    step.number("beta", r.right.part);
    step.number("I_R", r.at_right);
    step.decision(r.left.lower);
    step.decision(r.right.lower);
  }
  template <class T>
  void operator()(NumericStep<T>& step, const Shaded<T, T, T>& s) const {
    step.number("gamma", s.gamma);
    step.number("I", s.colour);
    step.decision(s.pixel.x);
    step.decision(s.pixel.y);
  }
  template <class T>
  void operator()(NumericStep<T>&, const Finished&) const {}
};

/// shade(polygon, observer), for all faces that look here.
template <class Corners, class Shade>
void each_face(const Subject& subject, const auto& watch, const Corners& corners, const Shade& shade) {
  for (std::size_t f = 0; f < subject.rings.size(); ++f) {
    if (subject.looks_away(f)) continue;
    watch(FaceTaken{f}, 0);
    const auto polygon = corners(f);
    shade(std::span(polygon));
  }
}

/// shade(polygon, picture, light, plot, observer): by the normals at vertices.
template <auto shade, bool once>
void tell_smooth(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  if (once)
    narrator.legend({{Role::input, "face"},
                     {Role::current, "current"},
                     {Role::measure, "line"},
                     {Role::rejected, "worst"}});
  else
    narrator.legend({{Role::input, "face"}, {Role::measure, "line"}, {Role::current, "current"}});
  tell_shading(narrator, subject, [&](const auto& watch) {
    each_face(
        subject, watch, [&](std::size_t f) { return subject.smooth(f); },
        [&](std::span<const Smooth> polygon) {
          shade(polygon, subject.picture(), subject.lamp, drop, watch);
        });
  });
}

void tell_gouraud(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.legend({{Role::input, "vertex"},
                   {Role::measure, "line"},
                   {Role::current, "current"},
                   {Role::rejected, "worst"}});
  const std::vector<double> colours = subject.vertex_colours();
  tell_shading(narrator, subject, [&](const auto& watch) {
    for (std::size_t v = 0; subject.given.empty() && v < colours.size(); ++v)
      watch(VertexLit<double>{v, colours[v]}, 0);
    each_face(
        subject, watch, [&](std::size_t f) { return subject.lit(f, colours); },
        [&](std::span<const Lit> polygon) { gouraud(polygon, subject.picture(), drop, watch); });
  });
  tell_side_by_side<GouraudNumbers>(narrator, [subject, colours]<class T>(T, const auto& observer) {
    for (std::size_t f = 0; f < subject.rings.size(); ++f) {
      if (subject.looks_away(f)) continue;
      std::vector<Corner<T, T>> corners;
      for (const Lit& corner : subject.lit(f, colours))
        corners.push_back({in_scalar<T>(corner.at), T(corner.value)});
      gouraud(std::span<const Corner<T, T>>(corners), subject.picture(), drop, observer);
    }
  });
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-6, 1e6};
  static const TopicEntry topic = completed<entry>(
      {.name = "polygon_shading",
       .chapter = "shading",
       .aliases = {"flat shading", "gouraud", "gouraud shading", "phong shading", "smooth shading",
                   "vertex normals"},
       .summary = "light once per polygon, once per vertex or once per pixel, and what lies between is mixed",
       .methods = {{.name = "gouraud",
                    .standing = Standing::taught,
                    .tell = tell_gouraud,
                    .unread = {"towards"},
                    .exact = true},
                   {.name = "phong",
                    .tell = tell_smooth<[](const auto&... a) { phong(a...); }, false>,
                    .unread = {"intensities", "towards"}},
                   {.name = "flat",
                    .tell = tell_smooth<[](const auto&... a) { flat(a...); }, true>,
                    .unread = {"intensities", "towards"}},
                   {.name = "all_three",
                    .tell = tell_three,
                    .function = "flat",
                    .unread = {"columns", "rows", "intensities", "towards"}},
                   {.name = "vertex_normals",
                    .tell = tell_vertex_normals,
                    .file = "vertex_normals.hpp",
                    .unread = {"columns", "rows", "window", "light", "eye", "ka", "kd", "ks", "shininess",
                               "intensities"}},
                   {.name = "flat_by_vertex_normals",
                    .standing = Standing::faulty,
                    .tell = tell_smooth<[](const auto&... a) { flat_by_vertex_normals(a...); }, true>,
                    .unread = {"intensities", "towards"}}},
       .default_method = "gouraud",
       .counts = {"PolygonLit", "VertexLit", "Shaded"},
       .parameters =
           {faces(400, "faces", "0,0,0 10,0,0 5,10,0", "A: 0,0,0 8,0,0 8,8,2; B: 0,0,0 8,8,2 0,8,0",
                  "what is shaded, seen from +z: faces without dents, counter-clockwise seen from outside",
                  modest),
            integer(3, 48, "columns", "12", "8", "how many pixels the picture is wide"),
            integer(3, 48, "rows", "12", "8", "how many pixels it is high"),
            bounds("window", "", "-0.5,-0.5,11.5,11.5",
                   "what the picture shows, in the faces' x and y; without it all of them, and a pixel "
                   "beside them",
                   {"xmin", "ymin", "xmax", "ymax"}, modest),
            numbers("light", "0,4,3", "0,0,2", "where the lamp stands", xyz, modest),
            numbers("eye", "8,4,3", "0,0,2", "where the viewer is, for the highlight", xyz, modest),
            number("ka", "0.1", "0.2", "the share of ambient light", {1e-6, 1}),
            number("kd", "0.7", "0.5", "the share that is scattered", {1e-6, 1}),
            number("ks", "0.2", "0.4", "the share in the highlight", {1e-6, 1}),
            number("shininess", "10", "40", "the exponent of the highlight", {1e-3, 1e4}),
            choice("weighting", {"plain", "area", "angle"}, "angle", "plain",
                   "how much a face's normal counts at a vertex"),
            points(1, 64, "intensities", "", "0 1 0.5",
                   "given for the corners of the faces in turn, in place of light", {"I"}, {1e-6, 1}),
            faces_subject::towards_parameter("-3,3,5"), exact_parameter()},
       .examples = {
           "--intensities '0 0.5 1' --window=-0.5,-0.5,11.5,11.5", "--method phong --light 5,4,3 --eye 5,4,8",
           "--method vertex_normals --weighting plain --faces '1,1,1 0,1,1 0,0,1; 1,1,1 0,0,1 1,0,1; 1,1,1 "
           "1,0,1 1,1,0; 1,0,1 1,0,0 1,1,0; 1,1,1 1,1,0 0,1,1; 0,1,1 1,1,0 0,1,0'"}});
  return topic;
}

}  // namespace gradus::polygon_shading
