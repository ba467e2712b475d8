#pragma once
// Several drawings on one sheet, in the same axes and scale: steps of a run, or a step of two runs.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "figure/figure.hpp"

namespace gradus {

/// One drawing among several.
struct SheetPanel {
  Figure figure;              ///< whose drawing is shown, and where it has one of its own, its sentence
  std::string heading, note;  ///< above it: at the left what it shows, at the right what is to be seen in it
  bool faulty = false;        ///< its heading is in the colour of faults
  bool parts = false;         ///< its note is, too
  std::optional<dvec2> ring;  ///< of the grid: what is pointed at
  std::vector<std::pair<std::string, std::string>> counts{};  ///< below its heading: "cuts" and "4"
};

/// What the sheet says of all panels.
struct PanelBand {
  /// Title, subtitle, method, fault, legend and longest sentence; its steps are not looked at.
  Trace banner;
  std::string position;  ///< in the footer
  std::string sentence;  ///< below all panels; empty: each has its figure's own below itself
  /// The figures' own, or the longest that they may have: also where there is one for all, they stand there
  /// if the drawings are as large with them.
  std::vector<std::string> own_sentences{};
  bool counted = false;  ///< panels have counts
};

/// Lays out as many panels as there are runs named in `runs`: the i-th panel shows a step of runs[i], and
/// panel(i) is asked for when its turn comes and must live until the next is asked for. Panels stand side by
/// side or in rows, so that their drawings are as large as can be. Throws ContractViolation as lay_out does,
/// and for a look that shows no drawing.
Sheet lay_out_panels(std::span<const Trace* const> runs, const PanelBand& band, const Look& look,
                     const std::function<SheetPanel(std::size_t)>& panel);

}  // namespace gradus
