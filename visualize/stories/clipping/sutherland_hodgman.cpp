// The story of a polygon and a convex window: what each border takes off, and what hangs together then.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include <map>
#include <optional>
#include <tuple>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_notes.hpp"
#include "stories/clipping/clip_space.hpp"
#include "stories/paper.hpp"
#include "stories/point_text.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::sutherland_hodgman {
namespace {

using fmt::arg;
using Corner = Vertex<double>;
using Points = std::vector<dvec2>;

constexpr std::string_view folder = "algorithms/clipping/sutherland_hodgman/";
constexpr int width = 36, height = 27;
constexpr const char* homogeneous_name = "homogeneous";

/// What a run was given.
struct Given {
  std::vector<Points> rings;                      ///< the outline, and perhaps holes
  std::optional<ConvexWindow<double>> oblique{};  ///< instead of the rectangle
  Rectangle<double> rectangle{};
  std::vector<int> order{};

  const Points& outline() const { return rings[0]; }
  Points window() const {
    if (oblique) return oblique->corners;
    const dvec2 low = rectangle.lower, high = rectangle.upper;
    return {low, {high.x, low.y}, high, {low.x, high.y}};
  }
  Line<double> border(int number) const {
    return oblique ? line_of(*oblique, number) : line_of(rectangle, number);
  }
};

Points places(std::span<const Corner> ring) {
  Points points;
  for (const Corner& v : ring) points.push_back(v.at);
  return points;
}

double area_of(const Points& ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i] - ring[0], b = ring[i + 1 < ring.size() ? i + 1 : 0] - ring[0];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}
double area_of(const Piece<double>& piece) {
  double area = area_of(places(piece.outline));
  for (const auto& hole : piece.holes) area += area_of(places(hole));
  return area;
}

Extent world_of(const Given& given) {
  Extent all;
  for (const Points& ring : given.rings) {
    for (const dvec2 p : ring) all.add(p);
  }
  for (const dvec2 p : given.window()) all.add(p);
  return widened(all, 0.08);
}

