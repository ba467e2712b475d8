// The promises of CSG trees: points exactly where the formula has them, on surfaces, too; ends of rays on the
// surfaces, and between them what points say; the same ends where leaves are skipped or changed; lengths that
// add up.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "modeling/csg_tree/skipping.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace csg_tree;

// Where an input has its numbers; the last one chooses operations and the cylinder's axis
constexpr std::size_t ball = 6, cylinder = 10, plane = 14, ray = 20, last = 26, choice = 27, numbers = 28;

/// Solids in order and rays that go somewhere.
void mend(Input& input) {
  for (std::size_t axis = 0; axis < 3; ++axis) put_in_order(input[axis], input[3 + axis]);
  for (const std::size_t radius : {ball + 3, cylinder + 3, last}) input[radius] = std::abs(input[radius]);
  if (input[last] == 0) input[last] = 1;
}

/// One number is that of another solid: faces coincide, a ray starts on a surface, or nearly so.
void make_flush(Kind kind, Input& input, Random& random) {
  const auto axis = static_cast<std::size_t>(random.uniform_int(0, 2));
  const auto put = [&](std::size_t to, double x) {
    input[to] = kind == Kind::ties || random.unit() < 0.3 ? x : nudged(x, random);
  };
  const double face = input[random.unit() < 0.5 ? axis : 3 + axis];
  put(plane + 3 + axis, face);
  put(ray + axis, face);
  for (std::size_t i = 0; i < 3; ++i) {
    if (random.unit() < 0.4) input[ray + 3 + i] = 0;
    if (random.unit() < 0.3) input[plane + i] = 0;
  }
  // A ray that touches the ball, and a cylinder that touches it from outside
  if (random.unit() < 0.5) put(ball + axis, face + input[ball + 3]);
  if (random.unit() < 0.5) put(cylinder + axis, input[ball + axis] + input[ball + 3] + input[cylinder + 3]);
}

Input generate(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, numbers);
  input[choice] = static_cast<double>(random.uniform_int(0, 80));
  if (kind == Kind::refused) return input;
  input[last] =
      kind == Kind::huge || kind == Kind::tiny || kind == Kind::denormal ? sized(random, -3, 3) : 20;
  mend(input);
  if (kind != Kind::random) make_flush(kind, input, random);
  mend(input);
  return input;
}
const Generator at_scales = at_every_scale(
    generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25},
    mend);

/// ((box . ball) . cylinder) . half-space.
template <class T, class S = T>
Nodes<T> tree_in(const std::vector<S>& given) {
  std::vector<T> x(given.begin(), given.end());
  const auto chosen =
      static_cast<std::size_t>(std::clamp(std::abs(to_double(Exact(given[choice]))), 0.0, 80.0));
  const auto op = [&](std::size_t part) {
    return std::array{Op::unite, Op::intersect, Op::subtract}[part % 3];
  };
  Nodes<T> tree;
  add_leaf<T>(tree, Box<T>{vector_in(x, 0), vector_in(x, 3)});
  add_leaf<T>(tree, Ball<T>{vector_in(x, ball), x[ball + 3]});
  add_node(tree, op(chosen), 0, 1);
  add_leaf<T>(tree, Cylinder<T>{vector_in(x, cylinder), x[cylinder + 3], static_cast<int>(chosen / 27)});
  add_node(tree, op(chosen / 3), 2, 3);
  add_leaf<T>(tree, HalfSpace<T>{vector_in(x, plane), vector_in(x, plane + 3)});
  add_node(tree, op(chosen / 9), 4, 5);
  return tree;
}
template <class T>
Ray<T> ray_in(const std::vector<T>& x) {
  return {vector_in(x, ray), vector_in(x, ray + 3), x[last]};
}

