#include "cli/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "plan/rules.hpp"
#include "request/names.hpp"
#include "scene/antialiasing.hpp"
#include "scene/choices.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

const Flag width{"width", 0, "N",
                 "columns of a line; default: COLUMNS, or the terminal's, or no end in a pipe"};
const Flag output{"output", 'o', "FILE", ""};
const Flag output_folder{"output", 'o', "DIR",
                         "a folder for a figure of the first difference of each wrong answer"};
const Flag step{
    "step", 0, "N",
    "one step: a number like 4, 4.1 for a finer event after it, or last; default: one that decides"};
const Flag steps{"steps", 0, "LIST",
                 "several: 3-9, or 1,4,9-12; 0-100/5 takes every fifth; auto: the input, the most telling "
                 "one, one of each kind of branch and of each phase, the result"};
const Flag panels{"panels", 0, "LIST",
                  "several drawings on one sheet: phases, one for each; or 2 to 8 steps like 1,4,9"};
const Flag compare{"compare", 0, "METHOD",
                   "beside another run: a method, another topic with the same inputs, or other inputs like "
                   "'--method NAME'; shows where they first differ, of two right runs their results"};
const Flag trace{
    "trace", 0, "FILE",
    "beside somebody's own answer: results.json, results.json#CASE of several, or a table like mine.csv "
    "with a pixel x,y per line; shows where it first differs"};
const Flag force{"force", 'f', "", "replaces a file also when gradus did not make it"};
const Flag format{"format", 0, "NAME",
                  "svg, png, pdf, pptx, html, csv, md, tex, json, txt, gif, mp4, webp, obj, ply or stl; "
                  "default: by the file's ending"};

/// How texts are worded.
const std::vector<Flag> words{
    {"label", 0, "SYMBOL=TEXT", "your own name for a symbol, as in p=d; everywhere but in the source", true},
    {"notation", 0, "BOOK",
     "foley, hearn, shirley or opengl, or a file like own.json: symbols, codes, vectors, axes and depth as "
     "written there"},
    {"language", 0, "CODE", "en or de: the language of sentences and headings"},
    {"numbers", 0, "HOW",
     "decimals (default), with ≈ where they are rounded, or fractions like 23/3 where they are short"},
};

/// How a figure looks.
const std::vector<Flag> looks{
    {"slots", 0, "LIST", "parts to show: title,drawing,listing,table,sentence,footer"},
    {"no-title", 0, "", "all of them but the title"},
    {"theme", 0, "NAME", "light, dark, greyscale, high_contrast or print"},
    {"background", 0, "COLOR", "the ground: #rrggbb, a colour's name, or none for a transparent one"},
    {"size", 0, "WxH", "1280x720 in pixels, a ratio like 4:3 or 1:1, or lengths like 12cmx8cm; default 16:9"},
    {"scale", 0, "N", "PNG and films: pixels for one of the figure, 0.1 to 8; default 1"},
    {"layout", 0, "NAME", "slide, or handout with smaller letters and more of source and table"},
    {"listing", 0, "FORM", "source (default), or pseudo: the same lines as a textbook writes them"},
    {"line-numbers", 0, "WHICH",
     "of the listing: listing (default) counts its lines, source the file's, or none"},
    {"crop", 0, "", "without the empty margin"},
    {"view", 0, "X0,Y0,X1,Y1",
     "the cells to show; default: all, or those round the step where they are too many"},
    {"y", 0, "DIRECTION", "up or down: turns the drawing"},
    {"svg-text", 0, "HOW", "outlines (default), or text that can be searched and edited"},
    {"title", 0, "TEXT", "instead of the topic's title"},
    {"caption", 0, "TEXT", "said before the sentence, in snippets and for who can't see the figure"},
};

