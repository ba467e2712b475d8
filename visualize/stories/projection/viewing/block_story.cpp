// A block of three by three numbers, read as three points in rows and as three in columns.

#include "stories/past.hpp"
#include "stories/projection/viewing/drawing.hpp"

namespace gradus::viewing {
namespace {

using Block = std::vector<std::vector<double>>;
struct ReadAsRows {};
struct ReadAsColumns {};

class BlockStory : public Past<steps::Started, ReadAsRows, ReadAsColumns, steps::Finished> {
 public:
  BlockStory(const Words& words, const Block& block, const DFrame& frame)
      : words_(words), block_(block), frame_(frame) {}

  Event say(const steps::Started&) const { return {.text = "started_block"}; }
  Event say(const ReadAsRows&) const { return told("rows"); }
  Event say(const ReadAsColumns&) const { return told("columns"); }
  Event say(const steps::Finished&) const { return {.text = "done_block"}; }

  View draw() const {
    View view;
    add_block(view, false, last<ReadAsRows>());
    add_block(view, true, last<ReadAsColumns>());
    return view;
  }

 private:
  static constexpr double width = 4.4, height = 4.2, top = 19.6;

  dvec3 point(std::size_t i, bool columns) const {
    if (columns) return points_of_block(block_)[i];
    return {block_[i][0], block_[i][1], block_[i][2]};
  }
  Event told(std::string_view as) const {
    const bool columns = as == "columns";
    return {.text = columns ? "read_columns" : "read_rows",
            .words = {{"point", point(0, columns)}, {"view", to_view(frame_, point(0, columns))}},
            .row = {words_.say(columns ? "as.columns" : "as.rows"),
                    figure_place(to_view(frame_, point(0, columns))),
                    figure_place(to_view(frame_, point(1, columns))),
                    figure_place(to_view(frame_, point(2, columns)))},
            .key = std::string(as)};
  }
  /// Where a number stands, in the block on the left or in that on the right.
  static dvec2 at(std::size_t row, std::size_t column, bool right) {
    return {(right ? 21.4 : 1.8) + width * (static_cast<double>(column) + 0.5),
            top - height * (static_cast<double>(row) + 0.5)};
  }
  void add_block(View& view, bool right, bool read) const {
    const std::string id = right ? "columns" : "rows";
    view.add({"caption " + id, Role::guide, Text{{at(1, 1, right).x, 21.4}, words_.say("as." + id)}});
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        view.add({fmt::format("number {} {}{}", id, row, column), Role::input,
                  Text{at(row, column, right), figure_real(block_[row][column])}});
    }
    for (std::size_t i = 0; read && i < 3; ++i) add_point(view, i, right);
  }
  /// A point's numbers in a box, and below the block what the viewer sees of it.
  void add_point(View& view, std::size_t i, bool right) const {
    const dvec2 first = right ? at(0, i, right) : at(i, 0, right),
                last = right ? at(2, i, right) : at(i, 2, right);
    const dvec2 lower{first.x - 0.42 * width, last.y - 0.38 * height},
        upper{last.x + 0.42 * width, first.y + 0.38 * height};
    const std::string id = fmt::format("point {} {}", right ? "columns" : "rows", i);
    const Role role = right ? Role::rejected : Role::accepted;
    view.add({id, role, Path{Extent{lower, upper}.corners(), true}});
    view.add({id + " area", role, Area{{Extent{lower, upper}.corners()}}});
    const std::string seen =
        figure_place(point(i, right)) + " → " + figure_place(to_view(frame_, point(i, right)));
    view.add(
        {id + " seen", Role::input, Text{{at(1, 1, right).x, 5.2 - 1.9 * static_cast<double>(i)}, seen}});
  }
  const Words& words_;
  const Block& block_;
  const DFrame& frame_;
};

/// The number of the listing's line that holds this text.
int line_with(Narrator& narrator, std::string_view text) {
  for (const auto& line : narrator.trace().listing) {
    if (line.text.find(text) != std::string::npos) return line.number;
  }
  return 0;
}

}  // namespace

void tell_block(Narrator& narrator) {
  const Subject subject = subject_of_axes(narrator.arguments());
  const std::vector<double> numbers = narrator.arguments().numbers("block");
  const Block block{{numbers[0], numbers[1], numbers[2]},
                    {numbers[3], numbers[4], numbers[5]},
                    {numbers[6], numbers[7], numbers[8]}};
  narrator.subtitle("subtitle_axes", {{"eye", subject.eye}});
  narrator.trace().goal = narrator.words().say("goal_block");
  narrator.paper(36, 24);
  narrator.legend({{Role::accepted, "as_rows"}, {Role::rejected, "as_columns"}});
  narrator.columns({{"read", false}, {"first", false}, {"second", false}, {"third", false}});
  const DFrame frame = subject.frame();
  BlockStory story(narrator.words(), block, frame);
  narrator.tell_whole(story, [&](const auto& watch) {
    watch(ReadAsRows{}, 0);
    watch(ReadAsColumns{}, line_with(narrator, "block.size() == 3) {"));
  });
  narrator.telling({2, 0});
  narrator.result({{"points", 3}});
}

}  // namespace gradus::viewing