/// Whether these numbers are solids and a ray.
template <class T>
bool taken(const std::vector<T>& x) {
  const T most = std::numeric_limits<T>::max() / 8;
  const auto any = [&](std::size_t from) { return x[from] != 0 || x[from + 1] != 0 || x[from + 2] != 0; };
  return std::all_of(x.begin(), x.begin() + last, [&](T v) { return std::abs(v) <= most; }) && x[0] <= x[3] &&
         x[1] <= x[4] && x[2] <= x[5] && 0 <= x[ball + 3] && 0 <= x[cylinder + 3] && any(plane) &&
         any(ray + 3) && 0 < x[last] && std::isfinite(x[last]) && std::isfinite(x[choice]);
}

// --- Points

/// The formula over the leaves, by strict signs alone, where no leaf has the point on its surface.
std::optional<bool> strictly(const Nodes<Exact>& tree, const Point<Exact>& p) {
  std::vector<bool> in;
  for (const Node<Exact>& node : tree) {
    if (!is_leaf(node)) {
      const bool a = in[node.a], b = in[node.b];
      in.push_back(node.op == Op::unite ? a || b : node.op == Op::intersect ? a && b : a && !b);
      continue;
    }
    Exact height(0);
    if (const auto* h = std::get_if<HalfSpace<Exact>>(&node.solid)) {
      height = glm::dot(h->normal, p) - glm::dot(h->normal, h->on);
    } else if (const auto* box = std::get_if<Box<Exact>>(&node.solid)) {
      height = box->lower.x - p.x;
      for (int i = 0; i < 3; ++i) height = std::max({height, box->lower[i] - p[i], p[i] - box->upper[i]});
    } else {
      const auto* c = std::get_if<Cylinder<Exact>>(&node.solid);
      const auto* b = std::get_if<Ball<Exact>>(&node.solid);
      Point<Exact> off = p - (c ? c->centre : b->centre);
      if (c) off[c->axis] = Exact(0);
      const Exact radius = c ? c->radius : b->radius;
      height = glm::dot(off, off) - radius * radius;
    }
    if (sign(height) == 0) return std::nullopt;
    in.push_back(sign(height) < 0);
  }
  return in.back();
}

const auto points_error = []<class T>(const std::vector<T>& given) -> double {
  const Point<T> p = vector_in(given, ray);
  const auto answer = accepted([&] { return contains<T>(tree_in<T>(given), p); });
  std::vector<T> solids = given;
  solids[ray + 3] = solids[ray + 4] = solids[ray + 5] = solids[last] = T(1);
  if (answer.has_value() != taken(solids)) return std::isfinite(given[choice]) ? wrong : 0;
  if (!answer) return 0;
  const auto drop = [](const auto&) {};
  if (contains<T>(tree_in<T>(given), p, drop) != *answer) return wrong;
  const Nodes<Exact> exact = tree_in<Exact>(given);
  Point<Exact> right(p);
  const auto formula = strictly(exact, right);
  if (formula) return *formula == *answer ? 0 : wrong;
  if (contains<Exact>(exact, right) != *answer) return wrong;
  // On a surface of small whole numbers: moved by next to nothing along x, less along y, least along z
  const auto whole = [](T x) { return std::abs(x) <= 64 && x == std::floor(x); };
  if (!std::all_of(given.begin(), given.begin() + last, whole)) return 0;
  right += Point<Exact>(Exact(0x1p-40), Exact(0x1p-60), Exact(0x1p-70));
  const auto moved = strictly(exact, right);
  return moved && *moved == *answer ? 0 : wrong;
};

// --- Rays

