#pragma once
// What a topic's benchmark file tells the instrument: which methods run on which inputs, and how far off
// their answers are. gradus-bench measures all of them the same way.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gradus::bench {

/// What a method is in its topic.
enum class Standing : std::uint8_t {
  taught,  ///< the textbook's
  faulty,  ///< wrong, kept as an exhibit
  robust,  ///< right on every input
  batch,   ///< right, and made for speed
  peer,    ///< somebody else's
};

constexpr std::string_view name_of(Standing standing) {
  constexpr std::string_view names[] = {"taught", "faulty", "robust", "batch", "peer"};
  return names[static_cast<std::size_t>(standing)];
}

/// How far a method's answers are from the oracle's, in the subject's unit.
struct Error {
  double max = 0, rms = 0;
  std::int64_t wrong = 0;  ///< decisions: accepted or not, another pixel, another count

  /// Adds the errors of single answers up.
  class Sum {
   public:
    void add(double off) {
      max_ = std::isfinite(off) ? std::max(max_, off) : off;
      squares_ += off * off;
      ++count_;
    }
    void wrong_decision() { ++wrong_; }
    Error error() const {
      return {max_, count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0, wrong_};
    }

   private:
    double max_ = 0, squares_ = 0;
    std::int64_t count_ = 0, wrong_ = 0;
  };
};

/// An input: a mix of items, or one of a series that grows.
struct Workload {
  std::string name;
  double size = 0;  ///< of a series, in the subject's measure; 0: not part of it
};

/// One method on one workload, ready to run.
struct Case {
  std::string method;
  Standing standing = Standing::taught;
  Workload workload;
  std::int64_t items = 1;           ///< that one run works off
  std::function<void()> run;        ///< what is timed
  std::function<void()> prepare{};  ///< before each run, not timed: a fresh canvas
  std::optional<Error> error{};     ///< nothing where there is no oracle
};

/// How long to measure.
struct Effort {
  int repetitions = 9;
  double seconds = 0.05;  ///< a repetition
};

/// The same picture by us and by somebody else's program, in one run.
struct Duel {
  std::string workload;
  double ms = 0;                    ///< a picture, the median of the repetitions
  std::optional<double> peer_ms{};  ///< nothing where the peer is not there
  int max_pixel_difference = 0;     ///< steps of 255, in the component that differs most
  std::int64_t pixels_off = 0;      ///< that differ by more than one step

  std::optional<double> ratio() const { return peer_ms ? std::optional(ms / *peer_ms) : std::nullopt; }
};

/// Which method a reader should take, and why.
struct Choice {
  std::string method{};
  std::string why{};  ///< goes on after "Choose METHOD: ", without a full stop
};

/// A topic's part of the benchmark.
struct Subject {
  std::string topic;
  std::string title;    ///< of its figures: "Segments against a window"
  std::string item;     ///< what one item is: "segment"
  std::string unit;     ///< of errors, as after "worst error, in": "ulp"
  std::string measure;  ///< what the series' sizes count: "length in pixels"; empty: there is no series
  std::string telling;  ///< the workload of the figure of time against error
  std::vector<Case> (*cases)();
  bool refined = false;  ///< the series makes errors smaller: a figure shows what that takes
  Choice choice{};       ///< marked in the charts; empty where it depends
  /// Measured instead of cases; `told` is called after each. peer: whom they are against, as it calls itself.
  std::vector<Duel> (*duels)(const Effort& effort, const std::function<void()>& told,
                             std::string& peer) = nullptr;
  std::size_t duel_count = 0;
  bool peer_is_built = false;  ///< whether its library was there at build time
};

/// Those of all topics, in the catalogue's order.
std::span<const Subject> subjects();

}  // namespace gradus::bench
