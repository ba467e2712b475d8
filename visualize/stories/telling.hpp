#pragma once
// Telling a run: what all stories do alike, once. Of each step a story says what changes in the drawing
// (`show`, for every step) and what is to be told (`say`, for the steps that are kept).
//
//   class Story {
//    public:
//     void show(Board& board, const Stepped& s);  // one of milestone, detail or neither; then what is drawn
//     Event say(const Stepped& s) const;
//   };
//   decision_parameter(from, to, drop, narrator.watcher(story));
//
// With it comes what stories are written with: topics, words, paper, strings, containers and algorithms.

#include <algorithm>
#include <array>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/faces.hpp"
#include "figure/recording.hpp"
#include "stories/paper.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus {

/// A value as the reader sees it: whole numbers with the typographic minus, real ones with four digits or so,
/// points in brackets, texts as they are.
struct Said {
  std::string text;

  Said(std::string words) : text(std::move(words)) {}
  Said(std::string_view words) : text(words) {}
  Said(const char* words) : text(words) {}
  template <std::integral Whole>
  Said(Whole number) : text(figure_number(static_cast<std::int64_t>(number))) {}
  Said(bool) = delete;
  Said(double number) : text(figure_real(number)) {}
  Said(ivec2 pixel) : text(figure_point(pixel)) {}
  Said(dvec2 place) : text(figure_place(place)) {}
  Said(dvec3 place) : text(figure_place(place)) {}
  Said(glm::dvec4 place) : text(figure_place(place)) {}
};

/// A value under the name by which a sentence's text asks for it: {name}.
struct Word {
  std::string_view name;
  Said said;
};

/// The texts of one topic in the reader's language: `say("started")` is the text "<topic>.started".
class Words {
 public:
  Words(const Wording& wording, std::string topic) : wording_(wording), topic_(std::move(topic)) {}

  std::string say(std::string_view key, std::initializer_list<Word> words = {}) const {
    return of(topic_, key, {words.begin(), words.size()});
  }
  std::string say(std::string_view key, std::span<const Word> words) const { return of(topic_, key, words); }
  /// "<key>.one" for 1, "<key>.many" for all others; {n} is the number.
  std::string count(std::string_view key, std::int64_t n, std::initializer_list<Word> words = {}) const {
    return counted(key, n, {words.begin(), words.size()});
  }
  std::string counted(std::string_view key, std::int64_t n, std::span<const Word> words) const;
  /// A text of a section that several topics share: shared("words", "yes").
  std::string shared(std::string_view section, std::string_view key,
                     std::initializer_list<Word> words = {}) const {
    return of(section, key, {words.begin(), words.size()});
  }
  /// What heads the picture of a step that is told by this key: the topic's text "panel.<key>", or of the
  /// part before its first dot. Empty: there is none.
  std::string heading(std::string_view key, std::span<const Word> words) const;
  /// What the reader calls this symbol.
  std::string symbol(std::string_view name) const { return wording_.symbol(name); }
  /// The same of an axis: x, y, z, w.
  std::string axis(int number) const {
    return symbol(std::string_view("xyzw").substr(static_cast<std::size_t>(number), 1));
  }
  /// What the reader calls a move to a neighbouring pixel: "NE".
  std::string move(ivec2 move) const { return move_name(wording_, move); }
  const Wording& wording() const { return wording_; }
  const Notation& notation() const { return wording_.notation(); }

 private:
  std::string of(std::string_view section, std::string_view key, std::span<const Word> words) const;

  const Wording& wording_;
  std::string topic_;
};

/// The key of a text, also one that is put together.
struct TextKey : std::string {
  TextKey() = default;
  TextKey(const char* key) : std::string(key) {}
  TextKey(std::string_view key) : std::string(key) {}
  TextKey(std::string key) : std::string(std::move(key)) {}
};

