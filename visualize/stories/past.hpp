#pragma once
// The steps that a run has reported so far: what a drawing on paper is a function of. A story that is a Past
// keeps nothing by hand; of its class are left `draw` and what is said of each step:
//
//   class Story : public Past<steps::Started, Entered, Finer<Compared>, Finished> {
//    public:
//     View draw() const;                       // of all(), last() and now()
//     Event say(const Entered& e) const;
//   };

#include <cstddef>
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
    its.last = ++count_;
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
    return at<Step>() == count_ ? last<Step>() : nullptr;
  }
  /// The last one of a type, if none of the other types came after it.
  template <class Step, class... Others>
  const Step* since() const {
    return ((at<Step>() > at<Others>()) && ...) ? last<Step>() : nullptr;
  }

 private:
  template <class Step>
  struct Steps {
    std::vector<Step> all{};
    std::size_t last = 0;  ///< as which step of all the last one came, from 1 on; 0: none did
  };
  template <class Step>
  struct Kept {
    using type = Steps<Step>;
  };
  template <class Step>
  struct Kept<Finer<Step>> {
    using type = Steps<Step>;
  };
  template <class Step>
  std::size_t at() const {
    return std::get<Steps<Step>>(kept_).last;
  }

  std::tuple<typename Kept<Told>::type...> kept_;
  std::size_t count_ = 0, turn_ = 0;
};

}  // namespace gradus
