#pragma once
// Sutherland and Hodgman's passes: at each border corner after corner is tested, and edges are cut.

#include "stories/clipping/sutherland_hodgman/drawing.hpp"

namespace gradus::sutherland_hodgman {

class BorderStory : public PlaneDrawing {
 public:
  using PlaneDrawing::say;
  using PlaneDrawing::show;

  /// right: for faulty methods the area that is right.
  BorderStory(const Words& words, const Subject& subject, std::optional<double> right)
      : PlaneDrawing(words, subject), right_(right) {}

  void show(Board& board, const VertexTested<double>& t) {
    begin_border(t.border);
    ++met_;
    quiet();
    mark_side(t.vertex, t.side);
    row_ = row_of(t);
    add_edge(t.last, t.vertex);
    put(board);
  }
  Event say(const VertexTested<double>& t) {
    const std::size_t answer = t.side > 0 ? 0 : t.side == 0 ? 1 : 2;
    constexpr std::array<const char*, 3> branches{"inside", "on", "outside"};
    constexpr std::array<std::string_view, 3> texts{"tested.inside", "tested.on", "tested.outside"};
    const std::string border = border_in_words(t.border);
    return {
        .text = texts[answer],
        .facts = {{"border", t.border}, {"side", t.side}, {"x", t.vertex.at.x}, {"y", t.vertex.at.y}},
        .words = {{"corner", names_(t.vertex)}, {"at", t.vertex.at}, {"border", border}},
        .row = row_,
        .phase = phase_of(t.border),
        .decides = Decision{words_.say("question.side", {{"corner", names_(t.vertex)}, {"border", border}}),
                            {side_text(1), side_text(0), side_text(-1)},
                            answer,
                            branches[answer]}};
  }

  void show(Board& board, const EdgeCut<double>& c) {
    quiet();
    const std::string name = names_(c.vertex);
    keep(c.vertex);
    const dvec2 at = panel_.at(c.vertex.at), from = panel_.at(c.from.at), to = panel_.at(c.to.at);
    view_.add({"f edge", Role::current, c.leaves ? Stroke{from, at, true} : Stroke{at, to, true}});
    view_.add({"f cut off", Role::rejected, c.leaves ? Stroke{at, to} : Stroke{from, at}});
    view_.add({"f here", Role::measure, Dot{at}});
    view_.add({"g made " + name, Role::measure,
               Label{at, fmt::format("{} = {}", name, figure_place(c.vertex.at))}});
    put(board);
    // From now on the name alone
    view_.add({"e side " + name, Role::result, Dot{at}});
    view_.add({"g made " + name, Role::result, Label{at, name}});
  }
  Event say(const EdgeCut<double>& c) {
    const std::string name = names_(c.vertex), border = border_in_words(c.border);
    const std::string from = names_(c.from), to = names_(c.to);
    Event event{
        .text = c.vertex.edge.of_window() ? "cut.corner"
                : c.leaves                ? "cut.leaves"
                                          : "cut.enters",
        .facts = {{"border", c.border}, {"leaves", c.leaves}, {"x", c.vertex.at.x}, {"y", c.vertex.at.y}},
        .words = {{"from", from}, {"to", to}, {"border", border}, {"name", name}, {"at", c.vertex.at}},
        .phase = phase_of(c.border),
        .decides = yes_or_no(words_, "question.cut", {{"from", from}, {"to", to}, {"border", border}}, true,
                             c.leaves ? "leaves" : "enters")};
    event.read = row_;
    return event;
  }

  void show(Board& board, const VertexKept<double>& k) {
    quiet();
    keep(k.vertex);
    view_.add({"f here", Role::current, Dot{panel_.at(k.vertex.at)}});
    board.detail(View(view_));
  }
  Event say(const VertexKept<double>& k) {
    return {.text = "kept",
            .facts = {{"border", k.border}, {"x", k.vertex.at.x}, {"y", k.vertex.at.y}},
            .words = {{"corner", names_(k.vertex)}},
            .count = std::ssize(kept_),
            .read = row_,
            .phase = phase_of(k.border)};
  }