/// What is told of one step. Sentences may take the words and the facts; of one name, the word.
struct Event {
  TextKey text{};                       ///< the sentence's key in the topic's section, written out
  std::vector<Field> facts{};           ///< the step's data, for programs
  std::vector<Word> words{};            ///< what the sentence needs besides
  std::optional<std::int64_t> count{};  ///< the sentence is that of a number: "<text>.one", "<text>.many"
  std::string sentence{};               ///< a sentence that is put together; then there is no text
  std::string note{};        ///< its effect in two or three words: "8 → 9 corners"; else Words::heading
  std::vector<Said> row{};   ///< the row that the step produced, from the first column on
  std::vector<Said> read{};  ///< the last row, completed
  std::string key{};         ///< what it is about: "4,2" for a pixel
  std::string phase{};       ///< without it: set up for Started, result for Finished, main loop for others
  bool begins = false, ends = false;  ///< then it is told as Started and Finished are, for any type
  std::optional<Level> level{};       ///< without it: a step, arithmetic for a detail, idea for Finished
  std::optional<Decision> decides{};  ///< what this step decides, if it does
  std::string_view type{};            ///< the type it is told as, where that is not the step's own
  std::optional<int> line{};          ///< the source line to show, where the step's own is not listed
};

/// What says an event once it is asked for; it must outlive this. A std::function has more code, and that for
/// each of many hundred kinds of steps.
class Saying {
 public:
  template <std::invocable Say>
  Saying(const Say& say)
      : say_(&say), call_([](const void* it) -> Event { return (*static_cast<const Say*>(it))(); }) {}
  Event operator()() const { return call_(say_); }

 private:
  const void* say_;
  Event (*call_)(const void*);
};

/// A point's coordinates as facts: x, y, z, w.
template <int N>
std::vector<Field> fields_of(const glm::vec<N, double>& p) {
  std::vector<Field> fields;
  for (int i = 0; i < N; ++i) fields.push_back({std::string(1, "xyzw"[i]), p[i]});
  return fields;
}

/// What is decided by yes or no, and the branch that follows.
Decision yes_or_no(const Words& words, std::string_view question, std::initializer_list<Word> values,
                   bool yes, std::string_view if_yes, std::string_view if_no = {});

/// Steps of the run as a whole, for stories of algorithms that report none: told without a source line.
namespace steps {
struct Started {};
struct Finished {};
}  // namespace steps

/// The drawing, and how long what is drawn stays: what an event points at goes with the next one; a pixel
/// that was plotted is a past one from the next milestone on. On paper the whole drawing is given instead.
class Board {
 public:
  explicit Board(TraceWriter& writer) : writer_(writer) {}

  /// The event that is shown is the next whole number, or a finer one behind it. Neither: nothing is told.
  void milestone(ivec2 focus = {});
  void detail(ivec2 focus = {});
  /// The next milestone gets this number: those before are not told.
  void skip_to(std::int64_t number) { writer_.skip_to(number); }
  /// Whether nothing more is kept: milestones are only counted from now on.
  bool full() const { return writer_.full(); }
  void count_milestone() { writer_.count_step(); }

  // On a grid

  void plot(ivec2 pixel, Role role);
  void all_plotted(Role role);
  /// Pixels plotted so far, each once; the last one of them.
  std::int64_t plotted() const;
  ivec2 last_plotted(ivec2 without) const;
  /// Whether the grid's cells reach as far.
  bool holds(dvec2 point) const;
  /// From now on the cell looks so, and is no pixel that was plotted.
  void put(ivec2 cell, Role role, std::string text = "", std::optional<Rgba8> color = {});
  /// From now on nothing is in the cell.
  void bare(ivec2 cell) { delta_.cells.push_back({cell, std::nullopt}); }
  /// For this event alone the cell looks so; then as before.
  void look_at(ivec2 pixel, Role role, std::optional<Rgba8> color = {});
  /// For this event alone.
  void mark(std::string id, Role role, decltype(Mark::shape) shape);
  /// How much the figure of this event tells: that of the run is the one that tells most, of equals the
  /// first.
  void tells(double how_much) { tells_ = how_much; }
  /// From now on, until it is removed.
  void keep(std::string id, Role role, decltype(Mark::shape) shape);
  void remove(std::string id) { delta_.removed.push_back(std::move(id)); }

