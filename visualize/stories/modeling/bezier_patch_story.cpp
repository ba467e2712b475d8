// The story of Bézier patches: a point found row by row and then in the column of what they leave; two
// patches joined more and more smoothly.

#include "modeling/bezier_patch/bezier_patch.hpp"

#include "modeling/bezier_patch/bezier_patch_notes.hpp"
#include "stories/modeling/bezier_patch/checking.hpp"
#include "stories/modeling/bezier_patch/drawing.hpp"
#include "stories/modeling/bezier_patch/join_story.hpp"
#include "stories/past.hpp"

namespace gradus::bezier_patch {
namespace {

class PointStory : public Past<steps::Started, RowReduced<double>, Reached<double>, TangentsFound<double>,
                               NormalFound<double>> {
 public:
  PointStory(const Words& words, const Net& net, dvec2 uv, const PatchDrawing& drawing, bool transposed)
      : words_(words), net_(net), uv_(uv), drawing_(drawing), transposed_(transposed) {}

  Event say(const steps::Started&) const {
    return {.text = "started",
            .words = {{"rows", net_.rows()}, {"columns", net_.columns}, {"u", uv_.x}, {"v", uv_.y}}};
  }
  Event say(const RowReduced<double>& r) const {
    return {.text = transposed_ ? "row_reduced.transposed" : "row_reduced",
            .facts = with_index(r),
            .words = {{"name", name_of(r.row)},
                      {"number", r.row},
                      {"u", uv_.x},
                      {"point", shown(r.at.point)},
                      {"first", shown(r.at.first)}},
            .note = name_of(r.row),
            .row = with_tangent({name_of(r.row), shown(r.at.point)}, r.at.first),
            .key = name_of(r.row),
            .phase = words_.say("phase.rows")};
  }
  Event say(const Reached<double>& r) const {
    return {.text = missed() ? "reached.missed" : "reached",
            .facts = fields_of(r.point),
            .words = {{"first", name_of(0)},
                      {"last", name_of(net_.rows() - 1)},
                      {"v", uv_.y},
                      {"point", shown(r.point)},
                      {"right", shown(right().point)},
                      {"off", length_between(r.point, right().point)}},
            .note = fmt::format("S = {}", short_place(r.point)),
            .row = {"S", shown(r.point)},
            .key = "S",
            .phase = words_.say("phase.column")};
  }
  Event say(const TangentsFound<double>& t) const {
    return {.text = "tangents",
            .facts = fields_of(t.along_u),
            .words = {{"along_u", shown(t.along_u)}, {"along_v", shown(t.along_v)}},
            .read = with_tangent({"S", shown(last<Reached<double>>()->point)}, t.along_u),
            .key = "S",
            .phase = words_.say("phase.frame")};
  }
  Event say(const NormalFound<double>& n) const {
    const double length = length_of(n.normal);
    return {
        .text = !is_defined() ? "normal.none"
                : by_limit()  ? "normal.limit"
                : transposed_ ? "normal.transposed"
                              : "normal",
        .facts = fields_of(n.normal),
        .words = {{"normal", shown(n.normal)}, {"unit", shown(unit_vector(n.normal))}, {"length", length}},
        .note = fmt::format("N = {}", short_place(n.normal)),
        .row = {"N", shown(n.normal)},
        .key = "N",
        .phase = words_.say("phase.frame"),
        .ends = true,
        .decides = yes_or_no(words_, "question.normal", {}, is_defined(), "normal", "none")};
  }

  /// The point, but for a normal that is not the tangents' product.
  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if constexpr (std::same_as<Step, NormalFound<double>>) return !is_defined() || by_limit() ? 2 : 0;
    return std::same_as<Step, Reached<double>> ? 1 : 0;
  }

  View draw() const {
    View view = drawing_.background();
    const auto& rows = all<RowReduced<double>>();
    const auto* reached = last<Reached<double>>();
    const auto* row = now<RowReduced<double>>();
    if (row) add_rounds(view, row->control, uv_.x);
    for (const RowReduced<double>& r : rows)
      add_name(view, fmt::format("v point {}", r.row), Role::accepted, r.at.point, name_of(r.row));
    if (!rows.empty()) add_in_square(view, "aside q u", Role::accepted, {uv_.x, 0}, {uv_.x, 1});
    if (reached) {
      view.add({"t curve", Role::accepted, drawing_.path(curve_of(reached->column))});
      if (now<Reached<double>>()) add_rounds(view, reached->column, uv_.y);
      add_in_square(view, "aside q v", Role::measure, {0, uv_.y}, {1, uv_.y}, true);
      add_name(view, "y S", Role::result, reached->point, "S");
      if (missed()) {
        add_name(view, "y right", Role::accepted, right().point, words_.say("right"));
        view.add({"x missed", Role::rejected,
                  Stroke{drawing_.at(reached->point), drawing_.at(right().point), false, true}});
      }
    }
    if (last<TangentsFound<double>>()) {
      add_arrow_along(view, "x u", Role::measure, tangent_u(), words_.say("tangent.u"));
      add_arrow_along(view, "x v", Role::measure, tangent_v(), words_.say("tangent.v"));
    }
    if (const auto* n = now<NormalFound<double>>(); n && is_defined())
      add_arrow_along(view, "x n", Role::result, n->normal, "N");
    view.add({"aside z uv", reached ? Role::result : Role::input, Dot{PatchDrawing::in_square(uv_)}});
    return view;
  }

