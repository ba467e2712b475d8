// The story of a z-buffer: which face each pixel shows, and why, polygon by polygon or row by row.

#include "visibility/z_buffer/z_buffer.hpp"

#include "stories/listing.hpp"
#include "stories/parameters.hpp"
#include "stories/rings.hpp"
#include "stories/visibility/z_buffer/section.hpp"
#include "stories/visibility/z_buffer/subject.hpp"
#include "visibility/z_buffer/z_buffer_notes.hpp"

namespace gradus::z_buffer {
namespace {

/// What the run is asked for besides its faces.
struct Look {
  bool rows = false;   ///< one line of depths: those of other rows are gone
  bool whole = false;  ///< colours are whole numbers
};

template <class T>
class Story {
 public:
  Story(const Words& words, const Subject& subject, DepthText<T> text, Look look, const Owners& right)
      : words_(words), subject_(subject), text_(text), look_(look), right_(right), section_(subject, words) {}

  /// The step that tells most: the first pixel of the last face that changes hands.
  std::optional<StepNumber> telling() const { return telling_; }
  /// How far apart depths must lie to be stored as two.
  void precision(double distance) { precision_ = distance; }
  /// What is marked where a pixel is compared: not the question about equal depths, which may be the last
  /// line before that is told.
  void comparing(int line) { comparing_ = line; }
  std::int64_t wrong() const { return std::ssize(wrong_); }

  void show(Board& board, const steps::Started&) {
    for (int y = 0; !look_.rows && y < subject_.size.y; ++y) clear_row(y);
    for (const Face& face : subject_.faces) keep_outline(name_of_outline(face.id), face.id, Role::guide);
    row_ = subject_.size.y / 2;
    next(board);
    if (!look_.rows) remove_outlines();
  }
  Event say(const steps::Started&) const {
    if (subject_.sight.eye) {
      const auto [n, f] = subject_.sight.distances();
      return {.text = "started_eye",
              .words = {{"eye", *subject_.sight.eye}, {"n", digits(n)}, {"f", digits(f)}}};
    }
    return {.text = look_.rows ? "started_rows" : "started",
            .words = {{"columns", subject_.size.x},
                      {"rows", subject_.size.y},
                      {"pixels", subject_.size.x * subject_.size.y}},
            .count = std::ssize(subject_.faces)};
  }

  void show(Board& board, const FaceTaken& f) {
    keep_outline("face", f.id, Role::input);
    row_ = std::clamp(static_cast<int>(middle_of(subject_.corners(f.id)).y), 0, subject_.size.y - 1);
    next(board, f.id);
  }
  Event say(const FaceTaken& f) const {
    Event event{.text = "edge_on", .facts = {{"face", subject_.name(f.id)}}, .key = subject_.name(f.id)};
    if (!f.plane) return event;
    const auto& plane = *f.plane;
    const bool level = plane.right == 0 && plane.down == 0;
    event.text = level ? "taken_level" : "taken_sloped";
    if (subject_.sight.eye) event.text = level ? "taken_level_eye" : "taken_sloped_eye";
    event.facts.insert(event.facts.end(), {{"right", plane.right}, {"down", plane.down}});
    event.words = {{"z", plane.nearest},
                   {"to", plane.farthest},
                   {"near", rounded(subject_.sight.z_of(plane.nearest))},
                   {"far", rounded(subject_.sight.z_of(plane.farthest))}};
    return event;
  }