/// How steps are put on paper and on a screen.
const std::vector<Flag> outputs{
    {"handout", 0, "CxR", "PDF: pages for print with so many figures across and down, like 2x3"},
    {"paper", 0, "NAME", "of a handout: a4 (default) or letter"},
    {"seconds-per-step", 0, "N", "films: how long each step stays; default 1.5"},
    {"hold-last", 0, "N", "films: how many seconds the last step stays; default 3"},
    {"transition", 0, "N",
     "films: seconds in which marks move to the next step, at most a third of it; default 0.3, in films of "
     "over 100 steps none; none: hard cuts"},
    {"fps", 0, "N", "MP4: pictures a second; default 25"},
    {"loop", 0, "N", "GIF and WebP: how often it runs; 0 (default): for ever"},
};

/// How a scene is seen.
const std::vector<Flag> views{
    {"size", 0, "WxH", "in pixels, up to 8192 per side; default 800x600, or what the scene says"},
    {"eye", 0, "X,Y,Z", "where it is seen from; default: in front, so that all of it is in the picture"},
    {"target", 0, "X,Y,Z", "what the eye looks at; default: the middle of the model"},
    {"up", 0, "X,Y,Z", "the direction that is up in the picture; default 0,1,0"},
    {"fov", 0, "DEGREES", "the angle of view between the lower and the upper edge; default 40"},
    {"projection", 0, "HOW",
     fmt::format("how space comes into the picture: {}; default {}",
                 fmt::join(pipeline::projection_names, ", "), pipeline::projection_names[0])},
    {"height", 0, "UNITS",
     "how much is seen from the lower to the upper edge where rays meet in no eye; default: all of it"},
    {"receding", 0, "DEGREES", "oblique: the angle at which depth is drawn; default 45"},
    {"foreshortening", 0, "FACTOR",
     "oblique: how long a unit of depth is drawn: 1 cavalier, 0.5 cabinet (default)"},
    {"turntable", 0, "N", "lets the camera go once round what it looks at, in so many frames"},
    {"light", 0, "X,Y,Z", "where a lamp stands; default: light from behind the viewer's left shoulder"},
    {"background", 0, "COLOR", "#rrggbb, a colour's name, or none for a transparent one; default white"},
    {"shading", 0, "HOW",
     "light once per face, corner or pixel: flat, gouraud or phong (default); wireframe draws edges "
     "alone"},
    {"hidden-surfaces", 0, "METHOD",
     fmt::format("what decides which surface is seen: {}, which is wrong where triangles overlap in depth; "
                 "default {}",
                 fmt::join(pipeline::hidden_surface_names, ", "), pipeline::hidden_surface_names[0])},
    {"culling", 0, "WHICH",
     "faces that turn their backs are left out: auto (of closed bodies, default), none or back (all)"},
    {"filter", 0, "HOW",
     "how textures are looked up: nearest, bilinear or mipmapped (default); none leaves them out"},
    {"aa", 0, "METHOD",
     fmt::format("antialiasing: {}; default {}", fmt::join(pipeline::antialiasing_names, ", "),
                 name_of(pipeline::default_antialiasing))},
    {"samples", 0, "N",
     fmt::format("samples per pixel, for methods that take some; default {}", pipeline::default_samples)},
};

const Flag frames{"frames", 0, "FRAMES", ""};

/// What of a scene is rendered.
const std::vector<Flag> plans{
    {"part", 0, "C,R,WxH", "only these pixels of the picture: column and row of the first, and how many"},
    {"without", 0, "RULES",
     fmt::format("skips nothing by these rules: {}, or all; the picture is the same",
                 fmt::join(pipeline::rule_names, ", "))},
};

std::vector<Flag> joined(std::vector<Flag> flags, std::initializer_list<std::vector<Flag>> more) {
  for (const std::vector<Flag>& some : more) flags.insert(flags.end(), some.begin(), some.end());
  return flags;
}

Flag with_help(Flag flag, const char* help) {
  flag.help = help;
  return flag;
}

