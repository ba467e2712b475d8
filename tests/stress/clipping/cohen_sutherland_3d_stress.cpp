// The promises of Cohen and Sutherland's clipping to a box, one segment or many, and to the view volume.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "stress/clipping/axis_boxes.hpp"

namespace gradus::stress {
namespace {

using cohen_sutherland_3d::ViewVolume;
using test::Fraction;

// --- The box ---

constexpr auto correctly_rounded = [](const auto& line, const auto& box, const auto& order) {
  return cohen_sutherland_3d::correctly_rounded(line, box, order);
};
constexpr auto cut_of_a_cut = [](const auto& line, const auto& box, const auto& order) {
  return cohen_sutherland_3d::cut_of_a_cut(line, box, order);
};
constexpr auto batch = [](const auto& lines, const auto& box, auto& clipped, auto& accepted) {
  return cohen_sutherland_3d::clip_batch(lines, box, clipped, accepted);
};

/// How often a line is cut at a box or the view volume; nothing where a watcher changes what is left.
template <int N, class T, class Box>
std::optional<int> cuts_of(const Segment<N, T>& line, const Box& box) {
  int cuts = 0;
  const auto count = [&]<class Step>(const Step&) {
    cuts += std::same_as<Step, cohen_sutherland_3d::Cut<N, T>>;
  };
  const auto watched = cohen_sutherland_3d::correctly_rounded(line, box, usual_order<3>(), count);
  if (!test::same_bits(watched, cohen_sutherland_3d::correctly_rounded(line, box))) return std::nullopt;
  return cuts;
}

Property six_cuts() {
  using axis_boxes::clip_of;
  Property cuts = axis_boxes::promise<3>("cuts", "at most six, and watching changes nothing",
                                         "correctly_rounded", [](const Input& i) {
                                           if (!axis_boxes::is_taken<3>(i)) return 0.0;
                                           const auto [line, box] = clip_of<3>(i);
                                           return cuts_of(line, box).value_or(7) <= 6 ? 0 : wrong;
                                         });
  cuts.shares = {
      axis_boxes::share<3>("six cuts", 0.0003, [](const auto& of) { return cuts_of(of.line, of.box) == 6; })};
  return cuts;
}

// --- The view volume: x, y, z, w of both ends ---

using Homogeneous = Segment<4, double>;

template <class T = double>
Segment<4, T> segment_of(const Input& i) {
  const auto n = [&](std::size_t k) { return static_cast<T>(i[k]); };
  return {{n(0), n(1), n(2), n(3)}, {n(4), n(5), n(6), n(7)}};
}
Input input_of(const Homogeneous& s) { return {s.a.x, s.a.y, s.a.z, s.a.w, s.b.x, s.b.y, s.b.z, s.b.w}; }

double whole(Random& random, std::int64_t low, std::int64_t high) {
  return static_cast<double>(random.uniform_int(low, high));
}
glm::dvec4 any_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high), z = random.uniform(low, high);
  return {x, y, z, random.uniform(-0.7, 2)};
}
glm::dvec4 grid_point(Random& random) {
  const double x = whole(random, -4, 4), y = whole(random, -4, 4), z = whole(random, -1, 4);
  return {x, y, z, whole(random, -2, 5)};
}
/// A point of space under a perspective matrix with its near plane at 1, its far plane at 100.
glm::dvec4 seen_point(Random& random) {
  const glm::dvec4 p = any_point(random, -60, 60);
  const double z = p.z + 50;
  return {1.5 * p.x, 2 * p.y, (100 * z - 100) / 99, z};
}
/// Of numbers of the kind, often in front of the eye and not far outside.
glm::dvec4 sized_point(Kind kind, Random& random) {
  const auto any = [&] { return number(kind, random); };
  const double x = any(), y = any(), z = any();
  glm::dvec4 p(x, y, z, any());
  if (random.unit() < 0.8) p.w = std::abs(p.w);
  if (random.unit() < 0.5) p.x = 0.5 * p.w * random.uniform(-2, 2);
  if (random.unit() < 0.5) p.y = 0.5 * p.w * random.uniform(-2, 2);
  if (random.unit() < 0.6) p.z = 0.5 * p.w * random.uniform(-1, 2);
  return p;
}

