#include "scene/scene_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <map>
#include <memory>
#include <utility>

#include "core/arithmetic/elementary.hpp"
#include "core/colour.hpp"
#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/camera/camera_path_keys.hpp"
#include "scene/camera/projection_keys.hpp"
#include "scene/decimal.hpp"
#include "scene/located_json.hpp"
#include "scene/models/subdivided.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

using Kind = JsonNode::Kind;
using Keys = std::initializer_list<std::string_view>;

constexpr double largest = 1e30;  // as in models
// Lengths that divide and directions that are made as long as 1 are as far from the ends of doubles: products
// of five such quotients are still finite
constexpr double smallest = 1e-30;
constexpr int largest_picture = 8192;

/// A value and the way to it, "/objects/0/place".
struct Found {
  const JsonNode& node;
  std::string way;
};

/// Reads single values, or refuses them.
class Values {
 public:
  explicit Values(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void refuse(const Found& at, std::string_view expected, std::string_view found) const {
    refuse_input(fmt::format("{}:{}: {}: expected {}, found {}", name_, at.node.line,
                             at.way.empty() ? "/" : at.way, expected, found));
  }
  [[noreturn]] void refuse(const Found& at, std::string_view expected) const {
    refuse(at, expected, described(at.node));
  }

  /// The members of an object, all of whose keys are among these.
  std::vector<std::pair<std::string_view, Found>> members(const Found& at, Keys keys) const {
    if (at.node.kind != Kind::object) refuse(at, fmt::format("an object with {}", fmt::join(keys, ", ")));
    std::vector<std::pair<std::string_view, Found>> members;
    for (const JsonMember& member : at.node.members) {
      const auto* key = std::ranges::find(keys, member.key);
      if (key == keys.end()) {
        refuse_input(fmt::format("{}:{}: {}: expected one of the keys {}, found {}", name_, member.line,
                                 at.way.empty() ? "/" : at.way, fmt::join(keys, ", "), shown(member.key)));
      }
      members.push_back({*key, {member.value, at.way + "/" + member.key}});
    }
    return members;
  }
  /// The member of this key, if there is one.
  static std::optional<Found> member(const Found& at, std::string_view key) {
    const JsonMember* found = at.node.member(key);
    if (!found) return std::nullopt;
    return Found{found->value, at.way + "/" + std::string(key)};
  }
  Found needed(const Found& at, std::string_view key) const {
    if (const auto found = member(at, key)) return *found;
    refuse(at, fmt::format("a key {}", shown(key)), "none");
  }

  std::vector<Found> elements(const Found& at, std::string_view expected, std::size_t most) const {
    if (at.node.kind != Kind::list) refuse(at, expected);
    const auto count = at.node.elements.size();
    if (count > most) refuse(at, fmt::format("{}, at most {}", expected, most), fmt::format("{}", count));
    std::vector<Found> elements;
    for (const JsonNode& element : at.node.elements)
      elements.push_back({element, fmt::format("{}/{}", at.way, elements.size())});
    return elements;
  }

  double number(const Found& at, std::string_view expected = "a number of at most 1e30 in size") const {
    const std::string& text = at.node.text;
    double value = 0;
    if (at.node.kind != Kind::number) refuse(at, expected);
    const auto read = read_decimal_by_strtod(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc{} || !(std::abs(value) <= largest)) refuse(at, expected);
    return value;
  }
  double number_in(const Found& at, double least, double most, std::string_view expected) const {
    const double value = number(at, expected);
    if (!(least <= value && value <= most)) refuse(at, expected);
    return value;
  }
  double above_zero(const Found& at) const {
    return number_in(at, smallest, largest, "a number above 0, from 1e-30 to 1e30");
  }
  int whole(const Found& at, int least, int most) const {
    const std::string expected = fmt::format("a whole number from {} to {}", least, most);
    const double value = number_in(at, least, most, expected);
    if (value != std::floor(value)) refuse(at, expected);
    return static_cast<int>(value);
  }
  bool truth(const Found& at) const {
    if (at.node.kind != Kind::boolean) refuse(at, "true or false");
    return at.node.truth;
  }
  const std::string& text(const Found& at, std::string_view expected) const {
    const std::string& text = at.node.text;
    if (at.node.kind != Kind::text || text.empty()) refuse(at, expected);
    // The system would read a file's name up to there
    if (text.find('\0') != std::string::npos) refuse(at, std::string(expected) + ", without NUL");
    return text;
  }
  /// The number of the name.
  std::size_t choice(const Found& at, std::span<const std::string_view> names) const {
    const std::string expected = fmt::format("one of {}", fmt::join(names, ", "));
    const auto found = std::ranges::find(names, text(at, expected));
    if (found == names.end()) refuse(at, expected);
    return static_cast<std::size_t>(found - names.begin());
  }

  dvec3 vector(const Found& at) const {
    constexpr std::string_view expected = "three numbers like [3, 2, 4]";
    const std::vector<Found> parts = elements(at, expected, 3);
    if (parts.size() != 3) refuse(at, expected);
    return {number(parts[0]), number(parts[1]), number(parts[2])};
  }
  dvec3 direction(const Found& at) const {
    const dvec3 way = vector(at);
    const dvec3 parts = glm::abs(way);
    if (way == dvec3{0}) refuse(at, "a direction like [0, 1, 0]", "[0, 0, 0]");
    if (std::max({parts.x, parts.y, parts.z}) < smallest)
      refuse(at, "a direction like [0, 1, 0], one of its numbers at least 1e-30 in size", "less");
    return way;
  }
  /// "#4080ff" in sRGB, or three shares of light.
  LinearRgb colour(const Found& at) const {
    constexpr std::string_view expected =
        "a colour like \"#4080ff\", or three amounts of light from 0 on like [0.1, 0.2, 1]";
    if (at.node.kind == Kind::text) {
      const std::string& text = at.node.text;
      std::uint32_t code = 0;
      const char* const end = text.data() + text.size();
      const auto read = std::from_chars(text.data() + (text.empty() ? 0 : 1), end, code, 16);
      if (text.size() != 7 || text[0] != '#' || read.ec != std::errc{} || read.ptr != end)
        refuse(at, expected);
      const auto byte = [code](int shift) { return static_cast<std::uint8_t>(code >> shift); };
      return linear_from_srgb8({byte(16), byte(8), byte(0)});
    }
    if (at.node.kind != Kind::list || at.node.elements.size() != 3) refuse(at, expected);
    LinearRgb light{0};
    for (const Found& part : elements(at, expected, 3)) {
      light[static_cast<int>(&part.node - at.node.elements.data())] =
          static_cast<float>(number_in(part, 0, largest, "an amount of light from 0 on"));
    }
    return light;
  }

 private:
  std::string name_;
};

// --- Where things stand

/// Readers of transformations.
class Placing {
 public:
  explicit Placing(const Values& values) : values_(values) {}

