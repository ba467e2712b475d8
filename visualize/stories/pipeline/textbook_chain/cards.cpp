#include "stories/pipeline/textbook_chain/cards.hpp"

#include <cmath>

#include "figure/text/number_text.hpp"
#include "stories/pipeline/textbook_chain/coordinates.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// What a card has room for.
constexpr std::size_t most_cuts = 2, most_corners = 4, most_tests = 5, most_lamps = 2;

/// The projection in the reader's notation: what it makes of his view space's axes, in his clip space.
glm::dmat4 shown_projection(const Words& words, const glm::dmat4& p) {
  glm::dmat4 shown{0};
  for (int i = 0; i < 4; ++i) {
    glm::dvec4 axis{0};
    axis[i] = i == 2 ? words.notation().third(1) : 1;
    shown[i] = shown_clip(words, p * axis);
  }
  return shown;
}

/// Its rows; or its columns, where vectors are rows.
Texts rows_of(const glm::dmat4& m, bool transposed, double noise) {
  Texts rows;
  for (int r = 0; r < 4; ++r) {
    rows.emplace_back();
    for (int c = 0; c < 4; ++c) rows.back().push_back(real_text(transposed ? m[r][c] : m[c][r], noise));
  }
  return rows;
}

template <int N>
Texts column_of(const glm::vec<N, double>& v, double noise) {
  Texts rows;
  for (int i = 0; i < N; ++i) rows.push_back({real_text(v[i], noise)});
  return rows;
}

/// An amount of light: a byte of the picture has no more than three decimals.
std::string light_text(double light) {
  return with_note(without_notes(figure_real(std::round(light * 1000) / 1000)), light);
}

std::string light_place(const dvec3& light) {
  return fmt::format("({}, {}, {})", light_text(light.x), light_text(light.y), light_text(light.z));
}

std::string hex_of(const Rgba8& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

}  // namespace

std::string depth_text(const Words& words, const DepthTested& test) {
  const std::string depth = fmt::format("{} = {}", words.symbol("z"), real_text(test.fragment.depth));
  if (!test.before) return depth;
  return fmt::format("{} {} {}", depth, test.nearer ? "<" : "≥", real_text(test.before->depth));
}

void Cards::strip(View& view, std::size_t stage) const {
  // As wide for all names, so that the stages keep their places in all languages
  constexpr double number_width = 0.9, wide = 11.8, height = 1.5;
  const double unit = paper_.unit();
  const std::string name = see(fmt::format("stage.{}", stage).c_str());
  const double whole = ChainPaper::card_left + ChainPaper::card_width;
  const double gap = (whole - wide - 7 * number_width) / 7;
  dvec2 at = dvec2{-0.5, -0.5} + dvec2{0, 0.95} * unit;
  for (std::size_t i = 1; i <= 8; ++i) {
    const bool told = i == stage;
    const double width = told ? wide : number_width;
    const dvec2 end = at + dvec2{width, 0} * unit;
    view.add({fmt::format("j strip {}", i), told ? Role::current : Role::guide,
              Text{(at + end) * 0.5, told ? name : fmt::format("{}", i), Align::centre, true}});
    if (told) {
      const dvec2 half{0, 0.5 * height * unit};
      view.add({"j strip told", Role::current,
                Path{{at - half, end - half, end + half, at + half}, true, false, true}});
    }
    const dvec2 next = end + dvec2{gap, 0} * unit;
    if (i < 8) {
      view.add({fmt::format("j strip way {}", i), Role::past,
                Path{{end + dvec2{0.15, 0} * unit, next - dvec2{0.15, 0} * unit}, false, false, true}});
    }
    at = next;
  }
}

void Cards::stages(View& view) const {
  Card card = this->card(view, "stages");
  for (int stage = 1; stage <= 8; ++stage) {
    card.say(see(fmt::format("stage.{}", stage).c_str()), Role::guide).line().down(0.35);
  }
}

void Cards::file(View& view) const {
  Card card = this->card(view, "file");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vertex = static_cast<std::size_t>(piece_.corners[i].vertex);
    card.say(fmt::format("{} = {}", vertex_name(i), at_text(run_.read[vertex].point.at)), Role::current)
        .line();
  }
  const FaceRead& face = run_.faces[static_cast<std::size_t>(piece_.id.face)];
  card.line();
  card.say(see("card.face", {{"line", face.line}, {"face", face.face}})).line();
  card.say(words_.count("card.corners", std::ssize(face.pieces), {{"corners", std::ssize(face.vertices)}}))
      .line();
  if (!way_.place) return;
  card.line();
  card.say(see("card.shows", {{"pixel", pixel_}})).line();
  card.say(at_text(way_.place->object));
}