 private:
  static std::string name_of(Index row) { return fmt::format("B{}", row); }
  static std::vector<Field> with_index(const RowReduced<double>& r) {
    std::vector<Field> fields{{"row", static_cast<std::int64_t>(r.row)}};
    std::ranges::move(fields_of(r.at.point), std::back_inserter(fields));
    return fields;
  }
  std::vector<Said> with_tangent(std::vector<Said> row, dvec3 along_u) const {
    if (!transposed_) row.push_back(shown(along_u));
    return row;
  }
  /// Without what is only a rounding.
  dvec3 shown(dvec3 p) const {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::abs(p[axis]) < 1e-12 * drawing_.size() ? 0 : p[axis];
    return p;
  }
  Frame<double> right() const { return de_casteljau(net_, uv_.x, uv_.y); }
  bool missed() const {
    const auto* reached = last<Reached<double>>();
    return transposed_ && reached && length_between(reached->point, right().point) > 1e-9 * drawing_.size();
  }
  dvec3 tangent_u() const { return last<TangentsFound<double>>()->along_u; }
  dvec3 tangent_v() const { return last<TangentsFound<double>>()->along_v; }
  bool by_limit() const { return is_defined() && (tangent_u() == dvec3{0} || tangent_v() == dvec3{0}); }
  /// Whether the normal is more than what roundings leave of parallel tangents.
  bool is_defined() const {
    const double longest = std::max({length_of(tangent_u()), length_of(tangent_v()), 1e-9 * drawing_.size()});
    return length_of(last<NormalFound<double>>()->normal) > 1e-9 * longest * longest;
  }

  void add_name(View& view, const std::string& id, Role role, dvec3 p, const std::string& name) const {
    view.add_named(id, role, drawing_.at(p), name);
  }
  static void add_in_square(View& view, const std::string& id, Role role, dvec2 from, dvec2 to,
                            bool dashed = false) {
    view.add({id, role, Stroke{PatchDrawing::in_square(from), PatchDrawing::in_square(to), false, dashed}});
  }
  /// A row or the column of points, and the rounds that reduce it; the last one is the tangent's edge.
  void add_rounds(View& view, Points<double> b, double t) const {
    view.add({"u control", Role::current, drawing_.path(b)});
    for (int round = 1; b.size() > 2; ++round) {
      for (Index i = 0; i + 1 < b.size(); ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
      b.pop_back();
      view.add({fmt::format("u round {}", round), Role::measure, drawing_.path(b, true)});
      for (Index i = 0; i < b.size(); ++i)
        view.add({fmt::format("u round {} {}", round, i), Role::measure, Dot{drawing_.at(b[i])}});
    }
  }
  /// From S.
  void add_arrow_along(View& view, const std::string& id, Role role, dvec3 way,
                       const std::string& name) const {
    const dvec3 from = last<Reached<double>>()->point, arrow = drawing_.arrow(way);
    if (arrow != dvec3{0}) add_arrow(view, id, role, drawing_.at(from), drawing_.at(from + arrow), name);
  }

  const Words& words_;
  const Net& net_;
  const dvec2 uv_;
  const PatchDrawing& drawing_;
  const bool transposed_;
};

dvec2 place_of(const Arguments& arguments) {
  const std::vector<double> uv = arguments.numbers("uv");
  if (!(0 <= uv[0] && uv[0] <= 1 && 0 <= uv[1] && uv[1] <= 1))
    refuse("uv", "expected u and v from 0 to 1, found {} and {}", uv[0], uv[1]);
  return {uv[0], uv[1]};
}

void give(Narrator& narrator, const std::vector<Net>& nets) {
  constexpr int pieces = 24;
  Points<double> points;
  Faces faces;
  for (const Net& net : nets) {
    const auto surface = on_grid(net, pieces, pieces);
    const auto from = static_cast<std::int32_t>(points.size());
    points.insert(points.end(), surface.points.begin(), surface.points.end());
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
      const auto ring = surface.faces[f];
      faces.add(std::array{from + ring[0], from + ring[1], from + ring[2], from + ring[3]});
    }
  }
  narrator.result(points, faces);
}

template <bool by_columns>
void tell_point(Narrator& narrator) {
  const Arguments& arguments = narrator.arguments();
  const Net net = net_of(arguments, "control");
  if (by_columns && net.rows() != net.columns)
    refuse(arguments, {"control", "columns"}, "expected as many rows as columns, which are mixed up here");
  const dvec2 uv = place_of(arguments);
  const faces_subject::Reader reader = faces_subject::reader_of(arguments);
  const auto found = [&](const auto&... watch) {
    if constexpr (by_columns)
      return transposed(net, uv.x, uv.y, watch...);
    else
      return de_casteljau(net, uv.x, uv.y, watch...);
  };
  const PatchDrawing drawing(narrator.words(), net, reader, found(), uv);
  require_scale(drawing.panel(), arguments, {"control"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"rows", net.rows()}, {"columns", net.columns}});
  // What the columns go along tells nothing of the surface
  if (by_columns)
    narrator.columns({{"point", false}, {"place", false}});
  else
    narrator.columns({{"point", false}, {"place", false}, {"along", false}});
  narrator.legend({{Role::input, "net"},
                   {Role::current, "row"},
                   {Role::accepted, "column"},
                   {Role::measure, "rounds"},
                   {Role::result, "point"},
                   {Role::rejected, "missed"}});
  if (!by_columns) {
    narrator.list("reduced");
    narrator.list_below(narrator.method().name);
  }
  narrator.handles("uv", [](dvec2 p) { return PatchDrawing::in_square(p); });
  narrator.handles("control", [&](dvec3 p) { return drawing.at(p); });
  PointStory story(narrator.words(), net, uv, drawing, by_columns);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Frame<double> f = found(watch);
  give(narrator, {net});
  narrator.result({{"x", f.point.x}, {"y", f.point.y}, {"z", f.point.z}});
}

