// Textures in the textbook chain: what a material's picture does to the colours, and what is refused.

#include "scene/models/textures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/colour.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/models/obj.hpp"

namespace gradus::pipeline::textures_test {
namespace {

using Files = std::map<std::string, std::string>;

/// A square with texture coordinates from 0 to 1, and its material.
const std::string square =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl m\nf 1/1 2/2 3/3 4/4\n";

FileReader among(const Files& files) {
  return [&files](const std::string& name) -> std::optional<LibraryText> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(LibraryText(found->second));
  };
}

/// A picture of two columns and two rows: red and green above blue and white.
Image four_colours(const std::string&, const std::string&, std::int64_t) {
  Image image(2, 2);
  image[{0, 0}] = {255, 0, 0};
  image[{1, 0}] = {0, 128, 0};
  image[{0, 1}] = {0, 0, 255};
  image[{1, 1}] = {255, 255, 255};
  return image;
}

/// The square with the picture, by light that comes from everywhere alone.
Scene scene_with(const std::string& material, TextureFilter filter) {
  const Files files{{"m.mtl", "newmtl m\n" + material + "map_Kd p.png\n"}, {"p.png", ""}};
  Mesh mesh = parse_obj(square, "m.obj", among(files)).mesh;
  load_textures(mesh, among(files), four_colours, "m.obj");
  Scene scene = scene_of(std::move(mesh), 1);
  scene.lights = {};
  scene.ambient = LinearRgb{1};
  scene.background = LinearRgb{0};
  scene.filter = filter;
  return scene;
}

std::set<std::array<int, 3>> colours_of(const Image& image) {
  std::set<std::array<int, 3>> all;
  for (const Rgba8 p : image.cells()) all.insert({p.r, p.g, p.b});
  return all;
}

/// R000-038
TEST(Textures, WhiteShowsThePureTextureAndBlackNothing) {
  const Image pure = render(scene_with("Kd 1 1 1\n", TextureFilter::nearest), {40, 40});
  EXPECT_EQ(colours_of(pure), (std::set<std::array<int, 3>>{
                                  {0, 0, 0}, {255, 0, 0}, {0, 128, 0}, {0, 0, 255}, {255, 255, 255}}));
  const Image black = render(scene_with("Kd 0 0 0\n", TextureFilter::nearest), {40, 40});
  EXPECT_EQ(colours_of(black), (std::set<std::array<int, 3>>{{0, 0, 0}}));
}

TEST(Textures, RowZeroIsAtTheTopAndVGoesUp) {
  const Image image = render(scene_with("Kd 1 1 1\n", TextureFilter::nearest), {40, 40});
  std::map<int, ivec2> sum, count;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const Rgba8 p = image[{x, y}];
      const int which = p.r > 0 && p.b > 0 ? 3 : p.b > 0 ? 2 : p.g > 0 ? 1 : p.r > 0 ? 0 : -1;
      sum[which] += ivec2{x, y};
      count[which] += 1;
    }
  }
  const auto middle = [&](int which) { return sum[which] / count[which]; };
  EXPECT_LT(middle(0).x, middle(1).x);
  EXPECT_LT(middle(0).y, middle(2).y);
  EXPECT_LT(middle(2).x, middle(3).x);
  EXPECT_LT(middle(1).y, middle(3).y);
}

/// Each visible fragment has the colour that its texture coordinates have on the texture.
TEST(Textures, TexelsAreThoseOfTheTextureCoordinates) {
  const Scene scene = scene_with("Kd 1 1 1\n", TextureFilter::nearest);
  const Image& texels = scene.objects[0].mesh->materials[1].diffuse_map.texels;
  int looked_at = 0;
  const auto watch = [&](const Shaded& s) {
    ASSERT_TRUE(s.texel);
    const ivec2 texel{s.texture.x < 0.5 ? 0 : 1, s.texture.y < 0.5 ? 1 : 0};
    EXPECT_EQ(*s.texel, linear_from_srgb8(texels[texel]));
    ++looked_at;
  };
  render(scene, {40, 40}, only<Shaded>(watch));
  EXPECT_GT(looked_at, 200);
}

/// One pixel covers the whole texture: the last level, the mean in linear light.
TEST(Textures, APixelOfTheWholeTextureHasItsMean) {
  Scene scene = scene_with("Kd 1 1 1\n", TextureFilter::mip_mapped);
  int looked_at = 0;
  const auto watch = [&](const Shaded& s) {
    const float green = linear_from_srgb8(std::uint8_t{128});
    EXPECT_NEAR(s.texel->r, 0.5f, 1e-6f);
    EXPECT_NEAR(s.texel->g, (1 + green) / 4, 1e-6f);
    ++looked_at;
  };
  render(scene, {1, 1}, only<Shaded>(watch));
  EXPECT_GT(looked_at, 0);
}

TEST(Textures, FlatAndGouraudWearThemToo) {
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    Scene scene = scene_with("Kd 1 1 1\n", TextureFilter::nearest);
    scene.shading = shading;
    EXPECT_EQ(colours_of(render(scene, {40, 40})).size(), 5U);
  }
}

std::string refusal_of(const std::string& model, const Files& files,
                       const PictureDecoder& decode = four_colours) {
  Mesh mesh = parse_obj(model, "m.obj", among(files)).mesh;
  try {
    load_textures(mesh, among(files), decode, "m.obj");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Textures, RefusedWithTheLineThatNamesThem) {
  Files files{{"m.mtl", "newmtl m\nKd 1 1 1\nmap_Kd -clamp on my wood.png\n"}};
  EXPECT_EQ(
      refusal_of(square, files),
      "m.mtl:3: map_Kd 'my wood.png': expected a PNG or JPEG file of that name beside the model, found none");
  const auto wide = [](const std::string&, const std::string&, std::int64_t) { return Image(40'000, 1); };
  files["my wood.png"] = "";
  EXPECT_EQ(refusal_of(square, files, wide),
            "m.mtl:3: map_Kd 'my wood.png': expected at most 32768 pixels per side, found 40000");
  // A mistake in the picture is reported by its decoder, under the same name
  const auto broken = [](const std::string&, const std::string& name, std::int64_t) -> Image {
    refuse_input(name + ": broken");
  };
  EXPECT_EQ(refusal_of(square, files, broken), "m.mtl:3: map_Kd 'my wood.png': broken");
  std::string far = square;
  far.replace(far.find("vt 1 1"), 6, "vt 1e9 1");
  EXPECT_EQ(refusal_of(far, files),
            "m.obj: expected texture coordinates within 524288 of 0 on faces with a texture");
  // What no face wears is not looked for
  files["m.mtl"] += "newmtl other\nmap_Kd gone.png\n";
  EXPECT_EQ(refusal_of(square, files), "");
}

TEST(Textures, EachFileIsReadOnceAndCounted) {
  const Files files{{"m.mtl", "newmtl m\nmap_Kd p.png\nnewmtl n\nmap_Kd p.png\nnewmtl o\nmap_Kd q.png\n"},
                    {"p.png", ""},
                    {"q.png", ""}};
  std::vector<std::int64_t> left;
  const auto decode = [&](const std::string& bytes, const std::string& name, std::int64_t most) {
    left.push_back(most);
    return four_colours(bytes, name, most);
  };
  EXPECT_EQ(refusal_of(square + "usemtl n\nf 1/1 2/2 3/3\nusemtl o\nf 1/1 2/2 3/3\n", files, decode), "");
  EXPECT_EQ(left, (std::vector<std::int64_t>{33'554'432, 33'554'432 - 4}));
}

}  // namespace
}  // namespace gradus::pipeline::textures_test
