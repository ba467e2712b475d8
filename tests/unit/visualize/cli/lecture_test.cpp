// Lectures: JSON that knows its lines, and what a lecture's keys become. The command that draws them is
// tested by tests/golden/lecture_test.py.

#include "cli/lecture/lecture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "cli/command_line/errors.hpp"
#include "core/image.hpp"
#include "request/names.hpp"
#include "request/written_json.hpp"
#include "support/seed.hpp"

namespace gradus::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = JsonNode::Kind;

// --- JSON with places --------------------------------------------------------------------------------------

std::string complaint(const std::string& text) {
  try {
    read_json(text, "a.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "(no complaint)";
}

TEST(LocatedJson, KnowsTheLineOfEveryKeyAndValue) {
  const JsonNode root = read_json("\n{ \"a\":\n  1,\r\n\"b\" : [true,\n\n null, \"x\"\n] }\n", "a.json");
  EXPECT_EQ(root.line, 2);
  ASSERT_EQ(root.members.size(), 2u);
  EXPECT_EQ(root.member("a")->line, 2);
  EXPECT_EQ(root.member("a")->value.line, 3) << "a number is read to the character after it";
  EXPECT_EQ(root.member("b")->line, 4);
  const std::vector<JsonNode>& list = root.member("b")->value.elements;
  ASSERT_EQ(list.size(), 3u);
  EXPECT_THAT((std::vector{list[0].line, list[1].line, list[2].line}), ElementsAre(4, 6, 6));
  EXPECT_EQ(root.member("c"), nullptr);
}

TEST(LocatedJson, KeepsNumbersAsTheyWereWritten) {
  const JsonNode root = read_json("[4.10, -0, 12345678901234567890123, 1e3]", "a.json");
  std::vector<std::string> texts;
  for (const JsonNode& element : root.elements) texts.push_back(element.text);
  EXPECT_THAT(texts, ElementsAre("4.10", "-0", "12345678901234567890123", "1e3"));
}

TEST(LocatedJson, SaysWhereWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"",
       "a.json:1: expected a value (a text in double quotes, a number, true, false, a list or an object), "
       "found the end of the file"},
      {"{\n\"a\": 1\n\"b\": 2}", "a.json:3: expected ',' or '}' after the value of 'a', found '\"b\"'"},
      {"{\"a\": 1,\n}", "a.json:2: expected another key in double quotes after the comma, found '}'"},
      {"[1,\n]", "a.json:2: expected another value after the comma, found ']'"},
      {"[1 2]", "a.json:1: expected ',' or ']' after a value of a list, found '2'"},
      {"{'a': 1}", "a.json:1: expected a key in double quotes or '}', found ''' (JSON takes double quotes)"},
      {"{a: 1}", "a.json:1: expected a key in double quotes or '}', found 'a'"},
      {"{\"a\" 1}", "a.json:1: expected ':' after the key 'a', found '1'"},
      {"\n// hello\n{}",
       "a.json:2: expected a value (a text in double quotes, a number, true, false, a list or an "
       "object), found '/' (JSON has no comments)"},
      {"{\"a\": 1,\n\n\"a\": 2}",
       "a.json:3: expected the key 'a' once (it stands in line 1 too), found it again"},
      {"[\"x\ny\"]", "a.json:1: expected '\"' at the end of a text, found the end of the line"},
      {"[\"x", "a.json:1: expected '\"' at the end of a text, found the end of the file"},
      {"[\"\t\"]", "a.json:1: expected \\t or another escape in a text, found the control character U+0009"},
      {"\n[\"\xe9\"]", "a.json:2: expected a text in UTF-8, found the byte 0xe9"},
      {"[\"\\q\"]",
       "a.json:1: expected one of \" \\ / b f n r t u after a backslash (write \\\\ for itself), found 'q'"},
      {"[\"\\ud800\"]", "a.json:1: expected both halves of a surrogate pair, found \\ud800 alone"},
      {"[\"\\u12g4\"]", "a.json:1: expected four hexadecimal digits after \\u, found 'g4'"},
      {"[01]", "a.json:1: expected a number without leading zeros, found '01'"},
      {"[1.]", "a.json:1: expected a digit, found ']'"},
      {"{} {}", "a.json:1: expected the end of the file, found '{'"},
      {"nul",
       "a.json:1: expected a value (a text in double quotes, a number, true, false, a list or an object), "
       "found 'nul'"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(complaint(text), expected) << text;
  EXPECT_EQ(complaint(std::string(64, '[') + std::string(64, ']')), "(no complaint)");
  EXPECT_EQ(complaint(std::string(65, '[') + std::string(65, ']')),
            "a.json:1: expected at most 64 levels, found one more");
  EXPECT_EQ(complaint(std::string(1'000'000, '[')), "a.json:1: expected at most 64 levels, found one more");
}

TEST(LocatedJson, ReadsEscapesAndSkipsAByteOrderMark) {
  EXPECT_EQ(read_json("\xef\xbb\xbf\"\\u00e4\\ud83d\\ude00\\n\\/\"", "a.json").text, "ä\xf0\x9f\x98\x80\n/");
}

/// A random value as text with random line breaks; the lines of all values are noted as they are written.
class Writer {
 public:
  explicit Writer(std::mt19937_64& random) : random_(random) {}
  void value(int depth) {
    lines.push_back(1 + static_cast<int>(std::ranges::count(text, '\n')));
    switch (random_() % (depth < 5 ? 7 : 5)) {
      case 0:
        text += random_() % 2 ? "true" : "null";
        break;
      case 1:
        text += std::to_string(static_cast<std::int32_t>(random_()));
        break;
      case 2:
        text += "0.25e1";
        break;
      case 3:
      case 4:
        text += random_() % 2 ? "\"a\\n\\\"ö\"" : "\"\"";
        break;
      case 5:
        parts('[', ']', [&](std::uint64_t) { value(depth + 1); });
        break;
      default:
        parts('{', '}', [&](std::uint64_t i) {
          text += "\"k" + std::to_string(i) + "\"";
          space();
          text += ':';
          space();
          value(depth + 1);
        });
    }
  }
  std::string text;
  std::vector<int> lines;

 private:
  template <class Part>
  void parts(char open, char close, Part part) {
    text += open;
    space();
    const std::uint64_t count = random_() % 4;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (i > 0) text += ',', space();
      part(i);
      space();
    }
    text += close;
  }
  void space() {
    constexpr const char* spaces[] = {"", " ", "\n", "\r\n", "\t\n\n "};
    text += spaces[random_() % 5];
  }
  std::mt19937_64& random_;
};

void lines_of(const JsonNode& node, std::vector<int>& lines) {
  lines.push_back(node.line);
  for (const JsonNode& element : node.elements) lines_of(element, lines);
  for (const JsonMember& member : node.members) lines_of(member.value, lines);
}

TEST(LocatedJson, AgreesWithTheLibraryOnRandomTexts) {
  const std::uint64_t start = test::seed();
  SCOPED_TRACE("GRADUS_SEED=" + std::to_string(start));
  std::mt19937_64 random(start);
  using Json = nlohmann::ordered_json;
  std::size_t accepted = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    Writer writer(random);
    writer.value(0);
    const JsonNode node = read_json(writer.text, "a.json");
    std::vector<int> lines;
    lines_of(node, lines);
    ASSERT_EQ(lines, writer.lines) << writer.text;
    ASSERT_EQ(Json::parse(write_json(node)), Json::parse(writer.text)) << writer.text;

    // One byte changed, lost or doubled
    std::string text = writer.text;
    const std::size_t at = random() % text.size();
    constexpr std::string_view bytes = "{}[]\",:\\ud8 019.-eE\n\t/'#tfn\xc3\xa4\xff";
    if (random() % 3 == 0) {
      text.erase(at, 1);
    } else {
      text.replace(at, random() % 2, 1, bytes[random() % bytes.size()]);
    }
    const std::string found = complaint(text);
    if (found.find(" once (") != std::string::npos) continue;  // the library takes a key twice
    try {
      const Json expected = Json::parse(text);
      ASSERT_EQ(found, "(no complaint)") << text;
      ASSERT_EQ(Json::parse(write_json(read_json(text, ""))), expected) << text;
      ++accepted;
    } catch (const Json::parse_error&) {
      ASSERT_NE(found, "(no complaint)") << text;
      ++refused;
    } catch (const Json::out_of_range&) {
      // 1e400 is a number, but none that the library can hold
    }
  }
  EXPECT_GT(accepted, 200u);
  EXPECT_GT(refused, 200u);
}

