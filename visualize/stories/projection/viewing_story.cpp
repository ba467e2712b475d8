// The story of a view: three axes at the eye, the matrix made of them, and what the viewer sees.

#include "stories/checking.hpp"
#include "stories/parameters.hpp"
#include "stories/past.hpp"
#include "stories/projection/viewing/drawing.hpp"

namespace gradus::viewing {
namespace {

/// A number without what rounding has left where exact arithmetic says 0: below 2^-40 of `size`.
double neat(double x, double size) { return std::abs(x) < 0x1p-40 * size ? 0 : x; }
dvec3 neat(dvec3 v, double size) { return {neat(v.x, size), neat(v.y, size), neat(v.z, size)}; }

/// The size of the largest term of a product of two vectors.
double largest_product(dvec3 a, dvec3 b) {
  return std::max({std::abs(a.x * b.x), std::abs(a.y * b.y), std::abs(a.z * b.z)});
}

/// A product of two vectors with its numbers: "0.8·2.8 + 0·3.6 + (−0.6)·3.2".
std::string product_text(dvec3 a, dvec3 b) {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += (i > 0 ? "\u00a0+\u00a0" : "") + figure_factor(a[i]) + "\u00a0·\u00a0" + figure_factor(b[i]);
  return text;
}

/// "right", "up", "forward", and again.
std::string axis_id(int number) { return std::string(axis_names[static_cast<std::size_t>(number % 3)]); }

// --- The steps

/// Which matrix is made of the axes.
enum class Way { rows, inverse, any_frame, minus_position, transposed };

/// What is given, and of given axes what their inverse is tested with: told by no step of the method.
struct Input {};
struct RowMultiplied {
  int row;
  glm::dmat4 inverse;
};
struct Inverted {};

/// Tells the frame, the matrix, and what it makes of the target.
class Story
    : public Past<Input, HintReplaced<double>, Aimed<double>, Levelled<double>, Framed<double>,
                  RowWritten<double>, ColumnWritten<double>, RowMultiplied, Inverted, Viewed<double>> {
 public:
  Story(const Words& words, const Subject& subject, Way way)
      : words_(words),
        subject_(subject),
        way_(way),
        drawing_(subject, words),
        frame_(subject.frame()),
        backward_(words.notation().looks_backward() && !faulty() && way != Way::any_frame),
        right_(world_to_view(frame_)),
        wrong_(way == Way::minus_position ? minus_position(frame_) : transposed(frame_)) {}

  const Drawing& drawing() const { return drawing_; }

  Event say(const Input&) const {
    if (way_ == Way::any_frame) {
      return {.text = "input_axes",
              .words = {{"right", frame_.right},
                        {"up", frame_.up},
                        {"forward", frame_.forward},
                        {"r", direction(0)},
                        {"u", direction(1)},
                        {"f", direction(2)}},
              .key = "eye",
              .begins = true};
    }
    return {.text = "input",
            .words = {{"eye", subject_.eye}, {"target", subject_.target}, {"up", subject_.up}},
            .key = "eye",
            .begins = true};
  }

  Event say(const HintReplaced<double>& h) const {
    Event event = of_frame("hint_replaced", "hint", h.spare, {{"up", h.up_hint}, {"spare", h.spare}});
    event.decides = hint_along_the_view(true);
    return event;
  }
  Event say(const Aimed<double>& a) const {
    Event event = of_frame("aimed", "forward", a.forward,
                           {{"along", a.target - a.eye},
                            {"distance", subject_.distance},
                            {"f", direction(2)},
                            {"forward", neat(a.forward, 1)}});
    if (subject_.along == Along::replaced && !last<HintReplaced<double>>())
      event.decides = hint_along_the_view(false);
    return event;
  }
  Event say(const Levelled<double>& l) const {
    const dvec3 across = glm::cross(frame_.forward, l.up_hint);
    const double length = length_of(across);
    return of_frame("levelled", "right", l.right,
                    {{"across", neat(across, length)},
                     {"length", length},
                     {"f", direction(2)},
                     {"r", direction(0)},
                     {"right", neat(l.right, 1)}});
  }
  Event say(const Framed<double>& f) const {
    return of_frame(
        "framed", "up", f.frame.up,
        {{"r", direction(0)}, {"u", direction(1)}, {"f", direction(2)}, {"up", neat(f.frame.up, 1)}});
  }

  Event say(const RowWritten<double>& r) const {
    const dvec3 axis = in_notation(r.row, neat(r.axis, 1));
    // The sum of the products as they are shown
    const double along = neat(-glm::dot(axis, subject_.eye), largest_product(axis, subject_.eye));
    const double shift = faulty() ? r.shift : along;
    Event event{
        .text = way_ == Way::minus_position ? "position_row" : "row",
        .facts = {{"row", r.row}, {"x", r.axis.x}, {"y", r.axis.y}, {"z", r.axis.z}, {"shift", r.shift}},
        .words = {{"axis", axis_name(r.row)},
                  {"product", product_text(axis, subject_.eye)},
                  {"shift", shift},
                  {"right", along}},
        .row = {axis_name(r.row), axis.x, axis.y, axis.z, shift},
        .key = axis_id(r.row),
        .phase = words_.say("phase.matrix")};
    if (way_ == Way::transposed) {
      event.text = "transposed_row";
      event.words = {{"entries", axis}, {"axis", neat(axis_of(frame_, r.row), 1)}};
      event.row[0] = words_.say("row_number", {{"n", r.row + 1}});
    }
    return event;
  }

  Event say(const ColumnWritten<double>& c) const {
    const bool eye = c.column == 3;
    const double size = way_ == Way::any_frame ? length_of(c.entries) : 1;
    const dvec3 entries = eye ? c.entries : in_notation(c.column, neat(c.entries, size));
    const std::string name = eye ? words_.say("name.eye") : axis_name(c.column);
    Event event{.text = eye ? "eye_column" : "column",
                .facts = {{"column", c.column}, {"x", c.entries.x}, {"y", c.entries.y}, {"z", c.entries.z}},
                .words = {{"eye", entries}, {"entries", entries}, {"axis", name}},
                .row = {name, entries.x, entries.y, entries.z, eye ? 1 : 0},
                .key = eye ? "eye" : axis_id(c.column),
                .phase = words_.say("phase.matrix")};
    if (way_ == Way::any_frame && !eye) add_reciprocal(event, c.column);
    return event;
  }

  Event say(const RowMultiplied& m) const {
    const glm::dmat4 product = right_ * m.inverse;
    const dvec3 axis = axis_of(frame_, m.row), column(m.inverse[m.row]);
    std::vector<Said> row{words_.say("product_name", {{"axis", axis_name(m.row)}})};
    for (int k = 0; k < 4; ++k)
      row.push_back(neat(product[k][m.row], length_of(axis) * length_of(dvec3(m.inverse[k]))));
    return {.text = "product_row",
            .facts = {{"row", m.row},
                      {"right", product[0][m.row], "product"},
                      {"up", product[1][m.row], "product"},
                      {"forward", product[2][m.row], "product"},
                      {"eye", product[3][m.row], "product"}},
            .words = {{"axis", axis_name(m.row)},
                      {"product", product_text(neat(axis, length_of(axis)), neat(column, length_of(column)))},
                      {"value", row[static_cast<std::size_t>(m.row) + 1]}},
            .row = row,
            .key = axis_id(m.row),
            .phase = words_.say("phase.check")};
  }
  /// What the transposed matrix would give in place of the identity, where it is wrong most.
  Event say(const Inverted&) const {
    Event event{.text = "inverted_upright", .key = "product", .ends = true, .level = Level::step};
    if (is_upright(frame_)) return event;
    const auto off = [&](int i) {
      const double wanted = i / 3 == i % 3 ? 1 : 0;
      return std::abs(glm::dot(axis_of(frame_, i / 3), axis_of(frame_, i % 3)) - wanted);
    };
    int worst = 0;
    for (int i = 1; i < 9; ++i) worst = off(i) > off(worst) ? i : worst;
    event.text = "inverted";
    event.words = {{"a", axis_name(worst / 3)},
                   {"b", axis_name(worst)},
                   {"value", glm::dot(axis_of(frame_, worst / 3), axis_of(frame_, worst % 3))},
                   {"wanted", worst / 3 == worst % 3 ? 1 : 0}};
    return event;
  }

  /// The matrix is whole: what it makes of the target.
  Event say(const Viewed<double>& v) const {
    const double size = length_of(subject_.eye) + length_of(subject_.target);
    if (way_ == Way::inverse) {
      return {.text = "led_back",
              .facts = fields("world", v.world),
              .words = {{"view", in_notation(v.view)}, {"target", neat(v.world, size)}},
              .key = "target",
              .ends = true,
              .level = Level::step};
    }
    const double sine = sine_between(subject_.target - subject_.eye, subject_.up);
    const bool by_chance = subject_.along == Along::divided && sine < least_sine<double>;
    return {.text = by_chance  ? "by_chance"
                    : faulty() ? "off_the_axis"
                               : "viewed",
            .facts = fields("view", v.view),
            .words = {{"view", in_notation(neat(v.view, size))},
                      {"r", direction(0)},
                      {"sine", sine},
                      {"right", neat(frame_.right, 1)},
                      {"distance", subject_.distance}},
            .row = {words_.say("last_row"), 0, 0, 0, 1},
            .key = "target",
            .ends = true,
            .level = Level::step};
  }

  View draw() const {
    const Drawing::Known known = this->known();
    if (way_ == Way::any_frame) return drawing_.given_axes(known, frame_);
    View view = drawing_.world(known, frame_);
    if (faulty())
      drawing_.add_view_space(view, known, wrong_, right_);
    else
      drawing_.add_picture(view, known, right_);
    const bool columns = way_ == Way::inverse;
    glm::dmat4 shown = faulty() ? wrong_ : columns ? view_to_world(frame_) : right_;
    if (backward_) {
      for (int i = 0; i < 4; ++i) (columns ? shown[2][i] : shown[i][2]) *= -1;
    }
    drawing_.add_matrix_of(view, known, shown, columns);
    return view;
  }

 private:
  Drawing::Known known() const {
    const bool whole = last<Viewed<double>>() || last<Inverted>();
    const auto written = all<RowWritten<double>>().size() + all<ColumnWritten<double>>().size();
    const int rows = whole ? 3 : std::min(3, static_cast<int>(written));
    return {.axes = {last<Levelled<double>>() != nullptr, last<Framed<double>>() != nullptr,
                     last<Aimed<double>>() != nullptr},
            .newest = newest(),
            .rows = rows,
            .seen = whole || (way_ != Way::any_frame && rows == 3)};
  }
  /// The axis, row or column of the step at hand.
  int newest() const {
    if (now<Levelled<double>>()) return 0;
    if (now<Framed<double>>()) return 1;
    if (now<Aimed<double>>()) return 2;
    if (const auto* row = now<RowWritten<double>>()) return row->row;
    const auto* column = now<ColumnWritten<double>>();
    return column && column->column < 3 ? column->column : -1;
  }
  bool faulty() const { return way_ == Way::minus_position || way_ == Way::transposed; }
  /// Of a row or column of the matrix.
  std::string axis_name(int number) const {
    return backward_ ? viewing::axis_name(words_, number % 3) : direction(number);
  }
  std::string direction(int number) const { return direction_name(words_, number % 3); }
  /// A row, column or place in view space, its third axis as the reader has it.
  dvec3 in_notation(dvec3 view) const { return backward_ ? dvec3(view.x, view.y, 0 - view.z) : view; }
  dvec3 in_notation(int axis, dvec3 v) const { return backward_ && axis == 2 ? dvec3(0) - v : v; }
  static std::vector<Field> fields(const std::string& name, dvec3 v) {
    return {{name + ".x", v.x, "x"}, {name + ".y", v.y, "y"}, {name + ".z", v.z, "z"}};
  }
  /// A step that finds a vector of the frame.
  Event of_frame(std::string_view text, const std::string& name, dvec3 found, std::vector<Word> words) const {
    return {.text = text,
            .facts = fields(name, found),
            .words = std::move(words),
            .key = name,
            .phase = words_.say("phase.frame")};
  }
  Decision hint_along_the_view(bool along) const {
    return yes_or_no(words_, "question", {{"up", subject_.up}}, along, "replaced", "kept");
  }
  /// Where a column of the inverse comes from: a cross product, divided by the determinant.
  void add_reciprocal(Event& event, int column) const {
    const dvec3 cross = glm::cross(axis_of(frame_, (column + 1) % 3), axis_of(frame_, (column + 2) % 3));
    event.text = "reciprocal";
    event.words.insert(event.words.end(), {{"a", axis_name(column + 1)},
                                           {"b", axis_name(column + 2)},
                                           {"cross", neat(cross, length_of(cross))},
                                           {"det", glm::dot(axis_of(frame_, column), cross)}});
  }

  const Words& words_;
  const Subject& subject_;
  const Way way_;
  const Drawing drawing_;
  const DFrame frame_;   ///< where axes will be, so that nothing jumps
  const bool backward_;  ///< the third axis of the matrix is the reader's; exhibits have the code's
  const glm::dmat4 right_, wrong_;
};

// --- The methods

void introduce(Narrator& narrator, Role last, std::string_view its_key) {
  narrator.legend({Role::input, Role::past, {last, its_key}});  // the axes are named where they are drawn
}
void introduce_axes(Narrator& narrator) {
  narrator.legend({Role::current,
                   {Role::accepted, "columns"},
                   {Role::result, "result_axes"},
                   Role::past,
                   {Role::input, "given_axes"}});
}

void conclude(Narrator& narrator, const glm::dmat4& matrix) {
  std::vector<Field> result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      result.push_back({fmt::format("m{}{}", row, column), matrix[column][row] + 0.0});
  }
  narrator.result(std::move(result));
}

/// Says once what the reader's notation calls otherwise than the code.
void say_axes_of_code(Narrator& narrator) {
  const Notation& notation = narrator.words().notation();
  narrator.shows_matrices();
  if (notation.axes.empty()) {
    if (notation.looks_backward()) narrator.in_the_code("notation.forward");
    return;
  }
  constexpr std::string_view minus = "−";
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name(axis_names[i]);
    if (i < 2 || !notation.looks_backward()) {
      narrator.named_in_the_code(notation.axes[i], name);
    } else if (notation.axes[i].starts_with(minus)) {
      narrator.named_in_the_code(notation.forward_name(name), name);
    } else {
      narrator.named_in_the_code(notation.axes[i], std::string(minus) + name);
    }
  }
}

