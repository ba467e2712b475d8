// What the JSON says, read back by the library: run_json is for other people's programs, trace_json for the
// player.

#include "json/json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "figure/recording.hpp"

namespace gradus {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> names_of(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

/// Two steps and a finer event between them.
Trace small_trace(Recording recording = {}) {
  TraceWriter writer(recording);
  Trace& trace = writer.trace();
  trace.topic = "bresenham_line";
  trace.title = "Bresenham line";
  trace.method = "decision_parameter";
  trace.arguments = {{"method", "decision_parameter"}, {"from", "0,0"}, {"to", "2,1"}};
  trace.listing = {{42, "x += 1;"}, {44, "p += 2 * dy;"}};
  trace.columns = {{"x"}, {"step", false}};
  trace.legend = {{Role::past, "drawn before"}};
  trace.grid.cells = {{0, 0}, {3, 2}};
  trace.backdrop = {{"ideal", Role::boundary, Stroke{{0, 0}, {2, 1}}}};
  Delta start;
  for (int x = 0; x < 3; ++x) start.cells.push_back({{x, 1}, CellLook{Role::past, ""}});
  start.cells.push_back({{0, 2}, CellLook{Role::current, "7"}});
  start.cells.push_back({{1, 2}, std::nullopt});
  start.set = {{"here", Role::current, Dot{{0.5, 1}, true}}};
  writer.step(start, {0, 0}, 0, [](TraceStep& step) {
    step.type = "Started";
    step.phase = "set up";
    step.fields = {
        {"at", ivec2{0, 0}}, {"p", std::int64_t{-3}}, {"type", std::string("a field of that name")}};
    step.row = {"0", ""};
  });
  writer.fine({}, {1, 0}, 42, [](TraceStep& step) { step.type = "Summed"; });
  Delta end;
  end.removed = {"here"};
  writer.step(end, {1, 0}, 44, [](TraceStep& step) {
    step.type = "Stepped";
    step.fields = {{"east", true}, {"error", 0.25}, {"infinite", std::numeric_limits<double>::infinity()}};
    step.read = {"0", "E"};
    step.row = {"1", ""};
  });
  trace.pixels = {{0, 0}, {1, 0}, {2, 1}};
  trace.result = {{"count", std::int64_t{3}}};
  return std::move(writer).finish();
}

TEST(RunJson, SaysTheRunInOrder) {
  const Json json = Json::parse(run_json(small_trace()));
  EXPECT_EQ(names_of(json), (std::vector<std::string>{"topic", "method", "input", "steps", "result"}));
  EXPECT_EQ(json["topic"], "bresenham_line");
  EXPECT_EQ(json["method"], "decision_parameter");
  EXPECT_EQ(json["input"], (Json{{"from", "0,0"}, {"to", "2,1"}}));
  EXPECT_EQ(json["result"], Json::parse(R"({"pixels": [[0, 0], [1, 0], [2, 1]], "count": 3})"));
}

TEST(RunJson, StepsHaveNumberTypeLineThenFields) {
  const Json steps = Json::parse(run_json(small_trace()))["steps"];
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0], Json::parse(R"({"number": 0, "type": "Started", "line": null, "at": [0, 0], "p": -3,
                                      "type_": "a field of that name"})"));
  EXPECT_EQ(steps[1], Json::parse(R"({"number": 0, "fine": 1, "type": "Summed", "line": 42})"));
  EXPECT_EQ(steps[2], Json::parse(R"({"number": 1, "type": "Stepped", "line": 44, "east": true, "error": 0.25,
                                      "infinite": null})"));
  EXPECT_EQ(names_of(steps[0]), (std::vector<std::string>{"number", "type", "line", "at", "p", "type_"}));
}

TEST(RunJson, SaysWhatIsFaultyAndWhatWasNotRecorded) {
  Trace trace = small_trace();
  EXPECT_FALSE(Json::parse(run_json(trace)).contains("faulty"));
  EXPECT_FALSE(Json::parse(run_json(trace)).contains("recorded"));
  trace.faulty = "leaves the circle";
  trace.last = 5;
  const Json json = Json::parse(run_json(trace));
  EXPECT_EQ(json["faulty"], "leaves the circle");
  EXPECT_EQ(json["recorded"], (Json{{"from", 0}, {"to", 1}, {"of", 5}}));
}

