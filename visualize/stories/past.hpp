#pragma once
// The steps that a run has reported so far: what a drawing on paper is a function of. A story that is a Past
// keeps nothing by hand - at most what every step changes, an order say, in a `take` of its own; of its class
// are left `draw` and what is said of each step:
//
//   class Story : public Past<steps::Started, Entered, Finer<Compared>, Finished> {
//    public:
//     View draw() const;                       // of all(), last() and now()
//     Event say(const Entered& e) const;
//   };

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace gradus {

/// A step that is told as a finer event, behind the last whole number.
template <class Step>
struct Finer {};

/// A step that is neither told nor kept.
template <class Step>
struct Untold {};

template <class... Told>
class Past {
 public:
  template <class Step>
  void take(const Step& step) {
    auto& its = std::get<Steps<Step>>(kept_);
    its.all.push_back(step);
    its.numbers.push_back(count_++);
  }
  template <class Step>
  static constexpr bool is_finer = (std::is_same_v<Told, Finer<Step>> || ...);
  template <class Step>
  static constexpr bool is_untold = (std::is_same_v<Told, Untold<Step>> || ...);

  /// The input at hand, of a run over many.
  std::size_t turn() const { return turn_; }
  void turn_to(std::size_t input) { turn_ = input; }

  /// Those of a type, in their order.
  template <class Step>
  const std::vector<Step>& all() const {
    return std::get<Steps<Step>>(kept_).all;
  }
  /// The last one of a type, or nullptr.
  template <class Step>
  const Step* last() const {
    return all<Step>().empty() ? nullptr : &all<Step>().back();
  }
  /// The step at hand where it is of this type, else nullptr.
  template <class Step>
  const Step* now() const {
    return end<Step>() == count_ ? last<Step>() : nullptr;
  }
  /// The last one of a type, if none of the other types came after it.
  template <class Step, class... Others>
  const Step* since() const {
    return ((end<Step>() > end<Others>()) && ...) ? last<Step>() : nullptr;
  }
  /// Those of a type that came after the last one of another.
  template <class Step, class Other>
  std::span<const Step> all_since() const {
    const auto& numbers = std::get<Steps<Step>>(kept_).numbers;
    const auto before = std::ranges::lower_bound(numbers, end<Other>()) - numbers.begin();
    return std::span(all<Step>()).subspan(static_cast<std::size_t>(before));
  }
  /// As which step of all the i-th one of a type came, both from 0 on.
  template <class Step>
  std::size_t number_of(std::size_t i) const {
    return std::get<Steps<Step>>(kept_).numbers[i];
  }

 private:
  template <class Step>
  struct Steps {
    std::vector<Step> all{};
    std::vector<std::size_t> numbers{};  ///< as which step of all each one came
  };
  template <class Step>
  struct Kept {
    using type = Steps<Step>;
  };
  template <class Step>
  struct Kept<Finer<Step>> {
    using type = Steps<Step>;
  };
  /// Behind the last one of a type; 0 where there was none.
  template <class Step>
  std::size_t end() const {
    const auto& numbers = std::get<Steps<Step>>(kept_).numbers;
    return numbers.empty() ? 0 : numbers.back() + 1;
  }

  std::tuple<typename Kept<Told>::type...> kept_;
  std::size_t count_ = 0, turn_ = 0;
};

}  // namespace gradus