  /// One transformation, or a list of which the first acts first.
  glm::dmat4 read(const Found& at) const {
    if (at.node.kind == Kind::object) return step(at);
    glm::dmat4 placement{1};
    constexpr std::string_view expected =
        "transformations like [{\"rotate\": {\"axis\": [0, 1, 0], \"degrees\": 30}}, {\"translate\": [1, 0, "
        "0]}]";
    for (const Found& one : values_.elements(at, expected, 1000)) placement = step(one) * placement;
    return placement;
  }

 private:
  glm::dmat4 step(const Found& at) const {
    const auto members = values_.members(at, {"translate", "rotate", "scale", "matrix"});
    if (members.size() != 1) {
      values_.refuse(at, "one of translate, rotate, scale, matrix alone",
                     members.empty() ? "none" : fmt::format("{} of them", members.size()));
    }
    const auto& [key, value] = members[0];
    if (key == "translate") return affine_3d::translation(values_.vector(value));
    if (key == "rotate") return rotation(value);
    if (key == "scale") return affine_3d::scaling(factors(value));
    return matrix(value);
  }

  glm::dmat4 rotation(const Found& at) const {
    values_.members(at, {"axis", "degrees", "about"});
    const dvec3 axis = values_.direction(values_.needed(at, "axis"));
    const double degrees = values_.number(values_.needed(at, "degrees"));
    const auto about = Values::member(at, "about");
    return affine_3d::rotate(axis, radians_from_degrees(degrees), about ? values_.vector(*about) : dvec3{0});
  }

  dvec3 factors(const Found& at) const {
    const dvec3 by = at.node.kind == Kind::number ? dvec3{values_.number(at)} : values_.vector(at);
    const dvec3 sizes = glm::abs(by);
    const double least = std::min({sizes.x, sizes.y, sizes.z});
    if (least < smallest) values_.refuse(at, "factors of at least 1e-30 in size", least == 0 ? "0" : "less");
    return by;
  }