TEST(RunJson, KeepsWholeNumbersWhole) {
  Trace trace = small_trace();
  trace.steps[0].fields = {{"p", std::numeric_limits<std::int64_t>::min()}};
  EXPECT_EQ(Json::parse(run_json(trace))["steps"][0]["p"].get<std::int64_t>(),
            std::numeric_limits<std::int64_t>::min());
}

TEST(TraceJson, HoldsWhatThePlayerNeeds) {
  const Json json = Json::parse(trace_json(small_trace()));
  EXPECT_EQ(json["schema"], trace_schema);
  EXPECT_EQ(json["arguments"][1], (Json{"from", "0,0"}));
  EXPECT_EQ(json["listing"], Json::parse(R"([[42, "x += 1;"], [44, "p += 2 * dy;"]])"));
  EXPECT_EQ(json["columns"], Json::parse(R"([{"id": "x", "name": "x", "numeric": true, "widest": "0"},
                                             {"id": "step", "name": "step", "numeric": false, "widest": "E"}])"));
  EXPECT_EQ(json["roles"].size(), all_roles.size());
  EXPECT_EQ(json["roles"][json["legend"][0][0].get<std::size_t>()], "past");
  EXPECT_EQ(json["grid"]["upper"], (Json{3, 2}));
  EXPECT_EQ(json["backdrop"], Json::parse(R"([["ideal", 1, "stroke", 0.0, 0.0, 2.0, 1.0]])"));
  EXPECT_EQ(json["last"], 1);
  EXPECT_FALSE(json.contains("before"));
}

TEST(TraceJson, TellsStepsAsDeltas) {
  const Json steps = Json::parse(trace_json(small_trace()))["steps"];
  EXPECT_EQ(steps[0]["number"], "0");
  EXPECT_EQ(steps[1]["number"], "0.1");
  EXPECT_EQ(steps[1]["level"], "arithmetic");
  EXPECT_EQ(steps[2]["number"], "1");
  // Neighbours in a row that look alike are one run; -1 is bare
  EXPECT_EQ(steps[0]["cells"], Json::parse(R"([[0, 1, 3, 2], [0, 2, 1, 3, "7"], [1, 2, 1, -1]])"));
  EXPECT_EQ(steps[0]["set"], Json::parse(R"([["here", 3, "ring", 0.5, 1.0]])"));
  EXPECT_EQ(steps[2]["removed"], Json{"here"});
  EXPECT_EQ(steps[2]["read"], (Json{"0", "E"}));
  EXPECT_FALSE(steps[1].contains("cells"));
  EXPECT_FALSE(steps[0].contains("line"));
}

TEST(TraceJson, HasNothingOfASlotThatWasDropped) {
  const std::vector<std::pair<Slot, std::vector<std::string>>> members{
      {Slot::title, {"title", "subtitle", "method_title"}},
      {Slot::drawing, {"roles", "legend", "grid", "backdrop", "cells", "set", "removed", "focus"}},
      {Slot::listing, {"listing", "source_file", "line"}},
      {Slot::table, {"columns", "result", "fields", "read", "row"}},
      {Slot::sentence, {"goal", "sentence"}},
      {Slot::footer, {"legend", "phase"}}};
  Trace trace = small_trace();
  for (TraceStep& step : trace.steps) step.sentence = "p < 0";
  const std::string whole = trace_json(trace);
  for (const auto& [slot, names] : members) {
    std::set<Slot> kept(all_slots.begin(), all_slots.end());
    kept.erase(slot);
    const std::string json = trace_json(trace, kept), alone = trace_json(trace, {slot});
    for (const std::string& name : names) {
      const std::string member = '"' + name + "\":";
      EXPECT_NE(whole.find(member), whole.npos) << name;
      EXPECT_EQ(json.find(member), json.npos) << name_of(slot) << ": " << name;
      EXPECT_EQ(alone.find(member) != alone.npos, name != "legend") << name_of(slot) << ": " << name;
    }
    EXPECT_EQ(Json::parse(json)["steps"][2].contains("type"), slot != Slot::listing);
    EXPECT_EQ(Json::parse(json)["slots"].size(), all_slots.size() - 1);
    EXPECT_EQ(Json::parse(json)["steps"].size(), trace.steps.size());
  }
  EXPECT_EQ(whole.find("\"slots\":"), whole.npos);
}