/// How far a point is from a leaf's surface, as a share of what the header allows there, and of the little
/// that the smallest numbers take. Inside it is negative.
template <class T>
double height_of(const Solid<T>& solid, const Ray<T>& r, const Exact& t) {
  const Exact unit = rounding_unit<T>(), tiny(std::numeric_limits<T>::min());
  const auto point = [&](int i) { return Exact(r.from[i]) + t * Exact(r.way[i]); };
  const auto of = [](const Exact& height, const Exact& bound) {
    return sign(height) < 0 ? -in_bounds(-height, bound) : in_bounds(height, bound);
  };
  if (const auto* h = std::get_if<HalfSpace<T>>(&solid)) {
    Exact height(0), size(0);
    for (int i = 0; i < 3; ++i) {
      const Exact n(h->normal[i]);
      height += n * (point(i) - Exact(h->on[i]));
      size += abs(n) * (abs(Exact(h->on[i]) - Exact(r.from[i])) + (t + tiny) * abs(Exact(r.way[i])));
    }
    return of(height, Exact(8) * unit * size + tiny * size + tiny);
  }
  if (const auto* box = std::get_if<Box<T>>(&solid)) {
    double most = -wrong;
    for (int i = 0; i < 3; ++i) {
      const Exact way = abs(Exact(r.way[i])) * tiny, from(r.from[i]), lower(box->lower[i]),
                  upper(box->upper[i]);
      most = std::max({most, of(lower - point(i), Exact(3) * unit * abs(lower - from) + way),
                       of(point(i) - upper, Exact(3) * unit * abs(upper - from) + way)});
    }
    return most;
  }
  const auto* c = std::get_if<Cylinder<T>>(&solid);
  const auto* b = std::get_if<Ball<T>>(&solid);
  const Exact radius(c ? c->radius : b->radius);
  Exact square(0), size = radius, way(0);
  for (int i = 0; i < 3; ++i) {
    if (c && i == c->axis) continue;
    const Exact centre((c ? c->centre : b->centre)[i]), off = point(i) - centre;
    square += off * off;
    size += abs(Exact(r.from[i]) - centre);
    way += abs(Exact(r.way[i]));
  }
  return of(square - radius * radius,
            Exact(16) * unit * size * size + (size + way) * tiny * way + tiny * tiny);
}

template <class T>
bool is_in(const Ends<T>& ends, const Exact& t) {
  return std::ranges::count_if(ends, [&](T end) { return Exact(end) < t; }) % 2 == 1;
}

/// Each leaf's ends lie on it; and between all ends, and where a ray is nearest to a centre, it is inside
/// where points are, as far as it is clear of surfaces.
const auto ends_error = []<class T>(const std::vector<T>& given) -> double {
  const Nodes<T> tree = tree_in<T>(given);
  const Ray<T> r = ray_in(given);
  const auto ends = accepted([&] { return along_ray<T>(tree, r); });
  if (ends.has_value() != taken(given)) return std::isfinite(given[choice]) ? wrong : 0;
  if (!ends) return 0;
  if (ends->size() % 2 != 0 || std::ranges::adjacent_find(*ends, std::greater_equal{}) != ends->end())
    return wrong;
  double most = 0;
  std::vector<Exact> places{Exact(0), Exact(r.last)};
  for (const Node<T>& node : tree) {
    if (!is_leaf(node)) continue;
    for (const T t : ends_in(node.solid, r)) {
      places.emplace_back(t);
      if (t != 0 && t != r.last) most = std::max(most, std::abs(height_of(node.solid, r, Exact(t))));
    }
  }
  std::ranges::sort(places);
  const std::size_t count = places.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (places[i] != places[i + 1]) places.push_back((places[i] + places[i + 1]) / Exact(2));
  }
  const Nodes<Exact> exact = tree_in<Exact>(given);
  for (std::size_t i = count; i < places.size(); ++i) {
    const Exact& t = places[i];
    const bool clear = std::ranges::all_of(tree, [&](const Node<T>& node) {
      return !is_leaf(node) || std::abs(height_of(node.solid, r, t)) > 1 ||
             std::holds_alternative<Box<T>>(node.solid);
    });
    Point<Exact> p(r.from);
    for (int k = 0; k < 3; ++k) p[k] += t * Exact(r.way[k]);
    if (clear && contains<Exact>(exact, p) != is_in(*ends, t)) return wrong;
  }
  return most;
};

const auto skipping_error = []<class T>(const std::vector<T>& given) -> double {
  if (!taken(given)) return 0;
  const Nodes<T> tree = tree_in<T>(given);
  const auto drop = [](const auto&) {};
  const Ends<T> right = along_ray<T>(tree, ray_in(given));
  return skipping<T>(tree, boxes_of<T>(tree), ray_in(given)) == right &&
                 along_ray<T>(tree, ray_in(given), drop) == right
             ? 0
             : wrong;
};

