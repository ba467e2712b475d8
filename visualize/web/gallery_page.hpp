#pragma once
// The gallery: a page of cards that opens from the file system, without a network.

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gradus {

/// What the figures of one topic share: they stand in one frame.
struct CardGroup {
  std::string id;     ///< "bresenham_line"
  std::string title;  ///< "Bresenham line"
  std::string page;   ///< relative path of the page that explains it; empty: none
};

/// A card of the gallery: one figure among those of its topic.
struct Card {
  std::string slug, title, chapter, caption;
  CardGroup group{};
  std::string name{};  ///< what the lecturer calls it, beside others of its topic: "steep"; empty: the title
  std::string faulty{};   ///< what is wrong with the run it shows; empty: nothing
  std::string command;    ///< to make it again
  std::string thumbnail;  ///< relative path of a picture: the drawing of the most telling step
  std::string player;     ///< relative path; empty: none
  std::vector<std::pair<std::string, std::string>> downloads{};  ///< (name shown, relative path)
  std::vector<std::string> words{};  ///< more to find it by: topic, aliases, method
  std::string opened{};  ///< relative path: what a click on the thumbnail opens where there is no player;
                         ///< empty: the thumbnail
  std::string slide{};   ///< relative path of its most telling step as a whole slide; empty: none
  std::string zip{};     ///< relative path: its steps as pictures; empty: none
  std::vector<std::pair<std::string, std::string>> snippets{};  ///< (for what: "Beamer", lines to paste)
};

/// What stands above the cards.
struct GalleryOptions {
  std::string title = "Gradus";
  std::string intro =
      "Computer graphics, step by step. Every figure here is drawn from a run of the algorithm's own code: "
      "open "
      "one and step through it, or take it for your slides.";
  std::string zip{};     ///< relative path: everything in one file; empty: none
  std::string errata{};  ///< relative path: the page of errata; empty: none
};

/// out/index.html.
std::string gallery_page(std::span<const Card> cards, const GalleryOptions& options = {});

}  // namespace gradus