void Cards::product(Card& card, const std::string& matrix, const glm::dmat4& m, std::size_t corner,
                    const glm::dvec4& from, const glm::dvec4& to) const {
  const bool rows = words_.notation().rows;
  const std::string name = vertex_name(corner);
  card.high(4).say(matrix + " =").block(rows_of(m, rows, run_.noise), Fence::brackets).line().down(0.5);
  card.say(fmt::format("{} = {}", name, at_text(from)), Role::current).line();
  const auto& [first, second] = rows ? std::tie(name, matrix) : std::tie(matrix, name);
  card.say(fmt::format("{}·{} =", first, second)).line();
  card.space(1).say(at_text(to), Role::current);
  card.line().down(0.5);
}

void Cards::moves(Card& card, const std::string& from, const std::string& to) const {
  card.say(see("card.moves", {{"pixel", pixel_}, {"from", from}})).line();
  card.say(fmt::format("→ {}", to)).line();
}

void Cards::placement(View& view, std::size_t corner) const {
  Card card = this->card(view, "placement");
  const Placed& placed = run_.placed[static_cast<std::size_t>(piece_.corners[corner].vertex)];
  product(card, words_.symbol("M"), run_.scene.objects[0].placement, corner, {placed.from.at, 1},
          {placed.to.at, 1});
  if (!way_.place) return;
  const PixelPlace& place = *way_.place;
  moves(card, at_text(place.object), at_text(place.world));
}

void Cards::projection(View& view, std::size_t corner) const {
  Card card = this->card(view, "projection");
  const double aspect = static_cast<double>(run_.size.width) / run_.size.height;
  const glm::dmat4 p = projection_matrix(projection_of(run_.scene.camera.lens, aspect));
  const Projected& v = projected(corner);
  product(card, words_.symbol("P"), shown_projection(words_, p), corner, {shown_view(words_, v.view), 1},
          shown_clip(words_, v.clip.at));
  if (!way_.place) return;
  const PixelPlace& place = *way_.place;
  moves(card, at_text(shown_view(words_, place.view)), at_text(shown_clip(words_, place.clip)));
}

void Cards::determinant(View& view) const {
  Card card = this->card(view, "determinant");
  Texts names, numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4 at = projected(i).clip.at;
    names.push_back({vertex_name(i)});
    numbers.push_back({length_text(at.x), length_text(at.y), length_text(at.w)});
  }
  const double det = exact_determinant({projected(0).clip.at, projected(1).clip.at, projected(2).clip.at});
  using back_face_culling::Facing;
  const bool front = faced_.facing == Facing::front;
  const std::string sign = det > 0 ? "> 0" : det < 0 ? "< 0" : "";
  card.high(3)
      .say("det")
      .block(names, Fence::none, Role::current, 1)
      .block(numbers, Fence::bars, Role::current)
      .line()
      .down(0.5);
  card.say(fmt::format("= {} {}", real_text(det), sign)).line().down(0.5);
  if (run_.fault == Fault::cull_after_division) {
    const double area =
        back_face_culling::divided_area(projected(0).clip.at, projected(1).clip.at, projected(2).clip.at);
    card.say(see(faced_.removed ? "card.area_removed" : "card.area_kept",
                 {{"area", area}, {"face", piece_.id.face}}),
             Role::rejected);
    return;
  }
  const char* verdict = front ? "card.front" : faced_.removed ? "card.removed" : "card.back";
  card.say(see(verdict, {{"face", piece_.id.face}}), faced_.removed ? Role::rejected : Role::accepted);
}

std::string Cards::corner_name(const glm::dvec4& at) const {
  const Clipped& own = *run_.clipped_of(piece_.id);
  const auto old = std::ranges::find(own.before, at, &ClipPoint::at);
  if (old != own.before.end()) return vertex_name(static_cast<std::size_t>(old - own.before.begin()));
  const auto found = std::ranges::find(own.after, at, &ClipPoint::at);
  return found == own.after.end() ? "" : fmt::format("c{}", found - own.after.begin());
}

std::string Cards::plane_text(const EdgeCut& cut) const {
  // Inside is sign * coordinate + bound * w >= 0
  const double limit = -cut.plane.sign * cut.plane.bound;
  const double factor = cut.plane.axis == 2 ? words_.notation().depth_of(limit) : limit;
  return fmt::format("{} = {}", words_.axis(cut.plane.axis), multiple_of_w(words_, factor));
}