/// The part of a line that a rectangle of the plane shows.
std::optional<Stroke> across(const Line<double>& line, const Extent& shown) {
  double first = -1e300, last = 1e300;
  for (const int axis : {0, 1}) {
    const double way = line.q[axis] - line.p[axis];
    if (way == 0) continue;
    const double low = (shown.lower[axis] - line.p[axis]) / way;
    const double high = (shown.upper[axis] - line.p[axis]) / way;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  if (!(first < last)) return std::nullopt;
  return Stroke{line.p + first * (line.q - line.p), line.p + last * (line.q - line.p), false, true};
}

/// Names of vertices: those given by their numbers, those made by letters as they come.
class Names {
 public:
  std::string operator()(const Corner& v) {
    if (!v.made()) return fmt::format("{}", v.input + 1);
    const auto [found, added] = letters_.insert({{v.edge.id, v.border.id, v.at.x, v.at.y}, letters_.size()});
    const std::size_t n = found->second;
    const char letter = static_cast<char>('A' + n % 26);
    return n < 26 ? std::string(1, letter) : fmt::format("{}{}", letter, n / 26);
  }

 private:
  std::map<std::tuple<int, int, double, double>, std::size_t> letters_;
};

/// Tells the steps of all methods.
class Teller {
 public:
  Teller(TraceWriter& writer, const Given& given, bool pieces, std::optional<double> right)
      : writer_(writer),
        words_(writer.wording()),
        given_(given),
        panel_({{3, 3}, {width - 1.5, height - 1.2}}, world_of(given)),
        pieces_(pieces),
        right_(right) {
    writer.trace().columns = {{"border", false}, {"corner", false}, {"side", false}, {"kept", false}};
    if (pieces) writer.trace().columns = {{"border", false}, {"out"}, {"in"}, {"rings"}};
    base();
    std::string order;
    for (const int border : given.order) order += (order.empty() ? "" : ", ") + name_of_border(border);
    tell(
        "Started", "words.set_up", 0,
        words_.say("sutherland_hodgman.started", arg("corners", given.outline().size()), arg("order", order)),
        {}, {}, Level::idea);
    for (const Points& ring : given.rings) {
      Ring<double> vertices;
      for (const dvec2 p : ring) {
        vertices.push_back({p, static_cast<int>(vertices.size()), {}, {}, {}});
      }
      before_border_.push_back(vertices);
    }
  }

  void operator()(const VertexTested<double>& t, int line = __builtin_LINE(), const char* = nullptr) {
    enter_border(t.border);
    quiet();
    const std::string name = names_(t.vertex);
    mark_side(t.vertex, t.side, name);
    const std::string_view side = side_name(t.side);
    if (t.side >= 0) kept_.push_back(t.vertex.at);
    // A corner that is kept after a cut comes after it: the cut is told next, and stands before it
    last_tested_ = t;
    show_kept();
    view_.add({"f here", Role::current, Dot{panel_.at(t.vertex.at), true}});
    last_row_ = {name_of_border(t.border), name, words_.say(fmt::format("sutherland_hodgman.side.{}", side)),
                 t.side >= 0 ? name : ""};
    tell("VertexTested", "", line,
         words_.say(fmt::format("sutherland_hodgman.tested.{}", side), arg("corner", name),
                    arg("at", figure_place(t.vertex.at)), arg("border", name_of_border(t.border))),
         {{"border", std::int64_t{t.border}},
          {"side", std::int64_t{t.side}},
          {"x", t.vertex.at.x},
          {"y", t.vertex.at.y}},
         last_row_);
  }

  void operator()(const EdgeCut<double>& c, int line = __builtin_LINE(), const char* = nullptr) {
    quiet();
    const std::string name = names_(c.vertex);
    // The cut comes before the corner that was tested last
    const bool kept_last = last_tested_ && last_tested_->side >= 0 && !kept_.empty();
    kept_.insert(kept_.end() - (kept_last ? 1 : 0), c.vertex.at);
    show_kept();
    view_.add({"f edge", Role::current, Stroke{panel_.at(c.from.at), panel_.at(c.to.at), true}});
    view_.add({"f here", Role::current, Dot{panel_.at(c.vertex.at)}});
    view_.add({"g made " + name, Role::current,
               Label{panel_.at(c.vertex.at), fmt::format("{} {}", name, figure_place(c.vertex.at))}});
    // In the table, too: the cut's row takes over the corner that stays
    Row read;
    std::string kept = name;
    if (kept_last) {
      read = last_row_;
      kept += ", " + read.back();
      read.back().clear();
    }
    const bool corner = c.vertex.edge.of_window();
    const std::string key = corner ? "corner" : c.leaves ? "leaves" : "enters";
    tell("EdgeCut", "", line,
         words_.say("sutherland_hodgman.cut." + key, arg("from", names_(c.from)), arg("to", names_(c.to)),
                    arg("border", name_of_border(c.border)), arg("name", name),
                    arg("at", figure_place(c.vertex.at))),
         {{"border", std::int64_t{c.border}},
          {"leaves", c.leaves},
          {"x", c.vertex.at.x},
          {"y", c.vertex.at.y}},
         {name_of_border(c.border), name, words_.say("sutherland_hodgman.side.cut"), kept}, Level::step,
         read);
    // From now on the name alone
    view_.add({"g made " + name, Role::past, Label{panel_.at(c.vertex.at), name}});
  }

  void operator()(const BorderPassed<double>& p, int line = __builtin_LINE(), const char* = nullptr) {
    enter_border(p.border);
    quiet();
    erase("c ");
    erase("d ");
    erase("e ");
    before_border_ = {p.polygon};
    show_rings(before_border_, "d ring", Role::accepted);
    tell("BorderPassed", "", line,
         p.polygon.empty()
             ? words_.say("sutherland_hodgman.passed_empty", arg("border", name_of_border(p.border)))
             : words_.count("sutherland_hodgman.passed", static_cast<std::int64_t>(p.polygon.size()),
                            arg("border", name_of_border(p.border))),
         {{"border", std::int64_t{p.border}}, {"corners", static_cast<std::int64_t>(p.polygon.size())}}, {},
         Level::idea);
    left_border();
  }

  void operator()(const RingTested<double>& t, int line = __builtin_LINE(), const char* = nullptr) {
    enter_border(t.border);
    quiet();
    std::size_t inside = 0;
    for (std::size_t i = 0; i < t.ring.size(); ++i) {
      mark_side(t.ring[i], t.sides[i], names_(t.ring[i]));
      inside += t.sides[i] > 0;
    }
    view_.add({"f ring", Role::current, Path{panel_.at(places(t.ring)), true}});
    tell("RingTested", "", line,
         words_.say("sutherland_hodgman.ring_tested", arg("inside", inside), arg("corners", t.ring.size()),
                    arg("border", name_of_border(t.border))),
         {{"border", std::int64_t{t.border}}, {"inside", static_cast<std::int64_t>(inside)}}, {});
  }

  void operator()(const CrossingsOrdered<double>& o, int line = __builtin_LINE(), const char* = nullptr) {
    quiet();
    erase("e ");
    for (std::size_t i = 0; i < o.crossings.size(); ++i) {
      const auto& c = o.crossings[i];
      numbers_[{c.chain, c.enters}] = i + 1;
      const std::string id = fmt::format("g crossing {:03}", i);
      view_.add({id, Role::current, Dot{panel_.at(c.vertex.at), !c.enters}});
      view_.add({id + " name", Role::current,
                 Label{panel_.at(c.vertex.at),
                       words_.say(c.enters ? "sutherland_hodgman.in" : "sutherland_hodgman.out",
                                  arg("number", i + 1))}});
    }
    crossings_ = o.crossings.size();
    const std::string border = name_of_border(o.border);
    tell("CrossingsOrdered", "", line,
         o.crossings.empty()
             ? words_.say("sutherland_hodgman.ordered_none", arg("border", border))
             : words_.say("sutherland_hodgman.ordered", arg("crossings", crossings_), arg("border", border)),
         {{"border", std::int64_t{o.border}}, {"crossings", static_cast<std::int64_t>(crossings_)}}, {});
  }

  void operator()(const CrossingsJoined<double>& j, int line = __builtin_LINE(), const char* = nullptr) {
    quiet();
    const std::size_t from = numbers_[{j.leaves.chain, false}], to = numbers_[{j.enters.chain, true}];
    const dvec2 a = panel_.at(j.leaves.vertex.at), b = panel_.at(j.enters.vertex.at);
    view_.add({"f join", Role::current, Stroke{a, b, true}});
    view_.add({fmt::format("d join {:03}", from), Role::accepted, Stroke{a, b}});
    tell("CrossingsJoined", "", line,
         words_.say("sutherland_hodgman.joined", arg("from", from), arg("to", to),
                    arg("border", name_of_border(j.border))),
         {{"from", static_cast<std::int64_t>(from)}, {"to", static_cast<std::int64_t>(to)}},
         {name_of_border(j.border), fmt::format("{}", from), fmt::format("{}", to), ""});
  }

  void operator()(const BorderSplit<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    quiet();
    erase("c ");
    erase("d ");
    erase("g ");
    before_border_ = s.rings;
    show_rings(before_border_, "d ring", Role::accepted);
    tell("BorderSplit", "", line,
         words_.count("sutherland_hodgman.split", static_cast<std::int64_t>(s.rings.size()),
                      arg("border", name_of_border(s.border))),
         {{"border", std::int64_t{s.border}}, {"rings", static_cast<std::int64_t>(s.rings.size())}},
         {name_of_border(s.border), "", "", fmt::format("{}", s.rings.size())}, Level::idea);
    left_border();
  }

  void operator()(const PieceTraced<double>& p, int line = __builtin_LINE(), const char* = nullptr) {
    if (p.number == 0) {
      erase("c ");
      erase("d ");
    }
    quiet();
    std::vector<Points> rings{panel_.at(places(p.piece.outline))};
    for (const auto& hole : p.piece.holes) rings.push_back(panel_.at(places(hole)));
    const std::string id = fmt::format("h piece {:03}", p.number);
    view_.add({id, Role::result, Area{rings}});
    for (std::size_t i = 0; i < rings.size(); ++i) {
      view_.add({fmt::format("{} line {}", id, i), Role::result, Path{rings[i], true}});
    }
    for (std::size_t i = 0; i < p.piece.outline.size(); ++i) {
      view_.add({fmt::format("{} dot {:03}", id, i), Role::result, Dot{rings[0][i]}});
    }
    view_.add({"f outline", Role::current, Path{rings[0], true}});
    total_ += area_of(p.piece);
    phase_ = words_.say("words.result");
    tell("PieceTraced", "words.result", line,
         words_.say("sutherland_hodgman.piece", arg("number", p.number + 1),
                    arg("corners", p.piece.outline.size()), arg("area", figure_real(area_of(p.piece)))),
         {{"piece", static_cast<std::int64_t>(p.number)}, {"area", area_of(p.piece)}}, {});
    ++traced_;
  }

  void operator()(const BridgeFound<double>& b, int = 0, const char* = nullptr) {
    quiet();
    const dvec2 from = panel_.at(b.from.at), to = panel_.at(b.to.at);
    found_.push_back({b.from.at, b.to.at});
    // The outline without the bridges, so that they are seen
    erase("h line");
    for (std::size_t i = 0; i < result_.size(); ++i) {
      add_without_bridges(i, result_[i], result_[i + 1 < result_.size() ? i + 1 : 0]);
    }
    const std::string id = fmt::format("i bridge {:03}", bridges_++);
    view_.add({id, Role::rejected, Stroke{from, to}});
    view_.add({id + " name", Role::rejected,
               Label{(from + to) * 0.5, words_.say("sutherland_hodgman.bridge_name")}});
    tell("BridgeFound", "words.result", 0,
         words_.say("sutherland_hodgman.bridge", arg("from", names_(b.from)), arg("to", names_(b.to)),
                    arg("border", name_of_border(b.border))),
         {{"border", std::int64_t{b.border}},
          {"from_x", b.from.at.x},
          {"from_y", b.from.at.y},
          {"to_x", b.to.at.x},
          {"to_y", b.to.at.y}},
         {});
  }

  /// Before the bridges: what came out, in its look.
  void show_result(std::span<const Corner> polygon) {
    quiet();
    erase("c ");
    erase("d ");
    erase("g ");
    result_ = places(polygon);
    if (polygon.empty()) return;
    const Points ring = panel_.at(result_);
    view_.add({"h area", Role::result, Area{{ring}}});
    view_.add({"h line", Role::result, Path{ring, true}});
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::string id = fmt::format("h corner {:03}", i);
      view_.add({id, Role::result, Dot{ring[i]}});
      if (ring.size() <= 24 && polygon[i].made())
        view_.add({id + " name", Role::result, Label{ring[i], names_(polygon[i])}});
    }
  }

  const Panel& panel() const { return panel_; }

  /// The last step.
  void finish() {
    quiet();
    std::string sentence = words_.say("sutherland_hodgman.nothing");
    if (pieces_ && traced_ > 0) {
      sentence = words_.count("sutherland_hodgman.done_pieces", traced_, arg("area", figure_real(total_)));
    } else if (!pieces_ && right_) {
      sentence =
          words_.say("sutherland_hodgman.done_wrong", arg("area", figure_real(std::abs(area_of(result_)))),
                     arg("right", figure_real(*right_)));
    } else if (!result_.empty()) {
      const std::string area = figure_real(std::abs(area_of(result_)));
      sentence = bridges_ > 0 ? words_.count("sutherland_hodgman.done_bridges", bridges_, arg("area", area),
                                             arg("corners", result_.size()))
                              : words_.say("sutherland_hodgman.done", arg("area", area),
                                           arg("corners", result_.size()));
    }
    tell("Finished", "words.result", 0, sentence, {}, {}, Level::idea);
  }

 private:
  static std::string_view side_name(int side) { return side > 0 ? "inside" : side < 0 ? "outside" : "on"; }
  std::string name_of_border(int border) const {
    constexpr std::array<std::string_view, 4> names{"left", "right", "bottom", "top"};
    if (given_.oblique) return words_.say("sutherland_hodgman.border.numbered", arg("number", border + 1));
    return words_.say(fmt::format("sutherland_hodgman.border.{}", names[static_cast<std::size_t>(border)]));
  }

  void base() {
    const Points window = given_.window();
    view_.add({"b window", Role::boundary, Path{panel_.at(window), true}});
    add_axes(view_, panel_, "a axes", {words_.symbol("x"), words_.symbol("y")});
    if (given_.oblique) {
      for (const int border : given_.order) {
        const Line<double> line = given_.border(border);
        view_.add({fmt::format("b border {:03}", border), Role::boundary,
                   Label{panel_.at(0.5 * line.p + 0.5 * line.q), name_of_border(border)}});
      }
    }
    std::size_t before = 0;  // corners of earlier rings
    for (std::size_t r = 0; r < given_.rings.size(); ++r) {
      const Points& ring = given_.rings[r];
      view_.add({fmt::format("b given {}", r), Role::input, Path{panel_.at(ring), true, true}});
      for (std::size_t i = 0; i < ring.size() && ring.size() <= 24; ++i) {
        const std::size_t n = before + i;
        view_.add({fmt::format("b number {:03}", n), Role::input,
                   Label{panel_.at(ring[i]), fmt::format("{}", n + 1)}});
      }
      before += ring.size();
    }
  }

  /// At the first step of a border: what comes to it, and the border itself.
  void enter_border(int border) {
    if (border_ == border) return;
    border_ = border;
    phase_ = words_.say("sutherland_hodgman.phase.border", arg("border", name_of_border(border)));
    erase("d ");
    kept_.clear();
    last_tested_.reset();
    numbers_.clear();
    show_rings(before_border_, "c ring", Role::past);
    if (const auto stroke = across(given_.border(border), panel_.shown())) {
      view_.add({"b window border", Role::current,
                 Stroke{panel_.at(stroke->a), panel_.at(stroke->b), false, true}});
    }
  }
  void left_border() {
    border_.reset();
    erase("b window border");
    erase("e ");
  }

  void show_rings(const std::vector<Ring<double>>& rings, std::string_view id, Role role) {
    std::vector<Points> all;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      all.push_back(panel_.at(places(rings[i])));
      view_.add({fmt::format("{} {:03} line", id, i), role, Path{all.back(), true}});
    }
    if (!all.empty()) view_.add({fmt::format("{} area", id), role, Area{all}});
  }
  void mark_side(const Corner& v, int side, const std::string& name) {
    const Role role = side >= 0 ? Role::accepted : Role::rejected;
    view_.add({"e side " + name, role, Dot{panel_.at(v.at), side < 0}});
  }
  /// An edge of the result but for the stretches of bridges on it.
  void add_without_bridges(std::size_t number, dvec2 a, dvec2 b) {
    const dvec2 way = b - a;
    const double square = glm::dot(way, way);
    if (square == 0) return;
    std::vector<std::pair<double, double>> gaps;
    for (const auto& [from, to] : found_) {
      const auto beside = [&](dvec2 p) { return std::abs(way.x * (p.y - a.y) - way.y * (p.x - a.x)); };
      if (beside(from) > 1e-9 * square || beside(to) > 1e-9 * square) continue;
      const double s = glm::dot(from - a, way) / square, t = glm::dot(to - a, way) / square;
      gaps.emplace_back(std::clamp(std::min(s, t), 0.0, 1.0), std::clamp(std::max(s, t), 0.0, 1.0));
    }
    std::sort(gaps.begin(), gaps.end());
    gaps.emplace_back(1, 1);
    double done = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (gaps[i].first > done) {
        view_.add({fmt::format("h line {:03} {}", number, i), Role::result,
                   Stroke{panel_.at(a + done * way), panel_.at(a + gaps[i].first * way)}});
      }
      done = std::max(done, gaps[i].second);
    }
  }
  void show_kept() {
    if (kept_.size() > 1) view_.add({"d kept", Role::accepted, Path{panel_.at(kept_)}});
  }
  /// Takes away what the last step pointed at.
  void quiet() { erase("f "); }
  void erase(std::string_view start) {
    std::erase_if(view_.marks, [&](const auto& mark) { return mark.first.starts_with(start); });
  }

  void tell(std::string_view type, std::string_view phase, int line, std::string sentence,
            std::vector<Field> fields, Row row, Level level = Level::step, Row read = {}) {
    const std::string said = phase.empty() ? phase_ : words_.say(phase);
    writer_.step(before_.change_to(view_), {0, 0}, line, [&](TraceStep& step) {
      step.type = type;
      step.phase = said;
      step.key = type;
      step.level = level;
      step.fields = std::move(fields);
      step.sentence = std::move(sentence);
      step.read = std::move(read);
      step.row = std::move(row);
    });
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Given& given_;
  Panel panel_;
  bool pieces_;
  std::optional<double> right_;  ///< for faulty methods: the right area
  View view_;
  Shown before_;
  Names names_;
  std::string phase_;
  std::optional<int> border_;
  std::vector<Ring<double>> before_border_;
  Points kept_, result_;
  Row last_row_;
  std::vector<std::pair<dvec2, dvec2>> found_;  ///< bridges
  std::optional<VertexTested<double>> last_tested_;
  std::map<std::pair<std::size_t, bool>, std::size_t> numbers_;
  std::size_t crossings_ = 0;
  std::int64_t bridges_ = 0, traced_ = 0;
  double total_ = 0;
};

