#include "figure/content.hpp"

#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "figure/aside.hpp"
#include "figure/layout/layout.hpp"
#include "figure/trace.hpp"

namespace gradus {
namespace {

/// Whether letters of a text reach below its line.
bool descends(std::string_view text) { return text.find_first_of("gjpqyQ,;()[]/") != std::string_view::npos; }

class Survey {
 public:
  explicit Survey(const Window& cells) : lower_(dvec2(cells.lower) - 0.5), upper_(dvec2(cells.upper) + 0.5) {}

  void add(const Mark& mark) {
    const bool aside = is_aside(mark.id), counts = mark.role != Role::guide && !aside;
    if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
      add(stroke->a, counts, aside);
      add(stroke->b, counts, aside);
    } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
      for (const dvec2 p : path->points) add(p, counts && !path->aside, aside || path->aside);
    } else if (const Dot* dot = std::get_if<Dot>(&mark.shape)) {
      add(dot->at, counts, aside);
    } else if (const Area* area = std::get_if<Area>(&mark.shape)) {
      for (const auto& ring : area->rings) {
        for (const dvec2 p : ring) add(p, false, aside);
      }
    } else if (const Picture* picture = std::get_if<Picture>(&mark.shape)) {
      for (const dvec2 p : {picture->lower, picture->upper}) add(p, !aside, aside || picture->aside);
    } else if (const Text* text = std::get_if<Text>(&mark.shape)) {
      const double width = text_width(text->text, Face::sans, layout::text_size);
      const double left = text->align == Align::left ? 0 : text->align == Align::centre ? width / 2 : width;
      const double below = text->line * layout::paragraph_line;
      add_text(text->at, left, width - left, 0.45 * layout::text_size - below,
               (descends(text->text) ? 0.65 : 0.42) * layout::text_size + below, aside || text->aside);
    } else if (const Label* label = std::get_if<Label>(&mark.shape)) {
      // Somewhere beside its point: half its width and a line are enough
      const double half = text_width(label->text, Face::sans, layout::text_size) / 2;
      add_text(label->at, half, half, layout::text_size, layout::text_size, aside);
    }
  }
  void add(const CellChange& change) {
    if (!change.look) return;
    const bool aside = change.look->role == Role::guide;
    add(dvec2(change.at) - 0.5, true, aside);
    add(dvec2(change.at) + 0.5, true, aside);
  }

  Content content() && {
    for (const auto& [at, room] : texts_) content_.texts.push_back(room);
    return std::move(content_);
  }

 private:
  void add(dvec2 p, bool counts, bool aside = false) {
    p = glm::clamp(p, lower_, upper_);  // marks are cut there
    content_.all.add(p);
    if (!aside) content_.bare.add(p);
    if (counts) content_.core.add(p);
  }
  void add_text(dvec2 at, double left, double right, double up, double down, bool aside = false) {
    if (at != glm::clamp(at, lower_, upper_)) return;
    content_.all.add(at);
    if (!aside) content_.bare.add(at);
    Content::TextRoom& room =
        texts_.try_emplace({at.x, at.y}, Content::TextRoom{at, 0, 0, 0, 0, aside}).first->second;
    room.left = std::max(room.left, left);
    room.right = std::max(room.right, right);
    room.up = std::max(room.up, up);
    room.down = std::max(room.down, down);
  }

  dvec2 lower_, upper_;
  Content content_;
  std::map<std::pair<double, double>, Content::TextRoom> texts_;
};

}  // namespace

Content content_of(const Trace& trace) {
  Survey survey(trace.grid.cells);
  for (const Mark& mark : trace.backdrop) survey.add(mark);
  for (const auto& [id, mark] : trace.before.marks()) survey.add(mark);
  for (const TraceStep& step : trace.steps) {
    for (const Mark& mark : step.delta.set) survey.add(mark);
    for (const CellChange& change : step.delta.cells) survey.add(change);
  }
  return std::move(survey).content();
}

}  // namespace gradus