/// The frame, and the matrix that `make` makes of it.
template <Along along, Way way, auto make>
void tell_view(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), along);
  constexpr bool faulty = way == Way::minus_position || way == Way::transposed;
  if (along == Along::replaced) narrator.list_below("spare_up");
  if (way == Way::rows && along != Along::divided) narrator.list_below("world_to_view");
  if (way == Way::inverse) narrator.list_below("view_to_world");
  introduce(narrator, faulty ? Role::rejected : Role::result, faulty ? "rejected" : "result");
  narrator.subtitle("subtitle", {{"eye", subject.eye}, {"target", subject.target}});
  narrator.paper(36, 24);
  say_axes_of_code(narrator);
  // The matrix is whole after its third row or column
  const bool replaced =
      along == Along::replaced && sine_between(subject.target - subject.eye, subject.up) < least_sine<double>;
  narrator.telling({replaced ? 7 : 6, 0});
  Story story(narrator.words(), subject, way);
  const Drawing& drawing = story.drawing();
  narrator.handles("eye", [&](dvec3 p) { return drawing.eye_at(p); });
  narrator.handles("target", [&](dvec3 p) { return drawing.at(p); });
  narrator.handles("up", [&](dvec3 up) { return drawing.hint_at(up); });
  const auto watch = narrator.watcher(story);
  watch(Input{}, 0);
  // The exhibits' listing has one of the two: the other is told without its lines
  const auto told_as = [&watch](bool listed) {
    return [&watch, listed](const auto& step, int line = __builtin_LINE(), const char* = nullptr) {
      watch(step, listed ? line : 0);
    };
  };
  const DFrame frame = subject.aimed(told_as(!faulty));
  const glm::dmat4 matrix = make(frame, told_as(along != Along::divided));
  const dvec3 ahead{0, 0, subject.distance};
  watch(way == Way::inverse ? Viewed<double>{through(matrix, ahead), ahead}
                            : Viewed<double>{subject.target, through(matrix, subject.target)},
        narrator.last_line());
  conclude(narrator, matrix);
}