/// Another ball; then the ball from before.
const auto changed_error = []<class T>(const std::vector<T>& given) -> double {
  if (!taken(given)) return 0;
  Evaluation<T> e = evaluated<T>(tree_in<T>(given), ray_in(given));
  const Evaluation<T> before = e;
  const Undo<T> undo = change<T>(e, 1, Ball<T>{vector_in(given, cylinder), given[cylinder + 3]});
  if (evaluated<T>(e.tree, e.ray).on != e.on) return wrong;
  restore(e, undo);
  const bool same = e.on == before.on && evaluated<T>(e.tree, e.ray).on == before.on;
  return same ? 0 : wrong;
};

/// A and B together are A or B and A and B; A is A without B and A and B. Lengths are exact sums of ends.
const auto lengths_error = []<class T>(const std::vector<T>& given) -> double {
  if (!taken(given)) return 0;
  const Nodes<T> tree = tree_in<T>(given);
  const Ends<T> a = ends_in(tree[0].solid, ray_in(given));
  const Ends<T> b = along_ray<T>(tree, ray_in(given));
  const auto length = [](const Ends<T>& ends) {
    Exact sum(0);
    for (std::size_t i = 0; i < ends.size(); ++i) sum += i % 2 == 1 ? Exact(ends[i]) : -Exact(ends[i]);
    return sum;
  };
  const Exact both = length(merged(Op::intersect, a, b)), without = length(merged(Op::subtract, a, b));
  const bool add_up = length(a) + length(b) == length(merged(Op::unite, a, b)) + both &&
                      length(a) == without + both && merged(Op::unite, a, b) == merged(Op::unite, b, a) &&
                      merged(Op::intersect, a, b) == merged(Op::intersect, b, a);
  return add_up ? 0 : wrong;
};

}  // namespace

Domain csg_tree() {
  // A ball on a box's face, a cylinder beside it, a half-space through the face; a ray along x through the
  // middle
  const Input flush{0, 0, 0, 8, 8, 8, 12, 4, 4, 4, 12, 4, 4, 2, 1, 0, 0, 8, 4, 4, -2, 4, 4, 1, 0, 0, 20, 7};
  const auto with = [&](std::initializer_list<std::pair<std::size_t, double>> changes) {
    Input input = flush;
    for (const auto& [at, x] : changes) input[at] = x;
    return input;
  };
  const auto promise = [&](std::string name, std::string states, double bound, std::int64_t cases,
                           auto judge) {
    return Property{
        .name = std::move(name),
        .states = std::move(states),
        .unit = bound > 0 ? "of the bound" : "",
        .bound = bound,
        .numbers = numbers,
        .generate = at_scales,
        .error = in_both(judge),
        .traps = {{"solids that touch in a face", flush},
                  {"a ray in a common face", with({{ray, 8}, {ray + 3, 0}, {ray + 4, 1}})},
                  {"a ray that touches a ball", with({{ray + 1, 8}})},
                  {"a ray along a cylinder's axis", with({{choice, 7}, {ray + 1, 6}})},
                  {"solids without size", with({{3, 0}, {4, 0}, {5, 0}, {ball + 3, 0}, {cylinder + 3, 0}})},
                  {"beyond the largest", with({{ball, 1e308}})},
                  {"no number", with({{ball + 3, std::nan("")}})}},
        .cases = cases};
  };
  return {
      "csg_tree",
      {promise("points",
               "a point is inside where the formula over exact signs has it, on surfaces by one rule", 0,
               1500, points_error),
       promise("ends", "ends lie on their surfaces within the header's bounds, and points between agree", 1,
               250, ends_error),
       promise("skipping", "leaves that are skipped change no end", 0, 4000, skipping_error),
       promise("changed", "a changed leaf gives what all of the tree gives, and undone what was before", 0,
               3000, changed_error),
       promise("lengths", "along a ray A and B are as long as A or B with A and B", 0, 1000, lengths_error)}};
}

}  // namespace gradus::stress