TEST(TraceJson, ALateRecordingTellsWhatWasDrawnBefore) {
  const Json json = Json::parse(trace_json(small_trace({1, 10})));
  EXPECT_EQ(json["steps"].size(), 1u);
  EXPECT_EQ(json["before"]["cells"], Json::parse(R"([[0, 1, 3, 2], [0, 2, 1, 3, "7"]])"));
  EXPECT_EQ(json["before"]["set"][0][0], "here");
}

TEST(TraceJson, ALateRecordingOnAHugeGridTellsWhatIsNear) {
  constexpr int far = INT32_MAX;
  TraceWriter writer({1, 10});
  writer.trace().grid.cells = {{INT32_MIN, INT32_MIN}, {far, far}};
  for (int i = 0; i < 2; ++i) {
    Delta delta;
    delta.cells = {{{far - i, INT32_MIN}, CellLook{Role::past, ""}}};
    writer.step(delta, {far, INT32_MIN}, 0, [](TraceStep&) {});
  }
  const Json json = Json::parse(trace_json(std::move(writer).finish()));
  EXPECT_EQ(json["before"]["cells"], (Json::array({Json{far, INT32_MIN, 1, 2}})));
}

TEST(TraceJson, PutsPicturesInAsPaletteOrAsTexels) {
  Trace trace = small_trace();
  Image two(2, 1, Rgba8{1, 2, 3, 255});
  two[{1, 0}] = {0, 0, 0, 0};
  trace.grid.picture = std::make_shared<const Image>(two);
  const Json few = Json::parse(trace_json(trace))["grid"]["picture"];
  EXPECT_EQ(few["palette"], Json::parse("[[1, 2, 3, 255], [0, 0, 0, 0]]"));
  EXPECT_EQ(few["indices"], "AAE=");

  Image colours(300, 1);
  for (int x = 0; x < 300; ++x) {
    colours[{x, 0}] = {static_cast<std::uint8_t>(x % 256), static_cast<std::uint8_t>(x / 256), 0, 255};
  }
  trace.grid.picture = std::make_shared<const Image>(colours);
  const Json many = Json::parse(trace_json(trace))["grid"]["picture"];
  EXPECT_FALSE(many.contains("palette"));
  EXPECT_EQ(many["rgba"].get<std::string>().size(), 1600u);
  EXPECT_EQ(many["rgba"].get<std::string>().substr(0, 8), "AAAA/wEA");
}

const std::string hostile =
    "</script><!-- <script> --> \xe2\x80\xa8\xe2\x80\xa9 \xff \x01 \" \\ ]]> p < 0 <= q";
const std::string harmless =
    "</script><!-- <script> --> \xe2\x80\xa8\xe2\x80\xa9 \xef\xbf\xbd \x01 \" \\ ]]> p < 0 <= q";

void expect_safe(const std::string& json) {
  for (const char* bad : {"</", "<!", "<s", "-->", "\xe2\x80\xa8", "\xe2\x80\xa9", "\xff", "\x01"}) {
    EXPECT_EQ(json.find(bad), json.npos) << bad;
  }
}

