#pragma once
// Pages that open from the file system, without a network.

#include <span>
#include <string>
#include <vector>

#include "figure/colophon.hpp"
#include "figure/trace.hpp"

namespace gradus {

/// The offline player: one HTML file with the trace in it, drawn from its marks by the page's own script.
std::string player_page(const Trace& trace, const Colophon& colophon);

/// A card of the gallery.
struct Card {
  std::string slug, title, chapter, caption;
  std::string command;    ///< to make it again
  std::string thumbnail;  ///< relative path of an SVG: the drawing of the most telling step
  std::string player;     ///< relative path; empty: there is none
  std::vector<std::pair<std::string, std::string>> downloads;  ///< (name shown, relative path)
};
/// out/index.html. Without a title of its own it is Gradus's.
std::string gallery_page(std::span<const Card> cards, const std::string& title = "");

}  // namespace gradus
