#pragma once
// What a topic is to everyone outside its own files: one TopicEntry, exported by its story. Command-line
// flags, `list --json`, help, lectures and the page's form are all made from it.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/geometry.hpp"
#include "core/image.hpp"
#include "core/refusal.hpp"
#include "figure/recording.hpp"
#include "figure/trace.hpp"
#include "stories/face_text.hpp"
#include "stories/factor_text.hpp"
#include "stories/point_text.hpp"

namespace gradus {

/// What kind of value a parameter takes; decides how it is read and how a wrong one is explained.
enum class ParameterType {
  cell,     ///< two whole numbers "3,4"
  window,   ///< four whole numbers "xmin,ymin,xmax,ymax", both corners included
  integer,  ///< one whole number
  choice,   ///< one of `choices`
  color,    ///< "#rrggbb" or a CSS basic colour name; canonical "#rrggbb"
  paint,    ///< a colour as above or, for mazes, one letter
  picture,  ///< a PNG or JPEG file
  maze,    ///< a text file, "-", or the rows themselves joined by "/"; a short file is made canonical as rows
  number,  ///< one number: "0.5", "1/3"
  numbers,  ///< as many numbers as `parts` has names: "1,0.5,2" for x,y,z
  bounds,   ///< the same, all lower ones first: "0,0,10,8" for xmin,ymin,xmax,ymax; none above its upper one
  points,   ///< points of as many numbers as `parts` has names: "0,0 6,0 6,3"; from `least` to `most` of them
  rings,    ///< several such lists: "0,0 6,0 6,3; 8,1 9,1 9,2"; `least` points per ring, `most` in all
  order,    ///< all of `choices`, each once: "left,right,bottom,top"; where `numbered`, "2,1,3", too
  factors,  ///< transformations in the order of acting: "rotate 30 about 1,1; scale 2"; `parts`: x,y or x,y,z
  faces,    ///< faces in space, "a: 0,0,0 4,0,0 4,3,0; b: …", or a JSON or OBJ file; `most` corners in all
  model,    ///< an OBJ file; commands take it as an operand too
  flag,     ///< given or not: "yes", else empty
};

/// How far from 0 the numbers of a parameter may lie. 0 itself always may.
struct Sizes {
  double least = 0, most = std::numeric_limits<double>::max();
  bool hold(double x) const { return x == 0 || (least <= std::abs(x) && std::abs(x) <= most); }
  bool limited() const { return least > 0 || most < std::numeric_limits<double>::max(); }
};
/// "up to 1e150 in size", "0 or from 1e-75 to 1e75 in size".
std::string text_of(const Sizes& sizes);

struct Parameter {
  std::string name;  ///< as in the source; the flag is the same with hyphens
  ParameterType type;
  std::string default_value;  ///< canonical; empty: none
  std::string example;        ///< a value to paste
  std::string help;           ///< one line: meaning and unit
  /// For numbers: the range, both included; for pictures: `most` pixels.
  std::int64_t least = INT32_MIN, most = INT32_MAX;
  std::vector<std::string> choices{};
  std::vector<std::string> parts{};  ///< names of the numbers of a point or of bounds: x, y, z
  std::string instead_of{};  ///< the parameter whose default gives way when this one is given; never both
  bool numbered = false;     ///< for an order: it may be one of the numbers from 1 on, for what has no names
  Sizes sizes{};             ///< of real numbers, each for itself; methods may take less
  std::string Notation::* noted = nullptr;  ///< what a reader's notation has in the place of the default
};

enum class Standing { plain, taught, fast, faulty };
/// A whole number of which a method takes less than others.
struct AtMost {
  std::string parameter;
  std::int64_t most;
};
/// The same for real numbers.
struct SizesOf {
  std::string parameter;
  Sizes sizes;
};

class Narrator;
/// A way to do what the topic does, and all that is known of it before it runs.
struct Method {
  std::string name, title{};
  Standing standing = Standing::plain;
  std::string note{};  ///< one line; for a faulty one: what is wrong with it