TEST(HostileText, IsSafeInAScriptElementAndComesBackAsItWas) {
  expect_safe(json_quoted(hostile));
  EXPECT_EQ(Json::parse(json_quoted(hostile)), harmless);
  EXPECT_NE(json_quoted("p < 0").find("p < 0"), std::string::npos) << "what is harmless stays legible";

  Trace trace = small_trace();
  trace.title = trace.faulty = trace.topic = trace.goal = hostile;
  trace.listing[0].text = trace.columns[0].name = trace.grid.x_name = hostile;
  trace.steps[0].fields = {{hostile, hostile}};
  trace.steps[0].sentence = trace.steps[0].row[0] = hostile;
  trace.steps[0].delta.set[0].id = hostile;
  trace.result = {{hostile, hostile}};
  expect_safe(trace_json(trace));
  expect_safe(run_json(trace));
  EXPECT_EQ(Json::parse(trace_json(trace))["steps"][0]["sentence"], harmless);
  EXPECT_EQ(Json::parse(run_json(trace))["steps"][0][harmless], harmless);
}

TEST(HostileText, MarksThatTurnTheDirectionAreEscaped) {
  EXPECT_EQ(json_quoted("a\u202e\u061c\u2066\u0085\x7f\u2028ö"),
            "\"a\\u202e\\u061c\\u2066\\u0085\\u007f\\u2028ö\"");
}

TEST(ListJson, TellsATopicByItsParameters) {
  TopicEntry topic{};
  topic.name = "bresenham_line";
  topic.title = "Bresenham line";
  topic.chapter = "scan_conversion";
  topic.aliases = {"line"};
  topic.methods = {{"dda", "DDA", Standing::faulty, "drifts"}};
  Parameter from{};
  from.name = "from";
  from.type = ParameterType::cell;
  from.default_value = "0,0";
  topic.parameters = {from};
  const std::array<const TopicEntry*, 1> topics{&topic};
  const Json json = Json::parse(list_json(topics));
  EXPECT_EQ(json["topics"].size(), 1u);
  const Json& told = json["topics"][0];
  EXPECT_EQ(told["name"], "bresenham_line");
  EXPECT_EQ(told["aliases"], Json{"line"});
  EXPECT_EQ(told["methods"][0]["standing"], "faulty");
  EXPECT_EQ(told["parameters"][0]["type"], "cell");
  EXPECT_EQ(told["parameters"][0]["least"], INT32_MIN);
}

TEST(ManifestJson, ComesBack) {
  Manifest manifest;
  manifest.owner = "my lecture.json fnv1a:0";
  manifest.jobs["line"] = {"key \xff 1", {{"a b/line.svg", 12, -5}, {"line.pdf", UINT64_MAX, INT64_MAX}}};
  manifest.jobs["empty"] = {"", {}};
  const Manifest back = parse_manifest(manifest_json(manifest));
  EXPECT_EQ(back.owner, manifest.owner);
  ASSERT_EQ(back.jobs.size(), 2u);
  const auto& [key, files] = back.jobs.at("line");
  EXPECT_EQ(key, "key \xef\xbf\xbd 1");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].path, "a b/line.svg");
  EXPECT_EQ(files[0].size, 12u);
  EXPECT_EQ(files[0].modified, -5);
  EXPECT_EQ(files[1].size, UINT64_MAX);
  EXPECT_EQ(files[1].modified, INT64_MAX);
}

TEST(ManifestJson, WhatCannotBeReadIsMadeAnew) {
  for (const char* text :
       {"", "{", "[]", "null", "7", R"({"jobs": 3})", R"({"jobs": {"a": 1}})", "\xff\xfe",
        R"({"jobs": {"a": {"key": "k"}}})", R"({"jobs": {"a": {"key": 1, "files": []}}})",
        R"({"jobs": {"a": {"key": "k", "files": [{"path": "p", "size": -1, "modified": 0}]}}})",
        R"({"jobs": {"a": {"key": "k", "files": [{"path": "p", "size": 1.5, "modified": 0}]}}})"}) {
    EXPECT_TRUE(parse_manifest(text).jobs.empty()) << text;
  }
  const std::string half = R"({"jobs": {"bad": [], "good": {"key": "k", "files": []}}})";
  EXPECT_EQ(parse_manifest(half).jobs.size(), 1u);
}

}  // namespace
}  // namespace gradus
