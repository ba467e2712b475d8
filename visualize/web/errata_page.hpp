#pragma once
// The page of errata: what docs/errata.md says, with the wrong form drawn beside the right one.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// An entry of docs/errata.md.
struct Erratum {
  std::string id;                               ///< "E001-05"
  std::string kind;                             ///< W, G, F or D
  std::string says, why, right, exhibit, test;  ///< Markdown
  std::string section;                          ///< "Circles"
};

/// The entries of class W (wrong) and F (fragile), in the order of the file.
std::vector<Erratum> wrong_and_fragile();

/// A line of the wrong form's source, round the one to blame.
struct ExhibitLine {
  std::string text;
  bool culprit = false;  ///< the one to blame
  Change change = Change::none;
};

/// One side of an exhibit: a run, at the step where the two part.
struct ExhibitSide {
  std::string name, title;  ///< of the method: "late_update", "late update"
  std::string picture;      ///< SVG; empty where the run is refused
  std::string sentence;     ///< of the step
  std::string command;      ///< that draws it
};

/// A wrong form run beside the right one, which may refuse the input.
struct Exhibit {
  std::string id;     ///< of the erratum
  std::string title;  ///< "Bresenham circle, radius 7"
  ExhibitSide wrong, right;
  std::vector<ExhibitLine> source;  ///< of the wrong form, round its culprit
  std::string refusal;     ///< what the right one says to the input instead of taking it; empty: it takes it
  std::string parting;     ///< where the runs part; empty: nowhere that both have
  std::string outcome;     ///< what the results differ in; empty: nothing that both tell
  std::string difference;  ///< in pixels
};

/// An input in a reading: what it says, and what becomes of it.
struct ReadingRow {
  std::string input, wrong, right;
};

/// A wrong way to read text beside the right one: no steps, but several small inputs and what becomes of
/// each.
struct Reading {
  std::string id;      ///< of the erratum
  std::string reader;  ///< the faulty function
  std::string title;   ///< "Names of materials"
  std::string frame;   ///< the text that stands before every input; empty: none
  std::string wrong_head, right_head;
  std::vector<ReadingRow> rows;
};

/// Whether this is what an entry is about. Two entries may have one id: the entry names the method, too.
bool shows(const Exhibit& exhibit, const Erratum& erratum);
bool shows(const Reading& reading, const Erratum& erratum);

/// out/errata.html: every entry, with the exhibits and readings of its id.
std::string errata_page(std::span<const Erratum> errata, std::span<const Exhibit> exhibits,
                        std::span<const Reading> readings = {});

}  // namespace gradus