/// Through a point of an edge of the volume, where two faces meet, or some steps beside it.
Homogeneous through_edge(Random& random) {
  const double w = random.uniform(1, 2), side = random.unit() < 0.5 ? -w : w;
  glm::dvec4 on{side, random.uniform(-w, w), random.uniform(0, w), w};
  const auto which = random.uniform_int(0, 3);
  if (which < 2) on.y = which == 0 ? side : -side;
  if (which >= 2) on.z = which == 2 ? 0 : w;
  // Away from the volume along one of the two faces: touches the edge
  glm::dvec4 way = any_point(random, -1, 1);
  way.x = way.w = std::ldexp(std::round(std::ldexp(way.w, 20)), -20);
  Homogeneous line{on - way, on + way};
  double& coordinate = line.b[static_cast<int>(random.uniform_int(0, 3))];
  coordinate = nudged(coordinate, random);
  return line;
}
/// From a few of the smallest numbers, 2^smallest, past (0, 0, 0, 0) nearly to the opposite.
Homogeneous past_nothing(int smallest, Random& random) {
  const glm::dvec4 a = grid_point(random), aside = grid_point(random);
  const double back = std::ldexp(1.0, static_cast<int>(random.uniform_int(0, std::min(-smallest, 1000))));
  glm::dvec4 b(0);
  for (int i = 0; i < 4; ++i) {
    b[i] = random.unit() < 0.5 ? aside[i] - back * a[i] : -back * nudged(a[i], random);
  }
  const double scale = std::ldexp(1.0, smallest);
  return {scale * a, scale * b};
}

Homogeneous ordinary(Random& random) {
  if (random.unit() < 0.5) {
    const glm::dvec4 a = seen_point(random);
    return {a, seen_point(random)};
  }
  const glm::dvec4 a = any_point(random, -2, 2);
  return {a, any_point(random, -2, 2)};
}

Input volume_input(Kind kind, Random& random) {
  switch (kind) {
    case Kind::random:
      return input_of(ordinary(random));
    case Kind::grazing:
      return input_of(through_edge(random));
    case Kind::ties: {
      const glm::dvec4 a = grid_point(random);
      return input_of({a, grid_point(random)});
    }
    case Kind::near_degenerate: {
      // Nearly a point, or nearly opposite each other
      Input input = input_of(ordinary(random));
      for (std::size_t k = 0; k < 4; ++k) input[4 + k] = nudged(input[k], random);
      if (random.unit() < 0.5) {
        for (std::size_t k = 4; k < 8; ++k) input[k] = -input[k];
      }
      return input;
    }
    case Kind::refused: {
      Input input = input_of(ordinary(random));
      const double way = random.unit();
      if (way < 0.3) std::fill(input.begin(), input.begin() + 4, 0.0);
      if (way > 0.6) {
        for (std::size_t k = 0; k < 4; ++k) input[4 + k] = -4 * input[k];
      }
      if (0.3 <= way && way <= 0.6) {
        input[static_cast<std::size_t>(random.uniform_int(0, 7))] = way < 0.45 ? std::nan("") : wrong;
      }
      return input;
    }
    case Kind::denormal:
      if (random.unit() < 0.5) return input_of(past_nothing(-1074, random));
      [[fallthrough]];
    default: {
      const glm::dvec4 a = sized_point(kind, random);
      return input_of({a, sized_point(kind, random)});
    }
  }
}

/// Floats, among them coordinates that lie midway between two, but for less than a double shows.
Input float_volume_input(Kind kind, Random& random) {
  if (kind == Kind::denormal && random.unit() < 0.5)
    return rounded_to_floats(input_of(past_nothing(-149, random)));
  if (kind == Kind::ties && random.unit() < 0.5) {
    // Depths -2 and 2 - e at the left side: y comes to 1 + (k + 1/2) steps, and e/16 of a step more
    const double e = std::ldexp(whole(random, -3, 3), -40), y = 1 + std::ldexp(whole(random, 0, 1000), -23);
    return {-4, y, 0.5, 2, -e, y + 0x1p-23, 0.5, 2};
  }
  static const auto all = at_every_scale_of_floats(volume_input);
  return all(kind, random);
}

/// Whether b = -s a with s > 0: then (0, 0, 0, 0), which is no point, lies between them.
bool through_nothing(const Homogeneous& s) {
  Fraction same = 0;
  for (int i = 0; i < 4; ++i) {
    same += Fraction(s.a[i]) * Fraction(s.b[i]);
    for (int j = 0; j < i; ++j) {
      if (Fraction(s.a[i]) * Fraction(s.b[j]) != Fraction(s.a[j]) * Fraction(s.b[i])) return false;
    }
  }
  return same < 0;
}
bool volume_is_taken(const Input& i) {
  const Homogeneous line = segment_of(i);
  const glm::dvec4 none(0);
  return all_finite(i) && line.a != none && line.b != none && !through_nothing(line);
}

