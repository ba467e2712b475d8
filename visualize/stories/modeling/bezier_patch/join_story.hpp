#pragma once
// Two patches joined more and more smoothly: the rows that each order of continuity puts, the surface in
// bands that show what the eye misses, a section across the seam with its curvature, and what was measured.

#include <array>
#include <glm/gtc/constants.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figure/aside.hpp"
#include "stories/modeling/bezier_patch/subject.hpp"
#include "stories/past.hpp"
#include "stories/rendered_surface.hpp"

namespace gradus::bezier_patch {

struct JoinSubject {
  Net first, second;
  double k;
  Continuity order;
  faces_subject::Reader reader;
};

inline constexpr std::array<const char*, 4> order_names{"C0", "G1", "C1", "C2"};
inline constexpr int places_measured = 32;

inline double degrees(double radians) { return radians * (180 / glm::pi<double>()); }

inline JoinSubject join_subject_of(const Arguments& arguments) {
  const auto order = std::ranges::find(order_names, arguments.text("order")) - order_names.begin();
  JoinSubject subject{net_of(arguments, "control"), net_of(arguments, "second"), *arguments.number("k"),
                      static_cast<Continuity>(order), faces_subject::reader_of(arguments)};
  if (!(0 < subject.k && subject.k <= 16))
    refuse("k", "expected a length above 0, up to 16, found {}", subject.k);
  if (subject.first.rows() != subject.second.rows())
    refuse(arguments, {"second", "control"},
           fmt::format("expected as many rows in both patches, found {} and {}", subject.first.rows(),
                       subject.second.rows()));
  if (subject.order == Continuity::C2 && subject.first.rows() < 3)
    refuse(arguments, {"order", "control", "columns"}, "expected at least three rows for C2, found two");
  return subject;
}

/// A plane across the seam in its middle, as it is looked at along the seam.
struct SectionPlane {
  dvec3 origin, across, up;

  explicit SectionPlane(const Net& first) : origin(de_casteljau(first, 0.5, 1.0).point) {
    const Frame<double> f = de_casteljau(first, 0.5, 1.0);
    const dvec3 along = unit_vector(f.along_u);
    dvec3 hint{0, 1, 0};
    if (std::abs(along.y) > 0.9) hint = {1, 0, 0};
    across = unit_vector(glm::cross(hint, along));
    if (glm::dot(across, f.along_v) < 0) across = -across;
    up = unit_vector(hint - glm::dot(hint, along) * along);
  }
  dvec2 flat(dvec3 p) const { return {glm::dot(p - origin, across), glm::dot(p - origin, up)}; }
};

/// The section through one patch, and at each place the curvature across, drawn away from its centre.
struct Section {
  std::vector<dvec2> curve{}, way{};  ///< way: the curvature as a vector
  double most = 0;

  Section(const Net& net, const SectionPlane& plane) {
    constexpr int pieces = 20;
    for (int k = 0; k <= pieces; ++k) {
      const Crossing<double> c = crossing(net, 0.5, static_cast<double>(k) / pieces);
      const dvec2 normal{glm::dot(c.normal, plane.across), glm::dot(c.normal, plane.up)};
      curve.push_back(plane.flat(c.point));
      way.push_back(-c.curvature * normal);
      most = std::max(most, std::abs(c.curvature));
    }
  }
};

class JoinStory : public Past<steps::Started, RowSet<double>, SeamMeasured<double>, steps::Finished> {
 public:
  /// nets: the second patch as it was given, then by each order.
  /// back: by the fault, that takes a difference the other way round.
  JoinStory(const Words& words, const JoinSubject& subject, std::vector<Net> nets, bool back)
      : words_(words),
        subject_(subject),
        back_(back),
        nets_(std::move(nets)),
        plane_(subject.first),
        first_(subject.first, plane_) {
    most_ = first_.most;
    for (const Net& net : nets_) {
      sections_.emplace_back(net, plane_);
      if (sections_.size() > 1) most_ = std::max(most_, sections_.back().most);
    }
    for (const Net* net : all_nets()) {
      for (const dvec3 p : net->points) extent_.add(subject.reader.flat(p));
    }
    extent_ = widened(extent_, 0.01);
  }

