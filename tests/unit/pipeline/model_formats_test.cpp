// Who reads a model, by its name.

#include "scene/models/model_formats.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "core/refusal.hpp"

namespace gradus::pipeline::model_formats_test {
namespace {

const FileReader nothing = [](const std::string&) -> std::optional<LibraryText> { return std::nullopt; };

TEST(ModelFormats, NamesDecide) {
  for (const char* name : {"a.gltf", "a.off", "a.GLB", "some.folder/a.Stl", "a.obj.ply", ".ply"})
    EXPECT_TRUE(is_other_format(name)) << name;
  for (const char* name : {"a.obj", "a.OBJ", "a", "", "ply", "a.ply/b", "a.json", "a.ply.", "standard input"})
    EXPECT_FALSE(is_other_format(name)) << name;
  EXPECT_EQ(ending_of("x/y.MTL"), "mtl");
}

TEST(ModelFormats, ObjIsReadByOurOwnReader) {
  const ModelImporter never = [](auto&&...) -> ModelFile { refuse_input("imported"); };
  EXPECT_EQ(read_model("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj", nothing, never).mesh.faces.size(),
            1u);
  EXPECT_THROW(read_model("", "m.glb", nothing, never), InputError);
}

TEST(ModelFormats, WithoutAnImporterOthersAreRefused) {
  try {
    read_model("ply\n", "m.glb", nothing, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "m.glb: expected an OBJ, OFF, PLY or STL file, for gradus was built without Assimp, which "
                 "reads others, found one of another format");
  }
}

}  // namespace
}  // namespace gradus::pipeline::model_formats_test
