#include "stories/telling.hpp"

#include <algorithm>
#include <iterator>

#include "core/mesh.hpp"
#include "figure/which_steps.hpp"
#include "stories/handles.hpp"
#include "stories/listing.hpp"

namespace gradus {
namespace {

Said said(const Value& value) {
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const double* real = std::get_if<double>(&value)) return *real;
  if (const ivec2* pixel = std::get_if<ivec2>(&value)) return *pixel;
  return std::get<std::string>(value);
}

/// The cells of a row, empty ones behind those that are said.
Row row_of(std::vector<Said> cells, std::size_t columns) {
  Row row;
  if (cells.empty()) return row;
  for (Said& cell : cells) row.push_back(std::move(cell.text));
  row.resize(columns);
  return row;
}

std::string usual_phase(const Words& words, const Event& event) {
  return words.shared("words", event.begins ? "set_up" : event.ends ? "result" : "main_loop");
}

const Method& method_of(const TopicEntry& topic, const Arguments& arguments) {
  const auto found = std::ranges::find(topic.methods, arguments.text("method"), &Method::name);
  if (found == topic.methods.end()) refuse("method", "a method of {} expected", topic.name);
  return *found;
}

/// Refuses what the method lacks, or takes less of than others do.
void require(const Method& method, const Arguments& arguments) {
  for (const std::string& name : method.without) {
    if (arguments.has(name) && !arguments.text(name).empty())
      refuse(name, "method {} takes none{}{}", method.name, method.why_without.empty() ? "" : ": ",
             method.why_without);
  }
  for (const AtMost& limit : method.within) {
    const std::int64_t found = arguments.integer(limit.parameter);
    if (found > limit.most) {
      refuse(limit.parameter, "method {} is watched from its start, so at most {}, found {}", method.name,
             limit.most, found);
    }
  }
  for (const SizesOf& sizes : method.sizes) require_sizes(arguments, sizes.parameter, sizes.sizes);
}

/// Of some methods alone the numbers are told in float, double and exact arithmetic side by side.
void require_exact(const TopicEntry& topic, const Method& method, const Arguments& arguments) {
  if (method.exact || !arguments.flag("exact")) return;
  std::vector<std::string_view> names;
  for (const Method& other : topic.methods) {
    if (other.exact) names.push_back(other.name);
  }
  refuse("exact", "expected one of the methods {} with it, found {}", fmt::join(names, ", "), method.name);
}

/// Told in the reader's words for this method of the topic.
Recording about(const TopicEntry& topic, const Method& method, Recording recording) {
  Notation notation = recording.wording.notation();
  notation.rows = notation.rows && !method.of_columns;
  recording.wording = recording.wording.with(std::move(notation)).about(topic.name);
  return recording;
}

}  // namespace

// --- Words

std::string Words::of(std::string_view section, std::string_view key, std::span<const Word> words) const {
  std::vector<NamedText> values;
  values.reserve(words.size());
  for (const Word& word : words) values.push_back({std::string(word.name), word.said.text});
  return wording_.fill(fmt::format("{}.{}", section, key), values);
}

std::string Words::counted(std::string_view key, std::int64_t n, std::span<const Word> words) const {
  std::vector<Word> all(words.begin(), words.end());
  all.push_back({"n", fmt::format("{}", n)});
  return of(topic_, fmt::format("{}.{}", key, n == 1 ? "one" : "many"), all);
}

std::string Words::heading(std::string_view key, std::span<const Word> words) const {
  for (const std::size_t end : {key.size(), key.find('.')}) {
    if (end == key.npos) continue;
    const std::string text = fmt::format("panel.{}", key.substr(0, end));
    if (wording_.has(fmt::format("{}.{}", topic_, text))) return say(text, words);
  }
  return "";
}

Decision yes_or_no(const Words& words, std::string_view question, std::initializer_list<Word> values,
                   bool yes, std::string_view if_yes, std::string_view if_no) {
  return {words.say(question, values),
          {words.shared("words", "yes"), words.shared("words", "no")},
          yes ? 0u : 1u,
          std::string(yes ? if_yes : if_no)};
}

// --- The board

void Board::clear() {
  for (const ivec2 p : pointed_) {
    delta_.cells.push_back({p, std::nullopt});
    if (plotted_.contains(key_of(p))) delta_.cells.push_back({p, CellLook{Role::past, ""}});
  }
  pointed_.clear();
  delta_.removed = std::move(marks_);
  marks_.clear();
}

void Board::milestone(ivec2 focus) {
  detail(focus);
  kind_ = Kind::milestone;
  for (const ivec2 p : fresh_) delta_.cells.push_back({p, CellLook{Role::past, ""}});
  fresh_.clear();
}

void Board::detail(ivec2 focus) {
  kind_ = Kind::detail;
  focus_ = focus;
  clear();
}

void Board::milestone(View view) {
  milestone();
  draw(std::move(view));
}

void Board::detail(View view) {
  detail();
  draw(std::move(view));
}

void Board::plot(ivec2 pixel, Role role) {
  delta_.cells.push_back({pixel, CellLook{role, ""}});
  fresh_.push_back(pixel);
  if (plotted_.insert(key_of(pixel)).second) writer_.trace().pixels.push_back(pixel);
}