const std::vector<Method>& all_methods() {
  constexpr std::string_view topic = "sutherland_hodgman";
  static const std::vector<Method> methods{
      method_in_english(topic, "border_by_border", Standing::taught),
      method_in_english(topic, "separate_pieces", Standing::plain),
      method_in_english(topic, homogeneous_name, Standing::plain),
      method_in_english(topic, "cut_of_a_cut", Standing::plain),
      method_in_english(topic, "entering_not_cut", Standing::faulty),
      method_in_english(topic, "previous_left_behind", Standing::faulty),
      method_in_english(topic, "marked_by_window", Standing::faulty),
      method_in_english(topic, "containing_left_whole", Standing::faulty)};
  return methods;
}
const Method& method_named(std::string_view name) {
  const auto& methods = all_methods();
  return *std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.name == name; });
}

const Parameter& order_parameter();

/// The order of an oblique window's borders: as they come, unless their numbers say otherwise.
std::vector<int> order_of(const Arguments& arguments, const ConvexWindow<double>& window) {
  std::vector<int> order = all_borders(window);
  const std::string& text = arguments.text("order");
  if (text == order_parameter().default_value) return order;
  const auto numbers = arguments.numbered_order("order");
  if (!numbers || numbers->size() != order.size()) {
    throw ArgumentError("order",
                        fmt::format("expected the numbers 1 to {} of the window's borders, each once in any "
                                    "order, found '{}'",
                                    order.size(), text));
  }
  std::ranges::transform(*numbers, order.begin(), [](std::size_t n) { return static_cast<int>(n); });
  return order;
}