  dvec2 at(dvec3 p) const { return panel(whole).at(subject_.reader.flat(p)); }
  Panel shown() const { return panel(whole); }
  /// The line that put the last row.
  void set_at(int line) { line_ = line; }

  double tells(const auto& step) const {
    return std::same_as<std::decay_t<decltype(step)>, steps::Finished> ? 1 : 0;
  }

  Event say(const steps::Started&) const {
    const Seam<double> seam = measure(subject_.first, nets_[0], places_measured);
    return {.text = "join.started", .words = {{"gap", short_real(seam.gap)}}};
  }
  Event say(const RowSet<double>& r) const {
    static constexpr std::array texts{"row_set.c0", "row_set.g1", "row_set.c1", "row_set.c2"};
    static constexpr std::array turned{"row_set.c0", "row_set.turned.g1", "row_set.turned.c1",
                                       "row_set.turned.c2"};
    const std::size_t order = current();
    return {.text = back_ ? turned[order] : texts[order],
            .facts = {{"row", static_cast<std::int64_t>(r.row)}},
            .words = {{"k", subject_.k},
                      {"columns", r.points.size()},
                      {"last", subject_.first.rows() - 1},
                      {"before", subject_.first.rows() - 2},
                      {"third", subject_.first.rows() - 3}},
            .key = order_names[order],
            .phase = order_names[order]};
  }
  Event say(const SeamMeasured<double>& m) const {
    // No gap is left: the border is one
    static constexpr std::array texts{"seam.crease", "seam.crease", "seam.slope", "seam.curvature",
                                      "seam.smooth"};
    static constexpr std::array branches{"gap", "crease", "slope", "curvature", "none"};
    const std::size_t order = current(), kind = first_difference(m.seam);
    std::vector<std::string> answers;
    for (const char* quantity : quantities) answers.push_back(words_.say(quantity));
    answers.push_back(words_.say("none"));
    const auto [gap, angle, slope, curvature] = values(m.seam);
    return {.text = angle > 90 ? "seam.folded" : texts[kind],
            .facts = {{"gap", m.seam.gap},
                      {"angle", degrees(m.seam.angle)},
                      {"slope", m.seam.slope},
                      {"curvature", m.seam.curvature}},
            .words = {{"order", order_names[order]},
                      {"angle_text", short_angle(angle)},
                      {"slope_text", short_real(slope)},
                      {"curvature_text", short_real(curvature)}},
            .note = headline(m.seam),
            .row = {order_names[order], short_real(gap), short_angle(angle), short_real(slope),
                    short_real(curvature)},
            .key = order_names[order],
            .phase = order_names[order],
            .decides = Decision{words_.say("question.differs", {{"order", order_names[order]}}), answers,
                                kind, branches[kind]},
            .line = line_};
  }
  Event say(const steps::Finished&) const {
    std::string list;
    for (const SeamMeasured<double>& m : all<SeamMeasured<double>>()) {
      if (!list.empty()) list += ", ";
      const std::size_t kind = first_difference(m.seam);
      list +=
          fmt::format("{} {}", order_names[static_cast<std::size_t>(&m - all<SeamMeasured<double>>().data())],
                      kind == 4 ? words_.say("none") : line(kind, values(m.seam)[kind]));
    }
    return {.text = "join.finished", .words = {{"list", list}}, .line = line_};
  }

  View draw() const {
    View view;
    if (now<steps::Finished>()) {
      for (std::size_t k = 1; k < nets_.size(); ++k) add_small(view, k);
      return view;
    }
    const auto* measured = now<SeamMeasured<double>>();
    const std::size_t shown = now<steps::Started>() ? 0 : current() + 1;
    add_picture(view, "a picture", panel(whole), shown);
    if (shown == 0)
      add_nets(view);
    else
      add_rows(view, shown);
    add_section(view, shown);
    if (measured) add_numbers(view, measured->seam);
    return view;
  }

 private:
  static constexpr Extent whole{{0.3, 0.3}, {35.7, 17.3}}, section{{0.5, 18}, {23.5, 26.8}};
  /// Of all orders; two lie above each other.
  static constexpr std::array<Extent, 4> small{{{{0.3, 13.7}, {17.7, 26.8}},
                                                {{18.3, 13.7}, {35.7, 26.8}},
                                                {{0.3, 0.2}, {17.7, 13.3}},
                                                {{18.3, 0.2}, {35.7, 13.3}}}};
  Extent place_of(std::size_t k) const {
    const std::size_t orders = nets_.size() - 1;
    if (orders == 1) return {{0.3, 0.2}, {35.7, 26.8}};
    if (orders == 2) return {small[2 * k - 2].lower, small[2 * k - 1].upper};
    return small[k - 1];
  }
  static constexpr std::array<const char*, 4> quantities{"gap", "angle", "slope", "curvature"};