void Board::all_plotted(Role role) {
  for (const ivec2 p : writer_.trace().pixels) delta_.cells.push_back({p, CellLook{role, ""}});
  fresh_.clear();
}

std::int64_t Board::plotted() const { return static_cast<std::int64_t>(writer_.trace().pixels.size()); }

ivec2 Board::last_plotted(ivec2 without) const {
  const auto& pixels = writer_.trace().pixels;
  return pixels.empty() ? without : pixels.back();
}

bool Board::holds(dvec2 point) const {
  const Window& cells = writer_.trace().grid.cells;
  return cells.lower.x <= point.x && point.x <= cells.upper.x && cells.lower.y <= point.y &&
         point.y <= cells.upper.y;
}

void Board::put(ivec2 cell, Role role, std::string text, std::optional<Rgba8> color) {
  delta_.cells.push_back({cell, CellLook{role, std::move(text), color}});
}

void Board::look_at(ivec2 pixel, Role role, std::optional<Rgba8> color) {
  pointed_.push_back(pixel);
  delta_.cells.push_back({pixel, CellLook{role, "", color}});
}

void Board::mark(std::string id, Role role, decltype(Mark::shape) shape) {
  marks_.push_back(id);
  keep(std::move(id), role, std::move(shape));
}

void Board::keep(std::string id, Role role, decltype(Mark::shape) shape) {
  delta_.set.push_back({std::move(id), role, std::move(shape)});
}

// --- The narrator

Narrator::Narrator(const TopicEntry& topic, const Arguments& arguments, Recording recording)
    : arguments_(arguments),
      recording_(about(topic, method_of(topic, arguments), std::move(recording))),
      topic_(topic),
      method_(method_of(topic, arguments)),
      writer_(recording_),
      words_(writer_.wording(), topic.name),
      board_(writer_),
      counted_(topic.counts.size()) {
  introduce(trace(), topic.name, arguments, method_.standing == Standing::faulty);
  std::erase_if(trace().arguments,
                [&](const Argument& a) { return std::ranges::count(method_.unread, a.name) > 0; });
  trace().columns = topic.columns;
  list(method_.function.empty() ? method_.name : method_.function);
}

void Narrator::in_the_code(std::string_view key, std::initializer_list<Word> words) {
  std::vector<NamedText> values;
  for (const Word& word : words) values.push_back({std::string(word.name), word.said.text});
  trace().in_the_code.push_back(words_.wording().fill(key, values));
}

void Narrator::grid(const Window& cells) {
  trace().grid.cells = cells;
  trace().grid.y_up = true;
  trace().grid.x_name = words_.symbol("x");
  trace().grid.y_name = words_.symbol("y");
}

void Narrator::whole_grid(const Window& cells, bool y_up) {
  grid(cells);
  trace().grid.whole = true;
  trace().grid.axes = false;
  trace().grid.y_up = y_up;
}

void Narrator::paper(int width, int height) { trace().grid = paper_grid(width, height); }

void Narrator::retitle(std::string_view key) {
  trace().method_title = words_.say(key, {{"method", trace().method_title}});
}

void Narrator::legend(std::initializer_list<LegendKey> entries) {
  trace().legend.clear();
  for (const auto& [role, key] : entries) add_to_legend(role, key);
}

void Narrator::add_to_legend(Role role, std::string_view key) {
  trace().legend.push_back({role, words_.say(fmt::format("legend.{}", key))});
}

void Narrator::backdrop(std::string id, Role role, decltype(Mark::shape) shape) {
  trace().backdrop.push_back({std::move(id), role, std::move(shape)});
}

void Narrator::add_handles(std::string_view parameter, int dimensions, const PlaceOnPaper& at,
                           std::optional<double> step) {
  if (!arguments_.has(parameter)) return;  // of what is not given there may be no entry
  const auto declared = std::ranges::find(topic_.parameters, parameter, &Parameter::name);
  const bool bounds = declared->type == ParameterType::bounds;
  for (Handle& handle : handles_of(arguments_.entry(parameter), dimensions, bounds, at, step))
    trace().handles.push_back(std::move(handle));
}

void Narrator::handle(std::string_view parameter, int number, dvec2 at, dvec2 along) {
  trace().handles.push_back({std::string(parameter), {number}, at, {along}});
}

void Narrator::list(std::string_view function, std::string_view file) {
  std::string name = topic_.name + (method_.standing == Standing::faulty ? "_notes.hpp" : ".hpp");
  if (!method_.file.empty()) name = method_.file;
  if (!file.empty()) name = file;
  const bool from_root = name.find('/') != std::string::npos;
  trace().source_file =
      from_root ? name : fmt::format("algorithms/{}/{}/{}", topic_.chapter, topic_.name, name);
  trace().listing.clear();
  trace().struck.clear();
  listed_.clear();
  list_below(function);
}