template <class T>
auto volume_part(const Segment<4, T>& line, const BorderOrder<3>& order = usual_order<3>()) {
  return cohen_sutherland_3d::correctly_rounded(line, ViewVolume{}, order);
}

/// 0 where the reverse is the reverse, again changes nothing, all lies in the volume in front of the eye, six
/// cuts do, and the faces' order does not matter.
template <class T>
double volume_relations(const Segment<4, T>& line, const std::optional<Segment<4, T>>& part) {
  const auto back = volume_part(test::reversed(line));
  if (!test::same_bits(part, back ? std::optional(test::reversed(*back)) : std::nullopt)) return wrong;
  if (cuts_of(line, ViewVolume{}).value_or(7) > 6) return wrong;
  auto order = usual_order<3>();
  for (int turn = 0; turn < 12; ++turn) {
    std::ranges::rotate(order, order.begin() + 1);
    if (turn % 3 == 2) std::swap(order[0], order[1]);
    if (volume_part(line, order) != part) return wrong;
  }
  if (!part) return 0;
  const bool is_inside = (region_code(part->a, ViewVolume{}) | region_code(part->b, ViewVolume{})) == 0;
  return is_inside && part->a.w > 0 && part->b.w > 0 && test::same_bits(volume_part(*part), part) ? 0 : wrong;
}

template <class T>
double volume_error(const Input& input) {
  const Segment<4, T> line = segment_of<T>(input);
  const bool taken = volume_is_taken(input);
  std::optional<Segment<4, T>> found;
  try {
    found = volume_part(line);
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken) return wrong;
  const auto exact = test::representable<T>(test::exact_part(line));
  return std::max(volume_relations(line, found), test::worst_end(found, exact, test::rounding_error<T>));
}

/// 0 where both methods in rationals are the definition, and the careful one in doubles is that, rounded.
double volume_rationals_error(const Input& input) {
  if (!volume_is_taken(input)) return 0;
  const ExactScope scope;
  const Homogeneous line = segment_of(input);
  const auto exact = [](const glm::dvec4& p) {
    return glm::vec<4, Exact>(Exact(p.x), Exact(p.y), Exact(p.z), Exact(p.w));
  };
  const Segment<4, Exact> same{exact(line.a), exact(line.b)};
  const auto right = volume_part(same);
  const auto rounded = volume_part(line);
  if (cohen_sutherland_3d::cut_of_a_cut(same, ViewVolume{}) != right) return wrong;
  if (right.has_value() != rounded.has_value()) return wrong;
  // What would round to no point at all was divided by w
  const auto part = test::exact_part(line), represented = test::representable<double>(part);
  if (part && (part->a != represented->a || part->b != represented->b)) return 0;
  for (int k = 0; right && k < 4; ++k) {
    if (to_double(right->a[k]) != rounded->a[k] || to_double(right->b[k]) != rounded->b[k]) return wrong;
  }
  return 0;
}

/// The exact projection of a segment in front of the eye, clipped to the box -1 <= x, y <= 1, 0 <= z <= 1: by
/// the values of t along the projection.
std::optional<test::ExactEnds<3>> exact_projection(const Homogeneous& line) {
  test::ExactEnds<3> ends;
  for (int k = 0; k < 3; ++k) {
    ends.a[static_cast<std::size_t>(k)] = Fraction(line.a[k]) / Fraction(line.a.w);
    ends.b[static_cast<std::size_t>(k)] = Fraction(line.b[k]) / Fraction(line.b.w);
  }
  return test::exact_clip<3>(ends, {-1, -1, 0}, {1, 1, 1});
}
/// How far a part of the view volume, divided by w, is from that.
template <class Method>
double divided_error(const Input& input, Method method) {
  // Where nothing under- or overflows
  const auto is_moderate = [](double x) {
    return x == 0 || (0x1p-100 < std::abs(x) && std::abs(x) < 0x1p100);
  };
  if (!std::ranges::all_of(input, is_moderate) || !(input[3] > 0 && input[7] > 0)) return 0;
  const Homogeneous line = segment_of(input);
  std::optional<Segment<3, double>> divided;
  if (const std::optional<Homogeneous> part = method(line)) {
    divided = {glm::dvec3(part->a) / part->a.w, glm::dvec3(part->b) / part->b.w};
  }
  return test::worst_end(divided, exact_projection(line),
                         [](double x, const Fraction& exact) { return test::error_in_ulp(x, exact); });
}
double taught_divided_error(const Input& i) {
  return divided_error(
      i, [](const Homogeneous& line) { return cohen_sutherland_3d::cut_of_a_cut(line, ViewVolume{}); });
}