  std::vector<const Net*> all_nets() const {
    std::vector<const Net*> all{&subject_.first};
    for (const Net& net : nets_) all.push_back(&net);
    return all;
  }
  Panel panel(const Extent& place) const { return Panel(place, extent_); }
  /// The order at hand.
  std::size_t current() const {
    const std::size_t measured = all<SeamMeasured<double>>().size();
    return now<SeamMeasured<double>>() ? measured - 1 : measured;
  }

  // What was measured

  double size() const { return size_of(subject_.first.points); }
  /// Gap, angle in degrees, slope, curvature; 0 for what is no more than a rounding.
  std::array<double, 4> values(const Seam<double>& s) const {
    const auto above = [](double value, double noise) { return value > noise ? value : 0; };
    return {above(s.gap, 1e-9 * size()), above(degrees(s.angle), 1e-5), above(s.slope, 1e-8 * size()),
            above(s.curvature, std::max(1e-7 * most_, 1e-9 / size()))};
  }
  std::size_t first_difference(const Seam<double>& s) const {
    const auto all = values(s);
    return static_cast<std::size_t>(std::ranges::find_if(all, [](double x) { return x > 0; }) - all.begin());
  }
  static std::string short_angle(double value) { return figure_real(std::round(value * 10) / 10); }
  /// What differs first, in a few words.
  std::string headline(const Seam<double>& s) const {
    const std::size_t kind = first_difference(s);
    return kind == 4 ? words_.say("none.differs") : line(kind, values(s)[kind]);
  }
  std::string line(std::size_t kind, double value) const {
    return kind == 1 ? fmt::format("{} {}°", words_.say("angle"), short_angle(value))
                     : fmt::format("{} {}", words_.say(quantities[kind]), short_real(value));
  }
  void add_numbers(View& view, const Seam<double>& s) const {
    const auto all = values(s);
    const std::size_t kind = first_difference(s);
    for (std::size_t i = 0; i < all.size(); ++i)
      view.add({fmt::format("z {}", i),
                i == kind  ? Role::rejected
                : i < kind ? Role::accepted
                           : Role::past,
                Text{{24.4, 25.4 - 2 * static_cast<double>(i)}, line(i, all[i]), Align::left, true}});
  }

  // Drawings

