// Work in a process of its own: what it returns, and how it may end.

#include "cli/system/own_process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <stdexcept>
#include <string>

#include "cli/models/model_bytes.hpp"

namespace gradus::cli {
namespace {

using End = ProcessResult::End;

constexpr ProcessLimits enough{.seconds = 100, .bytes = std::size_t{1} << 30};

TEST(OwnProcess, ReturnsAllBytes) {
  for (const std::size_t size : {0u, 1u, 1u << 16, 5'000'000u}) {
    const std::string bytes(size, '\0');
    const ProcessResult result = in_own_process([&] { return bytes; }, enough);
    EXPECT_EQ(result.end, End::whole);
    EXPECT_EQ(result.bytes, bytes);
  }
}

TEST(OwnProcess, WhatItDoesToItselfIsItsOwn) {
  int number = 1;
  EXPECT_EQ(in_own_process([&] { return std::to_string(++number); }, enough).bytes, "2");
  EXPECT_EQ(number, 1);
}

TEST(OwnProcess, MayEndByAnything) {
  EXPECT_EQ(in_own_process([]() -> std::string { throw std::runtime_error("no"); }, enough).end,
            End::crashed);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
    const auto crash = [signal]() -> std::string {
      std::signal(signal, SIG_DFL);
      raise(signal);
      return "still here";
    };
    EXPECT_EQ(in_own_process(crash, enough).end, End::crashed) << signal;
  }
  const auto out_of_time = []() -> std::string {
    raise(SIGXCPU);
    return "still here";
  };
  EXPECT_EQ(in_own_process(out_of_time, enough).end, End::too_much);
}

TEST(OwnProcess, HasItsLimits) {
  const auto limits = []() -> std::string {
    rlimit time{}, core{};
    getrlimit(RLIMIT_CPU, &time), getrlimit(RLIMIT_CORE, &core);
    return std::to_string(time.rlim_cur) + " " + std::to_string(core.rlim_cur);
  };
  EXPECT_EQ(in_own_process(limits, {.seconds = 7, .bytes = std::size_t{1} << 30}).bytes, "7 0");
}

// --- What crosses between processes of ours
// ----------------------------------------------------------------------

pipeline::ModelFile some_model() {
  pipeline::ModelFile m;
  m.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
  m.mesh.normals = {{0, 0, 1}};
  m.mesh.textures = {{0.25, 1}};
  m.mesh.files = {"m.ply"};
  Material red;
  red.name = "red";
  red.opacity = 0.5f;
  red.diffuse_map = {"wood.png", {}, "m.ply: a texture", false};
  m.mesh.materials.push_back(red);
  const Corner corners[]{{0, 0, 0}, {1, -1, 0}, {2, 0, -1}};
  add_face(m.mesh, corners, 1, 0, 7);
  m.points = 3;
  m.notes = {"one", ""};
  m.pictures = {{"*0", std::string("\0bytes", 6)}};
  return m;
}

TEST(ModelBytes, BothWaysIsTheSame) {
  const pipeline::ModelFile m = some_model();
  const auto back = model_in_bytes(bytes_of(m));
  ASSERT_TRUE(back);
  EXPECT_EQ(bytes_of(*back), bytes_of(m));
  EXPECT_EQ(back->mesh.corners, m.mesh.corners);
  EXPECT_EQ(back->mesh.materials[1].diffuse_map.place, "m.ply: a texture");
  EXPECT_FALSE(back->mesh.materials[1].diffuse_map.quotable);
  EXPECT_EQ(back->mesh.faces[0].line, 7);
  EXPECT_EQ(back->notes, m.notes);
  EXPECT_EQ(back->pictures, m.pictures);
}

TEST(ModelBytes, AnyPartIsNone) {
  const std::string bytes = bytes_of(some_model());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(model_in_bytes(std::string_view(bytes).substr(0, size))) << size;
  EXPECT_FALSE(model_in_bytes(bytes + "x"));
}

TEST(ModelBytes, NumbersOfWhatIsNotThereAreRefused) {
  const auto changed = [](auto change) {
    pipeline::ModelFile m = some_model();
    change(m.mesh);
    return model_in_bytes(bytes_of(m)).has_value();
  };
  EXPECT_TRUE(changed([](Mesh&) {}));
  EXPECT_FALSE(changed([](Mesh& m) { m.corners[1].position = 3; }));
  EXPECT_FALSE(changed([](Mesh& m) { m.corners[1].texture = 1; }));
  EXPECT_FALSE(changed([](Mesh& m) { m.corners[1].normal = -2; }));
  EXPECT_FALSE(changed([](Mesh& m) { m.faces[0].count = 4; }));
  EXPECT_FALSE(changed([](Mesh& m) { m.faces[0].first = 1; }));
  EXPECT_FALSE(changed([](Mesh& m) { m.faces[0].material = 2; }));
  EXPECT_FALSE(changed([](Mesh& m) { m.faces[0].file = 1; }));
}

}  // namespace
}  // namespace gradus::cli