Given given_of(const Arguments& arguments, bool pieces, bool exact) {
  Given given{.rings = {arguments.points("polygon")}};
  for (Points& hole : arguments.rings("hole")) {
    if (!pieces) throw ArgumentError("hole", "holes are cut by --method separate_pieces alone");
    given.rings.push_back(std::move(hole));
  }
  if (const Points points = arguments.points("window_polygon"); !points.empty()) {
    if (!exact) throw ArgumentError("window_polygon", "this method clips at rectangles alone");
    given.oblique = convex_window(std::span<const dvec2>(points));
    if (!given.oblique) {
      throw ArgumentError("window_polygon", "corners of a convex window with an area expected, in order");
    }
    given.order = order_of(arguments, *given.oblique);
    return given;
  }
  const std::vector<double> bounds = arguments.numbers("window");
  given.rectangle = {{bounds[0], bounds[1]}, {bounds[2], bounds[3]}};
  if (arguments.numbered_order("order")) {
    throw ArgumentError("order",
                        fmt::format("expected left,right,bottom,top, each once in any order, found '{}': "
                                    "numbers are for the borders of --window-polygon",
                                    arguments.text("order")));
  }
  for (const std::size_t border : arguments.order(order_parameter()))
    given.order.push_back(static_cast<int>(border));
  return given;
}

