#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/decimal.hpp"
#include "scene/located_json.hpp"
#include "scene/models/textures.hpp"
#include "scene/road/road_demo.hpp"

namespace gradus::pipeline {
namespace {

using Kind = JsonNode::Kind;

constexpr double largest_number = farthest_texture_coordinate;
constexpr double most_rounds = 1000;
constexpr int any = -1;  ///< as many as there are

/// What stands under a key. rows = 0: a single number; columns = 0: a list of `rows` numbers.
struct KnownKey {
  std::string_view name;
  int rows, columns;
  std::string_view expected, meaning;
};
constexpr std::string_view a_number = "a number", as_column = "3 rows of one number",
                           three_numbers = "3 numbers";
constexpr std::array<KnownKey, demo_keys> known_keys{{
    {"k_cam_up", 3, 1, as_column, "what is up in the picture, a hint"},
    {"k_sensor_height", 0, 0, a_number, "height of the camera's sensor"},
    {"k_sensor_width", 0, 0, a_number, "width of the camera's sensor"},
    {"k_f", 0, 0, a_number, "focal length, in the unit of the sensor"},
    {"car_velocity", 0, 0, a_number, "speed of the car, lengths a second"},
    {"k_road_radius", 0, 0, a_number, "radius of the circular road"},
    {"k_road_center", 3, 0, three_numbers, "centre of the road"},
    {"k_cam_car_rel_pos", 3, 0, three_numbers, "the camera in the car's axes: out, ahead, up"},
    {"k_duration", 0, 0, a_number, "length of the film, seconds"},
    {"k_fps", 0, 0, a_number, "frames a second"},
    {"v_pos", 3, any, "3 rows of as many numbers", "places of the vertices, a column each"},
    {"v_uvs", any, 2, "rows of 2 numbers", "their places in the texture, a row each, v up"},
    {"t_pos_idx", any, 3, "rows of 3 numbers", "triangles, a row of three vertices each"},
    {"k_cam_target", 3, 1, as_column, "what the camera of the demo target looks at"},
}};

/// The numbers under a key, row by row.
struct Block {
  const JsonMember* member = nullptr;
  std::size_t rows = 1, columns = 1;
  std::vector<double> numbers;
  bool whole = true;

  double at(std::size_t row, std::size_t column) const { return numbers[row * columns + column]; }
};

/// Reads an object of the known keys, or refuses it.
class DataReader {
 public:
  explicit DataReader(std::string name) : name_(std::move(name)) {}

  RoadDemo read(const JsonNode& root) {
    if (root.kind != Kind::object) {
      refuse_input(fmt::format("{}:{}: expected an object with the keys of a demo, found {}", name_,
                               root.line, described(root)));
    }
    for (const JsonMember& member : root.members) take(member);
    for (std::size_t i = 0; i < demo_keys; ++i) {
      if (!blocks_[i].member) {
        refuse_input(fmt::format("{}: expected a key {}, found none", name_, known_keys[i].name));
      }
    }
    fill();
    return std::move(demo_);
  }

 private:
  [[noreturn]] void refuse(const JsonMember& at, int line, std::string_view expected,
                           std::string_view found) const {
    refuse_input(fmt::format("{}:{}: {}: expected {}, found {}", name_, line, at.key, expected, found));
  }
  [[noreturn]] void refuse(const Block& at, std::string_view expected, std::string_view found) const {
    refuse(*at.member, at.member->value.line, expected, found);
  }

  void take(const JsonMember& member) {
    const auto known = std::ranges::find(known_keys, member.key, &KnownKey::name);
    if (known == known_keys.end()) {
      std::vector<std::string_view> names;
      for (const KnownKey& key : known_keys) names.push_back(key.name);
      refuse_input(fmt::format("{}:{}: expected one of the keys {}, found {}", name_, member.line,
                               fmt::join(names, ", "), shown(member.key)));
    }
    Block& block = blocks_[static_cast<std::size_t>(known - known_keys.begin())];
    block.member = &member;
    add_numbers(block, *known);
    demo_.entries.push_back({known->name, known->meaning, block.whole, shape(block, *known)});
  }

  static std::vector<std::size_t> shape(const Block& block, const KnownKey& key) {
    if (key.rows == 0) return {};
    if (key.columns == 0) return {block.columns};
    return {block.rows, block.columns};
  }

  void add_numbers(Block& block, const KnownKey& key) const {
    const JsonNode& value = block.member->value;
    if (key.rows == 0) return add_number(block, value, key);
    if (key.columns == 0) {
      block.columns = static_cast<std::size_t>(key.rows);
      return add_row(block, value, key);
    }
    const bool as_many = key.rows == any || value.elements.size() == static_cast<std::size_t>(key.rows);
    if (value.kind != Kind::list || value.elements.empty() || !as_many)
      refuse(block, key.expected, found_in(value));
    block.rows = value.elements.size();
    const JsonNode& first = value.elements[0];
    block.columns = key.columns == any ? first.elements.size() : static_cast<std::size_t>(key.columns);
    for (const JsonNode& row : value.elements) add_row(block, row, key);
  }

  void add_row(Block& block, const JsonNode& row, const KnownKey& key) const {
    if (row.kind != Kind::list || row.elements.empty() || row.elements.size() != block.columns)
      refuse(*block.member, row.line, key.expected, found_in(row));
    for (const JsonNode& element : row.elements) add_number(block, element, key);
  }

