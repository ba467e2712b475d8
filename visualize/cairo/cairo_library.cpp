#include "cairo/cairo_library.hpp"

namespace gradus {

const CairoLibrary& cairo() {
  static const CairoLibrary library{.library = {GRADUS_CAIRO, "pictures"}};
  return library;
}

}  // namespace gradus
