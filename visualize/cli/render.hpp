#pragma once
// A model as a picture: what `gradus render` makes, and `gradus again` makes again.

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/inputs.hpp"
#include "figure/colophon.hpp"

namespace gradus::cli {

/// A picture of a model, as the bytes of a PNG.
struct Rendered {
  std::string png;
  Colophon colophon;                 ///< what the PNG says of itself
  std::vector<std::string> files;    ///< paths that were read: the model, then its material libraries
  std::vector<std::string> remarks;  ///< what the user should know and what is no mistake, a line each
};

/// Renders what a request of `gradus render` asks for. find: where the model lies; its material libraries lie
/// beside it. Throws UsageError and InputError.
Rendered rendered(const Request& request, const FindFile& find = as_named);

/// Writes the picture, and the remarks to stderr unless `quiet`. Throws UsageError, WorkError.
void write_rendered(const Rendered& picture, const std::string& output, bool quiet);

/// Refuses an output that can't be a picture's: no PNG by its name, a folder, a terminal. Throws UsageError.
void check_picture_output(const std::string& output);

}  // namespace gradus::cli
