// Traces are the same on every compiler: their hashes are committed, and this runs in every build.
// GRADUS_UPDATE_GOLDEN=1 writes the file anew.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/example_traces.hpp"

namespace gradus {
namespace {

std::string text_of_value(const Value& value) {
  return std::visit(
      [](const auto& v) {
        if constexpr (std::same_as<std::decay_t<decltype(v)>, ivec2>) {
          return fmt::format("({},{})", v.x, v.y);
        } else {
          return fmt::format("{}", v);
        }
      },
      value);
}

std::string text_of_mark(const Mark& mark) {
  std::string text = mark.id + " " + std::string(name_of(mark.role));
  const auto point = [&text](dvec2 p) { text += fmt::format(" {} {}", p.x, p.y); };
  if (const Dot* dot = std::get_if<Dot>(&mark.shape)) point(dot->at);
  if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) point(stroke->a), point(stroke->b);
  if (const Path* path = std::get_if<Path>(&mark.shape)) {
    for (const dvec2 p : path->points) point(p);
  }
  if (const Label* label = std::get_if<Label>(&mark.shape)) {
    point(label->at);
    text += " " + label->text;
  }
  return text;
}

/// Everything a trace says, but for source lines: editing a comment changes no trace.
std::string whole_text(const Trace& trace) {
  std::string text = fmt::format("{}|{}|{}|{}\n", trace.title, trace.subtitle, trace.method, trace.faulty);
  for (const Mark& mark : trace.backdrop) text += text_of_mark(mark) + "\n";
  for (const TraceStep& step : trace.steps) {
    text +=
        fmt::format("{} {} {} {} {}\n", text_of(step.number), step.type, step.phase, step.key, step.sentence);
    for (const Field& field : step.fields) text += field.name + "=" + text_of_value(field.value) + ";";
    for (const std::string& cell : step.read) text += cell + "|";
    for (const std::string& cell : step.row) text += cell + "|";
    for (const std::string& id : step.delta.removed) text += "-" + id;
    for (const CellChange& change : step.delta.cells) {
      text += fmt::format("[{},{} {}]", change.at.x, change.at.y,
                          change.look ? name_of(change.look->role) : std::string_view("bare"));
      if (change.look && change.look->color) {
        const Rgba8 c = *change.look->color;
        text += fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
      }
    }
    if (step.delta.plane) text += *step.delta.plane ? "plane" : "cells";
    for (const Mark& mark : step.delta.set) text += text_of_mark(mark) + "\n";
  }
  for (const Field& field : trace.result) text += field.name + "=" + text_of_value(field.value) + "\n";
  return text;
}

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

TEST(TraceHash, IsTheCommittedOneOnThisCompiler) {
  const std::string path = std::string(GRADUS_SOURCE_DIR) + "/tests/golden/trace_hashes.txt";
  std::string hashes;
  std::size_t count = 0;
  for (const Trace& trace : test::telling_traces({}, {}, false)) {
    hashes += fmt::format("{:016x} {} {}, {}\n", fnv1a(whole_text(trace)), trace.topic, trace.method,
                          trace.subtitle);
    ++count;
  }
  EXPECT_GT(count, 20u);
  if (std::getenv("GRADUS_UPDATE_GOLDEN")) std::ofstream(path, std::ios::binary) << hashes;
  std::ostringstream golden;
  golden << std::ifstream(path, std::ios::binary).rdbuf();
  EXPECT_EQ(hashes, golden.str());
}

TEST(TraceHash, SeesADifference) {
  Trace trace = test::trace_of("bresenham_line");
  const std::uint64_t before = fnv1a(whole_text(trace));
  trace.steps[3].sentence += ".";
  EXPECT_NE(fnv1a(whole_text(trace)), before);
}

}  // namespace
}  // namespace gradus
