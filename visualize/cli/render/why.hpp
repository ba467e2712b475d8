#pragma once
// Why a pixel is what it is, told by `gradus render SCENE --why C,R`.

#include <functional>
#include <string>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/render.hpp"
#include "cli/files/files.hpp"
#include "plot/pixel_figure.hpp"
#include "why/why.hpp"

namespace gradus::cli {

/// Prints it. Throws UsageError and InputError.
void print_why(const Request& request);

/// Draws it, as the name's ending says. find, on_read: as for rendered(). Throws UsageError, InputError and
/// WorkError.
void draw_why(const Request& request, const Output& output, const FindFile& find,
              const std::function<void(const RenderBrief&)>& on_read);

/// Refuses an output that can't be such a figure's by its name. Throws UsageError.
void check_why_output(const std::string& output);

/// The story as it is drawn. picture: all of it, antialiased.
plot::PixelFigure pixel_figure(const std::string& name, const pipeline::Scene& scene,
                               const pipeline::PixelStory& story, Image picture);

}  // namespace gradus::cli
