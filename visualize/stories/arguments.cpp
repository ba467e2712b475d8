#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/contract.hpp"
#include "stories/topic.hpp"

namespace gradus {

void refuse(std::string_view parameter, const std::string& what) {
  refuse({Refusal::Kind::argument, what, std::string(parameter)});
}

void refuse(const Arguments& arguments, std::initializer_list<std::string_view> parameters,
            const std::string& what_was_expected) {
  const auto* const given = std::ranges::find_if(
      parameters, [&](std::string_view name) { return arguments.has(name) && arguments.entry(name).given; });
  refuse(std::string(given == parameters.end() ? *parameters.begin() : *given), what_was_expected);
}

// --- Sizes

std::string text_of(const Sizes& sizes) {
  const auto written = [](double x) {
    std::string text = fmt::format("{:g}", x);  // "1e+06" becomes "1e6"
    const std::size_t power = text.find('e');
    if (power == std::string::npos) return text;
    const bool small = text[power + 1] == '-';
    const std::size_t digits = text.find_first_not_of("+-0", power + 1);
    return text.substr(0, power + 1) + (small ? "-" : "") + text.substr(digits);
  };
  if (!sizes.limited()) return "of any size";
  if (sizes.least == 0) return fmt::format("up to {} in size", written(sizes.most));
  return fmt::format("0 or from {} to {} in size", written(sizes.least), written(sizes.most));
}

namespace {

/// Whether sizes hold the real numbers of a value, single ones and lists of them. Other values lack them;
/// factors have sizes of their own.
struct Holding {
  const Sizes& sizes;

  bool operator()(const Number& number) const { return sizes.hold(number.value); }
  template <class T>
  bool operator()(const std::vector<T>& several) const {
    return std::ranges::all_of(several, *this);
  }
  bool operator()(const FaceText& face) const { return (*this)(face.points); }
  bool operator()(const std::vector<FactorText>&) const { return true; }
  bool operator()(const auto&) const { return true; }
};

}  // namespace

bool all_hold(const Sizes& sizes, const ArgumentValue& value) { return std::visit(Holding{sizes}, value); }

void require_sizes(const Arguments& arguments, std::string_view parameter, const Sizes& sizes) {
  const Arguments::Entry& entry = arguments.entry(parameter);
  if (all_hold(sizes, entry.value)) return;
  refuse(parameter, "method {} needs numbers {}, found {}", arguments.text("method"), text_of(sizes),
         shown(entry.text));
}

// --- Arguments

void Arguments::set(Entry entry) {
  const auto known = std::ranges::find(entries_, entry.name, &Entry::name);
  if (known != entries_.end()) {
    *known = std::move(entry);
  } else {
    entries_.push_back(std::move(entry));
  }
}

bool Arguments::has(std::string_view name) const {
  return std::ranges::find(entries_, name, &Entry::name) != entries_.end();
}

const Arguments::Entry& Arguments::entry(std::string_view name) const {
  const auto known = std::ranges::find(entries_, name, &Entry::name);
  if (known == entries_.end()) refuse(std::string(name), "expected a value, found none");
  return *known;
}

/// The value of an argument that is a T; to read it as anything else is the program's mistake.
template <class T>
const T& Arguments::value(std::string_view name, std::string_view kind) const {
  const Entry& found = entry(name);
  const T* value = std::get_if<T>(&found.value);
  expects(value != nullptr, "{} is {}, not '{}'", name, kind, found.text);
  return *value;
}

/// The same, nothing where none was given.
template <class T>
const T* Arguments::value_if_given(std::string_view name, std::string_view kind) const {
  return has(name) && !text(name).empty() ? &value<T>(name, kind) : nullptr;
}

ivec2 Arguments::cell(std::string_view name) const { return value<ivec2>(name, "a cell"); }

std::optional<Window> Arguments::window(std::string_view name) const {
  const Window* const window = value_if_given<Window>(name, "a window");
  return window ? std::optional(*window) : std::nullopt;
}

std::int64_t Arguments::integer(std::string_view name) const {
  return value<std::int64_t>(name, "a whole number");
}

std::optional<double> Arguments::number(std::string_view name) const {
  const Number* const number = value_if_given<Number>(name, "a number");
  return number ? std::optional(number->value) : std::nullopt;
}

namespace {

/// A point of the plane or of space.
template <int N>
glm::vec<N, double> point_of(const Tuple& tuple) {
  expects(tuple.size() == std::size_t{N}, "expected points of {} numbers, found '{}'", N, text_of(tuple));
  glm::vec<N, double> point{};
  for (int i = 0; i < N; ++i) point[i] = tuple[static_cast<std::size_t>(i)].value;
  return point;
}

template <int N>
std::vector<glm::vec<N, double>> points_of(const std::vector<Tuple>& tuples) {
  std::vector<glm::vec<N, double>> points;
  for (const Tuple& tuple : tuples) points.push_back(point_of<N>(tuple));
  return points;
}

}  // namespace

std::vector<double> Arguments::numbers(std::string_view name) const {
  std::vector<double> values;
  if (const Tuple* const numbers = value_if_given<Tuple>(name, "numbers")) {
    for (const Number& number : *numbers) values.push_back(number.value);
  }
  return values;
}

std::optional<dvec3> Arguments::place(std::string_view name) const {
  const Tuple* const place = value_if_given<Tuple>(name, "a place");
  return place ? std::optional(point_of<3>(*place)) : std::nullopt;
}

std::vector<Tuple> Arguments::tuples(std::string_view name) const {
  const auto* const points = value_if_given<std::vector<Tuple>>(name, "points");
  return points ? *points : std::vector<Tuple>{};
}

std::vector<dvec2> Arguments::points(std::string_view name) const { return points_of<2>(tuples(name)); }

std::vector<dvec3> Arguments::places(std::string_view name) const { return points_of<3>(tuples(name)); }

std::vector<std::vector<dvec2>> Arguments::rings(std::string_view name) const {
  std::vector<std::vector<dvec2>> rings;
  if (const auto* const lists = value_if_given<std::vector<std::vector<Tuple>>>(name, "rings"))
    std::ranges::transform(*lists, std::back_inserter(rings), points_of<2>);
  return rings;
}

std::vector<NamedFace> Arguments::faces(std::string_view name) const {
  std::vector<NamedFace> faces;
  if (const auto* const texts = value_if_given<std::vector<FaceText>>(name, "faces")) {
    for (const FaceText& face : *texts) faces.push_back({face.name, face.color, points_of<3>(face.points)});
  }
  return faces;
}

std::optional<std::vector<std::size_t>> Arguments::numbered_order(std::string_view name) const {
  const Order& order = value<Order>(name, "an order");
  return order.numbered ? std::optional(order.places) : std::nullopt;
}

std::vector<std::size_t> Arguments::order(std::string_view name) const {
  const Order& order = value<Order>(name, "an order");
  expects(!order.numbered, "{} is an order of names, not '{}'", name, text(name));
  return order.places;
}

std::vector<FactorText> Arguments::factors(std::string_view name) const {
  return value<std::vector<FactorText>>(name, "factors");
}

Rgba8 Arguments::color(std::string_view name) const { return value<Rgba8>(name, "a colour"); }

}  // namespace gradus
