#pragma once
// The page of errata: what docs/errata.md says, with the wrong form drawn beside the right one.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A wrong form run beside the right one, which may refuse the input.
struct Exhibit {
  std::string id;                            ///< of the erratum
  std::string title;                         ///< "Bresenham circle, radius 7"
  std::string wrong_name, right_name;        ///< of the methods
  std::string wrong_picture, right_picture;  ///< SVG; that of a right one that refuses the input is empty
  std::string wrong_command, right_command;
  std::string refusal;     ///< what the right one says to the input instead of taking it; empty: it takes it
  std::string parting;     ///< the first step that differs, and how; empty: none that both have
  std::string outcome;     ///< what the results differ in; empty: nothing that both tell
  std::string difference;  ///< in pixels
};

/// Whether this is what an entry is about. Two entries may have one id: the entry names the method, too.
bool shows(const Exhibit& exhibit, const Erratum& erratum);

/// out/errata.html: every entry, with the exhibits of its id.
std::string errata_page(std::span<const Erratum> errata, std::span<const Exhibit> exhibits);

}  // namespace gradus