// --- Lectures ----------------------------------------------------------------------------------------------

Lecture lecture_of(const std::string& text) { return read_lecture({"a.json", text, "", as_named}); }

/// The problems without the file's name.
std::vector<std::string> problems_of(const std::string& text) {
  std::vector<std::string> texts;
  for (const Problem& problem : lecture_of(text).problems) {
    EXPECT_EQ(problem.text.substr(0, 7), "a.json:");
    texts.push_back(problem.text.substr(7));
  }
  return texts;
}

std::string in_figure(const std::string& members) {
  return "{\"figures\": [{\"topic\": \"bresenham_line\", \"input\": {}" + members + "}]}";
}

TEST(Lecture, BecomesWhatTheCommandLineWouldSay) {
  const Lecture lecture = lecture_of(R"({
    "title": "Lines", "theme": "dark", "steps": [1, "3-4"], "slots": "drawing",
    "figures": [
      {"topic": "bresenham_line", "input": {"from": [-1, 0], "to": "9,4"}},
      {"topic": "bresenham_line", "input": {"to": "(5, 2) "}, "theme": "light", "step": 4.10, "method": "dda",
       "outputs": ["png", "pdf", "png"], "caption": "It drifts."},
      {"topic": "flood_fill", "input": {"maze": ["####", "#..#", "####"], "at": [1, 1], "connectivity": 8}}
    ]})");
  ASSERT_THAT(lecture.problems, IsEmpty());
  ASSERT_EQ(lecture.figures.size(), 3u);
  EXPECT_EQ(lecture.title, "Lines");
  const LectureFigure &first = lecture.figures[0], &second = lecture.figures[1], &third = lecture.figures[2];
  EXPECT_EQ(command_of(first.spec),
            "gradus figure bresenham_line --from -1,0 --to 9,4 --steps 1,3-4 --slots drawing --theme dark");
  EXPECT_EQ(command_of(second.spec),
            "gradus figure bresenham_line --method dda --from 0,0 --to 5,2 --step 4.10 --slots drawing "
            "--caption 'It drifts.'");
  EXPECT_THAT(command_of(third.spec),
              HasSubstr("--maze '####/#..#/####' --at 1,1 --tolerance 0 --connectivity 8"));
  EXPECT_THAT(first.outputs,
              ElementsAre(Format::svg, Format::png, Format::pdf, Format::html, Format::csv, Format::json));
  EXPECT_THAT(second.outputs, ElementsAre(Format::png, Format::pdf));
  EXPECT_EQ(second.caption, "It drifts.");
  EXPECT_EQ(first.name, "bresenham_line");
  EXPECT_EQ(second.name, "bresenham_line_2");
  EXPECT_EQ(third.name, "flood_fill");
}

