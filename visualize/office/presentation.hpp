#pragma once
// Steps as a presentation of slides that people can go on editing (PresentationML, ISO/IEC 29500-1): title,
// code, table and sentence are text in fonts that every Office has; the drawing is a vector picture.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "figure/colophon.hpp"
#include "figure/sheet.hpp"
#include "theme/theme.hpp"

namespace gradus {

/// A part of a sheet for those who show vectors, and the same in pixels for those who don't.
struct PictureBytes {
  std::string svg, png;
};

/// What a slide is made from.
struct PresentedStep {
  Sheet sheet;           ///< the laid out figure: what stands where
  std::string caption;   ///< of the drawing, for who can't see it
  std::string sentence;  ///< what the speaker's notes say
};

/// A file inside the presentation's zip.
struct PackagePart {
  std::string name, bytes;
  bool stored = false;  ///< not to be compressed, so that it can be found without unpacking
};

/// What draws a part of a sheet, without a ground.
using DrawPart = std::function<PictureBytes(const Sheet& part)>;

/// What a presentation says of itself.
struct PresentationCard {
  Colophon colophon;
  std::string markup;  ///< the colophon as an XML element: how the figure is made again
};

/// The parts of the package, in the order in which they are to be packed: one slide per step, all of the size
/// of the first sheet. step(i) is asked for when its turn comes. The same steps give the same bytes.
/// At least one step.
std::vector<PackagePart> presentation_of(std::size_t steps,
                                         const std::function<PresentedStep(std::size_t)>& step,
                                         const DrawPart& draw, const Theme& theme,
                                         const PresentationCard& card);

}  // namespace gradus
