#pragma once
// `gradus render SCENE --frames`: the pictures that a camera sees on its path.

#include "cli/commands/commands.hpp"

namespace gradus::cli {

/// Whether a request of `gradus render` asks for files of frames, or for a film of them, rather than for one
/// picture. It has an output. Throws UsageError for flags that only frames have a use for.
bool asks_for_frames(const Request& request);

/// Renders the frames, several at once, each into a file of its own that appears whole; those that are there
/// already, made by the same command from the same files, are left as they are. Or a film, an MP4.
/// Throws UsageError, InputError and WorkError.
int render_frames(const Request& request);

}  // namespace gradus::cli
