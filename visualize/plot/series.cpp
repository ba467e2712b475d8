#include "plot/series.hpp"

#include <algorithm>
#include <cmath>

namespace gradus::plot {

std::optional<double> slope(std::span<const dvec2> points) {
  dvec2 mean{0, 0};
  for (const dvec2 p : points)
    mean += dvec2(std::log(p.x), std::log(p.y)) / static_cast<double>(points.size());
  double across = 0, along = 0;
  for (const dvec2 p : points) {
    const dvec2 d = dvec2(std::log(p.x), std::log(p.y)) - mean;
    across += d.x * d.y;
    along += d.x * d.x;
  }
  return along > 0 ? std::optional(across / along) : std::nullopt;
}

std::vector<bool> front(std::span<const dvec2> points) {
  std::vector<bool> kept(points.size(), true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const dvec2 other : points) {
      const bool no_worse = other.x <= points[i].x && other.y <= points[i].y;
      if (no_worse && (other.x < points[i].x || other.y < points[i].y)) kept[i] = false;
    }
  }
  return kept;
}

std::vector<double> moved_apart(std::span<const double> wanted, double apart, double least, double most) {
  const auto n = static_cast<double>(wanted.size());
  if (n > 1) apart = std::min(apart, (most - least) / (n - 1));
  // Less i gaps each, places need only rise: those that fall are put together at their mean
  struct Group {
    double sum, count;
    double mean() const { return sum / count; }
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    groups.push_back({wanted[i] - static_cast<double>(i) * apart, 1});
    while (groups.size() > 1 && groups.end()[-2].mean() > groups.back().mean()) {
      groups.end()[-2].sum += groups.back().sum;
      groups.end()[-2].count += groups.back().count;
      groups.pop_back();
    }
  }
  std::vector<double> places;
  for (const Group& group : groups) {
    for (int k = 0; k < group.count; ++k) {
      const double top = std::max(least, std::min(group.mean(), most - (n - 1) * apart));
      places.push_back(top + static_cast<double>(places.size()) * apart);
    }
  }
  return places;
}

std::vector<Style> styles_of(std::span<const Kind> methods) {
  constexpr Role roles[] = {Role::current, Role::accepted, Role::measure, Role::candidate,
                            Role::past,    Role::input,    Role::rejected};
  constexpr Marker markers[] = {Marker::square, Marker::diamond, Marker::triangle, Marker::disc};
  std::vector<Style> free;
  for (const bool open : {false, true}) {
    for (const Role colour : roles) free.push_back({colour, Marker::disc, open});
  }
  const auto take = [&](auto from, auto to, auto wanted) {
    const auto found = std::find_if(from, to, wanted);
    if (found == to) return Style{Role::past, Marker::disc, true};  // more than can be told apart
    const Style style = *found;
    std::erase_if(free, [&](const Style& s) { return s.role == style.role && s.open == style.open; });
    return style;
  };
  std::vector<Style> styles(methods.size());
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (methods[i] != Kind::chosen) continue;
    styles[i] = take(free.begin(), free.end(), [](const Style& s) { return s.role == Role::current; });
    styles[i].chosen = true;
    std::erase_if(free,
                  [](const Style& s) { return s.role == Role::current; });  // no other one looks like it
  }
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (methods[i] != Kind::faulty) continue;
    styles[i] = take(free.rbegin(), free.rend(), [](const Style& s) { return !s.open; });
    styles[i].marker = Marker::cross;
  }
  std::size_t usual = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (methods[i] != Kind::usual) continue;
    styles[i] = take(free.begin(), free.end(), [](const Style&) { return true; });
    styles[i].marker = markers[usual++ % std::size(markers)];
  }
  return styles;
}

}  // namespace gradus::plot