  /// Rows as they are printed; the last one, 0 0 0 1, may be left out.
  glm::dmat4 matrix(const Found& at) const {
    constexpr std::string_view expected = "three or four rows of four numbers";
    const std::vector<Found> rows = values_.elements(at, expected, 4);
    if (rows.size() < 3) values_.refuse(at, expected);
    glm::dmat4 m{1};
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::vector<Found> entries = values_.elements(rows[r], "a row of four numbers", 4);
      if (entries.size() != 4) values_.refuse(rows[r], "a row of four numbers");
      for (std::size_t c = 0; c < 4; ++c)
        m[static_cast<int>(c)][static_cast<int>(r)] = values_.number(entries[c]);
    }
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
      values_.refuse(rows[3], "the last row [0, 0, 0, 1]", "another one");
    return m;
  }

  const Values& values_;
};

// --- Lights

class Lamps {
 public:
  explicit Lamps(const Values& values) : values_(values) {}

  Light read(const Found& at) const {
    static constexpr std::array<std::string_view, 4> names{"point", "directional", "spot", "area"};
    values_.members(at, {"kind", "position", "direction", "target", "intensity", "attenuation", "range",
                         "outer", "inner", "concentration", "across", "along", "samples"});
    Light lamp;
    lamp.kind = static_cast<Light::Kind>(values_.choice(values_.needed(at, "kind"), names));
    // What this kind of lamp has no use for was meant for another one
    const auto only = [&](std::string_view key, std::initializer_list<Light::Kind> kinds) {
      const auto found = Values::member(at, key);
      if (found && std::ranges::find(kinds, lamp.kind) == kinds.end())
        values_.refuse(
            *found,
            fmt::format("no key {} for a {} light", shown(key), names[static_cast<std::size_t>(lamp.kind)]),
            "one");
      return found;
    };
    using enum Light::Kind;
    if (const auto p = only("position", {point, spot, area})) lamp.position = values_.vector(*p);
    if (lamp.kind != directional) values_.needed(at, "position");
    aim(at, lamp, only("direction", {directional, spot}), only("target", {spot}));
    if (const auto c = Values::member(at, "intensity")) lamp.intensity = values_.colour(*c);
    if (const auto a = only("attenuation", {point, spot, area})) attenuate(lamp, *a);
    if (const auto r = only("range", {point, spot, area})) lamp.range = values_.above_zero(*r);
    cone(lamp, only("outer", {spot}), only("inner", {spot}));
    if (const auto c = only("concentration", {spot}))
      lamp.concentration = values_.number_in(*c, 0, largest, "a number from 0 on");
    if (only("across", {area}) || lamp.kind == area)
      lamp.across = values_.direction(values_.needed(at, "across"));
    if (only("along", {area}) || lamp.kind == area)
      lamp.along = values_.direction(values_.needed(at, "along"));
    if (lamp.kind == area && glm::cross(lamp.across, lamp.along) == dvec3{0})
      values_.refuse(*Values::member(at, "along"), "another direction than that of across", "the same");
    if (const auto n = only("samples", {area})) lamp.samples = values_.whole(*n, 1, 1024);
    return lamp;
  }

 private:
  void aim(const Found& at, Light& lamp, const std::optional<Found>& direction,
           const std::optional<Found>& target) const {
    if (lamp.kind != Light::Kind::directional && lamp.kind != Light::Kind::spot) return;
    if (direction && target) values_.refuse(*target, "either a direction or a target", "both");
    if (!target) {
      lamp.direction = values_.direction(direction ? *direction : values_.needed(at, "direction"));
      return;
    }
    lamp.direction = values_.vector(*target) - lamp.position;
    if (lamp.direction == dvec3{0}) values_.refuse(*target, "another point than the light's", "the same");
  }

  void attenuate(Light& lamp, const Found& at) const {
    const dvec3 by = values_.vector(at);
    if (!(by.x >= 0 && by.y >= 0 && by.z >= 0) || std::max({by.x, by.y, by.z}) < smallest)
      values_.refuse(at, "constant, linear and quadratic part from 0 on, one of them at least 1e-30",
                     "others");
    lamp.constant = by.x, lamp.linear = by.y, lamp.quadratic = by.z;
  }

  void cone(Light& lamp, const std::optional<Found>& outer, const std::optional<Found>& inner) const {
    constexpr std::string_view expected = "an angle from the axis, 0 to 180 degrees";
    const double widest = outer ? values_.number_in(*outer, 0, 180, expected) : 60;
    const double full = inner ? values_.number_in(*inner, 0, 180, expected) : widest;
    if (full > widest)
      values_.refuse(*inner, fmt::format("an inner cone within the outer one, at most {} degrees", widest));
    lamp.outer_cosine = std::clamp(cos(radians_from_degrees(widest)), -1.0, 1.0);
    lamp.inner_cosine = std::clamp(cos(radians_from_degrees(full)), lamp.outer_cosine, 1.0);
  }