void Narrator::list_below(std::string_view function) {
  const std::string_view source = source_text(trace().source_file);
  std::vector<SourceLine>& listing = trace().listing;
  // Of several functions each has its heading, the first one from when there is a second
  if (listed_.size() == 1) {
    if (const auto heading = heading_of(source, first_listed_)) listing.insert(listing.begin(), *heading);
  }
  if (listed_.empty())
    first_listed_ = function;
  else if (const auto heading = heading_of(source, function))
    listing.push_back(*heading);
  listed_.push_back(body_of(source, function));
  std::ranges::move(listing_of(source, function), std::back_inserter(listing));
  std::ranges::move(struck_of(source, function), std::back_inserter(trace().struck));
}

void Narrator::tell_listed(std::string_view type, int line, std::string_view file, Saying say) {
  const bool by_story = file.find("visualize/") != std::string_view::npos;
  tell(type, by_story || file.ends_with(trace().source_file) ? line : 0, say);
}

int Narrator::marked_line(int line) {
  const std::vector<SourceLine>& all = trace().listing;
  for (const auto& [first, last] : listed_) {
    if (line < first || line > last) continue;
    const auto begin =
        std::ranges::find_if(all, [&](const SourceLine& l) { return l.number >= first && l.number <= last; });
    const auto end = std::find_if(begin, all.end(),
                                  [&](const SourceLine& l) { return l.number < first || l.number > last; });
    return line_that_ran({begin, end}, line);
  }
  return 0;
}

void Narrator::count(std::string_view type) {
  const auto found = std::ranges::find(topic_.counts, type);
  if (found != topic_.counts.end()) ++counted_[static_cast<std::size_t>(found - topic_.counts.begin())];
}

std::vector<std::string> Narrator::counts() const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < counted_.size(); ++i) {
    if (counted_[i] > 0) texts.push_back(words_.say("counts." + topic_.counts[i], {{"n", counted_[i]}}));
  }
  return texts;
}

void Narrator::tell(std::string_view type, int line, Saying say) {
  line_ = line;
  count(type);
  const auto describe = [&](TraceStep& step) { this->describe(step, type, say()); };
  const Board::Kind kind = std::exchange(board_.kind_, Board::Kind::none);
  Delta delta = std::exchange(board_.delta_, {});
  if (kind == Board::Kind::milestone) writer_.step(std::move(delta), board_.focus_, line, describe);
  if (kind == Board::Kind::detail) writer_.fine(std::move(delta), board_.focus_, line, describe);
  const double tells = std::exchange(board_.tells_, 0);
  if (!(tells > tells_most_)) return;
  tells_most_ = tells;
  telling_ = writer_.number();
}

void Narrator::describe(TraceStep& step, std::string_view type, Event event) {
  step.type = event.type.empty() ? type : event.type;
  step.line = event.line.value_or(step.line);
  event.begins = event.begins || type == "Started";
  event.ends = event.ends || type == "Finished";
  step.phase = event.phase.empty() ? usual_phase(words_, event) : std::move(event.phase);
  step.key = std::move(event.key);
  if (event.level || event.ends) step.level = event.level.value_or(Level::idea);
  if (event.text.empty()) {
    step.sentence = std::move(event.sentence);
  } else {
    std::vector<Word> words = std::move(event.words);
    for (const Field& fact : event.facts) {
      if (std::ranges::find(words, fact.name, &Word::name) == words.end())
        words.push_back({fact.name, said(fact.value)});
    }
    step.sentence =
        event.count ? words_.counted(event.text, *event.count, words) : words_.say(event.text, words);
    if (event.note.empty()) event.note = words_.heading(event.text, words);
  }
  step.note = std::move(event.note);
  step.decision = std::move(event.decides);
  step.read = row_of(std::move(event.read), trace().columns.size());
  step.row = row_of(std::move(event.row), trace().columns.size());
  step.fields = std::move(event.facts);
  step.tells = board_.tells_;
  if (key_by_type_ && step.key.empty()) step.key = type;
}

void Narrator::result(std::span<const dvec3> points, const Faces& faces) {
  trace().mesh = std::make_shared<const PolygonMesh>(PolygonMesh{{points.begin(), points.end()}, faces});
}

Trace Narrator::finish() && {
  for (TraceStep& step : trace().steps) step.line = marked_line(step.line);
  Trace trace = std::move(writer_).finish();
  trace.telling = telling_ ? *telling_ : telling_step(trace);
  trace.result = std::move(result_);
  trace.counts = counts();
  if (afterwards_) afterwards_(trace);
  return trace;
}

Trace tell(const TopicEntry& topic, const Arguments& arguments, Recording recording) {
  const Method& method = method_of(topic, arguments);
  require(method, arguments);
  require_exact(topic, method, arguments);
  Narrator narrator(topic, arguments, std::move(recording));
  method.tell(narrator);
  return std::move(narrator).finish();
}

void complete_texts(TopicEntry& topic) {
  const Wording english;
  topic.title = english.say(topic.name + ".title");
  for (Method& method : topic.methods) {
    method.title = english.say(fmt::format("{}.method.{}", topic.name, method.name));
    method.note = english.say(fmt::format("{}.note.{}", topic.name, method.name));
  }
  if (topic.default_method.empty()) topic.default_method = topic.methods.front().name;
}

}  // namespace gradus