TEST(Lecture, GivesNamesThatNobodyElseHas) {
  const Lecture lecture = lecture_of(R"({"figures": [
    {"topic": "bresenham_line", "input": {}},
    {"topic": "bresenham_line", "input": {}, "name": "Bresenham_Line"},
    {"topic": "bresenham_line", "input": {}, "name": "bresenham_line_3"},
    {"topic": "bresenham_line", "input": {}}]})");
  ASSERT_THAT(lecture.problems, IsEmpty());
  std::vector<std::string> names;
  for (const LectureFigure& figure : lecture.figures) names.push_back(figure.name);
  EXPECT_THAT(names,
              ElementsAre("bresenham_line_2", "Bresenham_Line", "bresenham_line_3", "bresenham_line_4"));
}

TEST(Lecture, RefusesNamesThatAreNoFileNames) {
  for (const char* name : {"../x", "/etc/x", "<script>", "", ".hidden", "-x", "a b", "index.html", "ö",
                           "a\\u0000b", "a\\nb", "x/y"}) {
    const auto problems = problems_of(in_figure(std::string(", \"name\": \"") + name + "\""));
    ASSERT_EQ(problems.size(), 1u) << name;
    EXPECT_THAT(problems[0], HasSubstr("1: figures[0].name: expected a name of at most 80 letters")) << name;
    EXPECT_EQ(std::ranges::count_if(problems[0], [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
              0);
  }
  EXPECT_THAT(
      problems_of(in_figure(", \"name\": \"Topics\"")),
      ElementsAre("1: figures[0].name: expected another name, for the pages of the topics have this one, "
                  "found 'Topics'"));
  EXPECT_THAT(problems_of(in_figure(", \"name\": \"" + std::string(80, 'x') + "\"")), IsEmpty());
  EXPECT_EQ(problems_of(in_figure(", \"name\": \"" + std::string(81, 'x') + "\"")).size(), 1u);
}

TEST(Lecture, SaysWhatTheRightKeyWouldBe) {
  EXPECT_THAT(
      problems_of(in_figure(",\n\"methd\": \"dda\"")),
      ElementsAre("2: figures[0].methd: expected a known key, found 'methd', did you mean 'method'?"));
  EXPECT_THAT(
      problems_of(in_figure(", \"from\": \"0,0\"")),
      ElementsAre("1: figures[0].from: expected a known key, found 'from' (it belongs into \"input\")"));
  EXPECT_THAT(
      problems_of("{\"figures\": [], \"topic\": \"flood_fill\"}"),
      ElementsAre(
          "1: topic: expected a known key, found 'topic' (it belongs into a figure, beside \"topic\")",
          "1: figures: expected a list of at least one figure, found an empty list"));
  EXPECT_THAT(problems_of("{\"figures\": [{\"topic\": \"flood_fill\", \"input\": {\"theme\": \"dark\"}}]}"),
              ElementsAre("1: figures[0].input.theme: expected a known key, found 'theme' (it belongs beside "
                          "\"input\", not into it)"));
  const auto none = problems_of(in_figure(", \"zzzzzz\\u001b\": 1"));
  ASSERT_EQ(none.size(), 1u);
  EXPECT_THAT(none[0], HasSubstr("expected one of topic, input, method, name, caption, outputs, "));
  EXPECT_EQ(none[0].find('\x1b'), std::string::npos) << "nothing that moves a terminal's cursor";
}

TEST(Lecture, FindsAllProblemsInOneGo) {
  EXPECT_THAT(
      problems_of(R"({
    "theme": "drak",
    "figures": [
      {"topic": "bresenham_line",
       "input": {"from": [0, 0, 3],
                 "to": "9.5,4"},
       "method": "breadth_first", "size": "12"},
      {"topic": "bresenham_line", "input": {}},
      {"topic": "Bresenham", "input": 4}, {}, 7
    ]})"),
      ElementsAre(
          "2: theme: expected one of light, dark, greyscale, high_contrast, print, found 'drak', did you "
          "mean "
          "'dark'?",
          "5: figures[0].input.from: expected two whole numbers from -2147483648 to 2147483647 like 3,4, "
          "found '0,0,3'",
          "6: figures[0].input.to: expected two whole numbers from -2147483648 to 2147483647 like 3,4, "
          "found '9.5,4'",
          "7: figures[0].method: expected one of decision_parameter, run_length, dda, first_octant, "
          "swapped_ends, misprinted_derivation, found 'breadth_first'",
          HasSubstr("7: figures[0].size: expected a width and a height"),
          HasSubstr("9: figures[2].topic: expected one of "),
          "9: figures[2].input: expected an object of the topic's inputs like {\"from\": \"0,0\"}, found 4",
          "9: figures[3]: expected the key \"topic\", found none",
          "9: figures[3]: expected the key \"input\" ({} for the topic's defaults), found none",
          "9: figures[4]: expected an object with the keys \"topic\" and \"input\", found 7"));
}

TEST(Lecture, ChecksTheKindOfEveryValue) {
  const auto problem = [](const std::string& members) {
    const auto problems = problems_of(in_figure(members));
    return problems.size() == 1 ? problems[0] : "(not one problem)";
  };
  EXPECT_EQ(problem(", \"theme\": 4"), "1: figures[0].theme: expected a text, found 4");
  EXPECT_EQ(problem(", \"step\": true"), "1: figures[0].step: expected a number, found true");
  EXPECT_EQ(problem(", \"steps\": {}"),
            "1: figures[0].steps: expected a list of numbers and texts, or one text, found an object");
  EXPECT_EQ(problem(", \"steps\": [1, null]"),
            "1: figures[0].steps: expected a list of numbers and texts, or one text, found null");
  EXPECT_EQ(problem(", \"caption\": \"a\\nb\""),
            "1: figures[0].caption: expected a text on one line, found 'a\\nb'");
  EXPECT_EQ(problem(", \"step\": 1, \"steps\": \"2\""),
            "1: figures[0].step: expected either this or steps, found both");
  EXPECT_THAT(problem(", \"outputs\": []"), HasSubstr("expected a list of svg, png, "));
  EXPECT_THAT(problem(", \"outputs\": [\"pgn\"]"), HasSubstr("found 'pgn', did you mean 'png'?"));
  EXPECT_EQ(problems_of("[]"),
            std::vector<std::string>{"1: expected an object with the key \"figures\", found an empty list"});
  EXPECT_EQ(problems_of("{}"),
            std::vector<std::string>{"1: expected the key \"figures\" or \"renders\", found none"});
  EXPECT_THAT(problems_of("{\"figures\": [{\"topic\": \"flood_fill\", \"input\": {\"image\": \"-\"}}]}"),
              ElementsAre("1: figures[0].input.image: expected a file's name, found '-'"))
      << "nothing is read from standard input";
  EXPECT_THAT(
      problems_of("{\"figures\": [{\"topic\": \"flood_fill\", \"input\": {\"maze\": [\"no maze\"]}}]}"),
      ElementsAre("1: figures[0].input.maze: expected rows of '#', '.' and letters, found 'no maze'"));
}

TEST(Lecture, KeysAreTheFlagsOfAFigureAndAFewOfItsOwn) {
  const auto command = std::ranges::find(commands(), "figure", &Command::name);
  std::size_t flags = 0;
  for (const Flag& flag : command->flags) {
    if (std::set<std::string>{"output", "format", "force", "snippet"}.contains(flag.name)) continue;
    std::string name = flag.name == "label" ? "labels" : flag.name;
    std::ranges::replace(name, '-', '_');
    const auto key = std::ranges::find(lecture_keys(), name, &LectureKey::name);
    ASSERT_NE(key, lecture_keys().end()) << name;
    EXPECT_TRUE(key->of_figure) << name;
    EXPECT_FALSE(key->help.empty()) << name;
    ++flags;
  }
  EXPECT_GE(flags, 5u);
  for (const char* own : {"topic", "input", "method", "name", "caption", "outputs"}) {
    EXPECT_TRUE(std::ranges::find(lecture_keys(), own, &LectureKey::name)->of_figure) << own;
  }
  std::set<std::string> names;
  for (const LectureKey& key : lecture_keys())
    EXPECT_TRUE(names.insert(key.name).second) << key.name << " twice";
}

// --- Renders -----------------------------------------------------------------------------------------------

const std::string models = std::string(GRADUS_SOURCE_DIR) + "/examples/models/";

std::string render_of(const std::string& members) {
  return "{\"renders\": [{\"model\": \"" + models + "spot.obj\"" + members + "}]}";
}

TEST(LectureRenders, BecomeWhatTheCommandLineWouldSay) {
  const Lecture lecture = lecture_of(render_of(
      R"json(, "eye": [-3, "1.50", 0], "light": "(-2, 2, -2)", "fov": 2e1, "size": "64X48", "background": "WHITE",
         "title": "T", "caption": "C")json"));
  ASSERT_THAT(lecture.problems, IsEmpty());
  ASSERT_EQ(lecture.renders.size(), 1u);
  EXPECT_THAT(lecture.figures, IsEmpty());
  const LectureRender& render = lecture.renders[0];
  EXPECT_EQ(render.brief.colophon.command,
            "gradus render spot.obj --size 64x48 --eye -3,1.5,0 --fov 20 --light -2,2,-2");
  EXPECT_EQ(render.name, "spot");
  EXPECT_EQ(render.title, "T");
  EXPECT_EQ(render.caption, "C");
  EXPECT_THAT(render.copies,
              ElementsAre(models + "spot.obj", models + "spot.mtl", models + "spot_texture.png"));
  const std::vector<AnyPart> parts = lecture.parts();
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(&part_of(parts[0]), &render);
}

TEST(LectureRenders, KnowTheLibrariesOfTheirModels) {
  const Lecture lecture = lecture_of("{\"renders\": [{\"model\": \"" + models + "letter_f.obj\"}]}");
  ASSERT_EQ(lecture.renders.size(), 1u);
  EXPECT_THAT(lecture.renders[0].copies, ElementsAre(models + "letter_f.obj", models + "letter_f.mtl"));
}

TEST(LectureRenders, AreOthersWhenAnythingIsOther) {
  const auto contents = [](const std::string& members) {
    const Lecture lecture = lecture_of(render_of(members));
    return lecture.renders.empty() ? "(none)" : lecture.renders[0].contents();
  };
  const std::vector<std::string> all{"",
                                     R"(, "name": "b")",
                                     R"(, "title": "b")",
                                     R"(, "caption": "b")",
                                     R"(, "size": "8x8")",
                                     R"(, "eye": [1, 2, 3])",
                                     R"(, "target": [1, 2, 3])",
                                     R"(, "up": [1, 2, 3])",
                                     R"(, "fov": 4)",
                                     R"(, "light": [1, 2, 3])",
                                     R"(, "background": "none")"};
  std::set<std::string> different;
  for (const std::string& members : all) different.insert(contents(members));
  EXPECT_EQ(different.size(), all.size());
  EXPECT_EQ(contents(R"(, "size": "800x600", "fov": 40, "background": "white")"), contents(""))
      << "defaults that are said";
}

TEST(LectureRenders, KeysAreTheFlagsOfTheCommandAndAFewOfTheirOwn) {
  const auto command = std::ranges::find(commands(), "render", &Command::name);
  std::set<std::string> expected{"model", "name", "title", "caption"}, found;
  for (const Flag& flag : command->flags) expected.insert(folded(flag.name));
  // Where to, by whom, what is told instead of drawn or beside it, and frames: a lecture shows the first
  for (const char* other : {"output", "force", "engine", "report", "part", "without", "why", "frames",
                            "array", "turntable", "jobs"})
    expected.erase(other);
  for (const LectureKey& key : render_keys()) {
    EXPECT_TRUE(found.insert(key.name).second) << key.name << " twice";
    EXPECT_FALSE(key.help.empty()) << key.name;
  }
  EXPECT_EQ(found, expected);
}

TEST(LectureRenders, SayAllThatIsWrongWithThem) {
  EXPECT_THAT(problems_of(render_of(R"(, "eye": [1, 2],
    "fov": "wide", "modle": 1,
    "up": {}, "name": "a b")")),
              ElementsAre("1: renders[0].eye: expected three numbers like 3,2,4, none larger than 1e30, "
                          "found '1,2'",
                          "2: renders[0].modle: expected a known key, found 'modle', did you mean 'model'?",
                          "2: renders[0].fov: expected the vertical angle of view, 0.001 to 179.999 degrees, "
                          "found 'wide'",
                          HasSubstr("3: renders[0].name: expected a name of at most 80 letters"),
                          "3: renders[0].up: expected three numbers like [3, 2, 4], or one text, found an "
                          "object"));
  EXPECT_THAT(problems_of(R"({"renders": [{"model": "no/where.obj"}, {}, {"model": "-"}]})"),
              ElementsAre("1: renders[0].model: expected a readable file, found 'no/where.obj' (No such file "
                          "or directory)",
                          "1: renders[1]: expected the key \"model\", found none",
                          "1: renders[2].model: expected a file's name, found '-'"));
  EXPECT_THAT(problems_of(render_of(R"(, "eye": [0, 0, 9], "target": [0, 0, 9])")),
              ElementsAre("1: renders[0].target: expected another point than the eye 0,0,9, found 0,0,9"));
  EXPECT_THAT(problems_of(render_of(R"(, "eye": [0, 0, 9], "target": [0, 0, 0], "up": [0, 0, 1])")),
              ElementsAre(HasSubstr("1: renders[0].up: expected a direction that is not along the view")));
}

TEST(Lecture, TheBuiltInGalleryHasNoProblems) {
  const Lecture gallery = read_lecture(gallery_lecture());
  EXPECT_THAT(gallery.problems, IsEmpty());
  EXPECT_GE(gallery.figures.size(), 11u);
  std::set<const TopicEntry*> shown;
  for (const LectureFigure& figure : gallery.figures) {
    shown.insert(figure.spec.topic);
    EXPECT_FALSE(figure.caption.empty()) << figure.name;
  }
  EXPECT_EQ(shown.size(), catalogue().size()) << "every topic has a figure in the gallery";
  std::set<std::string> rendered;
  for (const LectureRender& render : gallery.renders) {
    rendered.insert(render.files.front());
    EXPECT_FALSE(render.caption.empty()) << render.name;
    EXPECT_FALSE(render.title.empty()) << render.name;
  }
  EXPECT_EQ(rendered.size(), 7u) << "two models and five scenes, each rendered once";
}

}  // namespace
}  // namespace gradus::cli