  const Values& values_;
};

// --- The whole

class SceneReader {
 public:
  SceneReader(const std::string& name, const ModelFinder& find, const PictureDecoder& decode,
              const ModelImporter& import)
      : values_(name), find_(find), decode_(decode), import_(import), name_(name) {}

  SceneFile read(const JsonNode& root) {
    const Found at{root, ""};
    for (const auto& [key, value] :
         values_.members(at, {"$schema", "size", "background", "ambient", "shading", "hidden_surfaces",
                              "culling", "filter", "aa", "samples", "camera", "lights", "objects"}))
      take(key, value);
    check_samples(at);
    take_objects(values_.needed(at, "objects"));
    return std::move(file_);
  }

 private:
  Scene& scene() { return file_.scene; }

  void take(std::string_view key, const Found& at) {
    static constexpr std::array<std::string_view, 3> filters{"nearest", "bilinear", "mipmapped"};
    if (key == "$schema") values_.text(at, "where the schema is, a text");
    if (key == "size") take_size(at);
    if (key == "background") scene().background = values_.colour(at);
    if (key == "ambient") scene().ambient = values_.colour(at);
    if (key == "shading") scene().shading = static_cast<Shading>(values_.choice(at, shading_names));
    if (key == "hidden_surfaces")
      scene().hidden_surfaces = static_cast<HiddenSurfaces>(values_.choice(at, hidden_surface_names));
    if (key == "culling") scene().culling = static_cast<Culling>(values_.choice(at, culling_names));
    if (key == "filter") scene().filter = static_cast<TextureFilter>(values_.choice(at, filters));
    if (key == "aa") scene().antialiasing = static_cast<Antialiasing>(values_.choice(at, antialiasing_names));
    if (key == "samples") scene().samples = values_.whole(at, 1, 256);
    if (key == "camera") take_camera(at);
    if (key == "lights") take_lights(at);
  }

  void take_size(const Found& at) {
    constexpr std::string_view expected = "a width and a height in pixels like [800, 600]";
    const std::vector<Found> sides = values_.elements(at, expected, 2);
    if (sides.size() != 2) values_.refuse(at, expected);
    file_.size =
        ivec2{values_.whole(sides[0], 1, largest_picture), values_.whole(sides[1], 1, largest_picture)};
  }

  void check_samples(const Found& root) {
    const auto at = Values::member(root, "samples");
    if (!at) return;
    const Antialiasing method = scene().antialiasing;
    if (!takes_samples(method))
      values_.refuse(*at, fmt::format("no number of samples for {}, which has its own", name_of(method)));
    if (takes_squares(method) && grid_side(scene().samples) == 0)
      values_.refuse(*at, "a square like 4, 9 or 16, for they stand in cells");
  }

  void take_camera(const Found& at) {
    values_.members(at, {"eye", "target", "up", "projection", "fov", "focal", "sensor", "height", "receding",
                         "foreshortening", "near", "far", "path", "interpolation"});
    View& view = file_.view;
    if (const auto eye = Values::member(at, "eye")) view.eye = values_.vector(*eye);
    if (const auto target = Values::member(at, "target")) view.target = values_.vector(*target);
    if (const auto up = Values::member(at, "up")) view.up = values_.direction(*up);
    take_projection(values_, at, view);
    take_lens(values_, at, view);
    file_.path = camera_path_in(values_, at, view);
    const auto near = Values::member(at, "near"), far = Values::member(at, "far");
    if (!near && !far) return;
    file_.depths =
        dvec2{values_.above_zero(values_.needed(at, "near")), values_.above_zero(values_.needed(at, "far"))};
    if (!(file_.depths->x < file_.depths->y)) values_.refuse(*far, "a far plane behind the near one");
  }

  void take_lights(const Found& at) {
    file_.lights_told = true;
    const Lamps lamps(values_);
    for (const Found& one : values_.elements(at, "a list of lights", most_lights))
      scene().lights.push_back(lamps.read(one));
  }

  // Objects
  void take_objects(const Found& at) {
    const std::vector<Found> objects = values_.elements(at, "a list of objects", most_objects);
    if (objects.empty()) values_.refuse(at, "a list of at least one object");
    for (const Found& one : objects) take_object(one);
  }