/// Runs one of the methods in exact arithmetic at a rectangle or another window.
template <class Window>
void run_exact(const Given& given, const Window& window, bool pieces, Teller& teller) {
  const std::span<const int> order(given.order);
  if (pieces) {
    separate_pieces(Rings<double>(std::span<const Points>(given.rings)), window, order, teller);
    return;
  }
  const std::span<const dvec2> points(given.outline());
  const auto polygon = clip_to_window(points, window, order, teller);
  teller.show_result(polygon);
  bridges(std::span<const Corner>(polygon), points, window, teller);
}

/// The notes' passes, and their special case.
void run_plain(const Given& given, std::string_view method, Teller& teller) {
  const Task<double> task{given.outline(), given.rectangle, given.order};
  const auto polygon = method == "containing_left_whole"
                           ? containing_left_whole(task, teller)
                           : by_passes(task, [&](auto rest, auto border) {
                               if (method == "entering_not_cut")
                                 return entering_not_cut(rest, border, teller);
                               if (method == "previous_left_behind")
                                 return previous_left_behind(rest, border, teller);
                               if (method == "marked_by_window")
                                 return marked_by_window(rest, border, teller);
                               return cut_of_a_cut(rest, border, teller);
                             });
  teller.show_result(polygon);
}

/// What the steps of the textbook's passes hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const VertexTested<T>& v) const {
    to.type = "VertexTested";
    to.point("vertex", v.vertex.at);
    to.decision(v.side);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const EdgeCut<T>& c) const {
    to.type = "EdgeCut";
    to.point("cut", c.vertex.at);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const BorderPassed<T>&) const {
    to.type = "BorderPassed";
  }
};