void Cards::cut(Card& card, const EdgeCut& cut) const {
  const std::string from = corner_name(cut.inside), to = corner_name(cut.outside), made = corner_name(cut.at);
  if (from.empty() || to.empty() || made.empty()) return;
  const double in = distance(cut.plane, cut.inside), out = 0 - distance(cut.plane, cut.outside);
  card.say(see("card.cut", {{"from", from}, {"to", to}, {"plane", plane_text(cut)}})).line();
  card.say(fmt::format("t = {} / ({} + {})", length_text(in), length_text(in), length_text(out))).line();
  card.say(fmt::format("= {}", real_text(cut.t)));
  card.say(fmt::format("→ {}", made), Role::accepted).line();
}

void Cards::division(View& view) const {
  const Clipped* own = run_.clipped_of(piece_.id);
  if (!own) return;
  Card card = this->card(view, "division");
  if (own->after.empty()) {
    card.say(see("card.gone", {{"face", piece_.id.face}}), Role::rejected);
    return;
  }
  if (!own->changed) {
    const auto [low, high] = std::minmax({words_.notation().depth_of(0), words_.notation().depth_of(1)});
    card.say(fmt::format("{} ≤ {} ≤ {}", multiple_of_w(words_, low), words_.symbol("z"),
                         multiple_of_w(words_, high)));
    card.say(see("card.whole")).line();
  }
  for (std::size_t i = 0; i < std::min(way_.cuts.size(), most_cuts); ++i) cut(card, way_.cuts[i]);
  Texts rows;
  for (std::size_t k = 0; k < std::min(own->after.size(), most_corners); ++k) {
    // The table has the others
    if (k == 0) rows.push_back({"c0", at_text(shown_clip(words_, own->after[k].at))});
    rows.push_back({fmt::format("c{} ÷ {}", k, words_.symbol("w")),
                    place_text(shown_divided(words_, own->divided[k].at))});
  }
  card.down(0.4).high(rows.size()).block(rows, Fence::none, Role::current, 2);
}

void Cards::edges(View& view, const EdgeValues& e, const std::optional<dvec3>& found) const {
  Card card = this->card(view, "edges");
  const auto inside = [](dvec3 v) { return std::min({v.x, v.y, v.z}) >= 0; };
  if (found) {
    card.say(see("card.found")).line().space(1).say(place_text(*found), Role::rejected).line().down(0.4);
    card.say(see("card.exact")).line().space(1).say(place_text(e.values), Role::accepted);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = e.values[static_cast<int>(i)];
    card.say(fmt::format("{} = {}", edge_name(i), real_text(value)), Role::measure).line();
  }
  card.say(see(inside(e.values) ? "card.inside" : "card.outside", {{"pixel", pixel_}})).line().down(0.4);
  if (!way_.fragment) return;
  card.say(fmt::format("λ = E / {}", real_text(e.doubled_area))).line();
  card.say(fmt::format("= {}", place_text(e.weights))).line().down(0.4);
  for (int i = 0; i < 3; ++i) {
    card.say(i == 0 ? fmt::format("{} =", words_.symbol("z")) : "+");
    card.say(fmt::format("{}·{}", real_text(e.weights[i]), real_text(e.corner_depths[i])));
    if (i < 2) card.line();
  }
  card.say(fmt::format("= {}", real_text(way_.fragment->depth))).line().down(0.4);
  card.say(see("card.shares")).line();
  card.say(place_text(way_.fragment->weights)).line();
}

void Cards::depth(View& view, const DepthTested& last) const {
  Card card = this->card(view, "depth");
  std::size_t shown = 0;
  while (shown < way_.tests.size() && way_.tests[shown].fragment.triangle != last.fragment.triangle) ++shown;
  for (std::size_t i = shown < most_tests ? 0 : shown + 1 - most_tests; i <= shown; ++i) {
    const DepthTested& test = way_.tests[i];
    const char* verdict = !test.before ? "card.first" : test.nearer ? "card.nearer" : "card.farther";
    const Role role = test.nearer ? Role::accepted : Role::rejected;
    card.say(see("face", {{"face", test.fragment.id.face}})).say(depth_text(words_, test)).line();
    card.space(1).say(see(verdict, {{"pixel", pixel_}}), role).line().down(0.4);
  }
}