std::vector<Command> all_commands() {
  return {
      {"list",
       "one WORD",
       "the topics, by chapter; WORD searches names, aliases and titles",
       0,
       1,
       false,
       {{"json", 0, "", "as JSON"}, width},
       {"gradus list", "gradus list fill", "gradus list --json"},
       Operand::topic},
      {"help",
       "one TOPIC or command",
       "a topic's inputs, units and methods, with examples to paste",
       0,
       1,
       false,
       {width},
       {"gradus help", "gradus help TOPIC", "gradus help figure"},
       Operand::page},
      {"run",
       "a TOPIC",
       "runs a topic and prints its step table",
       1,
       1,
       true,
       joined({{"json", 0, "", "as JSON: topic, method, input, steps, result"}, step, steps, width}, {words}),
       {"gradus run TOPIC", "gradus run TOPIC --method NAME --json", "gradus run TOPIC --steps auto"}},
      {"figure",
       "a TOPIC",
       "draws steps of a topic into files",
       1,
       1,
       true,
       joined(
           {with_help(output, "where to; {step} in the name makes one file per step; - is standard output"),
            step,
            steps,
            panels,
            compare,
            trace,
            format,
            force,
            {"snippet", 0, "KIND", "prints the lines to paste into a lecture: beamer, reveal or markdown"}},
           {looks, words, outputs}),
       {"gradus figure TOPIC -o figure.svg", "gradus figure TOPIC --step 1 --theme dark -o figure.png",
        "gradus figure TOPIC -o 'figure-{step}.png'    # one file per step",
        "gradus figure TOPIC -o figure.pdf             # one page per step",
        "gradus figure TOPIC -o figure.html            # the player, to step through in a browser",
        "gradus figure TOPIC -o figure.pdf --steps auto --size 4:3 --snippet beamer",
        "gradus figure TOPIC -o figure.svg --panels phases    # one slide, a drawing for each phase",
        "gradus figure TOPIC -o figure.pdf --handout 2x3 --paper a4",
        "gradus run TOPIC --json > mine.json && gradus figure TOPIC --trace mine.json -o mine.svg",
        "gradus figure TOPIC -o figure.gif --seconds-per-step 2"},
       Operand::none,
       {"a PDF: 1000 pages, the first of a longer run; --steps takes others",
        "a film: 1000 frames; 10000 with --steps; 8294400 pixels each, as 3840 x 2160 has",
        "a page (.html): 4000 steps; 20000 with --steps",
        "{step} in the name: 1000 files; 100000 with --steps"}},
      {"source",
       "a TOPIC",
       "prints a topic's algorithm, in C++; --plain: as one header for your own program, without observers",
       1,
       1,
       false,
       {{"plain", 0, "",
         "one header with all that the topic needs but GLM and the standard library, and no observers"},
        with_help(output, "where to; default: standard output"),
        with_help(force, "replaces a file that is there, of any kind")},
       {"gradus source TOPIC", "gradus source TOPIC --plain -o topic.hpp"},
       Operand::topic},
      {"cases",
       "a TOPIC",
       "inputs to try your own program on: easy, typical and nasty ones, and ties",
       1,
       1,
       true,
       {{"json", 0, "", "as JSON: topic, conventions, what is asked for, cases"},
        {"count", 0, "N", "how many of each kind, 1 to 50; default 4"},
        {"random-seed", 0, "N", "which inputs; the same number makes the same ones; default 1"},
        width},
       {"gradus cases TOPIC", "gradus cases TOPIC --json > cases.json",
        "gradus cases TOPIC --method NAME --random-seed 7 --count 2"}},
      {"check",
       "a TOPIC and a FILE",
       "judges what your own program answered, in JSON or a table: right, by another tie rule, wrong from "
       "which "
       "step on",
       2,
       2,
       true,
       {output_folder, force, {"json", 0, "", "as JSON: verdicts, steps, whether later steps follow"}, width},
       {"gradus run TOPIC --json | gradus check TOPIC -        # our own answer",
        "gradus run TOPIC --json > results.json && gradus check TOPIC results.json --json",
        "gradus check TOPIC results.json -o wrong/"},
       Operand::answers},
      {"figures",
       "one LECTURE",
       "draws every figure of a lecture, or of the built-in gallery; only what has changed",
       0,
       1,
       false,
       joined({with_help(output, "the folder; default out"),
               {"check", 0, "", "reads the lecture and reports every problem; draws nothing"},
               {"schema", 0, "", "prints the JSON Schema of lectures, for editors that check while you type"},
               {"only", 0, "GLOB", "only figures or topics with such a name; * and ? stand for any letters"},
               {"jobs", 'j', "N", "how many at once; default: the usable cores"},
               {"force", 'f', "",
                "all anew; also over another lecture's figures and files that gradus did not make"},
               {"zip", 0, "", "packs the folder into one file beside it, for a learning platform"}},
              {{lecture_looks().begin(), lecture_looks().end()}}),
       {"gradus figures -o out/", "gradus figures my_lecture.json -o my_lecture/",
        "gradus figures my_lecture.json --check", "gradus figures -o out/ --only 'TOPIC*'",
        "gradus figures my_lecture.json -o dark/ --theme dark --size 4:3", "gradus figures -o out/ --zip",
        "gradus figures -o out/ --jobs 2 --force"},
       Operand::lecture},
      {"worksheet",
       "a TOPIC",
       "exercises for print or Moodle: step tables with blanks, an input for each student, and the answer "
       "key",
       1,
       64,
       true,
       joined(
           {with_help(output, "where to: .pdf, .tex (with its drawings in a PDF beside it) or .xml (Moodle)"),
            {"key", 0, "FILE",
             "where the answer key goes; default: beside the sheets, with -key in its name"},
            {"students", 0, "FILE",
             "their names, one per line, or a CSV with names first; default: one sheet"},
            {"seed", 0, "N", "which inputs; the same number makes the same ones; default 1"},
            {"points", 0, "N", "of a sheet, shared by rows and drawings; default 10"},
            {"table-rows", 0, "N", "how many rows of the table at most, 2 to 16; default 12"},
            {"calculator", 0, "", "takes numbers of three decimals, too: not for the hand"},
            {"no-drawing", 0, "", "the table alone"},
            {"lecture", 0, "LECTURE",
             "words, notation and input of that lecture's first figure of the topic"},
            {"format", 0, "NAME", "pdf, tex or xml; default: by the file's ending"},
            {"paper", 0, "NAME", "a4 (default) or letter"},
            force},
           {words}),
       {"gradus worksheet TOPIC -o sheet.pdf              # and sheet-key.pdf",
        "gradus worksheet TOPIC -o sheet.pdf --students names.txt --seed 7 --language de",
        "gradus worksheet TOPIC -o sheet.tex --paper letter --table-rows 8",
        "gradus worksheet TOPIC TOPIC -o exam.pdf --points 20    # two tasks per student",
        "gradus worksheet TOPIC -o quiz.xml --students names.txt"},
       Operand::topic,
       {"500 students"}},
      {"render",
       "a MODEL.obj or a SCENE.json",
       "renders a model (OBJ with the materials that lie beside it, glTF, PLY, STL and others) or a scene of "
       "several into a PNG or a page",
       1,
       1,
       false,
       joined(
           {with_help(output,
                      "the PNG; - is standard output; an HTML page tells of the pixel that is clicked; "
                      "{frame} in the name makes one file per frame of the camera's path, .mp4 a film")},
           {views,
            plans,
            {with_help(frames,
                       "of the camera's path: 0-124, 17, or 0-124/5, every fifth; default: all, or the "
                       "first for one picture"),
             {"array", 0, "K/N", "of the frames every N-th from the K-th on: one of N parts, for a cluster"},
             {"jobs", 'j', "N", "how many frames at once; default: the usable cores"},
             {"engine", 0, "NAME",
              "what draws: fast (default), in tiles on all cores, or textbook, the eight stages one after "
              "the "
              "other; wireframes and triangles in an order of their own are always the textbook's"},
             {"report", 0, "", "prints what was done and what was left out, stage by stage"},
             {"why", 0, "C,R",
              "prints instead why the pixel in this column and row is what it is, from 0,0 at the upper "
              "left; with -o draws it: SVG, PNG or PDF"},
             force}}),
       {"gradus render letter_f.obj -o f.png", "gradus render street.json -o street.png",
        "gradus render pasture.json -o pasture.png",
        "gradus render letter_f.obj -o wide.png --size 640x360 --fov 90",
        "gradus render spot.obj -o lamp.png --eye=-3,1,0 --light=-2,2,-2 --background "
        "'#202830'",
        "gradus render letter_f.obj -o - --background none > clear.png",
        "gradus render town.json -o roof.png --part 600,300,320x180 --report",
        "gradus render spot.json --why 480,300", "gradus render spot.json --why 480,300 -o why.svg",
        "gradus render spot.json -o spot.html --size 240x135    # a page to click in",
        "gradus render town_flight.json -o 'frames/f-{frame}.png' --frames 0-124 --size 320x180",
        "gradus render town_flight.json -o flight.mp4 --size 320x180",
        "gradus render spot.obj --turntable 120 -o spin.mp4 --size 480x480"},
       Operand::model},
      {"explain",
       "a MODEL.obj or a SCENE.json",
       "prints what rendering it will run and skip, object by object and stage by stage, and why",
       1,
       1,
       false,
       joined({{"json", 0, "", "as JSON: the decision on each object and stage"},
               with_help(output, "draws instead where in the picture work is left out; a PNG or SVG"),
               with_help(frames, "one frame of the camera's path, like 17; default: its first"),
               force},
              {views, plans}),
       {"gradus explain town.json", "gradus explain town.json --part 200,100,300x200",
        "gradus explain closed_room.json --json", "gradus explain spot.obj --eye=-1.5,1.2,-2.7",
        "gradus explain town.json -o left_out.png"},
       Operand::model},
      {"demo",
       "a DEMO: forward, target or both",
       "films the view from a car on a circular road: along the road, at one target, or both side by side",
       1,
       1,
       false,
       {with_help(output,
                  "the film, an MP4; a name that ends in .png: a strip of five frames; - is standard "
                  "output"),
        {"frames", 0, "DIR", "a folder for every frame, 000.png and so on; with -o or without"},
        {"data", 0, "FILE",
         "camera, road, film and model, as `gradus inspect` lists them; default: the program's own pyramid"},
        {"texture", 0, "FILE", "the PNG that the model wears; default: the pyramid's stones"},
        {"jobs", 'j', "N", "how many frames at once; default: the usable cores"},
        force},
       {"gradus demo forward -o forward.mp4", "gradus demo target -o target.mp4 --frames target/",
        "gradus demo both -o both.png                  # five frames of each",
        "gradus demo forward --frames forward/"},
       Operand::demo,
       {"a film: 1000 frames, 60 a second"}},
      {"inspect",
       "a FILE",
       "lists what stands in a file of data for gradus demo: keys, types, shapes",
       1,
       1,
       false,
       {{"json", 0, "", "as JSON"}, width},
       {"gradus inspect pyramid_demo.json", "gradus inspect pyramid_demo.json --json"},
       Operand::data},
      {"bench",
       "TOPICs",
       "measures the methods of topics: time against error, beside others' programs",
       0,
       64,
       false,
       {{"output", 'o', "DIR", "a folder for charts of time against error and against size, and bench.json"},
        force,
        {"json", 0, "", "as JSON in Google Benchmark's layout, instead of tables"},
        {"from", 0, "FILE", "tables and charts of a bench.json, without measuring again"},
        {"theme", 0, "NAME", "of the charts: light, dark, greyscale, high_contrast or print"},
        {"seconds", 0, "N", "how long a repetition of one method lasts; default 0.05"},
        {"repetitions", 0, "N", "of which the median counts; default 9"},
        {"require-peers", 0, "", "fails where a program is missing that the engine is compared with"}},
       {"gradus bench", "gradus bench TOPIC", "gradus bench TOPIC -o bench/",
        "gradus bench TOPIC --json > bench.json",
        "gradus bench --from bench/bench.json --theme dark -o dark/"},
       Operand::topic},
      {"stress",
       "TOPICs",
       "attacks what topics promise with hard inputs, against exact arithmetic",
       0,
       64,
       false,
       {{"seconds", 0, "N", "how long in all; default 10"},
        {"random-seed", 0, "N", "which inputs; the same number makes the same ones; default 1"},
        {"list", 0, "", "only says what is promised; attacks nothing"},
        {"replay", 0, "CASE", "one input, as a report prints it, or a trap's name: PROPERTY:TRAP"},
        {"output", 'o', "DIR", "a folder for figures of the worst inputs"},
        force},
       {"gradus stress", "gradus stress TOPIC --seconds 60", "gradus stress TOPIC --random-seed 7 -o worst/"},
       Operand::topic},
      {"again",
       "a FILE",
       "makes a figure again from what it carries in its metadata",
       1,
       1,
       false,
       joined({with_help(output, "where to; default: beside the figure, with -again in its name"), step,
               steps, panels, compare, format, force},
              {looks, words, outputs}),
       {"gradus again line.svg", "gradus again line.svg --theme dark",
        "gradus again line.svg --step 2 -o line-2.png"},
       Operand::figure},
      {"open",
       "one FOLDER",
       "shows the figures in a folder, or the page or figure of that name, in the browser; default out",
       0,
       1,
       false,
       {},
       {"gradus open", "gradus open my_lecture/", "BROWSER=firefox gradus open"},
       Operand::folder},
      {"completion",
       "one SHELL",
       "prints the lines that complete what you type: for bash, zsh or fish",
       1,
       1 << 16,
       false,
       {{"next", 0, "", "prints what may come next behind --, a line each: the shell's lines ask it"}},
       {"source <(gradus completion bash)      # in ~/.bashrc",
        "gradus completion zsh > _gradus      # in a folder of $fpath",
        "gradus completion fish > gradus.fish", "gradus completion --next -- figure TOPIC --theme ''"},
       Operand::shell},
      {"man",
       "one TOPIC or command",
       "prints a page of the manual, for `man -l`: of gradus, of a command or of a topic",
       0,
       1,
       false,
       {{"output", 'o', "DIR", "writes all pages into this folder"}, force},
       {"gradus man > gradus.1", "gradus man figure > gradus-figure.1", "gradus man TOPIC > topic.7",
        "gradus man -o man/"},
       Operand::page},
  };
}

}  // namespace