  std::shared_ptr<const Image> rendered(std::size_t k) const {
    auto& picture = pictures_[k];
    if (picture) return picture;
    constexpr int pieces = 40;
    Points<double> points, normals;
    Faces faces;
    for (const Net* net : {&subject_.first, &nets_[k]}) {
      const auto from = static_cast<std::int32_t>(points.size());
      const auto surface = on_grid(*net, pieces, pieces);
      points.insert(points.end(), surface.points.begin(), surface.points.end());
      const auto its_normals = normals_on_grid(*net, pieces);
      normals.insert(normals.end(), its_normals.begin(), its_normals.end());
      for (std::size_t f = 0; f < surface.faces.size(); ++f) {
        const auto r = surface.faces[f];
        faces.add(std::array{from + r[0], from + r[1], from + r[2], from + r[3]});
      }
    }
    const faces_subject::Reader& reader = subject_.reader;
    picture = rendered_surface(points, faces,
                               {.right = reader.right,
                                .up = reader.up,
                                .towards = reader.towards,
                                .shown = extent_,
                                .width = 400,
                                .normals = normals,
                                .bands = {9, 0, 0}});
    return picture;
  }
  void add_picture(View& view, const std::string& id, const Panel& shown, std::size_t k) const {
    view.add({id, Role::past, Picture{shown.at(extent_.lower), shown.at(extent_.upper), rendered(k)}});
  }
  /// One of four.
  void add_small(View& view, std::size_t k) const {
    const Extent place = place_of(k);
    const Panel shown = panel({place.lower, place.upper - dvec2{0, 1.9}});
    // Panels show of a drawing what lies where they have the surface: the later orders
    const bool aside = place.lower.y > whole.lower.y && nets_.size() > 2;
    const std::string id = fmt::format("{}a {}", aside ? aside_prefix : "", k);
    add_picture(view, id, shown, k);
    add_seam(view, id + " seam", shown, nets_[k].row(0));
    const double y = place.upper.y - 0.8;
    view.add({id + " name", Role::current, Text{{place.lower.x + 0.4, y}, order_names[k - 1], Align::left}});
    view.add(
        {id + " number", Role::past,
         Text{{place.upper.x - 0.4, y}, headline(all<SeamMeasured<double>>()[k - 1].seam), Align::right}});
  }
  /// Where the seam goes on in front of the surface.
  void add_seam(View& view, const std::string& id, const Panel& shown, Points<double> row) const {
    const auto depth = [&](dvec3 p) { return glm::dot(p, subject_.reader.towards); };
    if (depth(row.front()) > depth(row.back())) std::ranges::reverse(row);
    const dvec2 end = shown.at(subject_.reader.flat(row.back()));
    const dvec2 way = end - shown.at(subject_.reader.flat(row[row.size() - 2]));
    const double length = length_of(way);
    if (length > 0) view.add({id, Role::result, Stroke{end, end + 1.2 / length * way}});
  }
  void add_path(View& view, const std::string& id, Role role, const Points<double>& points) const {
    view.add({id, role, Path{mapped(points, [&](dvec3 p) { return at(p); })}});
  }
  /// A row with its name at the end that is nearer.
  void add_row(View& view, const std::string& id, Role role, const Points<double>& row,
               std::string name) const {
    add_path(view, id, role, row);
    const auto depth = [&](dvec3 p) { return glm::dot(p, subject_.reader.towards); };
    const dvec3 end = depth(row.front()) > depth(row.back()) ? row.front() : row.back();
    view.add({id + " name", role, Label{at(end), std::move(name)}});
    for (std::size_t i = 0; i < row.size(); ++i)
      view.add({fmt::format("{} {}", id, i), role, Dot{at(row[i])}});
  }
  /// Both as they were given.
  void add_nets(View& view) const {
    for (Index j = 0; j < subject_.first.rows(); ++j) {
      add_row(view, fmt::format("c first {}", j), Role::input, subject_.first.row(j), fmt::format("P{}", j));
      add_row(view, fmt::format("c second {}", j), Role::candidate, nets_[0].row(j), fmt::format("Q{}", j));
    }
  }
  /// The last rows of the first patch, and those of the second that this order puts, the last one strong.
  void add_rows(View& view, std::size_t k) const {
    const Net &P = subject_.first, &Q = nets_[k];
    const Index m = P.rows() - 1, last = rows_of(k);
    for (Index j = std::max(last, Index{1}); j > 0; --j)
      add_row(view, fmt::format("c first {}", j), Role::input, P.row(m - j), fmt::format("P{}", m - j));
    for (Index j = 0; j <= last; ++j)
      add_row(view, fmt::format("d second {}", j), j == last ? Role::current : Role::accepted, Q.row(j),
              j == 0 ? fmt::format("P{}", m) : fmt::format("Q{}", j));
    for (Index i = 0; i < P.columns; ++i) {
      Points<double> before, behind{P(m, i)};
      for (Index j = std::max(last, Index{1}); j + 1 > 0; --j) before.push_back(P(m - j, i));
      for (Index j = 1; j <= last; ++j) behind.push_back(Q(j, i));
      add_path(view, fmt::format("b before {}", i), Role::input, before);
      if (behind.size() > 1) add_path(view, fmt::format("b behind {}", i), Role::current, behind);
    }
  }
  /// 0 for C0, 1 for G1 and C1, 2 for C2.
  static Index rows_of(std::size_t k) { return k == 1 ? 0 : k == 4 ? 2 : 1; }