  void show(Board& board, const Compared<T, Id>& c) {
    ++fine_;
    tested_ = c.key;
    const auto there = holder_.find(place(c.pixel));
    before_ = there == holder_.end() ? std::nullopt : std::optional(there->second);
    if (before_ && tells(c, c.nearer ? c.key : *before_)) {
      telling_ = {milestones_, fine_};
      told_ = c.key;
      told_row_ = c.pixel.y;
    }
    row_ = c.pixel.y;
    const std::string kept = text_(c.nearer ? c.depth : *c.before);
    put(c.pixel, Role::result, kept, fill(c.nearer ? c.key : *before_));
    const Role role = c.nearer ? Role::current : Role::rejected;
    View now = with_section(c.key, ": " + text_(c.depth) + "\u00a0" + relation(c));
    section_.add_comparison(now, c.pixel, c.key, before_, role);
    now.add({"a row", Role::candidate, row_box(row_)});
    now.add({"at", role, square(c.pixel)});
    if (c.nearer) holder_[place(c.pixel)] = c.key;
    board.detail(std::move(now));
  }
  Event say(const Compared<T, Id>& c) const {
    const std::string face = subject_.name(c.key), z = text_(c.depth);
    const std::string old = c.before ? text_(*c.before) : "∞";
    const std::string other = before_ ? subject_.name(*before_) : "";
    const bool tie = c.before && *c.before == c.depth;
    Event event{.text = !c.before  ? "free"
                        : tie      ? (c.nearer ? "tie_taken" : "tie_left")
                        : c.nearer ? "nearer"
                                   : "farther",
                .facts = {{"pixel", c.pixel}, {"face", face}, {"nearer", c.nearer}},
                .words = {{"other", other}, {"z", z}, {"old", old}},
                .row = {face, c.pixel.x, c.pixel.y, z, old, c.nearer ? face : other},
                .key = pixel_key(c.pixel),
                .level = Level::step};
    event.line = comparing_;
    add_places(event, c);
    if (look_.whole && c.nearer) {
      event.text = "whole";
      add(event, {{"colour", channels(subject_.color(c.key))}, {"rest", channels(fill(c.key))}});
    }
    if (before_ && !c.nearer && is_wrong(c.pixel, *before_)) {
      const double exact = z_at(c.key, c.pixel), held = z_at(*before_, c.pixel);
      event.text = exact == held ? "tie_wrong" : "fight";
      add(event, {{"exact", digits(exact)}, {"held", digits(held)}});
    }
    event.decides = yes_or_no(words_, tie ? "question.tie" : "question",
                              {{"z", z}, {"old", old}, {"face", face}, {"other", other}}, c.nearer,
                              c.before ? "nearer" : "free", tie ? "tie" : "farther");
    return event;
  }

  void show(Board& board, const FaceDone& f) {
    keep_outline("face", f.id, Role::input);
    next(board, f.id);
  }
  Event say(const FaceDone& f) const {
    return {.text = "face_done",
            .facts = {{"compared", f.compared}, {"kept", f.kept}},
            .words = {{"face", subject_.name(f.id)}, {"left", f.compared - f.kept}},
            .count = f.compared,
            .note = words_.say("note.face_done", {{"face", subject_.name(f.id)}}),
            .key = subject_.name(f.id),
            .level = Level::idea};
  }

  void show(Board& board, const RowBegun& r) {
    clear_row(r.y);
    view_.add({"row", Role::candidate, row_box(r.y)});
    row_ = r.y;
    next(board);
  }
  Event say(const RowBegun& r) const {
    return {.text = "row_begun",
            .facts = {{"row", r.y}},
            .words = {{"columns", subject_.size.x}},
            .key = figure_number(r.y)};
  }
  void show(Board& board, const RowDone& r) {
    for (int x = 0; x < subject_.size.x; ++x) {
      const auto there = holder_.find({x, r.y});
      if (there == holder_.end())
        view_.cells.erase({r.y, x});
      else
        put({x, r.y}, Role::result, "", fill(there->second));
    }
    view_.add({"row", Role::candidate, row_box(r.y)});
    row_ = r.y;
    next(board, subject_.faces.back().id);
  }
  Event say(const RowDone& r) const {
    return {.text = "row_done",
            .facts = {{"compared", r.compared}, {"kept", r.kept}},
            .words = {{"row", r.y}},
            .count = r.compared,
            .key = figure_number(r.y),
            .level = Level::idea};
  }

