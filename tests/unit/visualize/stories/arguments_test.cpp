#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stories/point_text.hpp"
#include "stories/topic.hpp"

namespace gradus {
namespace {

Parameter parameter(ParameterType type) { return {"value", type, "", "", ""}; }

std::string complaint(const Parameter& parameter, std::string_view text) {
  try {
    return "(taken as " + canonical(parameter, text) + ")";
  } catch (const ArgumentError& error) {
    return error.parameter + ": " + error.what();
  }
}

// --- canonical -----------------------------------------------------------------------------------

TEST(Canonical, Cell) {
  const Parameter cell = parameter(ParameterType::cell);
  for (const char* text : {"3,4", "(3, 4)", " 3 , 4 ", "+3,4", "(3,4)", "03,004", "\t3,4\n"}) {
    EXPECT_EQ(canonical(cell, text), "3,4") << text;
  }
  EXPECT_EQ(canonical(cell, "-5,8"), "-5,8");
  EXPECT_EQ(canonical(cell, "-0,0"), "0,0");
  EXPECT_EQ(canonical(cell, "-2147483648,2147483647"), "-2147483648,2147483647");
}

TEST(Canonical, CellSaysWhatItExpects) {
  const Parameter cell = parameter(ParameterType::cell);
  const std::string expected =
      "value: expected two whole numbers from -2147483648 to 2147483647 like 3,4, found ";
  EXPECT_EQ(complaint(cell, "1/3,2"), expected + "'1/3,2'");
  for (const char* text : {"",
                           "3",
                           "3,",
                           ",4",
                           "3,4,5",
                           "(3,4",
                           "3,4)",
                           "(",
                           ")",
                           "()",
                           "(,)",
                           "3;4",
                           "3 4",
                           "3.0,4",
                           "1e3,4",
                           "0x3,4",
                           "3,2147483648",
                           "-2147483649,4",
                           "99999999999999999999,1",
                           "a,b",
                           "--3,4",
                           "+-3,4",
                           "3,4 5,6",
                           "+,1",
                           "((3,4))"}) {
    EXPECT_EQ(complaint(cell, text), expected + "'" + text + "'");
  }
  Parameter small = cell;
  small.least = 0, small.most = 9;
  EXPECT_EQ(complaint(small, "3,10"), "value: expected two whole numbers from 0 to 9 like 3,4, found '3,10'");
}

TEST(Canonical, Integer) {
  Parameter integer = parameter(ParameterType::integer);
  integer.least = 0, integer.most = 255;
  EXPECT_EQ(canonical(integer, " 007 "), "7");
  EXPECT_EQ(canonical(integer, "255"), "255");
  for (const char* text : {"", "-1", "256", "1.0", "x", "1 2"}) {
    EXPECT_EQ(complaint(integer, text),
              std::string("value: expected a whole number from 0 to 255, found '") + text + "'");
  }
}

TEST(Canonical, Choice) {
  Parameter choice = parameter(ParameterType::choice);
  choice.choices = {"4", "8", "depth_first"};
  EXPECT_EQ(canonical(choice, "8"), "8");
  EXPECT_EQ(canonical(choice, "Depth-First"), "depth_first");
  EXPECT_EQ(complaint(choice, "6"), "value: expected one of 4, 8, depth_first, found '6'");
}

TEST(Canonical, Color) {
  const Parameter color = parameter(ParameterType::color);
  EXPECT_EQ(canonical(color, "#0072B2"), "#0072b2");
  EXPECT_EQ(canonical(color, "#1aF"), "#11aaff");
  EXPECT_EQ(canonical(color, "Teal"), "#008080");
  EXPECT_EQ(canonical(color, "grey"), "#808080");
  EXPECT_EQ(
      complaint(color, "#12345g"),
      "value: expected a colour #rrggbb or one of black, silver, gray, white, maroon, red, purple, fuchsia, "
      "green, lime, olive, yellow, navy, blue, teal, aqua, found '#12345g'");
  for (const char* text : {"", "#", "#12", "#1234", "0072b2", "never", "# 12345"}) {
    EXPECT_NE(complaint(color, text).find("expected a colour"), std::string::npos) << text;
  }
}

TEST(Canonical, FilesGoByTheirNames) {
  EXPECT_EQ(canonical(parameter(ParameterType::picture), "some/folder/horse.png"), "horse.png");
  EXPECT_EQ(canonical(parameter(ParameterType::picture), "-"), "-");
  EXPECT_EQ(complaint(parameter(ParameterType::picture), "folder/"),
            "value: expected a PNG or JPEG file, found 'folder/'");
  EXPECT_EQ(canonical(parameter(ParameterType::maze), "some/folder/room.txt"), "room.txt");
  EXPECT_EQ(canonical(parameter(ParameterType::maze), "room.txt"), "room.txt");
  EXPECT_EQ(canonical(parameter(ParameterType::maze), "mazes/room"), "room");
  // Found by tests/fuzz: `gradus again` looked for another file, or took the name for rows
  for (const char* name : {" room.txt", "@#.#"}) {
    EXPECT_EQ(canonical(parameter(ParameterType::maze), name), name);
  }
  EXPECT_EQ(canonical(parameter(ParameterType::maze), "9/ room.txt"), " room.txt");
  EXPECT_EQ(canonical(parameter(ParameterType::maze), "9/#.#"), "@#.#");
}

TEST(Canonical, MazeRows) {
  const Parameter maze = parameter(ParameterType::maze);
  for (const char* rows : {"#.#/...", "..../.##.", "...", "#", "#a#/b.c", "#./#.#"})
    EXPECT_EQ(canonical(maze, rows), rows);
  EXPECT_EQ(canonical(maze, "##\n..\n"), "##/..");
  EXPECT_EQ(complaint(maze, ""), "value: expected a text file or rows like '#.#/...', found ''");
}

// --- Arguments -----------------------------------------------------------------------------------

/// What the user wrote for a parameter of this type.
Arguments::Entry written(std::string name, Parameter parameter, std::string_view text) {
  parameter.name = std::move(name);
  return read_argument(parameter, text);
}

TEST(Arguments, AreReadByType) {
  Arguments arguments;
  arguments.set({.name = "method", .text = "dda"});
  arguments.set(written("from", parameter(ParameterType::cell), "-2147483648,7"));
  arguments.set(written("tolerance", parameter(ParameterType::integer), "12"));
  arguments.set(written("color", parameter(ParameterType::color), "#0072b2"));
  EXPECT_EQ(arguments.cell("from"), ivec2(INT32_MIN, 7));
  EXPECT_EQ(arguments.integer("tolerance"), 12);
  EXPECT_EQ(arguments.color("color"), (Rgba8{0x00, 0x72, 0xb2, 255}));
  EXPECT_EQ(arguments.text("method"), "dda");
  EXPECT_TRUE(arguments.has("from"));
  EXPECT_FALSE(arguments.has("to"));
  EXPECT_EQ(arguments.entries().front().name, "method");
}

TEST(Arguments, SettingAgainReplacesInPlace) {
  Arguments arguments;
  arguments.set({.name = "a", .text = "1"});
  arguments.set({.name = "b", .text = "2"});
  arguments.set({.name = "a", .text = "3"});
  ASSERT_EQ(arguments.entries().size(), 2u);
  EXPECT_EQ(arguments.entries()[0].text, "3");
}

TEST(Arguments, AMissingOneIsTheUsersMistake) {
  const Arguments arguments;
  try {
    arguments.cell("from");
    FAIL() << "expected an ArgumentError";
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.parameter, "from");
    EXPECT_STREQ(error.what(), "expected a value, found none");
  }
}

TEST(Arguments, AnotherTypeIsTheProgramsMistake) {
  Parameter pair = parameter(ParameterType::numbers);
  pair.parts = {"x", "y"};
  Arguments arguments;
  arguments.set(written("v", pair, "1/3,2"));
  arguments.set({.name = "unread", .text = "1"});
  EXPECT_EQ(arguments.numbers("v"), (std::vector<double>{1.0 / 3, 2}));
  EXPECT_THROW(arguments.cell("v"), ContractViolation);
  EXPECT_THROW(arguments.integer("v"), ContractViolation);
  EXPECT_THROW(arguments.number("v"), ContractViolation);
  EXPECT_THROW(arguments.place("v"), ContractViolation) << "two numbers are no place in space";
  EXPECT_THROW(arguments.points("v"), ContractViolation);
  EXPECT_THROW(arguments.color("v"), ContractViolation);
  EXPECT_THROW(arguments.integer("unread"), ContractViolation) << "set without having been read";
}

// --- Texts inside messages -----------------------------------------------------------------------

TEST(Shown, PlainTextStays) {
  EXPECT_EQ(shown("3,4"), "'3,4'");
  EXPECT_EQ(shown("größe ≤ 1"), "'größe ≤ 1'");
}

TEST(Shown, ControlCharactersAndBrokenUtf8AreEscaped) {
  EXPECT_EQ(shown("a\n\tb"), "'a\\n\\tb'");
  EXPECT_EQ(shown("\x1b[31mred\x7f"), "'\\x1b[31mred\\x7f'");
  EXPECT_EQ(shown(std::string_view("a\0b", 3)), "'a\\x00b'");
  EXPECT_EQ(shown("\xff\xc3"), "'\\xff\\xc3'");
  EXPECT_EQ(shown("\xc0\xaf"), "'\\xc0\\xaf'") << "overlong";
  EXPECT_EQ(shown("\xed\xa0\x80"), "'\\xed\\xa0\\x80'") << "a surrogate";
  EXPECT_EQ(shown("\xc2\x9b"), "'\\xc2\\x9b'") << "the 8-bit form of ESC [";
  EXPECT_EQ(shown("\xe2\x80\xae"), "'\\xe2\\x80\\xae'") << "right-to-left override";
}

TEST(Shown, LongTextsAreCut) {
  EXPECT_LT(shown(std::string(100'000, 'x')).size(), 100u);
  EXPECT_TRUE(shown(std::string(100'000, 'x')).ends_with("…'"));
}

// --- Numbers and points --------------------------------------------------------------------------

Number number(std::string_view text) {
  auto read = read_number(text);
  if (const auto* misread = std::get_if<Misread>(&read)) ADD_FAILURE() << misread->what;
  const auto* found = std::get_if<Number>(&read);
  return found ? *found : Number{};
}

TEST(ReadNumber, CanonicalSpellings) {
  const std::pair<const char*, const char*> spellings[] = {
      {"3", "3"},         {"+3", "3"},          {"-0", "0"},       {"007", "7"},
      {"2/6", "1/3"},     {"-2/6", "-1/3"},     {"2/-6", "-1/3"},  {"-2/-6", "1/3"},
      {"6/3", "2"},       {"0/5", "0"},         {"0.250", "0.25"}, {".5", "0.5"},
      {"5.", "5"},        {"-1.50", "-1.5"},    {"1e3", "1000"},   {"1.25e-2", "0.0125"},
      {"1e300", "1e300"}, {"1E-300", "1e-300"}, {" 4 ", "4"}};
  for (const auto& [text, expected] : spellings) {
    EXPECT_EQ(number(text).text, expected) << text;
    EXPECT_EQ(number(number(text).text).text, expected) << "canonical reads back as itself";
    EXPECT_EQ(number(number(text).text).value, number(text).value) << text;
  }
}

TEST(ReadNumber, ExactWhereItFits) {
  EXPECT_EQ(number("0.1").exact, (Fraction{1, 10}));
  EXPECT_EQ(number("-1/3").exact, (Fraction{-1, 3}));
  EXPECT_EQ(number("-9223372036854775808/1").exact, (Fraction{INT64_MIN, 1}));
  EXPECT_EQ(number("1e-19").exact, std::nullopt);
  EXPECT_EQ(number("0.1").value, 0.1);
  EXPECT_EQ(number("1e22").value, 1e22);
}

TEST(ReadNumber, WhatIsTooSmallForADoubleIsZeroOrTheNearestOne) {
  for (const char* text :
       {"1e-400", "2e-324", "1e-4000", "-1e-0400", "1e-99999999999999999999", "0.0001e-322"}) {
    EXPECT_EQ(number(text).value, 0) << text;
    EXPECT_EQ(number(number(text).text).text, number(text).text) << "canonical reads back as itself";
  }
  EXPECT_EQ(number("3e-324").value, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(number("1e-310").value, 1e-310);
  EXPECT_EQ(number("0e99999").text, "0");
  EXPECT_EQ(number("1e-4000").text, "1e-4000");
  for (const char* text : {"1e400", "1e4000", "1e99999999999999999999", "-0.1e310"}) {
    EXPECT_EQ(std::get<Misread>(read_number(text)).what,
              "expected a number of at most 1.8e308, found '" + std::string(text) + "'");
  }
}

TEST(ReadNumber, FractionsAreRoundedOnce) {
  EXPECT_EQ(number("1/3").value, 1.0 / 3.0);
  EXPECT_EQ(number("9007199254740993/1").value, 9007199254740992.0) << "a tie goes to even";
  EXPECT_EQ(number("9007199254740993/2").value, 4503599627370496.0) << "the same, halved";
  EXPECT_EQ(number("9223372036854775807/9223372036854775806").value, 1.0);
  EXPECT_EQ(number("1/9223372036854775807").value, std::ldexp(1.0, -63));
  EXPECT_EQ(number("-9223372036854775808/9223372036854775807").value, -1.0);
}

TEST(ReadNumber, Refusals) {
  for (const char* text : {"",      "x",
                           "1/0",   "1/",
                           "/2",    "1.5/2",
                           "1/2/3", "1..2",
                           "1e",    "1e+",
                           "1e 5",  "--1",
                           "nan",   "inf",
                           "1e999", "1e99999",
                           "0x10",  "1 2",
                           ".",     "-",
                           "1,5",   "9223372036854775808/1"}) {
    EXPECT_TRUE(std::holds_alternative<Misread>(read_number(text))) << text;
  }
  EXPECT_EQ(std::get<Misread>(read_number("two")).what,
            "expected a number like 3, -5, 1/3 or 0.25, found 'two'");
}

const std::vector<std::string> parts_of_plane{"x", "y"}, parts_of_space{"x", "y", "z"};

TEST(ReadTuple, Spellings) {
  EXPECT_EQ(text_of(std::get<Tuple>(read_tuple("1/3,2", parts_of_plane))), "1/3,2");
  EXPECT_EQ(text_of(std::get<Tuple>(read_tuple("(-0.50, 4/2)", parts_of_plane))), "-0.5,2");
  EXPECT_EQ(text_of(std::get<Tuple>(read_tuple(" 1e3 ,-0, .25", parts_of_space))), "1000,0,0.25");
  const auto complaint_of = [](std::string_view text) {
    return std::get<Misread>(read_tuple(text, parts_of_plane)).what;
  };
  EXPECT_EQ(complaint_of("3"), "expected 2 numbers x,y, found '3'");
  EXPECT_EQ(complaint_of("3,y"), "expected a number like 3, -5, 1/3 or 0.25, found 'y'");
  for (const char* text : {"", ",", "3,", ",4", "3,4,5", "(3,4", "3,4)", "("}) {
    EXPECT_EQ(complaint_of(text), "expected 2 numbers x,y, found " + shown(text));
  }
}

TEST(ReadTuples, Lists) {
  for (const char* text : {"0,0 6,0 6,3", "(0, 0) (6,0)(6 , 3)", "0,0;6,0;6,3",
                           "# corners\n0,0\n6,0 # right\n\n6,3\n", "0 ,0  6, 0 6 , 3"}) {
    const auto read = read_tuples(text, parts_of_plane);
    ASSERT_TRUE(std::holds_alternative<std::vector<Tuple>>(read)) << text << std::get<Misread>(read).what;
    EXPECT_EQ(text_of(std::get<std::vector<Tuple>>(read)), "0,0 6,0 6,3") << text;
  }
}

TEST(ReadTuples, ErrorsNameThePoint) {
  EXPECT_EQ(std::get<Misread>(read_tuples("0,0 6 6,3", parts_of_plane)).what,
            "point 2: expected 2 numbers x,y, found '6'");
  EXPECT_EQ(std::get<Misread>(read_tuples(" ", parts_of_plane)).what,
            "expected points x,y with spaces between them, found ' '");
}

TEST(Canonical, Flags) {
  const Parameter flag = parameter(ParameterType::flag);
  EXPECT_EQ(canonical(flag, " Yes "), "yes");
  EXPECT_EQ(canonical(flag, "no"), "");
  EXPECT_EQ(canonical(flag, ""), "");
  EXPECT_EQ(complaint(flag, "maybe"), "value: expected yes or no, found 'maybe'");
}

Parameter with_parts(ParameterType type, std::vector<std::string> parts) {
  Parameter made = parameter(type);
  made.parts = std::move(parts);
  return made;
}

TEST(Canonical, Numbers) {
  const Parameter circle = with_parts(ParameterType::numbers, {"cx", "cy", "r"});
  EXPECT_EQ(canonical(circle, "(0.50, -0, 1e1)"), "0.5,0,10");
  EXPECT_EQ(complaint(circle, "1,2"), "value: expected 3 numbers cx,cy,r, found '1,2'");
  EXPECT_EQ(complaint(circle, "1,2,nan"), "value: expected a number like 3, -5, 1/3 or 0.25, found 'nan'");
}

TEST(Canonical, Number) {
  Parameter fov = parameter(ParameterType::number);
  fov.least = 1;
  fov.most = 170;
  EXPECT_EQ(canonical(fov, " 60 "), "60");
  EXPECT_EQ(canonical(fov, "+1"), "1");
  EXPECT_EQ(canonical(fov, "1.70e2"), "170");
  EXPECT_EQ(canonical(fov, "100/3"), "100/3");
  EXPECT_EQ(canonical(fov, ".50e2"), "50");
  for (const char* text :
       {"", "0.999", "170.5", "-60", "1/0", "nan", "inf", "1e400", "6 0", "60 degrees", "3,4"})
    EXPECT_EQ(complaint(fov, text), "value: expected a number from 1 to 170, found " + shown(text)) << text;
}

TEST(Canonical, ModelsGoByTheirNames) {
  const Parameter model = parameter(ParameterType::model);
  EXPECT_EQ(canonical(model, "some/folder/spot.obj"), "spot.obj");
  EXPECT_EQ(canonical(model, "spot.obj"), "spot.obj");
  EXPECT_EQ(canonical(model, "-"), "-");
  for (const char* text : {"", "folder/"})
    EXPECT_NE(complaint(model, text).find("value: expected an OBJ file"), std::string::npos)
        << complaint(model, text);
}

TEST(Canonical, BoundsNameWhatIsSwapped) {
  const Parameter window = with_parts(ParameterType::bounds, {"xmin", "ymin", "xmax", "ymax"});
  EXPECT_EQ(canonical(window, "0, 0, 10, 8"), "0,0,10,8");
  EXPECT_EQ(canonical(window, "5,0,5,8"), "5,0,5,8") << "a window without an inside is one";
  EXPECT_EQ(complaint(window, "10,0,0,8"), "value: expected xmin <= xmax, not 10 > 0, found '10,0,0,8'");
  EXPECT_EQ(complaint(window, "0,8,10,0"), "value: expected ymin <= ymax, not 8 > 0, found '0,8,10,0'");
  const Parameter box = with_parts(ParameterType::bounds, {"xmin", "ymin", "zmin", "xmax", "ymax", "zmax"});
  EXPECT_EQ(complaint(box, "0,0,2,1,1,1"), "value: expected zmin <= zmax, not 2 > 1, found '0,0,2,1,1,1'");
}

TEST(Canonical, PointsAreCounted) {
  Parameter polygon = with_parts(ParameterType::points, parts_of_plane);
  polygon.least = 3;
  polygon.most = 4;
  EXPECT_EQ(canonical(polygon, "0,0; 6,0; 6,3"), "0,0 6,0 6,3");
  EXPECT_EQ(complaint(polygon, "0,0 6,0"), "value: expected at least 3 points, found 2");
  EXPECT_EQ(complaint(polygon, "0,0 6,0 6,1 6,2 6,3"), "value: expected at most 4 points, found 5");
  EXPECT_EQ(complaint(polygon, "0,0 6,0 6"), "value: point 3: expected 2 numbers x,y, found '6'");
}

TEST(Canonical, OrderHasEveryChoiceOnce) {
  Parameter order = parameter(ParameterType::order);
  order.choices = {"left", "right", "bottom", "top"};
  EXPECT_EQ(canonical(order, "Top, left,right ,bottom"), "top,left,right,bottom");
  for (const char* text :
       {"", "left", "left,left,right,top", "left,right,bottom,top,top", "left,right,bottom,up"})
    EXPECT_EQ(complaint(order, text),
              "value: expected left,right,bottom,top, each once in any order, found " + shown(text));
}

TEST(Canonical, RingsAreListsOfPoints) {
  Parameter holes = with_parts(ParameterType::rings, parts_of_plane);
  holes.least = 3;
  holes.most = 7;
  EXPECT_EQ(canonical(holes, "0,0 6,0 6,3"), "0,0 6,0 6,3");
  EXPECT_EQ(canonical(holes, "0,0 6,0\t6,3;(1, 1) 2,1 2/4,2 ;"), "0,0 6,0 6,3; 1,1 2,1 1/2,2");
  EXPECT_EQ(canonical(holes, "0,0 6,0 6,3 # one\n; 1,1 2,1 2,2 # two; three"), "0,0 6,0 6,3; 1,1 2,1 2,2");
  const std::string too_few = "value: ring 2: expected at least 3 points, with ; between rings alone, found ";
  EXPECT_EQ(complaint(holes, "0,0 6,0 6,3; 1,1 2,1"), too_few + "2");
  EXPECT_EQ(complaint(holes, "0,0 6,0 6,3; 1,1; 2,1; 2,2"), too_few + "1");
  EXPECT_EQ(complaint(holes, "0,0 6,0 6,3; 1,1 2,1 2"),
            "value: ring 2: point 3: expected 2 numbers x,y, found '2'");
  EXPECT_EQ(complaint(holes, "0,0 6,0 6,3 6,4; 1,1 2,1 2,2 2,3"),
            "value: expected at most 7 points in all, found 8");
  for (const char* text : {"", " ; "})
    EXPECT_EQ(complaint(holes, text),
              "value: expected rings of points x,y, with ; between rings, found " + shown(text));
  Arguments arguments;
  arguments.set(written("holes", holes, "0,0 6,0 6,3; 1,1 2,1 1/2,2"));
  arguments.set({.name = "none", .text = ""});
  EXPECT_EQ(arguments.rings("holes"),
            (std::vector<std::vector<dvec2>>{{{0, 0}, {6, 0}, {6, 3}}, {{1, 1}, {2, 1}, {0.5, 2}}}));
  EXPECT_TRUE(arguments.rings("none").empty());
}

TEST(Canonical, AnOrderMayBeOneOfNumbers) {
  Parameter order = parameter(ParameterType::order);
  order.choices = {"left", "right", "bottom", "top"};
  order.numbered = true;
  EXPECT_EQ(canonical(order, "top,left,right,bottom"), "top,left,right,bottom");
  EXPECT_EQ(canonical(order, " 3, 1,2"), "3,1,2");
  EXPECT_EQ(canonical(order, "5,4,3,2,1"), "5,4,3,2,1");
  for (const char* text : {"", "0,1,2", "1,1,2", "1,2,4", "left,2,3,4", "1.0,2", "+1,2", "1,2,"})
    EXPECT_EQ(
        complaint(order, text),
        "value: expected left,right,bottom,top or the numbers 1, 2, … to the last, each once in any order, "
        "found " +
            shown(text));
  Arguments arguments;
  arguments.set(written("order", order, "3,1,2"));
  arguments.set(written("names", order, "top,left,right,bottom"));
  EXPECT_EQ(arguments.numbered_order("order"), (std::vector<std::size_t>{2, 0, 1}));
  EXPECT_EQ(arguments.numbered_order("names"), std::nullopt);
  EXPECT_THROW(arguments.order("order"), ContractViolation) << "numbers, not choices";
}

TEST(Arguments, ReadWhatTheirTypesSay) {
  Parameter order = parameter(ParameterType::order);
  order.choices = {"left", "right", "bottom", "top"};
  Arguments arguments;
  arguments.set(written("line", with_parts(ParameterType::numbers, parts_of_plane), "1/2,-3"));
  arguments.set(written("polygon", with_parts(ParameterType::points, parts_of_plane), "0,0 6,0 6,3"));
  arguments.set(written("corners", with_parts(ParameterType::points, parts_of_space), "0,0,1 6,0,2"));
  arguments.set(written("eye", with_parts(ParameterType::numbers, parts_of_space), "1,2,3"));
  arguments.set(written("fov", parameter(ParameterType::number), "100/3"));
  arguments.set({.name = "none", .text = ""});
  arguments.set(written("order", order, "top,left,right,bottom"));
  arguments.set(
      written("factors", with_parts(ParameterType::factors, parts_of_plane), "rotate 30 about 1,1; scale 2"));
  EXPECT_EQ(arguments.numbers("line"), (std::vector<double>{0.5, -3}));
  EXPECT_EQ(arguments.points("polygon"), (std::vector<dvec2>{{0, 0}, {6, 0}, {6, 3}}));
  EXPECT_EQ(arguments.places("corners"), (std::vector<dvec3>{{0, 0, 1}, {6, 0, 2}}));
  EXPECT_EQ(arguments.place("eye"), (dvec3{1, 2, 3}));
  EXPECT_EQ(arguments.order("order"), (std::vector<std::size_t>{3, 0, 1, 2}));
  EXPECT_TRUE(arguments.numbers("none").empty() && arguments.points("none").empty());
  EXPECT_EQ(arguments.place("none"), std::nullopt);
  EXPECT_EQ(arguments.number("fov"), std::optional(100.0 / 3));
  EXPECT_EQ(arguments.number("none"), std::nullopt);
  ASSERT_EQ(arguments.factors("factors").size(), 2u);
  EXPECT_EQ(text_of(arguments.factors("factors")[0].pivot), "1,1");
}

TEST(Canonical, PaintIsAColourOrALetter) {
  const Parameter paint = parameter(ParameterType::paint);
  EXPECT_EQ(canonical(paint, " b "), "b");
  EXPECT_EQ(canonical(paint, "Q"), "Q");
  EXPECT_EQ(canonical(paint, "Red"), "#ff0000");
  EXPECT_EQ(canonical(paint, "#D55E00"), "#d55e00");
  EXPECT_THROW(canonical(paint, "7"), ArgumentError);
  EXPECT_THROW(canonical(paint, "ab"), ArgumentError);
}

TEST(Canonical, WindowsAreFourNumbersTheRightWayRound) {
  const Parameter window = parameter(ParameterType::window);
  EXPECT_EQ(canonical(window, " 0, -5,10 ,3"), "0,-5,10,3");
  EXPECT_EQ(canonical(window, "7,7,7,7"), "7,7,7,7");
  for (const char* wrong : {"1,2,3", "1,2,3,4,5", "5,0,3,1", "0,5,1,3", "a,b,c,d", "0,0,3000000000,1", ""}) {
    EXPECT_THROW(canonical(window, wrong), ArgumentError) << wrong;
  }
  Arguments arguments;
  arguments.set(written("window", window, "0,-5,10,3"));
  EXPECT_EQ(arguments.window("window"), (Window{{0, -5}, {10, 3}}));
  EXPECT_FALSE(arguments.window("another"));
}

// --- Entries -------------------------------------------------------------------------------------

TEST(Entries, AreFoundByExactlyTheirNames) {
  for (const TopicEntry* topic : catalogue()) EXPECT_EQ(find_entry(topic->name), topic) << topic->name;
  EXPECT_EQ(find_entry("textbook_chain"), nullptr) << "the namespace of the story of pipeline";
  for (const char* name : {"", "line", "Bresenham line", "bresenham", "bresenham_line_"})
    EXPECT_EQ(find_entry(name), nullptr) << name;
}

}  // namespace
}  // namespace gradus