  void add_section(View& view, std::size_t k) const {
    Extent extent;
    for (const Section* s : {&first_, &sections_[0], &sections_[1], &sections_.back()}) {
      for (const dvec2 p : s->curve) extent.add(p);
    }
    const double scale = most_ > 0 ? 0.25 * extent.size().x / most_ : 0;
    for (const Section* s : all_sections()) {
      for (std::size_t i = 0; i < s->curve.size(); ++i) extent.add(s->curve[i] + scale * s->way[i]);
    }
    const Panel shown(section, extent);
    add_comb(view, "aside m first", Role::input, shown, first_, scale);
    add_comb(view, "aside m second", k == 0 ? Role::candidate : Role::current, shown, sections_[k],
             k == 0 ? 0 : scale);
  }
  std::vector<const Section*> all_sections() const {
    std::vector<const Section*> all{&first_};
    for (std::size_t k = 1; k < sections_.size(); ++k) all.push_back(&sections_[k]);
    return all;
  }
  static void add_comb(View& view, const std::string& id, Role role, const Panel& shown, const Section& s,
                       double scale) {
    std::vector<dvec2> tips;
    for (std::size_t i = 0; i < s.curve.size(); ++i) {
      tips.push_back(shown.at(s.curve[i] + scale * s.way[i]));
      if (length_between(tips.back(), shown.at(s.curve[i])) > 0.01)
        view.add({fmt::format("{} tooth {:02}", id, i), Role::measure,
                  Stroke{shown.at(s.curve[i]), tips.back(), false, false, true}});
    }
    for (std::size_t i = 1; scale > 0 && i < tips.size(); ++i)
      view.add({fmt::format("{} comb {:02}", id, i), Role::measure,
                Stroke{tips[i - 1], tips[i], false, false, true}});
    view.add({id + " curve", role, Path{shown.at(s.curve)}});
  }

  const Words& words_;
  const JoinSubject& subject_;
  const bool back_;
  const std::vector<Net> nets_;
  const SectionPlane plane_;
  const Section first_;
  std::vector<Section> sections_{};
  double most_ = 0;
  Extent extent_{};
  int line_ = 0;
  mutable std::map<std::size_t, std::shared_ptr<const Image>> pictures_{};
};

/// Each order up to the one that is asked for. joined(order, observer): the second patch. Returns the last.
template <class Joined>
Net tell_orders(Narrator& narrator, const JoinSubject& subject, const Joined& joined) {
  std::vector<Net> nets{subject.second};
  const auto last = static_cast<std::size_t>(subject.order);
  for (std::size_t k = 0; k <= last; ++k) nets.push_back(joined(static_cast<Continuity>(k)));
  auto has_normals = [&] {
    const SectionPlane plane(subject.first);
    const Section whole(subject.first, plane);
    for (const Net& net : nets) {
      measure(subject.first, net, places_measured);
      const Section one(net, plane);
    }
  };
  if (!keeps_contracts(has_normals))
    refuse(narrator.arguments(), {"control", "second", "columns"},
           "expected patches with a normal along the seam and across it");
  JoinStory story(narrator.words(), subject, nets, narrator.method().standing == Standing::faulty);
  require_scale(story.shown(), narrator.arguments(), {"control", "second"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle.join", {{"rows", subject.first.rows()}, {"columns", subject.first.columns}});
  narrator.columns({{"order", false}, {"gap"}, {"angle"}, {"slope"}, {"curvature"}});
  narrator.legend({{Role::input, "first"},
                   {Role::candidate, "given"},
                   {Role::accepted, "set"},
                   {Role::current, "now"},
                   {Role::measure, "comb"}});
  narrator.handles("control", [&](dvec3 p) { return story.at(p); });
  narrator.handles("second", [&](dvec3 p) { return story.at(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (std::size_t k = 0; k <= last; ++k) {
    const Index row = k == 0 ? 0 : k == 3 ? 2 : 1;
    const auto its_row = [&](const RowSet<double>& step, int line = __builtin_LINE(),
                             const char* file = __builtin_FILE()) {
      if (step.row != row) return;
      watch(step, line, file);
      story.set_at(narrator.line());
    };
    joined(static_cast<Continuity>(k), its_row);
    measure(subject.first, nets[k + 1], places_measured, watch);
  }
  watch(steps::Finished{}, 0);
  const Seam<double> seam = measure(subject.first, nets.back(), places_measured);
  narrator.result({{"gap", seam.gap},
                   {"angle", degrees(seam.angle)},
                   {"slope", seam.slope},
                   {"curvature", seam.curvature}});
  return nets.back();
}

}  // namespace gradus::bezier_patch