std::span<const Flag> lecture_looks() {
  static const std::vector<Flag> flags = [] {
    std::vector<Flag> chosen;
    for (const char* name : {"theme", "background", "size", "scale", "layout", "crop", "svg-text"}) {
      chosen.push_back(*std::ranges::find(looks, name, &Flag::name));
    }
    for (const char* name : {"notation", "language", "numbers"}) {
      chosen.push_back(*std::ranges::find(words, name, &Flag::name));
    }
    return chosen;
  }();
  return flags;
}

std::span<const Command> commands() {
  static const std::vector<Command> all = all_commands();
  return all;
}

std::string parameter_flag(const Command& command, const Parameter& parameter) {
  const std::string name = hyphened(parameter.name);
  const bool taken = std::ranges::find(command.flags, name, &Flag::name) != command.flags.end();
  return taken ? "input-" + name : name;
}

std::span<const Flag> common_flags() {
  static const std::vector<Flag> flags{
      {"color", 0, "WHEN", "auto, always or never: colours in the terminal"},
      {"quiet", 'q', "", "no progress and no remarks"},
      {"help", 'h', "", "this help"},
      {"version", 'V', "", "the version of gradus and of the libraries it uses"},
  };
  return flags;
}

Color Request::color() const {
  const auto wanted = flags.find("color");
  return wanted == flags.end() ? Color::automatic : read_color(wanted->second);
}

std::size_t Request::width() const {
  const auto wanted = flags.find("width");
  return output_width(wanted == flags.end() ? "" : wanted->second);
}

}  // namespace gradus::cli