  // On paper

  /// The whole drawing from now on.
  void draw(View view) { delta_ = shown_.change_to(std::move(view)); }
  /// The event that shows this drawing.
  void milestone(View view);
  void detail(View view);

 private:
  friend class Narrator;
  enum class Kind { none, milestone, detail };
  void clear();

  TraceWriter& writer_;
  Kind kind_ = Kind::none;
  ivec2 focus_{};
  double tells_ = 0;
  Delta delta_;
  std::vector<std::string> marks_;      ///< of the last event
  std::vector<ivec2> pointed_, fresh_;  ///< cells that will look otherwise with the next event, or milestone
  std::unordered_set<std::uint64_t> plotted_;
  Shown shown_;
};

/// A role of the drawing and the key of what it stands for: the text "<topic>.legend.<key>".
struct LegendKey {
  LegendKey(Role its_role) : LegendKey(its_role, name_of(its_role)) {}
  LegendKey(Role its_role, std::string_view its_key) : role(its_role), key(its_key) {}

  Role role;
  std::string_view key;
};

/// Where a drawing shows a point of its input, if it does. Coordinates that it lacks are 0.
using PlaceOnPaper = std::function<std::optional<dvec2>(const glm::dvec4&)>;

/// A drawing whose coordinates are those of its input.
inline constexpr auto as_it_is = [](dvec2 p) { return p; };
/// The same, as far as these cells go.
inline auto as_it_is_in(const Window& cells) {
  return [cells](dvec2 p) {
    const bool shown = p == glm::clamp(p, dvec2(cells.lower) - 0.5, dvec2(cells.upper) + 0.5);
    return shown ? std::optional(p) : std::nullopt;
  };
}

/// A panel of the paper, as far as it shows the plane; it must outlive this.
inline auto shown_in(const Panel& panel) {
  return [&panel](dvec2 p) { return panel.shown_at(p); };
}

/// One run of one method, told.
class Narrator {
 public:
  Narrator(const TopicEntry& topic, const Arguments& arguments, Recording recording);
  Narrator(const Narrator&) = delete;
  Narrator& operator=(const Narrator&) = delete;

  const Arguments& arguments() const { return arguments_; }
  const Recording& recording() const { return recording_; }
  const Words& words() const { return words_; }
  const Method& method() const { return method_; }
  Board& board() { return board_; }
  /// What is said of the run as a whole; what has no function here is set there.
  Trace& trace() { return writer_.trace(); }