  void show(Board& board, const BorderPassed<double>& p) {
    begin_border(p.border);
    quiet();
    erase("e ");
    pass_border({p.polygon});
    put(board);
    leave_border();
  }
  Event say(const BorderPassed<double>& p) const {
    const auto corners = std::ssize(p.polygon);
    Event event{.text = "passed_empty",
                .facts = {{"border", p.border}, {"corners", corners}},
                .words = {{"border", border_in_words(p.border)}},
                .note = words_.count("passed_note", corners, {{"before", met_}}),
                .phase = phase_of(p.border),
                .level = Level::idea,
                .decides = yes_or_no(words_, "question.left", {}, corners > 0, "accepted", "rejected")};
    if (corners == 0) return event;
    event.text = "passed";
    event.count = corners;
    return event;
  }

  /// What came out, in its look; the next step shows it.
  void add_result(std::span<const Vertex<double>> polygon) {
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

  void show(Board& board, const BridgeFound<double>& b) {
    quiet();
    const dvec2 from = panel_.at(b.from.at), to = panel_.at(b.to.at);
    bridges_.emplace_back(b.from.at, b.to.at);
    // The outline without the bridges, so that they are seen
    erase("h line");
    for (std::size_t i = 0; i < result_.size(); ++i) {
      add_without_bridges(i, result_[i], result_[i + 1 < result_.size() ? i + 1 : 0]);
    }
    const std::string id = fmt::format("i bridge {:03}", bridges_.size() - 1);
    view_.add({id, Role::candidate, Stroke{from, to}});
    view_.add({id + " name", Role::candidate, Label{(from + to) * 0.5, words_.say("bridge_name")}});
    put(board);
  }
  Event say(const BridgeFound<double>& b) {
    return {.text = "bridge",
            .facts = {{"border", b.border},
                      {"from_x", b.from.at.x, "x"},
                      {"from_y", b.from.at.y, "y"},
                      {"to_x", b.to.at.x, "x"},
                      {"to_y", b.to.at.y, "y"}},
            .words = {{"from", names_(b.from)}, {"to", names_(b.to)}, {"border", border_in_words(b.border)}},
            .phase = words_.shared("words", "result")};
  }

  void show(Board& board, const steps::Finished&) {
    quiet();
    put(board);
  }
  Event say(const steps::Finished&) const {
    Event event{.text = "nothing",
                .words = {{"area", std::abs(area_of(result_))}, {"corners", result_.size()}}};
    if (right_) {
      event.text = "done_wrong";
      event.words.push_back({"right", *right_});
    } else if (!bridges_.empty()) {
      event.text = "done_bridges";
      event.count = std::ssize(bridges_);
    } else if (!result_.empty()) {
      event.text = "done";
    }
    return event;
  }

 private:
  std::string side_text(int side) const {
    return words_.say(side > 0 ? "side.inside" : side < 0 ? "side.outside" : "side.on");
  }
  std::vector<Said> row_of(const VertexTested<double>& t) {
    const std::string name = names_(t.vertex);
    return {fmt::format("{} → {}", names_(t.last), name), side_text(t.was), side_text(t.side), ""};
  }
  /// The edge that is looked at, and its corners' names.
  void add_edge(const Vertex<double>& last, const Vertex<double>& now) {
    const dvec2 from = panel_.at(last.at), to = panel_.at(now.at);
    view_.add({"f edge", Role::current, Stroke{from, to, true}});
  }
  void begin_border(int border) {
    if (!enter_border(border)) return;
    kept_.clear();
    met_ = 0;
  }
  /// A corner joins what stays, and the row of its edge says so.
  void keep(const Vertex<double>& vertex) {
    kept_.push_back(vertex.at);
    const std::string name = names_(vertex);
    if (!row_.empty()) row_.back() = row_.back().text.empty() ? name : row_.back().text + ", " + name;
    if (kept_.size() > 1) view_.add({"d kept", Role::result, Path{panel_.at(kept_)}});
  }
  /// An edge of the result but for the stretches of bridges on it.
  void add_without_bridges(std::size_t number, dvec2 a, dvec2 b) {
    const dvec2 way = b - a;
    const double square = glm::dot(way, way);
    if (square == 0) return;
    std::vector<std::pair<double, double>> gaps;
    for (const auto& [from, to] : bridges_) {
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

  const std::optional<double> right_;
  std::vector<Said> row_;  ///< of the edge at hand
  std::int64_t met_ = 0;   ///< corners that met this border
  Points kept_, result_;
  std::vector<std::pair<dvec2, dvec2>> bridges_;
};

}  // namespace gradus::sutherland_hodgman
