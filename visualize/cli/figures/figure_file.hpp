#pragma once
// A figure as a file's bytes: what it shows, in which format, and the command that makes it again.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/figures/figure_spec.hpp"
#include "cli/figures/formats.hpp"
#include "request/takes.hpp"

namespace gradus::cli {

FilmFormat film_format(Format format);

/// A figure has one page per step in PDF; more than this are not put into one file.
inline constexpr std::int64_t most_pages = 1000;

/// --format, or the ending of the output's name; SVG for standard output. Throws UsageError.
Format read_format(const Request& request, const std::string& output);

/// What is shown of a run where no step is named: Trace::telling, where it is kept.
StepNumber telling_step(const Takes& takes);
/// The one step that an SVG or PNG shows: --step, else the telling one, or where runs are compared
/// compared_step. Throws UsageError when there is none.
StepNumber shown_step(const FigureSpec& spec, const Takes& takes);
/// The steps that a document or a series of files has: --steps or --step, else all whole ones that are
/// recorded.
std::vector<StepNumber> shown_steps(const FigureSpec& spec, const Takes& takes);

/// The step on its sheet, beside another run where the spec says so; with panels these, for any step.
Sheet sheet_in(const FigureSpec& spec, Takes& takes, StepNumber step, const Look& look);
/// The same in the spec's look; every letter of it can be drawn. Throws UsageError.
Sheet sheet_of(const FigureSpec& spec, Takes& takes, StepNumber step);

/// SVG or PNG.
std::string picture_bytes(const FigureSpec& spec, Takes& takes, StepNumber step, Format format);
/// The same of its sheet_of().
std::string picture_bytes(const Sheet& sheet, const FigureSpec& spec, Takes& takes, StepNumber step,
                          Format format);
/// Told that the i-th picture of a file has been drawn.
using OnDrawn = std::function<void(std::size_t i)>;
/// PDF, one page per step.
std::string pages_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps,
                        const OnDrawn& on_drawn = {});
/// PPTX, a slide per step.
std::string slides_bytes(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps,
                         const OnDrawn& on_drawn = {});
/// Throws UsageError for options out of a film's range, and for frames larger than films are shown, each of
/// which takes seconds.
void check_film(const FigureSpec& spec, Format format);
/// GIF, MP4, WebP: a frame per step, and what moves between them. `on_drawn` is told of each of
/// pictures_drawn(). Throws UsageError, WorkError.
std::string film_of(const FigureSpec& spec, Takes& takes, const std::vector<StepNumber>& steps, Format format,
                    const OnDrawn& on_drawn = {});
/// OBJ, PLY, STL: the surface that the run has made. Throws UsageError where it makes none.
std::string model_bytes(const FigureSpec& spec, const Trace& trace, Format format);
/// HTML, CSV, JSON, text: made from a trace. It is the opening of the run, or the part that the spec wants.
/// With `takes` the player shows the run that stands beside it, too.
std::string trace_bytes(const FigureSpec& spec, const Trace& trace, Format format,
                        const std::string& topic_page = "", const Takes* takes = nullptr);
/// The trace that those show; throws UsageError for steps that the run, or the format, has not.
Trace shown_part(const FigureSpec& spec, const Takes& takes, Format format);

}  // namespace gradus::cli