  void add_number(Block& block, const JsonNode& node, const KnownKey& key) const {
    if (node.kind != Kind::number) refuse(*block.member, node.line, key.expected, found_in(node));
    double value = 0;
    const char* const first = node.text.data();
    const auto read = read_decimal_by_strtod(first, first + node.text.size(), value);
    if (read.ec != std::errc{} || !(std::abs(value) <= largest_number))
      refuse(*block.member, node.line, fmt::format("numbers of at most {} in size", largest_number),
             node.text);
    block.numbers.push_back(value);
    block.whole = block.whole && node.text.find_first_of(".eE") == std::string::npos;
  }

  static std::string found_in(const JsonNode& node) {
    if (node.kind != Kind::list) return described(node);
    return fmt::format("a list of {}", node.elements.size());
  }

  // --- What the numbers mean -------------------------------------------------------------------------------

  const Block& block(std::string_view key) const {
    const auto known = std::ranges::find(known_keys, key, &KnownKey::name);
    return blocks_[static_cast<std::size_t>(known - known_keys.begin())];
  }

  double above_zero(std::string_view key) const {
    const Block& found = block(key);
    if (!(found.numbers[0] > 0)) refuse(found, "a number above 0", found.member->value.text);
    return found.numbers[0];
  }

  int whole(std::string_view key, int most) const {
    const Block& found = block(key);
    const double number = found.numbers[0];
    if (!found.whole || !(1 <= number && number <= most))
      refuse(found, fmt::format("a whole number from 1 to {}", most), found.member->value.text);
    return static_cast<int>(number);
  }

  /// Of three numbers in a row or in a column.
  dvec3 vector(std::string_view key) const {
    const std::vector<double>& n = block(key).numbers;
    return {n[0], n[1], n[2]};
  }

  void fill() {
    demo_.road = {vector("k_road_center"), above_zero("k_road_radius"), above_zero("car_velocity")};
    const double rounds = angular_speed(demo_.road) * block("k_duration").numbers[0] / 6.283185307179586;
    if (!(rounds <= most_rounds)) {
      refuse(block("car_velocity"), fmt::format("at most {} rounds of the road in all", most_rounds),
             fmt::format("{:.4g}", rounds));
    }
    demo_.mount = vector("k_cam_car_rel_pos");
    demo_.target = vector("k_cam_target");
    demo_.seconds = whole("k_duration", most_demo_frames);
    demo_.fps = whole("k_fps", most_demo_fps);
    if (frame_count(demo_) > most_demo_frames) {
      refuse(block("k_duration"), fmt::format("at most {} frames in all", most_demo_frames),
             fmt::format("{}", frame_count(demo_)));
    }
    fill_camera();
    fill_model();
  }

  void fill_camera() {
    demo_.up = vector("k_cam_up");
    // In the plane of the road it would be the view direction somewhere
    if (!(std::abs(demo_.up.z) >= 1e-3 * glm::length(demo_.up)) || demo_.up == dvec3{0})
      refuse(block("k_cam_up"), "a direction out of the road's plane like [[0], [0], [1]]",
             fmt::format("({}, {}, {})", demo_.up.x, demo_.up.y, demo_.up.z));
    demo_.focal = above_zero("k_f");
    demo_.sensor_width = above_zero("k_sensor_width");
    demo_.sensor_height = above_zero("k_sensor_height");
    const double ratio = demo_.sensor_width / demo_.sensor_height,
                 opening = demo_.sensor_height / demo_.focal;
    if (!(0.125 <= ratio && ratio <= 8))
      refuse(block("k_sensor_width"), "1/8 to 8 times the height", fmt::format("{} times", ratio));
    if (!(1e-4 <= opening && opening <= 1e4))
      refuse(block("k_f"), "1e-4 to 1e4 times the sensor's height", fmt::format("{} times", 1 / opening));
  }

  void fill_model() {
    const Block &places = block("v_pos"), &uvs = block("v_uvs"), &corners = block("t_pos_idx");
    const std::size_t count = places.columns;
    if (count > most_demo_vertices || corners.rows > most_demo_vertices)
      refuse(count > most_demo_vertices ? places : corners, fmt::format("at most {}", most_demo_vertices),
             fmt::format("{}", std::max(count, corners.rows)));
    if (uvs.rows != count)
      refuse(uvs, fmt::format("{} rows, one per vertex", count), fmt::format("{}", uvs.rows));
    for (std::size_t i = 0; i < count; ++i) {
      demo_.positions.emplace_back(places.at(0, i), places.at(1, i), places.at(2, i));
      demo_.uvs.emplace_back(uvs.at(i, 0), uvs.at(i, 1));
    }
    for (std::size_t i = 0; i < corners.rows; ++i) {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = vertex(corners, corners.at(i, k), count);
      demo_.triangles.push_back(triangle);
    }
  }

  int vertex(const Block& corners, double number, std::size_t count) const {
    if (!corners.whole || !(0 <= number && number < static_cast<double>(count)))
      refuse(corners, fmt::format("whole numbers of vertices from 0 to {}", count - 1),
             fmt::format("{}", number));
    return static_cast<int>(number);
  }

  std::string name_;
  std::array<Block, demo_keys> blocks_;
  RoadDemo demo_;
};

}  // namespace

RoadDemo parse_road_demo(std::string_view text, const std::string& name) {
  return DataReader(name).read(read_json(text, name));
}

}  // namespace gradus::pipeline