  void (*tell)(Narrator&) = nullptr;  ///< runs it and tells its steps
  std::string function{};             ///< what is listed; without it, the function of the method's name
  std::string file{};  ///< where that is in the topic's folder; without it, the topic's header, or its notes
  std::vector<std::string> without{};                   ///< parameters it lacks
  std::string why_without = "it walks to every pixel";  ///< may be empty
  std::vector<AtMost> within{};
  std::vector<SizesOf> sizes{};
  std::vector<std::string> unread{};  ///< parameters that it takes no notice of: its traces don't name them
  bool of_columns = false;            ///< its vectors are columns in every notation
  bool exact = false;                 ///< its numbers can be told in three arithmetics side by side
  /// Names of parameters and their texts: what it starts with where no input is given and the defaults would
  /// not show what it is good for, or what is wrong with it.
  std::vector<std::pair<std::string, std::string>> opening{};
};

/// All of several things, each once: their positions among the choices, or, `numbered`, among 1, 2, 3, …
struct Order {
  std::vector<std::size_t> places{};
  bool numbered = false;
};

/// What an argument was read as, by its parameter's type. Nothing where none was given, and where the text is
/// all there is to it: a choice, a paint's letter, a file's name, the rows of a maze.
using ArgumentValue = std::variant<std::monostate,
                                   bool,                             // flag
                                   std::int64_t,                     // integer
                                   ivec2,                            // cell
                                   Window,                           // window
                                   Rgba8,                            // color, paint
                                   Number,                           // number
                                   Tuple,                            // numbers, bounds
                                   std::vector<Tuple>,               // points
                                   std::vector<std::vector<Tuple>>,  // rings
                                   Order,                            // order
                                   std::vector<FaceText>,            // faces
                                   std::vector<FactorText>>;         // factors

/// Whether the sizes hold each real number of a value.
bool all_hold(const Sizes& sizes, const ArgumentValue& value);

/// The arguments of a run, complete (defaults filled in), each read once. Files have already been read, too.
class Arguments {
 public:
  struct Entry {
    std::string name;
    std::string text;                      ///< canonical spelling
    ArgumentValue value{};                 ///< what that says (see read_argument)
    std::shared_ptr<const Image> image{};  ///< picture parameters: what the file holds; copies share it
    std::string content{};  ///< mazes: the rows, one per line, wherever they came from; models: the file
    std::map<std::string, std::string> libraries{};  ///< models: what the material files it names hold
    std::string hash{};                              ///< of the file's bytes, where the value is a file
    bool quotable = true;                            ///< whether messages may show what stands in that file
    bool given = false;                              ///< rather than a default
  };
  void set(Entry entry);
  bool has(std::string_view name) const;
  const Entry& entry(std::string_view name) const;
  const std::string& text(std::string_view name) const { return entry(name).text; }
  ivec2 cell(std::string_view name) const;
  /// Nothing where none was given.
  std::optional<Window> window(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  /// Nothing where none was given.
  std::optional<double> number(std::string_view name) const;
  /// Of a parameter of type numbers or bounds; empty where none was given.
  std::vector<double> numbers(std::string_view name) const;
  /// Three numbers as a point of space; nothing where none was given.
  std::optional<dvec3> place(std::string_view name) const;
  /// Points of two numbers; empty where none was given.
  std::vector<dvec2> points(std::string_view name) const;
  /// Points of as many numbers as the parameter has parts; empty where none was given.
  std::vector<Tuple> tuples(std::string_view name) const;
  /// Points of three numbers; empty where none was given.
  std::vector<dvec3> places(std::string_view name) const;
  /// Lists of points of two numbers; empty where none was given.
  std::vector<std::vector<dvec2>> rings(std::string_view name) const;
  /// Empty where none were given.
  std::vector<NamedFace> faces(std::string_view name) const;
  /// For each place in the order wanted, the position among the parameter's choices.
  std::vector<std::size_t> order(std::string_view name) const;
  /// The same where the order is one of numbers, 1 at position 0; nothing where it is one of choices.
  std::optional<std::vector<std::size_t>> numbered_order(std::string_view name) const;
  std::vector<FactorText> factors(std::string_view name) const;
  Rgba8 color(std::string_view name) const;
  /// Whether a flag was given; false if the topic has no such flag.
  bool flag(std::string_view name) const { return has(name) && text(name) == "yes"; }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  template <class T>
  const T& value(std::string_view name, std::string_view kind) const;
  template <class T>
  const T* value_if_given(std::string_view name, std::string_view kind) const;

  std::vector<Entry> entries_;  ///< in the order of the topic's parameters; "method" first
};

/// Ends a run that can't be with these arguments. What was expected is said of the first of the parameters
/// that was given, because a default is never the mistake.
[[noreturn]] void refuse(const Arguments& arguments, std::initializer_list<std::string_view> parameters,
                         const std::string& what_was_expected);

/// The same for one parameter.
[[noreturn]] void refuse(std::string_view parameter, const std::string& what_was_expected);
template <class First, class... Rest>
[[noreturn]] void refuse(std::string_view parameter, fmt::format_string<First, Rest...> format, First&& first,
                         Rest&&... rest) {
  refuse(parameter, fmt::format(format, std::forward<First>(first), std::forward<Rest>(rest)...));
}

/// Refuses a parameter's numbers beyond these sizes, for the sake of a method that takes less than others.
void require_sizes(const Arguments& arguments, std::string_view parameter, const Sizes& sizes);

/// Reads one argument as the user wrote it: "(3, 4)" is the cell 3,4 with the canonical spelling "3,4".
/// Throws ArgumentError saying what was expected and what was found. Does not read files.
Arguments::Entry read_argument(const Parameter& parameter, std::string_view text);
/// The canonical spelling alone.
std::string canonical(const Parameter& parameter, std::string_view text);

/// Whether a maze argument is the rows themselves, with "/" or line ends between them, rather than a file's
/// name: a maze's characters alone, and either a wall among them or rows of one length.
bool is_maze_rows(std::string_view text);

struct Checking;  // stories/checking.hpp

struct TopicEntry {
  std::string name, title{}, chapter;  ///< "bresenham_line", "Bresenham line", "scan_conversion"
  std::vector<std::string> aliases{};
  std::string summary;  ///< one line for `list`
  std::vector<Method> methods;
  std::string default_method{};
  std::vector<Column> columns{};  ///< of the methods that name none of their own
  /// Types of steps by whose number runs are compared, the first ones first: "<topic>.counts.<type>" says it.
  std::vector<std::string> counts{};
  std::vector<Parameter> parameters;
  std::vector<std::string> examples;  ///< three argument lists to paste: "--from 0,0 --to 7,3"
  Trace (*run)(const Arguments&, Recording) = nullptr;
  /// What judges others' answers knows of this topic besides; nullptr: nothing.
  const Checking* checking = nullptr;
};

/// Every topic there is, by chapter, then name.
std::span<const TopicEntry* const> catalogue();

/// The topic of exactly this name, or nullptr.
const TopicEntry* find_entry(std::string_view name);

/// The topic's parameter that is a model, if it has one: what commands take as an operand.
const Parameter* model_of(const TopicEntry& topic);

/// The topic's arguments: those given, canonical, and the defaults of all others. Reads no files: a maze is
/// given as rows joined by "/". Throws ArgumentError for an unknown name or a wrong value.
Arguments arguments_of(const TopicEntry& topic, std::span<const Argument> given);

/// Runs a topic on these arguments: arguments_of, then topic.run.
Trace trace_of(const TopicEntry& topic, std::initializer_list<Argument> given = {}, Recording recording = {});

/// A small model that comes with the project, by its file's name: "letter_f.obj", "letter_f.mtl". Empty for
/// one that doesn't.
std::string_view shipped_model(std::string_view name);

/// A source file of the catalogue as the build saw it, by its path from the project's root.
std::string_view source_text(std::string_view path);

/// The shown lines of a function in a source file: its body without the plumbing (observers, expects,
/// template heads), real line numbers, the function's own indentation removed.
std::vector<SourceLine> listing_of(std::string_view source, std::string_view function);
/// The lines that a fault strikes out of the taught function's body: in its source they are comments //- and
/// those that come instead end in //+.
std::vector<SourceLine> struck_of(std::string_view source, std::string_view function);

}  // namespace gradus
