#pragma once
// What a figure is to show and how: all that its canonical command says.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/commands.hpp"
#include "cli/figures/compare.hpp"
#include "cli/film/film.hpp"
#include "figure/figure.hpp"
#include "figure/handout.hpp"
#include "figure/text/wording.hpp"
#include "request/takes.hpp"
#include "theme/finish.hpp"

namespace gradus::cli {

/// What --panels asks for.
struct PanelChoice {
  static constexpr std::size_t least = 2, most = 8;
  bool phases = false;            ///< a drawing for each phase of the run
  std::vector<StepNumber> steps;  ///< else one for each of these
};

struct FigureSpec : StepChoice {
  const TopicEntry* topic = nullptr;
  Arguments arguments;
  std::optional<PanelChoice> panels;  ///< several drawings of the run on one sheet
  std::optional<OtherSide> compare;   ///< another run beside this one
  Look look;
  const Theme* theme = nullptr;
  bool transparent = false;
  std::optional<Rgb> ground;  ///< instead of the theme's paper
  double scale = 1;
  SvgText svg_text = SvgText::outlines;
  Wording wording;
  ListingForm listing = ListingForm::source;
  std::optional<PageGrid> handout;  ///< PDF: pages for print instead of a page per step
  Paper paper = papers().front();
  FilmOptions film;
  std::string caption;  ///< said before the one made from the step's sentence
  /// Canonical texts of the flags that differ from the defaults, by name: what the command will say.
  std::map<std::string, std::string> said;

  /// Whether the reader named the steps to show.
  bool chooses_steps() const { return names_steps() || panels; }
};

/// Takes all that the request says of how a figure looks; what it does not name stays. Throws UsageError.
void apply_flags(FigureSpec& spec, const Request& request);
FigureSpec read_spec(const Request& request, const Arguments& arguments);

/// "gradus figure <topic> --from 0,0 --to 7,3 --step 4 --theme dark": all arguments, and what differs from
/// the defaults of a figure.
std::string command_of(const FigureSpec& spec);

/// The spec of one step of it.
FigureSpec at_step(FigureSpec spec, StepNumber step);

/// The spec of these steps of it.
FigureSpec with_steps(FigureSpec spec, const std::vector<StepRange>& steps);

/// The run beside it, where there is one.
inline const OtherSide* beside_of(const FigureSpec& spec) { return spec.compare ? &*spec.compare : nullptr; }

/// Colours, ground and sharpness.
Finish finish_of(const FigureSpec& spec);

}  // namespace gradus::cli