template <bool back>
void tell_join(Narrator& narrator) {
  const JoinSubject subject = join_subject_of(narrator.arguments());
  const auto joined = [&](Continuity order, const auto&... watch) {
    if constexpr (back)
      return turned_back(subject.first, subject.second, order, subject.k, watch...);
    else
      return join(subject.first, subject.second, order, subject.k, watch...);
  };
  give(narrator, {subject.first, tell_orders(narrator, subject, joined)});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-6, 1e6};
  const std::vector<std::string> of_join{"second", "k", "order"};
  static const TopicEntry topic = completed<entry>(
      {.name = "bezier_patch",
       .chapter = "modeling",
       .aliases = {"bezier surface", "tensor product surface", "bicubic patch", "geometric continuity"},
       .summary =
           "a surface from a net of control points: a point with its normal, two patches joined smoothly",
       .methods =
           {{.name = "de_casteljau",
             .standing = Standing::taught,
             .tell = tell_point<false>,
             .unread = of_join},
            {.name = "join", .tell = tell_join<false>, .unread = {"uv"}},
            {.name = "transposed",
             .standing = Standing::faulty,
             .tell = tell_point<true>,
             .unread = of_join,
             .opening = {{"uv", "0.25,0.75"}}},
            {.name = "turned_back", .standing = Standing::faulty, .tell = tell_join<true>, .unread = {"uv"}}},
       .parameters = {points(4, 36, "control",
                             "0,-1,12 4,1,12 8,0,12 12,-2,12 0,3,8 4,6,8 8,5,8 12,2,8 "
                             "0,5,4 4,9,4 8,8,4 12,4,4 0,5,0 4,9,0 8,8,0 12,5,0",
                             "0,0,6 6,4,6 0,4,0 6,0,0", "control points, row by row", xyz, modest),
                      integer(2, 6, "columns", "4", "2", "how many control points a row has"),
                      numbers("uv", "0.4,0.6", "1/2,1/2", "where on the patch: u along the rows, v across",
                              {"u", "v"}, {1e-6, 1}),
                      points(4, 36, "second",
                             "0,3,-1 4,7,-1 8,6,-1 12,3,-1 0,2,-4 4,4,-4 8,4,-4 12,2,-4 "
                             "0,2,-8 4,4,-8 8,3,-8 12,2,-8 0,1,-12 4,2,-12 8,1,-12 12,0,-12",
                             "0,0,-1 6,2,-1 0,1,-6 6,1,-6", "those of the patch that is joined to it", xyz,
                             modest),
                      choice("order", {"C0", "G1", "C1", "C2"}, "C2", "G1",
                             "how far the patches shall agree at the seam"),
                      number("k", "0.75", "2",
                             "G1: how long the second patch's first edges are, beside the first one's last",
                             {1e-3, 16}),
                      faces_subject::towards_parameter("8,7,5")},
       .examples = {"--uv 1/2,1/2", "--columns 2 --control '0,0,6 6,4,6 0,4,0 6,0,0'",
                    "--method join --order G1 --k 2"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::bezier_patch
