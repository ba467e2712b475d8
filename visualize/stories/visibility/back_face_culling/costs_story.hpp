#pragma once
// What each method's arithmetic costs for the faces that are given, and how many of them it gets wrong.

#include "stories/past.hpp"
#include "stories/visibility/back_face_culling/drawing.hpp"

namespace gradus::back_face_culling {

/// Additions, products and divisions of a method, counted in a run.
struct Cost {
  std::string_view method;
  std::int64_t operations;
  std::vector<int> (*signs)(const Subject&);  ///< what the method finds
};

/// A method's operations are counted.
struct MethodCounted {
  std::size_t method;
  std::int64_t operations;
  std::optional<std::int64_t> wrong;  ///< faces; nothing where corners have no place in the picture
};

class CostsStory : public Past<steps::Started, MethodCounted, steps::Finished> {
 public:
  static constexpr int width = 38, height = 27;

  CostsStory(const Words& words, const Subject& subject, std::span<const Cost> costs)
      : words_(words), subject_(subject), costs_(costs) {
    for (const Cost& cost : costs_) most_ = std::max(most_, cost.operations);
  }

  Event say(const steps::Started&) const { return {.text = "costs", .words = {{"methods", costs_.size()}}}; }
  Event say(const MethodCounted& m) const {
    const std::string wrong = m.wrong ? fmt::format("{}", *m.wrong) : "–";
    return {.text = !m.wrong       ? "cost.nowhere"
                    : *m.wrong > 0 ? "cost.wrong"
                                   : "cost",
            .facts = {{"operations", m.operations}},
            .words = {{"method", name(m.method)},
                      {"operations", m.operations},
                      {"wrong", wrong},
                      {"count", subject_.faces.size()}},
            .row = {name(m.method), m.operations, wrong},
            .key = std::string(costs_[m.method].method)};
  }
  Event say(const steps::Finished&) const {
    return {.text = "costs.finished",
            .words = {{"area", operations_of("screen_area")}, {"normal", operations_of("normal_and_view")}}};
  }

  View draw() const {
    View view;
    for (std::size_t i = 0; i < costs_.size(); ++i) add_bar(view, i);
    return view;
  }

 private:
  std::string name(std::size_t i) const { return words_.say(fmt::format("method.{}", costs_[i].method)); }
  std::int64_t operations_of(std::string_view method) const {
    return std::ranges::find(costs_, method, &Cost::method)->operations;
  }
  void add_bar(View& view, std::size_t i) const {
    constexpr double left = 19, longest = 13.5, pitch = 3.25;
    const auto counted = all<MethodCounted>();
    const bool done = i < counted.size(),
               current = done && &counted[i] == &counted.back() && now<MethodCounted>();
    const std::int64_t operations = costs_[i].operations;
    const double y = height - 2 - pitch * static_cast<double>(i);
    const double right = left + longest * static_cast<double>(operations) / static_cast<double>(most_);
    const bool wrong = done && counted[i].wrong.value_or(1) > 0;
    const Role role = !done ? Role::past : current ? Role::current : wrong ? Role::rejected : Role::accepted;
    const std::string id = fmt::format("b {:02}", i);
    add_ring(view, id, role, Extent{{left, y - 1.1}, {right, y + 1.1}}.corners(), 2);
    view.add({id + " name", done ? role : Role::guide, Text{{left - 0.6, y}, name(i), Align::right}});
    if (!done) return;
    const std::string number = fmt::format("{}", operations);
    const std::string text =
        wrong && counted[i].wrong
            ? words_.say("cost.note", {{"operations", number}, {"wrong", *counted[i].wrong}})
            : number;
    view.add({id + " value", role, Text{{right + 0.5, y}, text, Align::left}});
  }

  const Words& words_;
  const Subject& subject_;
  const std::span<const Cost> costs_;
  std::int64_t most_ = 1;
};

}  // namespace gradus::back_face_culling
