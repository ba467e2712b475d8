#include "check/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "check/lists.hpp"
#include "request/names.hpp"

namespace gradus::check {
namespace {

/// Whether an element is one of ours. Of cells, of which there may be many, their keys are kept.
class OursOrNot {
 public:
  OursOrNot(const ExpectedList& list, double tolerance) : list_(list), tolerance_(tolerance) {
    if (!list.cells()) return;
    for (const ExpectedElement& element : list.elements) keys_.insert(text_of(element.values));
  }
  bool operator()(const Element& element) const {
    if (list_.cells()) return keys_.contains(text_of(element));
    return std::ranges::any_of(
        list_.elements, [&](const ExpectedElement& e) { return agree(e.values, element, tolerance_); });
  }

 private:
  const ExpectedList& list_;
  const double tolerance_;
  std::set<std::string> keys_;
};

/// What a list's elements are called, one and many.
std::string called(const ExpectedList& list) { return list.cells() ? "pixel" : list.name; }

/// An order in which cells and other values can be sorted.
std::string sort_key(const Element& element) { return text_of(element); }

/// Whether the orders of two lists agree as far as their elements do.
bool orders_agree(const Translated::List& theirs, double tolerance) {
  const auto& ours = theirs.ours->elements;
  const std::size_t least = std::min(ours.size(), theirs.elements.size());
  std::size_t at_their_place = 0;
  for (std::size_t i = 0; i < least; ++i)
    at_their_place += agree(ours[i].values, theirs.elements[i], tolerance);
  const std::size_t missing = missing_from(elements_of(*theirs.ours), theirs.elements, tolerance).size();
  const std::size_t common = theirs.elements.size() - missing;
  return 2 * at_their_place >= common;
}

}  // namespace

Comparison::Comparison(const Task& task, const Expected& expected, const Translated& theirs, double tolerance)
    : task_(task), expected_(expected), theirs_(theirs), tolerance_(tolerance) {
  for (const Translated::Step& step : theirs.steps) {
    if (!step.stands_for) continue;
    steps_.push_back(step.values);
    stand_for_.push_back(expected.steps[*step.stands_for]);
  }
  for (const Translated::List& list : theirs.lists) compare_list(list);
  compare_values();
  compare_steps();
  std::ranges::stable_sort(differences_, {},
                           [](const Difference& d) { return std::pair(d.step, !d.shows_step); });
}

bool Comparison::near(ivec2 a, ivec2 b) const {
  const Checking* checking = task_.topic.checking;
  return checking && checking->as_near && a != b && checking->as_near(task_.arguments, a, b);
}

/// Whether the step that asks for this element might as well have answered otherwise.
bool Comparison::is_tied(const ExpectedList& list, const Element& element) const {
  const Checking* checking = task_.topic.checking;
  if (!checking || !checking->is_tie) return false;
  const auto asked = std::ranges::find(checking->asked, list.name, &Asked::name);
  if (asked == checking->asked.end() || asked->where.empty()) return false;
  return std::ranges::any_of(expected_.steps, [&](const TraceStep* step) {
    if (step->type != asked->type || !checking->is_tie(*step)) return false;
    const Values values = values_of(*step);
    for (std::size_t i = 0; i < asked->fields.size(); ++i) {
      const Value* value = value_of(values, asked->fields[i]);
      if (!value || !agree(*value, element[i], tolerance_)) return false;
    }
    return true;
  });
}

void Comparison::compare_values() {
  for (const Field& field : theirs_.values) {
    const Value& ours = *value_of(expected_.values, field.name);
    if (agree(ours, field.value, tolerance_)) continue;
    differences_.push_back(
        {.step = task_.ours.last,
         .what = fmt::format("{} is {}, ours {}", field.name, text_of(field.value), text_of(ours)),
         .shows_step = false});
  }
}

// --- Lists -------------------------------------------------------------------------------------------------

void Comparison::compare_list(const Translated::List& theirs) {
  switch (theirs.ours->same) {
    case SameList::set:
      return compare_set(theirs);
    case SameList::segments:
      return compare_segments(theirs);
    case SameList::ring:
      return compare_rings(theirs);
    case SameList::order:
      return compare_in_order(theirs);
  }
}

/// As sets; cells that are drawn one after the other as long as possible in their order, which tells where
/// the first of them goes wrong.
void Comparison::compare_set(const Translated::List& theirs) {
  const ExpectedList& list = *theirs.ours;
  const auto ours = elements_of(list);
  find_tied_cells(theirs);
  const bool same = missing_from(ours, theirs.elements, tolerance_).empty() &&
                    missing_from(theirs.elements, ours, tolerance_).empty();
  if (same) {
    if (!same_in_order(ours, theirs.elements, tolerance_))
      remarks_.push_back(list.name + " in another order");
    return;
  }
  if (!may_choose(list) && !is_ours_and_more(theirs) && orders_agree(theirs, tolerance_))
    compare_in_order(theirs);
  else
    compare_as_sets(theirs);
}

void Comparison::compare_segments(const Translated::List& theirs) {
  Translated::List turned = theirs;
  if (turn_segments(elements_of(*theirs.ours), turned.elements, tolerance_) > 0)
    remarks_.push_back(theirs.ours->name + " from its other end");
  compare_set(turned);
}

void Comparison::compare_rings(const Translated::List& theirs) {
  const RingsBeside rings = rings_beside(*theirs.ours, theirs.elements, tolerance_);
  ExpectedList ours = *theirs.ours;
  ours.elements = rings.ours;
  const Translated::List fitted{&ours, rings.theirs};
  if (same_in_order(elements_of(ours), rings.theirs, tolerance_)) {
    std::vector<std::string> how;
    if (rings.turned) how.emplace_back("from another one on");
    if (rings.backwards) how.emplace_back("backwards");
    if (rings.closed) how.emplace_back("closed by the first one");
    if (rings.repeated > 0) how.push_back(fmt::format("{} of them again", rings.repeated));
    if (!how.empty()) remarks_.push_back(fmt::format("{} {}", ours.name, fmt::join(how, ", ")));
    return;
  }
  const std::size_t before = differences_.size();
  if (ours.elements.size() != rings.theirs.size()) compare_as_sets(fitted);
  // The same corners on another way round
  if (differences_.size() == before) compare_in_order(fitted);
}

/// Whether each element is one that a decision may leave out: then one more moves all behind it.
bool Comparison::may_choose(const ExpectedList& list) const {
  return task_.topic.checking && std::ranges::any_of(task_.topic.checking->asked, [&](const Asked& asked) {
           return asked.name == list.name && !asked.where.empty();
         });
}

/// Whether all of ours are there, and more of the same.
bool Comparison::is_ours_and_more(const Translated::List& theirs) const {
  const std::size_t count = theirs.ours->elements.size();
  if (theirs.elements.size() <= count) return false;
  const OursOrNot is_ours(*theirs.ours, tolerance_);
  std::set<std::string> seen;
  for (const Element& element : theirs.elements) {
    if (!is_ours(element)) return false;
    seen.insert(sort_key(element));
  }
  return seen.size() >= count;
}

void Comparison::compare_in_order(const Translated::List& theirs) {
  const ExpectedList& ours = *theirs.ours;
  const bool cells = ours.cells();
  if (cells) in_order_ = &theirs;
  const std::size_t least = std::min(ours.elements.size(), theirs.elements.size());
  bool wrong = false;
  for (std::size_t i = 0; i < least; ++i) {
    const Element &a = ours.elements[i].values, &b = theirs.elements[i];
    if (agree(a, b, tolerance_)) continue;
    const bool tie = cells && near(cell_of(a), cell_of(b));
    if (!tie && !wrong) first_wrong_ = i;
    wrong = wrong || !tie;
    if (cells && !tie) wrong_cells_.push_back(cell_of(b));
    differences_.push_back({ours.elements[i].step,
                            fmt::format("{} {} is {}, ours {}", called(ours), i + 1, text_of(b), text_of(a)),
                            tie});
  }
  if (theirs.elements.size() < ours.elements.size()) {
    if (!wrong) first_wrong_ = least;
    const ExpectedElement& next = ours.elements[least];
    differences_.push_back({next.step, fmt::format("{} of {} end after {}, ours go on with {}", ours.name,
                                                   ours.elements.size(), least, text_of(next.values))});
  }
  if (theirs.elements.size() > ours.elements.size()) {
    if (!wrong) first_wrong_ = least;
    for (std::size_t i = least; cells && i < theirs.elements.size(); ++i)
      wrong_cells_.push_back(cell_of(theirs.elements[i]));
    differences_.push_back({task_.ours.last, fmt::format("{} go on with {} where ours end after {}",
                                                         ours.name, text_of(theirs.elements[least]), least)});
  }
}

void Comparison::compare_as_sets(const Translated::List& theirs) {
  const ExpectedList& ours = *theirs.ours;
  const auto our_elements = elements_of(ours);
  const auto missing = missing_from(theirs.elements, our_elements, tolerance_);
  auto extra = missing_from(our_elements, theirs.elements, tolerance_);
  const std::vector<std::size_t> places = steps_of(theirs, expected_);
  const OursOrNot is_ours(ours, tolerance_);
  std::size_t again = 0;
  std::erase_if(extra, [&](std::size_t i) {
    const bool known = is_ours(theirs.elements[i]);
    again += known;
    return known;
  });
  for (const std::size_t i : missing) {
    const Element& element = ours.elements[i].values;
    bool tie = is_tied(ours, element);
    if (ours.cells() && !tie) {
      const auto instead = std::ranges::find_if(
          extra, [&](std::size_t j) { return near(cell_of(element), cell_of(theirs.elements[j])); });
      tie = instead != extra.end();
      if (tie) extra.erase(instead);
    }
    differences_.push_back(
        {ours.elements[i].step, fmt::format("{} {} is missing", called(ours), text_of(element)), tie});
  }
  for (const std::size_t j : extra) {
    const Element& element = theirs.elements[j];
    const bool tie = is_tied(ours, element);
    if (ours.cells() && !tie) wrong_cells_.push_back(cell_of(element));
    const std::int64_t step = j < places.size() ? expected_.steps[places[j]]->number.step : task_.ours.last;
    differences_.push_back({step, fmt::format("{} {} is none of ours", called(ours), text_of(element)), tie});
  }
  if (again > 0) remarks_.push_back(fmt::format("{} of its {} more than once", again, ours.name));
}

void Comparison::find_tied_cells(const Translated::List& theirs) {
  const Checking* checking = task_.topic.checking;
  if (!checking) return;
  if (theirs.ours->cells() && checking->as_near) {
    std::set<std::string> taken;
    for (const Element& element : theirs.elements) taken.insert(sort_key(element));
    for (const ExpectedElement& element : theirs.ours->elements) {
      const ivec2 ours = cell_of(element.values);
      for (const ivec2 way : {ivec2{1, 0}, ivec2{-1, 0}, ivec2{0, 1}, ivec2{0, -1}}) {
        const bool fits =
            std::abs(std::int64_t{ours.x}) < INT32_MAX && std::abs(std::int64_t{ours.y}) < INT32_MAX;
        if (!fits || !near(ours, ours + way)) continue;
        if (taken.contains(sort_key({ours})))
          tied_.push_back({element.step, ours, ours + way});
        else if (taken.contains(sort_key({ours + way})))
          tied_.push_back({element.step, ours + way, ours});
      }
    }
  }
  const auto asked = std::ranges::find(checking->asked, theirs.ours->name, &Asked::name);
  if (asked == checking->asked.end() || asked->where.empty() || !checking->is_tie) return;
  for (const TraceStep* step : expected_.steps) {
    if (step->type != asked->type || !checking->is_tie(*step)) continue;
    const Values values = values_of(*step);
    Element element;
    for (const std::string& field : asked->fields) {
      if (const Value* value = value_of(values, field)) element.push_back(*value);
    }
    const bool taken =
        std::ranges::any_of(theirs.elements, [&](const Element& e) { return agree(e, element, tolerance_); });
    ++(taken ? tied_in_ : tied_out_);
  }
}

// --- Steps -------------------------------------------------------------------------------------------------

Follows Comparison::follows(std::size_t i) const {
  const Checking* checking = task_.topic.checking;
  if (!checking || !checking->follows || i == 0) return Follows::untold;
  return checking->follows({task_.arguments, steps_, stand_for_, tolerance_}, i);
}

void Comparison::compare_step(std::size_t i) {
  const Values ours = values_of(*stand_for_[i]);
  const std::int64_t number = stand_for_[i]->number.step;
  std::vector<std::string> wrong;
  bool cell_is_tied = false;
  for (const Field& field : steps_[i]) {
    const Value* value = value_of(ours, field.name);
    if (value && agree(*value, field.value, tolerance_)) continue;
    wrong.push_back(value
                        ? fmt::format("{} is {}, ours {}", field.name, text_of(field.value), text_of(*value))
                        : fmt::format("{} is {}, ours lacks it", field.name, text_of(field.value)));
  }
  if (wrong.empty()) return;
  const auto cell = [](const Values& values) -> std::optional<ivec2> {
    if (const auto pixel = value_as<ivec2>(values, "pixel")) return pixel;
    const auto x = value_as<std::int64_t>(values, "x"), y = value_as<std::int64_t>(values, "y");
    return x && y ? std::optional(ivec2(static_cast<int>(*x), static_cast<int>(*y))) : std::nullopt;
  };
  const auto theirs = cell(steps_[i]), our_cell = cell(ours);
  if (theirs && our_cell) cell_is_tied = near(*theirs, *our_cell);
  const bool cells_alone = wrong.size() == 1 || !value_of(steps_[i], "p");
  const bool tie = cell_is_tied && (follows(i) == Follows::yes || cells_alone);
  differences_.push_back({number, wrong.front(), tie});
}

void Comparison::compare_steps() {
  for (std::size_t i = 0; i < steps_.size(); ++i) compare_step(i);
  const bool more = std::ranges::any_of(theirs_.steps, [](const auto& step) { return !step.stands_for; });
  if (more) {
    differences_.push_back(
        {.step = task_.ours.last,
         .what = fmt::format("{} steps, of which {} stand for ours", theirs_.steps.size(), steps_.size())});
  }
  if (steps_.empty()) return;
  const TraceStep& last = *stand_for_.back();
  const auto next = std::ranges::find_if(expected_.steps, [&](const TraceStep* step) {
    const Values ours = values_of(*step);
    return step->number > last.number && step->type == last.type &&
           std::ranges::all_of(steps_.back(), [&](const Field& f) { return value_of(ours, f.name); });
  });
  if (next != expected_.steps.end()) {
    differences_.push_back({(*next)->number.step, fmt::format("steps end after step {}", last.number.step)});
  }
}

// --- What comes behind the first difference ----------------------------------------------------------------

std::pair<Follows, std::string> Comparison::later_steps(std::int64_t first_step) const {
  std::size_t first = 0;
  while (first < steps_.size() && stand_for_[first]->number.step < first_step) ++first;
  bool told = first + 1 < steps_.size();
  for (std::size_t i = first + 1; i < steps_.size(); ++i) {
    const Follows how = follows(i);
    if (how == Follows::no) {
      return {how, fmt::format("step {} does not follow from step {}", stand_for_[i]->number.step,
                               stand_for_[i - 1]->number.step)};
    }
    told = told && how == Follows::yes;
  }
  if (!told) return {Follows::untold, ""};
  return {Follows::yes, "all later steps follow rightly from there"};
}

std::pair<Follows, std::string> Comparison::later_cells() const {
  const auto& ours = in_order_->ours->elements;
  std::vector<ivec2> rest, our_rest;
  for (std::size_t i = first_wrong_; i < in_order_->elements.size(); ++i)
    rest.push_back(cell_of(in_order_->elements[i]));
  for (std::size_t i = first_wrong_; i < ours.size(); ++i) our_rest.push_back(cell_of(ours[i].values));
  if (rest.size() < 2) return {Follows::untold, ""};
  const std::size_t both = std::min(rest.size(), our_rest.size());
  if (both > 1 &&
      std::equal(rest.begin() + 1, rest.begin() + static_cast<std::ptrdiff_t>(both), our_rest.begin() + 1) &&
      rest.size() == our_rest.size()) {
    return {Follows::yes, "all later pixels are right"};
  }
  const auto moved = [&](std::size_t i) { return glm::i64vec2(rest[i]) - glm::i64vec2(our_rest[i]); };
  std::size_t same = 1;
  while (same < both && moved(same) == moved(0)) ++same;
  if (both > 1 && same == both) {
    return {Follows::yes, fmt::format("all later pixels follow rightly from there, moved by ({}, {})",
                                      moved(0).x, moved(0).y)};
  }
  const Checking* checking = task_.topic.checking;
  if (!checking || !checking->goes_on) return {Follows::untold, ""};
  const std::size_t good = checking->goes_on(task_.arguments, rest);
  if (good >= rest.size())
    return {Follows::yes,
            "all later pixels follow from there by the rule, from a wrong value of its variable"};
  return {Follows::no, fmt::format("pixel {} does not follow from those before", first_wrong_ + good + 1)};
}

std::pair<Follows, std::string> Comparison::later(std::int64_t first_step) const {
  if (!steps_.empty()) {
    if (const auto told = later_steps(first_step); told.first != Follows::untold) return told;
  }
  if (in_order_) return later_cells();
  return {Follows::untold, ""};
}

}  // namespace gradus::check