void put_side_by_side(Trace& trace, const Given& given) {
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    std::vector<glm::vec<2, T>> corners;
    for (const dvec2 p : given.outline()) corners.push_back(in_scalar<T>(p));
    const Rectangle<T> window = in_scalar<T>(given.rectangle);
    by_passes(Task<T>{corners, window, given.order},
              [&](auto rest, auto border) { return cut_of_a_cut(rest, border, observer); });
  });
}

/// Corners in clip space, as they were given.
std::vector<Point<double>> homogeneous_of(const Arguments& arguments) {
  const std::vector<std::string> parts{"x", "y", "z", "w"};
  const auto read = read_tuples(arguments.text("homogeneous"), parts);
  expects(!std::holds_alternative<Misread>(read), "points in their canonical spelling");
  std::vector<Point<double>> corners;
  for (const Tuple& p : std::get<std::vector<Tuple>>(read)) {
    corners.push_back({{p[0].value, p[1].value, p[2].value, p[3].value}});
    const auto& at = corners.back().at;
    if (at == dvec4(0)) {
      throw ArgumentError("homogeneous", fmt::format("point {}: 0,0,0,0 is no point", corners.size()));
    }
    for (int i = 0; i < 4; ++i) {
      const double size = std::abs(at[i]);
      if (size == 0 || (1e-6 <= size && size <= 1e6)) continue;
      throw ArgumentError("homogeneous",
                          fmt::format("point {}: expected numbers that are 0 or from 0.000001 to 1000000 in "
                                      "size, found '{}'",
                                      corners.size(), text_of(p)));
    }
  }
  return corners;
}