  void show(Board& board, const Finished&) {
    view_.marks.erase(look_.rows ? "row" : "face");
    remove_outlines();
    for (const auto& [at, id] : right_) {
      const auto there = holder_.find(at);
      if (there != holder_.end() && there->second == id) continue;
      const ivec2 pixel{at.first, at.second};
      wrong_.push_back(pixel);
      const dvec2 p = dvec2(pixel) + dvec2{0.32, -0.32}, down{0.1, 0.1}, up{0.1, -0.1};
      view_.add({fmt::format("wrong {}", pixel_key(pixel)), Role::measure, Stroke{p - down, p + down}});
      view_.add({fmt::format("wrong {} b", pixel_key(pixel)), Role::measure, Stroke{p - up, p + up}});
    }
    if (told_) row_ = told_row_;
    if (!wrong_.empty()) row_ = wrong_.front().y;
    board.detail(with_section(subject_.faces.back().id));
  }
  Event say(const Finished& f) const {
    Event event{.text = look_.whole       ? "finished_whole"
                        : !wrong_.empty() ? "finished_wrong"
                        : look_.rows      ? "finished_rows"
                                          : "finished",
                .facts = {{"compared", f.compared}, {"kept", f.kept}, {"bytes", f.bytes}},
                .words = {{"cell", sizeof(Cell<T, Id>)},
                          {"cells", f.bytes / std::int64_t{sizeof(Cell<T, Id>)}},
                          {"pixels", holder_.size()}},
                .count = wrong_.empty() ? f.compared : std::ssize(wrong_)};
    if constexpr (!std::same_as<T, double>) {
      event.text = wrong_.empty() ? "finished_precise" : "finished_fight";
      if (wrong_.empty()) event.count = std::ssize(holder_);
      event.words.push_back({"precision", precision_});
    }
    return event;
  }

 private:
  static void add(Event& event, std::initializer_list<Word> words) {
    event.words.insert(event.words.end(), words);
  }

  static std::pair<int, int> place(ivec2 p) { return {p.x, p.y}; }
  /// The next whole number.
  void next(Board& board, std::optional<Id> last = {}) {
    ++milestones_;
    fine_ = 0;
    board.milestone(with_section(last));
  }
  /// comparison: of two depths, after the section's name.
  View with_section(std::optional<Id> last, const std::string& comparison = "") const {
    View view = view_;
    section_.add_to(view, row_, last, holder_, words_.say("section", {{"row", row_}}) + comparison);
    return view;
  }
  void put(ivec2 p, Role role, std::string text, std::optional<Rgba8> color = {}) {
    view_.cells.insert_or_assign({p.y, p.x}, CellLook{role, std::move(text), color});
  }
  /// Whether this pixel tells more than those before: one that goes wrong, or else one that changes hands.
  bool tells(const Compared<T, Id>& c, Id shown) {
    if (is_wrong(c.pixel, shown)) return !std::exchange(told_wrong_, true);
    return c.nearer && !told_wrong_ && told_ != c.key;
  }
  /// Whether the pixel shows another face than it will in the end.
  bool is_wrong(ivec2 pixel, Id shown) const {
    const auto end = right_.find(place(pixel));
    return end != right_.end() && *before_ != end->second && shown != end->second && tested_ == end->second;
  }
  /// Where a face lies in space that a pixel shows.
  double z_at(Id id, ivec2 pixel) const {
    const auto face = std::ranges::find(subject_.faces, id, &Face::id);
    const auto plane = plane_of(*face);
    return plane ? subject_.sight.z_of(plane->at(pixel)) : 0;
  }
  /// Where the two faces of a pixel lie, for an eye that stores something else.
  void add_places(Event& event, const Compared<T, Id>& c) const {
    if (!subject_.sight.eye || !before_ || c.depth == *c.before) return;
    const double now = rounded(z_at(c.key, c.pixel)), held = rounded(z_at(*before_, c.pixel));
    if (now == held) return;
    event.text = c.nearer ? "nearer_eye" : "farther_eye";
    add(event, {{"now", now}, {"there", held}});
  }

