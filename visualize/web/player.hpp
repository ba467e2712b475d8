#pragma once
// Pages that open from the file system, without a network.

#include <set>
#include <span>
#include <string>
#include <vector>

#include "figure/colophon.hpp"
#include "figure/sheet.hpp"
#include "figure/trace.hpp"

namespace gradus {

struct PlayerOptions {
  std::set<Slot> slots{all_slots.begin(), all_slots.end()};  ///< what is shown; of the rest not even the data
  std::string theme{};       ///< the page's first theme; empty: what the reader's system prefers
  std::string topic_page{};  ///< relative path of the page about the algorithm; empty: none
};
/// The offline player: one HTML file with the trace in it, drawn from its marks by the page's own script. Its
/// own words are in the language of the trace.
std::string player_page(const Trace& trace, const Colophon& colophon, const PlayerOptions& options = {});

/// A card of the gallery.
struct Card {
  std::string slug, title, chapter, caption;
  std::string command;    ///< to make it again
  std::string thumbnail;  ///< relative path of an SVG: the drawing of the most telling step
  std::string player;     ///< relative path
  std::vector<std::pair<std::string, std::string>> downloads;  ///< (name shown, relative path)
};
/// out/index.html.
std::string gallery_page(std::span<const Card> cards);

}  // namespace gradus
