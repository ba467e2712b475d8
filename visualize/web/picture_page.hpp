#pragma once
// A rendered picture as a page that tells of each of its pixels: opens from the file system, without a
// network.

#include <string>
#include <vector>

#include "figure/colophon.hpp"

namespace gradus {

/// What such a page holds.
struct PicturePage {
  Colophon colophon;
  std::string png;  ///< the picture
  int width = 0, height = 0;
  std::vector<std::string> forms, shared, rows;  ///< of a TextPack: a block per row, a text per pixel
};

/// One HTML file. A click on a pixel shows its text, as do arrow keys and Enter.
std::string picture_page(const PicturePage& page);

}  // namespace gradus