  /// Cells with the axes x and y, y up.
  void grid(const Window& cells);
  /// Cells without axes, all of which are always shown; pictures' rows count downwards.
  void whole_grid(const Window& cells, bool y_up = false);
  void paper(int width, int height);
  void columns(std::vector<Column> columns) { trace().columns = std::move(columns); }
  void subtitle(std::string_view key, std::initializer_list<Word> words) {
    trace().subtitle = words_.say(key, words);
  }
  /// The method's title becomes this text, which asks for {method}.
  void retitle(std::string_view key);
  /// The figure says once how the code has it, where it differs from the reader's notation: the text
  /// "notation.columns".
  void in_the_code(std::string_view key, std::initializer_list<Word> words = {});
  /// The same of a name that is no symbol of the topic: "u = right".
  void named_in_the_code(std::string name, std::string of_code) {
    trace().named_in_the_code.push_back({std::move(of_code), std::move(name)});
  }
  /// Its drawings or its table show matrices.
  void shows_matrices() {
    if (words_.notation().rows) in_the_code("notation.columns");
  }
  /// Its drawings or its table show depths after the projection; `before`: those of view space, too.
  void shows_depths(bool before = false) {
    if (before && words_.notation().looks_backward()) in_the_code("notation.forward");
    if (words_.notation().depth) in_the_code("notation.depth");
  }
  /// What has a colour of its own, the most important first; "" leaves a colour out. Without it: what
  /// decisions ask about.
  void quantities(std::vector<std::string> symbols) { trace().quantities = std::move(symbols); }
  void legend(std::initializer_list<LegendKey> entries);
  void add_to_legend(Role role, std::string_view key);
  /// Stands unchanged behind all steps.
  void backdrop(std::string id, Role role, decltype(Mark::shape) shape);
  /// The points of an argument can be dragged: of the plane, of space, or with a fourth number, where `at`
  /// draws them in step 0, if it draws them. Numbers that belong to no point are left out; see also `handle`.
  /// step: by how much a point is moved to measure what that does; 1 where the drawing has it on a grid.
  template <class At>
  void handles(std::string_view parameter, const At& at, std::optional<double> step = {}) {
    constexpr int dimensions = std::invocable<At, dvec2> ? 2 : std::invocable<At, dvec3> ? 3 : 4;
    add_handles(
        parameter, dimensions,
        [&at](const glm::dvec4& p) -> std::optional<dvec2> { return at(glm::vec<dimensions, double>(p)); },
        step);
  }
  /// One number can be dragged, counted from 0 as the argument's text has it: at this place of step 0's
  /// drawing, which goes `along` when the number grows by 1.
  void handle(std::string_view parameter, int number, dvec2 at, dvec2 along);
  /// The lines shown are another function's: of this file, in the topic's folder or by its path from the
  /// project's root, or of the method's own.
  void list(std::string_view function, std::string_view file = {});
  /// Below them those of another function of the same file.
  void list_below(std::string_view function);
  void result(std::vector<Field> fields) { result_ = std::move(fields); }
  /// The surface that the run has made: files of models take it.
  void result(std::span<const dvec3> points, const Faces& faces);
  /// The step whose figure tells most, if none of them says so itself. Without it: see telling_step.
  void telling(StepNumber number) { telling_ = number; }
  void skip_to(std::int64_t number) { writer_.skip_to(number); }
  /// Steps that name no key are about what their type says: on paper there is no pixel to name.
  void key_by_type() { key_by_type_ = true; }

  /// The observer for a method. `Story` has show(Board&, step) and say(step) for each of its steps, or is a
  /// Past with draw() and say(step); a forgotten one does not compile. It may have tells(step), too: how much
  /// that step's figure tells; and a story of very long runs count(Board&, step): what remains to be done of
  /// a step when the recording is full.
  template <class Story>
  auto watcher(Story& story) {
    return [this, &story]<class Step>(const Step& step, int line = __builtin_LINE(),
                                      const char* file = __builtin_FILE()) {
      this->tell(story, step, line, file);
    };
  }
  /// The same for what no step tells: an input, a whole curve.
  void tell(std::string_view type, int line, Saying say);
  /// A run between Started and Finished, of an algorithm that reports neither: run(observer).
  template <class Story, class Run>
  void tell_whole(Story& story, const Run& run) {
    const auto watch = watcher(story);
    watch(steps::Started{}, 0);
    run(watch);
    watch(steps::Finished{}, 0);
  }
  /// The same algorithm for many inputs: take(i, observer) for each of them after story.turn_to(i).
  template <class Story, class Take>
  void tell_each(Story& story, std::size_t count, const Take& take) {
    tell_whole(story, [&](const auto& watch) {
      for (std::size_t i = 0; i < count; ++i) {
        story.turn_to(i);
        take(i, watch);
      }
    });
  }
  /// The source line that reported the last step.
  int line() const { return line_; }
  /// The last one that is listed: where a run is done.
  int last_line() { return trace().listing.back().number; }

  /// What is done with the trace once all is told.
  void afterwards(std::function<void(Trace&)> change) { afterwards_ = std::move(change); }
  Trace finish() &&;