  void take_object(const Found& at) {
    values_.members(at, {"name", "model", "place", "instances", "two_sided", "material", "subdivide"});
    Object object = model_of(values_.needed(at, "model"));
    if (const auto name = Values::member(at, "name")) object.name = values_.text(*name, "a name");
    if (const auto sides = Values::member(at, "two_sided")) object.two_sided = values_.truth(*sides);
    if (const auto material = Values::member(at, "material")) cover(object, *material);
    if (const auto levels = Values::member(at, "subdivide")) take_levels(object, *levels);
    const Placing placing(values_);
    const auto place = Values::member(at, "place"), instances = Values::member(at, "instances");
    if (place) object.placement = placing.read(*place);
    if (!instances) return add(at, std::move(object));
    const std::vector<Found> places = values_.elements(*instances, "a list of places", most_objects);
    if (places.empty()) values_.refuse(*instances, "a list of at least one place");
    for (const Found& one : places) {
      Object instance = object;
      instance.placement = placing.read(one) * object.placement;
      add(one, std::move(instance));
    }
  }

  /// Makes the model a control mesh.
  void take_levels(Object& object, const Found& at) const {
    object.subdivision = Subdivision{object.mesh, values_.whole(at, 1, most_subdivisions)};
    if (const auto problem = why_not_subdivided(*object.mesh))
      values_.refuse(at, "a model that is a surface, to subdivide", *problem);
  }

  /// Refuses a place that leaves no body.
  void add(const Found& at, Object object) {
    const double volume = glm::determinant(glm::dmat3(object.placement));
    if (!std::isfinite(volume) || volume == 0) values_.refuse(at, "a place with an inverse", "another");
    if (scene().objects.size() == most_objects)
      values_.refuse(at, fmt::format("at most {} objects with all instances", most_objects), "more");
    scene().objects.push_back(std::move(object));
  }

  const Object& model_of(const Found& at) {
    const std::string& name = values_.text(at, "a file's name like \"../models/spot.obj\"");
    if (const auto known = models_.find(name); known != models_.end()) return known->second;
    if (models_.size() == most_models)
      values_.refuse(at, fmt::format("at most {} different models", most_models), "one more");
    const std::optional<FoundModel> found = find_(name);
    if (!found) values_.refuse(at, "the name of a file that is there");
    if (!found->text.problem.empty())
      refuse_input(fmt::format("{}:{}: {}: {}", name_, at.node.line, at.way, found->text.problem));
    const TextFile file{found->called, found->text.quotable};
    ModelFile model = read_model(found->text.text, file, found->beside, import_);
    if (decode_) load_textures(model, found->beside, decode_, found->called);
    file_.notes.insert(file_.notes.end(), model.notes.begin(), model.notes.end());
    return models_.emplace(name, object_of(std::move(model.mesh), name)).first->second;
  }

  /// Gives all faces one material.
  void cover(Object& object, const Found& at) const {
    const auto number = [&](const Found& value, double most, std::string_view expected) {
      return static_cast<float>(values_.number_in(value, 0, most, expected));
    };
    Material material;
    material.name = "scene";
    std::optional<LinearRgb> ambient;
    for (const auto& [key, value] :
         values_.members(at, {"ambient", "diffuse", "specular", "shininess", "emission", "opacity"})) {
      if (key == "ambient") ambient = values_.colour(value);
      if (key == "diffuse") material.diffuse = values_.colour(value);
      if (key == "specular") material.specular = values_.colour(value);
      if (key == "emission") material.emission = values_.colour(value);
      if (key == "shininess") material.shininess = number(value, largest, "an exponent from 0 on");
      if (key == "opacity") material.opacity = number(value, 1, "an opacity from 0 to 1");
    }
    material.ambient = ambient.value_or(material.diffuse);  // as in material libraries
    Mesh mesh = *object.mesh;
    mesh.materials = {Material{}, material};
    for (MeshFace& face : mesh.faces) face.material = 1;
    object.see_through = material.opacity < 1;
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }

  Values values_;
  const ModelFinder& find_;
  const PictureDecoder& decode_;
  const ModelImporter& import_;
  const std::string& name_;
  std::map<std::string, Object, std::less<>> models_;
  SceneFile file_;
};

}  // namespace

SceneFile parse_scene(std::string_view text, const std::string& name, const ModelFinder& find,
                      const PictureDecoder& decode, const ModelImporter& import) {
  return SceneReader(name, find, decode, import).read(read_json(text, name));
}

}  // namespace gradus::pipeline