  Rgba8 fill(Id id) const {
    const Rgba8 c = subject_.color(id);
    if (!look_.whole) return c;
    const auto whole = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel / 255 * 255); };
    return {whole(c.r), whole(c.g), whole(c.b), 255};
  }
  /// Red, green and blue from 0 to 1.
  static dvec3 channels(Rgba8 c) {
    const auto share = [](std::uint8_t channel) { return std::round(channel / 2.55) / 100; };
    return {share(c.r), share(c.g), share(c.b)};
  }
  /// How the new depth, which stands above, compares with the old one.
  std::string relation(const Compared<T, Id>& c) const {
    if (!c.before) return "< ∞";
    return (*c.before == c.depth ? "= " : c.depth < *c.before ? "< " : "> ") + text_(*c.before);
  }
  Path row_box(int y) const {
    return {Extent{{-0.5, y - 0.5}, {subject_.size.x - 0.5, y + 0.5}}.corners(), true};
  }
  void clear_row(int y) {
    for (int x = 0; x < subject_.size.x; ++x) put({x, y}, Role::guide, "∞");
  }
  static std::string name_of_outline(Id id) { return fmt::format("face {}", id.face); }
  void remove_outlines() {
    for (const Face& face : subject_.faces) view_.marks.erase(name_of_outline(face.id));
  }
  /// The face's border, within the picture.
  void keep_outline(std::string name, Id id, Role role) {
    std::vector<dvec2> ring;
    for (const dvec3& corner : subject_.corners(id)) ring.push_back(dvec2(corner) - 0.5);
    for (const int axis : {0, 1}) {
      ring = cut(ring, axis, 1, -0.5);
      ring = cut(ring, axis, -1, 0.5 - subject_.size[axis]);
    }
    if (ring.size() > 2) view_.add({std::move(name), role, Path{ring, true}});
  }

  const Words& words_;
  const Subject& subject_;
  const DepthText<T> text_;
  const Look look_;
  const Owners& right_;
  const Section section_;
  View view_{};
  Owners holder_;
  std::optional<Id> before_, tested_, told_;
  bool told_wrong_ = false;
  int row_ = 0, told_row_ = 0;  ///< of the section
  std::vector<ivec2> wrong_;
  std::int64_t milestones_ = -1;
  int fine_ = 0;
  std::optional<StepNumber> telling_;
  std::optional<int> comparing_;
  double precision_ = 0;
};

// --- The methods

/// What stands unchanged behind all steps. base: of the codes in the cells.
void set_scene(Narrator& narrator, const Subject& subject, std::int64_t base) {
  const Words& words = narrator.words();
  narrator.trace().subtitle =
      words.count(subject.sight.eye ? "subtitle_eye" : "subtitle", std::ssize(subject.faces),
                  {{"columns", subject.size.x}, {"rows", subject.size.y}});
  narrator.handles("faces", [&](dvec3 p) { return subject.shown_at(p); });
  // Room for numbers at the left and below, and for the section at the right
  const Extent section = Section::place_of(subject);
  narrator.whole_grid({{-4, -2}, ivec2(section.upper) + ivec2(6, 4)});
  add_pixel_grid(narrator, subject);
  narrator.legend({{Role::input, "input"},
                   {Role::candidate, "candidate"},
                   Role::accepted,
                   Role::current,
                   Role::rejected,
                   Role::measure});
  narrator.trace().legend.back().sample = Sample::cross;
  for (const Face& face : subject.faces) {
    narrator.trace().legend.push_back({Role::result, subject.name(face.id), {}, subject.color(face.id)});
  }
  if (base == 0) return;
  const std::string& depth = narrator.arguments().text("depth");
  narrator.trace().subtitle += words.say("codes." + depth, {{"base", base}});
}

template <class T, class Run>
void tell_walk(Narrator& narrator, const Subject& subject, auto store, Look look, const Run& run) {
  const DepthText<T> text(subject, store);
  set_scene(narrator, subject, text.base());
  const Owners right = right_of(subject);
  Story<T> story(narrator.words(), subject, text, look, right);
  story.precision(distance_between_codes(subject, store));
  const auto& listing = narrator.trace().listing;
  const int compared = line_with(listing, "nearer = z < d"), called = line_with(listing, "keep_nearest(");
  if (compared + called > 0) story.comparing(compared > 0 ? compared : called);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  run(watch);
  if (story.telling()) narrator.telling(*story.telling());
  narrator.result({{"wrong", story.wrong()}, {"shown", std::ssize(right)}});
}

/// With depths stored as the reader wants them: use(T{}, store).
void with_depths(const Arguments& arguments, const Subject& subject, const auto& use) {
  const std::string& depth = arguments.text("depth");
  if (depth == "float") return use(float{}, AsFloat{subject.sight.depths()});
  if (depth == "fixed24") return use(std::int32_t{}, AsFixed24{subject.sight.depths()});
  if (depth == "reversed_float") return use(float{}, AsReversedFloat{subject.sight.depths()});
  use(double{}, Exactly{});
}