void Cards::lamp(Card& card, const LampLight& l) const {
  const std::string name = see("card.lamp", {{"number", l.light + 1}}),
                    n_dot_l = fmt::format("N·L = {}", real_text(l.n_dot_l));
  card.say(name).say(n_dot_l);
  if (!(l.n_dot_l > 0)) {
    card.say(see("card.behind")).line().down(0.4);
    return;
  }
  card.line();
  card.space(1).say(see("card.diffuse", {{"arrives", l.arrival.share()}})).line();
  card.space(1).say(light_place(l.diffuse)).line();
  card.space(1)
      .say(fmt::format("R·V = {}", real_text(l.cosine)))
      .say(see("card.power", {{"power", way_.shininess}}));
  card.line().space(1).say(see("card.highlight")).say(light_place(l.specular)).line().down(0.4);
}

void Cards::light(View& view) const {
  if (!way_.shaded) return;
  Card card = this->card(view, "light");
  card.say(see("card.ambient")).say(light_place(way_.shaded->ambient)).line().down(0.4);
  for (std::size_t i = 0; i < std::min(way_.lamps.size(), most_lamps); ++i) lamp(card, way_.lamps[i]);
  card.say(see("card.sum")).say(light_place(dvec3(way_.shaded->colour)), Role::current);
}

void Cards::bytes(View& view) const {
  if (!way_.written) return;
  Card card = this->card(view, "bytes");
  card.say(see("card.linear"), Role::guide).line();
  const Rgba8& c = way_.written->colour;
  Texts rows;
  for (int i = 0; i < 3; ++i) {
    const double light = static_cast<double>(way_.written->light[i]);
    const int byte = std::array<int, 3>{c.r, c.g, c.b}[static_cast<std::size_t>(i)];
    rows.push_back({std::string(1, "RGB"[i]), real_text(light), "→", real_text(srgb_of_linear(light)),
                    "·255 ≈", figure_number(byte)});
  }
  card.high(3).block(rows, Fence::none, Role::input, 1).line();
  card.down(0.5).say(hex_of(c), Role::current);
  // The colour, large
  const ivec2 lower(glm::ceil(paper_.card().lower + dvec2{0, 8.5} * paper_.unit())),
      size(dvec2{11, 2.6} * paper_.unit());
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x)
      view.cells.insert_or_assign({lower.y + y, lower.x + x}, CellLook{Role::guide, "", c});
  }
  view.add({"g swatch", Role::guide,
            Path{Extent{dvec2(lower) - 0.5, dvec2(lower + size) - 0.5}.corners(), true, false, true}});
}

void Cards::way(View& view) const {
  Card card = this->card(view, "way");
  const auto step = [&](const std::string& number, const std::string& text, Role role = Role::input) {
    if (!number.empty()) card.down(0.25);
    card.say(number.empty() ? "\u00a0\u00a0" : number, Role::guide).say(text, role).line();
  };
  const auto end = [&] {
    const Rgba8& c = way_.written->colour;
    step("8", fmt::format("sRGB {}, {}, {} = {}", c.r, c.g, c.b, hex_of(c)), Role::current);
  };
  if (!way_.place) {
    step("4", see(faced_.removed ? "card.removed" : "card.uncovered",
                  {{"face", piece_.id.face}, {"pixel", pixel_}}));
    return end();
  }
  const PixelPlace& p = *way_.place;
  step("1",
       see("card.face_way",
           {{"face", piece_.id.face},
            {"names", fmt::format("{}, {}, {}", vertex_name(0), vertex_name(1), vertex_name(2))}}),
       Role::current);
  step("", at_text(p.object));
  step("2", see("card.world_way", {{"place", at_text(p.world)}}));
  step("3", see("card.clip_way", {{"place", at_text(shown_clip(words_, p.clip))}}));
  const double det = exact_determinant({projected(0).clip.at, projected(1).clip.at, projected(2).clip.at});
  step("4", fmt::format("det = {} {} 0", real_text(det), det > 0 ? ">" : "<"));
  step("5", fmt::format("÷ {} = {}", length_text(p.clip.w), place_text(shown_divided(words_, p.divided))));
  step("6", see("card.edges_way", {{"values", place_text(way_.edges->values)}}));
  const std::string depth = fmt::format("{} = {}", words_.symbol("z"), real_text(way_.fragment->depth));
  if (way_.shaded) {
    const bool own = way_.shaded->fragment.id == piece_.id;
    step("7", own ? words_.count("card.nearest", std::ssize(way_.tests), {{"depth", depth}})
                  : see("card.hidden", {{"depth", depth}, {"face", way_.shaded->fragment.id.face}}));
    step("", see("card.light_way", {{"light", place_text(dvec3(way_.shaded->colour))}}));
  }
  end();
}

}  // namespace gradus::textbook_chain