/// The method before the division.
Trace run_homogeneous(const Arguments& arguments, Recording recording) {
  if (!arguments.rings("hole").empty())
    throw ArgumentError("hole", "holes are cut by --method separate_pieces alone");
  if (!arguments.points("window_polygon").empty())
    throw ArgumentError("window_polygon", "method homogeneous clips at the planes of clip space alone");
  const std::vector<Point<double>> corners = homogeneous_of(arguments);
  const auto planes = view_volume(1.0, 1.0);
  TraceWriter writer(recording);
  Trace& about = writer.trace();
  const Wording& words = about.wording;
  introduce(about, "sutherland_hodgman", arguments, false);
  // Only what this method reads
  std::erase_if(about.arguments,
                [](const Argument& a) { return a.name != "method" && a.name != "homogeneous"; });
  about.subtitle = words.say("sutherland_hodgman.subtitle_space", arg("corners", corners.size()),
                             arg("planes", planes.size()));
  about.goal = words.say("sutherland_hodgman.goal_space");
  about.grid = paper_grid(ClipSpaceTeller::paper_width, ClipSpaceTeller::paper_height);
  about.legend = {{Role::input, words.say("sutherland_hodgman.legend.input")},
                  {Role::past, words.say("sutherland_hodgman.legend.past_plane")},
                  {Role::current, words.say("sutherland_hodgman.legend.current")},
                  {Role::accepted, words.say("sutherland_hodgman.legend.accepted")},
                  {Role::rejected, words.say("sutherland_hodgman.legend.rejected_space")},
                  {Role::result, words.say("sutherland_hodgman.legend.result")}};
  about.source_file = std::string(folder) + "sutherland_hodgman.hpp";
  about.listing = listing_of(source_text(about.source_file), "clip");
  ClipSpaceTeller teller(writer, corners);
  const auto polygon = clip(corners, std::span<const Plane<double>>(planes), teller);
  teller.finish();
  Trace trace = std::move(writer).finish();
  trace.telling = {trace.last, 0};
  trace.result = {{"corners", static_cast<std::int64_t>(polygon.size())}};
  return trace;
}

Trace run(const Arguments& arguments, Recording recording) {
  const Method& method = method_named(arguments.text("method"));
  if (side_by_side(arguments)) require_method(arguments, {"cut_of_a_cut"});
  if (method.name == homogeneous_name) return run_homogeneous(arguments, recording);
  const bool pieces = method.name == "separate_pieces";
  const bool exact = pieces || method.name == "border_by_border";
  const bool faulty = method.standing == Standing::faulty;
  const Given given = given_of(arguments, pieces, exact);

  TraceWriter writer(recording);
  Trace& about = writer.trace();
  const Wording& words = about.wording;
  introduce(about, "sutherland_hodgman", arguments, faulty);
  std::erase_if(about.arguments, [&](const Argument& a) {
    return a.name == "homogeneous" ||
           (a.name == "order" && given.oblique && a.value == order_parameter().default_value);
  });
  about.subtitle = words.say("sutherland_hodgman.subtitle", arg("corners", given.outline().size()),
                             arg("borders", given.order.size()));
  about.grid = paper_grid(width, height);
  about.legend = {{Role::input, words.say("sutherland_hodgman.legend.input")},
                  {Role::boundary, words.say("sutherland_hodgman.legend.boundary")},
                  {Role::past, words.say("sutherland_hodgman.legend.past")},
                  {Role::current, words.say("sutherland_hodgman.legend.current")},
                  {Role::accepted, words.say("sutherland_hodgman.legend.accepted")},
                  {Role::rejected, words.say("sutherland_hodgman.legend.rejected")},
                  {Role::result, words.say("sutherland_hodgman.legend.result")}};
  const std::string file = pieces  ? "separate_pieces.hpp"
                           : exact ? "sutherland_hodgman.hpp"
                                   : "sutherland_hodgman_notes.hpp";
  about.source_file = std::string(folder) + file;
  about.listing = listing_of(source_text(about.source_file), pieces  ? "split_at"
                                                             : exact ? "cut_at_border"
                                                                     : method.name);

  std::optional<double> right;
  if (faulty) {
    const auto polygon = clip_to_window(std::span<const dvec2>(given.outline()), given.rectangle);
    right = std::abs(area_of(places(polygon)));
  }
  Teller teller(writer, given, pieces, right);
  require_scale(teller.panel(), arguments, {"polygon", "window", "window_polygon"});
  if (!exact) {
    run_plain(given, method.name, teller);
  } else if (given.oblique) {
    run_exact(given, *given.oblique, pieces, teller);
  } else {
    run_exact(given, given.rectangle, pieces, teller);
  }
  teller.finish();
  Trace trace = std::move(writer).finish();
  trace.telling = {trace.last, 0};
  if (side_by_side(arguments)) put_side_by_side(trace, given);
  return trace;
}