Property volume_promise(const char* name, const char* states, double (*error)(const Input&)) {
  return {.name = name,
          .states = states,
          .unit = "ulp",
          .bound = 0.5,
          .numbers = 8,
          .generate = at_every_scale(volume_input),
          .error = error,
          .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
            return {{"method", "view_volume"}, {"homogeneous", axis_boxes::list(i, 0, 8)}};
          },
          .traps = {{"w goes through 0", {-2, 0, 1, 2, 2, 0, 0, -2}},
                    {"wholly behind the eye", {0, 0, -1, -2, 1, 1, -2, -3}},
                    {"ends in the eye's plane", {0, 0, 0.5, 1, 1, 0, 0, 0}},
                    {"z = 1e-310 in front of the eye", {1, 0, 1e-310, 1e-310, 0, 0, 1, 2}},
                    {"a sum of w and x overflows", {1e308, 0, 1, 1.5e308, -1.7e308, 1, 2, 1.5e308}},
                    {"an end rounds to (0, 0, 0, 0)", {0x1p-1074, 0, 0x1p-1074, 0, -1, 1 - 0x1p-52, -1, 1}},
                    {"no point", {0, 0, 0, 0, 1, 0, 0, 1}},
                    {"opposite each other", {1, 2, 3, 4, -2, -4, -6, -8}}}};
}

template <class Holds>
Share volume_share(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) { return volume_is_taken(i) && holds(segment_of(i)); }};
}

Property volumes() {
  Property promised =
      volume_promise("view_volume",
                     "before the division: accepts and rejects exactly; every end is the nearest "
                     "double, in front of the eye; again changes nothing",
                     volume_error<double>);
  const auto is_behind = [](const Homogeneous& s) { return s.a.w <= 0 && s.b.w <= 0; };
  promised.shares = {
      volume_share("kept", 0.2, [](const auto& s) { return volume_part(s).has_value(); }),
      volume_share("kept of a line past the eye", 0.02,
                   [](const auto& s) { return (s.a.w <= 0) != (s.b.w <= 0) && volume_part(s); }),
      volume_share("wholly behind the eye", 0.01, is_behind),
      volume_share("an end divided by w", 0.002, [](const auto& s) {
        const auto whole_part = test::exact_part(s), part = test::representable<double>(whole_part);
        return part && (part->a != whole_part->a || part->b != whole_part->b);
      })};
  return promised;
}
Property float_volumes() {
  Property promised =
      volume_promise("view_volume_in_float", "the same in float, also midway between two of them",
                     [](const Input& i) { return volume_error<float>(rounded_to_floats(i)); });
  promised.generate = float_volume_input;
  return promised;
}
Property volumes_in_rationals() {
  Property promised = volume_promise("view_volume_in_rationals",
                                     "both methods in rationals are the definition", volume_rationals_error);
  promised.cases = 2'000;  // rationals of this size take long
  return promised;
}
Property divided() {
  Property promised = volume_promise(
      "divided", "x/w of what is left is the exact projection, clipped, to 3 ulp", [](const Input& i) {
        return divided_error(i, [](const Homogeneous& line) { return volume_part(line); });
      });
  promised.bound = 3;
  promised.kinds = {Kind::random};
  promised.traps.clear();
  promised.shares = {
      volume_share("divided", 0.15, [](const auto& s) { return s.a.w > 0 && s.b.w > 0 && volume_part(s); }),
      {"20 ulp by cuts of cuts", 0.001, [](const Input& i) { return taught_divided_error(i) > 20; }}};
  return promised;
}

}  // namespace

Domain cohen_sutherland_3d() {
  auto all =
      axis_boxes::promises<3>("", "correctly_rounded", correctly_rounded, "cut_of_a_cut", cut_of_a_cut);
  for (const Property& one : {axis_boxes::batch_promise<3>(batch, correctly_rounded), six_cuts(), volumes(),
                              float_volumes(), volumes_in_rationals(), divided()}) {
    all.push_back(one);
  }
  return {"cohen_sutherland_3d", all};
}

}  // namespace gradus::stress