template <bool rows>
void tell_stored(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.list_below("keep_nearest");
  with_depths(narrator.arguments(), subject, [&]<class T>(T, auto store) {
    tell_walk<T>(narrator, subject, store, {.rows = rows}, [&](const auto& watch) {
      Raster<Cell<T, Id>> buffer(subject.size.x, rows ? 1 : subject.size.y);
      const std::span<const Face> faces(subject.faces);
      if constexpr (rows)
        scanline<T>(faces, subject.picture(), buffer.row(0), store, [](ivec2, Id) {}, watch);
      else
        per_polygon<T>(faces, buffer, store, watch);
    });
  });
}

template <bool whole>
void tell_mistake(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  tell_walk<double>(narrator, subject, Exactly{}, {.whole = whole}, [&](const auto& watch) {
    Raster<Cell<double, Id>> buffer(subject.size.x, subject.size.y);
    Raster<glm::ivec3> colours(subject.size.x, subject.size.y);
    const auto colour_of = [&](Id id) {
      const Rgba8 c = subject.color(id);
      return dvec3(c.r, c.g, c.b) / 255.0;
    };
    if constexpr (whole)
      integer_colours(subject.faces, buffer, colours, colour_of, Exactly{}, watch);
    else
      first_come(subject.faces, buffer, Exactly{}, watch);
  });
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes up_to_a_million{1e-6, 1e6};
  static const TopicEntry topic = completed<entry>(
      {.name = "z_buffer",
       .chapter = "visibility",
       .aliases = {"depth buffer", "depth test", "z-buffer", "hidden surface removal", "z-fighting"},
       .summary = "at every pixel the nearest face, whatever the order of drawing",
       .methods = {{.name = "per_polygon", .standing = Standing::taught, .tell = tell_stored<false>},
                   {.name = "scanline", .tell = tell_stored<true>},
                   {.name = "first_come",
                    .standing = Standing::faulty,
                    .tell = tell_mistake<false>,
                    .unread = {"depth", "near", "far"}},
                   {.name = "integer_colours",
                    .standing = Standing::faulty,
                    .tell = tell_mistake<true>,
                    .unread = {"depth", "near", "far"}}},
       .default_method = "per_polygon",
       .columns = {{"face", false}, {"x"}, {"y"}, {"z"}, {"old"}, {"shown", false}},
       .counts = {"Compared"},
       .parameters =
           {faces(400, "faces",
                  "A: 0,0,5 6,0,5 6,5,5 0,5,5; B: 3,2,3 8,2,3 8,7,3 3,7,3; C: 1,4,1 7,4,7 7,8,7 1,8,1",
                  "A: 0,0,4 6,0,4 0,6,4; B: 2,0,2 8,0,6 8,8,6 2,8,2",
                  "plane convex faces: x right and y down in pixels, z away from the viewer",
                  up_to_a_million),
            integer(1, 16, "columns", "8", "12", "how many pixels the picture is wide"),
            integer(1, 16, "rows", "8", "6", "how many pixels it is high"),
            {.name = "order",
             .type = ParameterType::order,
             .default_value = "given",
             .example = "3,1,2",
             .help = "in which order the faces are drawn, by their numbers, as 3,1,2; or given",
             .choices = {"given"},
             .numbered = true},
            choice(
                "depth", {"exact", "float", "fixed24", "reversed_float"}, "exact", "fixed24",
                "how depths are stored: as they are, or from near to far as float, 24 bits, reversed float"),
            numbers("eye", "", "3,3,-6",
                    "where the eye is, before the picture in z = 0; without one it looks straight on", xyz,
                    up_to_a_million),
            number("near", "0", "1", "the depth that is stored as 0 (reversed: as 1)", up_to_a_million),
            number("far", "10", "1000000", "the depth that is stored as 1 (reversed: as 0)",
                   up_to_a_million)},
       .examples = {"--order 3,1,2", "--method scanline --columns 8 --rows 8",
                    "--depth fixed24 --far 1000000 --faces 'A: 0,0,500 8,0,500 8,8,500 0,8,500; B: 0,0,500.2 "
                    "8,0,499.8 8,8,499.8 0,8,500.2'",
                    "--eye 4,4,-8"}});
  return topic;
}

}  // namespace gradus::z_buffer
