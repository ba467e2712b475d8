// What reading models costs: text that is in memory already, beside tinyobjloader, which forgives more.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <memory>
#include <numbers>

#include "benchmark/subject.hpp"
#include "scene/models/obj.hpp"

#ifdef GRADUS_HAS_TINYOBJ
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#endif

namespace gradus::bench {
namespace {

/// A ball of 2 n x n squares. dressed: with texture coordinates and normals; else in triangles of positions.
std::string ball(int n, bool dressed) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      const double polar = std::numbers::pi * j / n, around = std::numbers::pi * i / n;
      const double x = std::sin(polar) * std::cos(around), y = std::cos(polar),
                   z = std::sin(polar) * std::sin(around);
      fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", x, y, z);
      if (!dressed) continue;
      fmt::format_to(out, "vt {:.6f} {:.6f}\n", i / (2.0 * n), j / (1.0 * n));
      fmt::format_to(out, "vn {:.6f} {:.6f} {:.6f}\n", x, y, z);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      const int a = j * 2 * n + i + 1, b = j * 2 * n + (i + 1) % (2 * n) + 1, c = b + 2 * n, d = a + 2 * n;
      if (dressed)
        fmt::format_to(out, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2} {3}/{3}/{3}\n", a, b, c, d);
      else
        fmt::format_to(out, "f {0} {1} {2}\nf {0} {2} {3}\n", a, b, c, d);
    }
  }
  return text;
}

/// The coordinates of the positions of a text, by the C library.
std::vector<double> coordinates_in(const std::string& text) {
  std::vector<double> found;
  for (const char* line = text.c_str(); line[0] == 'v' || line[0] == 'f';
       line = std::strchr(line, '\n') + 1) {
    if (line[0] != 'v' || line[1] != ' ') continue;
    const char* at = line + 1;
    for (int i = 0; i < 3; ++i) {
      char* end = nullptr;
      found.push_back(std::strtod(at, &end));
      at = end;
    }
  }
  return found;
}

template <class Coordinate>
Error error_of(const std::vector<double>& right, std::size_t count, Coordinate coordinate) {
  Error::Sum sum;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (i >= count)
      sum.wrong_decision();
    else
      sum.add(std::abs(coordinate(i) - right[i]));
  }
  return sum.error();
}

pipeline::ModelFile read(const std::string& text) {
  return pipeline::parse_obj(text, "ball.obj", [](const std::string&) { return std::nullopt; });
}

Case ours(const std::shared_ptr<const std::string>& text, const Workload& workload) {
  const auto model = std::make_shared<pipeline::ModelFile>(read(*text));
  const Mesh& mesh = model->mesh;
  const Error error = error_of(coordinates_in(*text), 3 * mesh.positions.size(),
                               [&](std::size_t i) { return mesh.positions[i / 3][static_cast<int>(i % 3)]; });
  return {.method = "parse_obj",
          .standing = Standing::robust,
          .workload = workload,
          .items = std::ssize(*text),
          .run = [text, model] { *model = read(*text); },
          .error = error};
}

#ifdef GRADUS_HAS_TINYOBJ
Case tinyobjloader(const std::shared_ptr<const std::string>& text, const Workload& workload) {
  const auto read = [text](tinyobj::ObjReader& reader) {
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    reader.ParseFromString(*text, "", config);
  };
  const auto reader = std::make_shared<tinyobj::ObjReader>();
  read(*reader);
  const std::vector<tinyobj::real_t>& found = reader->GetAttrib().vertices;
  const Error error =
      error_of(coordinates_in(*text), found.size(), [&](std::size_t i) { return double{found[i]}; });
  return {.method = "tinyobjloader",
          .standing = Standing::peer,
          .workload = workload,
          .items = std::ssize(*text),
          .run = [read, reader] { read(*reader); },
          .error = error};
}
#endif

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const std::string& text, const Workload& workload) {
    const auto shared = std::make_shared<const std::string>(text);
    all.push_back(ours(shared, workload));
#ifdef GRADUS_HAS_TINYOBJ
    all.push_back(tinyobjloader(shared, workload));
#endif
  };
  for (const int n : {10, 32, 100, 316}) {
    const std::string text = ball(n, true);
    add(text, {fmt::format("quads with all, {} kB", text.size() / 1000), static_cast<double>(text.size())});
  }
  add(ball(316, true), {"quads with texture coordinates and normals"});
  add(ball(316, false), {"triangles of positions"});
  return all;
}

}  // namespace

Subject read_obj() {
  return {.topic = "read_obj",
          .title = "Models from OBJ text",
          .item = "byte",
          .unit = "parts of a coordinate",
          .measure = "bytes",
          .telling = "quads with texture coordinates and normals",
          .cases = cases,
          .choice = {"parse_obj", "every number the nearest double, in less time"}};
}

}  // namespace gradus::bench