/// What makes the matrix of the frame.
constexpr auto rows = [](auto... run) { return world_to_view(run...); };
constexpr auto columns = [](auto... run) { return view_to_world(run...); };
constexpr auto moved = [](auto... run) { return minus_position(run...); };
constexpr auto turned = [](auto... run) { return transposed(run...); };

void tell_any_frame(Narrator& narrator) {
  const Subject subject = subject_of_axes(narrator.arguments());
  introduce_axes(narrator);
  narrator.subtitle("subtitle_axes", {{"eye", subject.eye}});
  narrator.paper(36, 24);
  say_axes_of_code(narrator);
  narrator.telling({3, 0});
  Story story(narrator.words(), subject, Way::any_frame);
  narrator.handles("axes", [&](dvec3 axis) { return story.drawing().axis_at(axis); });
  const auto watch = narrator.watcher(story);
  watch(Input{}, 0);
  const glm::dmat4 inverse = inverse_of_any_frame(subject.frame(), watch);
  for (int row = 0; row < 3; ++row) watch(RowMultiplied{row, inverse}, narrator.last_line());
  watch(Inverted{}, narrator.last_line());
  conclude(narrator, inverse);
}

const Checking& checking() {
  static const Checking known{.matrix = {"m00", "m01", "m02", "m03", "m10", "m11", "m12", "m13",  //
                                         "m20", "m21", "m22", "m23", "m30", "m31", "m32", "m33"},
                              .matrix_columns = 4};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  const auto looking = [](std::string name, Standing standing, void (*tell)(Narrator&),
                          std::string function = {}) {
    return Method{.name = std::move(name),
                  .standing = standing,
                  .tell = tell,
                  .function = std::move(function),
                  .unread = {"axes", "block"}};
  };
  static const TopicEntry topic = completed<entry>(
      {.name = "viewing",
       .chapter = "projection",
       .aliases = {"look at", "lookat", "view matrix", "world to view", "camera"},
       .summary = "the frame of a viewer, and the matrix that takes the world to it",
       .methods =
           {looking("world_to_view", Standing::taught, tell_view<Along::refused, Way::rows, rows>, "look_at"),
            looking("view_to_world", Standing::plain, tell_view<Along::refused, Way::inverse, columns>,
                    "look_at"),
            {.name = "inverse_of_any_frame", .tell = tell_any_frame, .unread = {"target", "up", "block"}},
            looking("spare_up", Standing::plain, tell_view<Along::replaced, Way::rows, rows>, "look_at"),
            {.name = "points_of_block",
             .standing = Standing::faulty,
             .tell = tell_block,
             .unread = {"target", "up"}},
            looking("minus_position", Standing::faulty,
                    tell_view<Along::refused, Way::minus_position, moved>),
            looking("transposed", Standing::faulty, tell_view<Along::refused, Way::transposed, turned>),
            looking("cross_products", Standing::faulty, tell_view<Along::divided, Way::rows, rows>)},
       .columns = {{"axis", false}, {"x"}, {"y"}, {"z"}, {"last"}},
       .parameters =
           {numbers("eye", "1.6,2.1,1.6", "3,2,5", "where the viewer is: x,y,z in world units", xyz,
                    coordinate_sizes),
            numbers("target", "0.4,0.6,0", "0,0,0", "what the viewer looks at", xyz, coordinate_sizes),
            numbers("up", "0,1,0", "0,0,1", "what points up in the picture: a direction of any length",
                    xyz, coordinate_sizes),
            points(3, 3, "axes", "2,0,0 1,1,0 0,-0.5,-1", "1,0,0 0,2,0 0.5,0,-1",
                   "method inverse_of_any_frame: right, up and forward, of any lengths and angles", xyz),
            numbers("block", "1,2,3,4,5,6,7,8,9", "0,0,0,1,0,0,0,1,0",
                    "method points_of_block: three rows of three numbers",
                    {"a", "b", "c", "d", "e", "f", "g", "h", "i"}, coordinate_sizes)},
       .examples = {"--eye 1.6,2.1,1.6 --target 0.4,0.6,0", "--eye 3,2,5 --target 0,0,0 --up 0,1,0",
                    "--eye 2,3,5 --target 0,0,0 --method transposed",
                    "--eye 0.4,5,0 --target 0.4,0.6,0 --method spare_up"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::viewing
