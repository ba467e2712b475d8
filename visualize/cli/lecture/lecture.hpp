#pragma once
// A lecture: one JSON file that says which figures to make, with which inputs and in which look.
//
//   {"theme": "dark", "figures": [{"topic": "…", "input": {"from": "0,0", "to": "9,4"}}],
//    "renders": [{"model": "spot.obj", "eye": [-1.5, 1.2, -2.7]}]}
//
// Its keys are the flags of `gradus figure`, with underscores, and a few of its own: see lecture_keys. Those
// of a render are the flags of `gradus render`: see render_keys.

#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/render.hpp"
#include "cli/figures/figure_file.hpp"

namespace gradus::cli {

// --- The keys ----------------------------------------------------------------------------------------------

/// What may stand as a key's value.
enum class KeyKind {
  text,
  number,    ///< or the same as a text
  toggle,    ///< true or false
  list,      ///< texts and numbers, or the same as one text with commas
  place,     ///< three numbers, or the same as one text with commas
  labels,    ///< an object: symbol -> the reader's name for it
  notation,  ///< a name, a file, or an object
  topic,     ///< the name of a topic
  method,    ///< one of the topic's methods
  input,     ///< an object of the topic's parameters
  outputs,   ///< a list of formats
  figures,   ///< the list of figures
  renders,   ///< the list of renders
};

struct LectureKey {
  std::string name;
  KeyKind kind;
  bool of_lecture, of_figure;  ///< where it may stand; a flag of both is a default that a figure can override
  std::string help;
};

/// All keys: those of a lecture's own, then one for each flag of `gradus figure` that says how figures look.
std::span<const LectureKey> lecture_keys();

/// The keys of a render: a few of its own, then one for each flag of `gradus render` but the output.
std::span<const LectureKey> render_keys();

/// The JSON Schema (draft 2020-12) of a lecture, made from the keys, the topics and the formats.
std::string lecture_schema();

// --- The file ----------------------------------------------------------------------------------------------

struct LectureFile {
  std::string name;  ///< as errors call it
  std::string text;
  std::string owner;  ///< which lecture this is: a folder of figures remembers it
  FindFile find;      ///< where the files are that its figures name
};

/// The lecture at this path, or from standard input for "-". Throws UsageError when it can't be read.
LectureFile lecture_at(const std::string& path);

/// The built-in gallery: examples/gallery.json.
LectureFile gallery_lecture();

// --- What it says ------------------------------------------------------------------------------------------

/// Where something stands: the line, and the way to it, "figures[3].input.to".
struct Place {
  int line;
  std::string path;
};

/// What is wrong with a lecture: "lecture.json:12: figures[3].step: expected …, found …".
struct Problem {
  int line = 0;
  std::string text;
  friend auto operator<=>(const Problem&, const Problem&) = default;
};

/// What figures and renders of a lecture have in common.
struct LecturePart {
  std::string name;  ///< of its folder and files, unique in the lecture
  std::string caption;
  Request request;                  ///< the same as a command line
  std::vector<std::string> files;   ///< input files, as paths
  std::vector<std::string> copies;  ///< those of them that `gradus again` needs beside the figure

  /// Where it stands, and each of its flags and parameters, by name: "svg-text", "from".
  Place place;
  std::map<std::string, Place> places;
};

/// A figure of a lecture, with its inputs read.
struct LectureFigure : LecturePart {
  std::vector<Format> outputs;
  FigureSpec spec;
  std::vector<std::string> remarks;  ///< on what was read, a line each

  /// All that the lecture says of it, as one text.
  std::string contents() const;
};

/// A rendered model of a lecture, read but for its pixels.
struct LectureRender : LecturePart {
  std::string title;  ///< of its card; empty: none of its own
  RenderBrief brief;

  /// All that the lecture says of it, as one text.
  std::string contents() const;
};

/// A figure or a render.
using AnyPart = std::variant<const LectureFigure*, const LectureRender*>;
const LecturePart& part_of(const AnyPart& any);

struct Lecture {
  std::string file;   ///< as errors call it
  std::string title;  ///< empty: none of its own
  std::vector<LectureFigure> figures;
  std::vector<LectureRender> renders;
  std::vector<Problem> problems;  ///< by line

  /// The figures, then the renders.
  std::vector<AnyPart> parts() const;
};

/// Reads it all, noting every problem. Throws InputError for what is no JSON, WorkError when a file of the
/// built-in gallery is missing. `instead`: flags of looks, checked already, that stand in the place of what
/// the lecture says.
Lecture read_lecture(const LectureFile& file, const std::map<std::string, std::string>& instead = {});

/// What went wrong with a figure or a render, with its place; for errors that are not about the user's input
/// its name will do.
Problem problem_of(const Lecture& lecture, const LecturePart& part, const std::exception& error);

/// Whether it is the user's input that is wrong.
bool is_about_input(const std::exception& error);

}  // namespace gradus::cli