/// Of coordinates: squares of their differences neither overflow nor underflow.
constexpr Sizes plane_sizes{1e-100, 1e100};

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> all{
      {.name = "polygon",
       .type = ParameterType::points,
       .default_value = "-4,3 3,-4 6,-3 13,5 7,8 6,-1 4,-1 4,7",
       .example = "2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4",
       .help = "the polygon's corners, in either direction",
       .least = 3,
       .most = 200,
       .parts = {"x", "y"},
       .sizes = plane_sizes},
      {.name = "hole",
       .type = ParameterType::rings,
       .default_value = "",
       .example = "7,1 9,1 9,3 7,3; 4,1 5,1 5,2",
       .help = "holes in it, apart from one another (separate_pieces alone)",
       .least = 3,
       .most = 200,
       .parts = {"x", "y"},
       .sizes = plane_sizes},
      {.name = "window",
       .type = ParameterType::bounds,
       .default_value = "0,0,10,10",
       .example = "0,0,10,10",
       .help = "the rectangle to clip at, its borders included",
       .parts = {"xmin", "ymin", "xmax", "ymax"},
       .sizes = plane_sizes},
      {.name = "window_polygon",
       .type = ParameterType::points,
       .default_value = "",
       .example = "5,-3 12,3 8,10 -2,7",
       .help = "a convex window instead: its corners in order; cut at in that order, counter-clockwise",
       .least = 3,
       .most = 50,
       .parts = {"x", "y"},
       .instead_of = "window",
       .sizes = plane_sizes},
      {.name = "homogeneous",
       .type = ParameterType::points,
       .default_value = "-2,-1,2.75,3 1.5,-1.5,1.65,2 1.5,2,-1.65,-1",
       .example = "-2,-1,2.75,3 1.5,-1.5,1.65,2 1.5,2,-1.65,-1",
       .help = "method homogeneous: the corners in clip space, not divided by w yet",
       .least = 3,
       .most = 50,
       .parts = {"x", "y", "z", "w"}},
      {.name = "order",
       .type = ParameterType::order,
       .default_value = "left,right,bottom,top",
       .example = "bottom,left,top,right",
       .help = "in which order the borders are cut at; those of window_polygon by their numbers, as 3,1,2",
       .choices = {"left", "right", "bottom", "top"},
       .numbered = true},
      exact_parameter()};
  return all;
}
const Parameter& order_parameter() {
  return *std::ranges::find(parameters(), ParameterType::order, &Parameter::type);
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "sutherland_hodgman",
      .title = Wording().say("sutherland_hodgman.title"),
      .chapter = "clipping",
      .aliases = {"polygon clipping", "reentrant clipping", "weiler atherton"},
      .summary = "the part of a polygon that lies in a convex window, border by border",
      .methods = all_methods(),
      .default_method = "border_by_border",
      .parameters = parameters(),
      .examples = {"--polygon '2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4' --window 0,0,10,10",
                   "--polygon '2,-4 8,-4 8,4 6,4 6,-2 4,-2 4,4 2,4' --method separate_pieces",
                   "--window-polygon '5,-3 12,3 8,10 -2,7'",
                   "--method homogeneous --homogeneous '-2,-1,2.75,3 1.5,-1.5,1.65,2 1.5,2,-1.65,-1'"},
      .run = run};
  return topic;
}

}  // namespace gradus::sutherland_hodgman