  /// "Stepped" of gradus::bresenham_line::Stepped, "Cut" of Cut<double>.
  template <class Step>
  static constexpr std::string_view step_name() {
    return {letters<Step>.data(), letters<Step>.size()};
  }

 private:
  template <class Story, class Step>
  void tell(Story& story, const Step& step, int line, const char* file) {
    if constexpr (requires { story.count(board_, step); }) {
      if (board_.full()) return story.count(board_, step);
    }
    if constexpr (requires { story.draw(); }) {
      story.take(step);
      if constexpr (Story::template is_finer<Step>)
        board_.detail(story.draw());
      else
        board_.milestone(story.draw());
    } else {
      story.show(board_, step);
    }
    if constexpr (requires { story.tells(step); }) board_.tells(story.tells(step));
    tell_listed(step_name<Step>(), line, file, [&] { return story.say(step); });
  }
  template <class Story, class Step>
    requires(Story::template is_untold<Step>)
  void tell(Story&, const Step&, int, const char*) {}
  static constexpr std::string_view name_in(std::string_view function) {
    std::string_view name = function.substr(function.find("Step = ") + 7);
    name = name.substr(0, name.find_first_of("<;],"));
    return name.substr(name.rfind(':') + 1);
  }
  template <class Step>
  static constexpr std::string_view found_name() {
    return name_in(__PRETTY_FUNCTION__);
  }
  /// The name alone: what the compiler calls the function is many times longer.
  template <class Step>
  static constexpr auto letters = [] {
    std::array<char, found_name<Step>().size()> all{};
    std::ranges::copy(found_name<Step>(), all.begin());
    return all;
  }();
  /// The same with the line at 0 where it is one of another file than the listed one. Lines that a story
  /// hands on it has looked up.
  void tell_listed(std::string_view type, int line, std::string_view file, Saying say);
  /// The line that is marked for a report from this one; 0 where it isn't in what is listed.
  int marked_line(int line);
  void count(std::string_view type);
  std::vector<std::string> counts() const;
  void describe(TraceStep& step, std::string_view type, Event event);
  void add_handles(std::string_view parameter, int dimensions, const PlaceOnPaper& at,
                   std::optional<double> step);

  const Arguments& arguments_;
  const Recording recording_;
  const TopicEntry& topic_;
  const Method& method_;
  TraceWriter writer_;
  const Words words_;
  Board board_;
  bool key_by_type_ = false;
  std::vector<Field> result_;
  std::vector<std::int64_t> counted_;  ///< of each type that the topic counts
  std::optional<StepNumber> telling_;
  double tells_most_ = 0;
  int line_ = 0;
  std::string first_listed_;                 ///< the first function in the listing
  std::vector<std::pair<int, int>> listed_;  ///< the source lines of the functions in the listing
  std::function<void(Trace&)> afterwards_;
};

/// Watches a run that is told as a whole: the source line that reports such a step.
template <class Noted>
struct LineOf {
  int line = 0;
  template <class Step>
  void operator()(const Step&, int at = __builtin_LINE(), const char* = nullptr) {
    if constexpr (std::same_as<Step, Noted>) line = at;
  }
};

/// Runs a topic: refuses what its method can't take, then has the method tell itself.
Trace tell(const TopicEntry& topic, const Arguments& arguments, Recording recording);

/// What stands in TopicEntry::run of a topic whose methods tell themselves.
template <const TopicEntry& (*entry)()>
Trace told(const Arguments& arguments, Recording recording) {
  return tell(entry(), arguments, std::move(recording));
}

/// Fills in what can be derived: the title and the methods' titles and notes from the English texts, and the
/// default method (the first).
void complete_texts(TopicEntry& topic);
/// The entry with all that, and with `run`.
template <const TopicEntry& (*entry)()>
TopicEntry completed(TopicEntry topic) {
  complete_texts(topic);
  topic.run = told<entry>;
  return topic;
}

}  // namespace gradus
