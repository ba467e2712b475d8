// `gradus run`: the step table in the terminal.

#include <fmt/format.h>

#include <algorithm>

#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/files/files.hpp"
#include "json/json.hpp"
#include "request/openings.hpp"
#include "request/takes.hpp"
#include "text/text_output.hpp"
#include "text/wrap.hpp"

namespace gradus::cli {

int run(const Request& request) {
  const Inputs inputs = read_inputs(*request.topic, opened(*request.topic, request.arguments));
  const FigureSpec spec = read_spec(request, inputs.arguments);
  const Takes takes(*request.topic, spec.arguments, spec.wording, spec.listing);
  if (!request.quiet()) std::ranges::for_each(inputs.remarks, note);
  const bool json = request.has("json");
  const Trace trace = chosen_part(spec, takes);
  const bool color = !json && use_color(request.color(), Stream::out);
  write_stream(Stream::out, json ? run_json(trace) : wrapped(text_of(trace, color), request.width()));
  if (const std::string remark = cut_remark(trace);
      !spec.chooses_steps() && !remark.empty() && !request.quiet())
    note(remark);
  return 0;
}

}  // namespace gradus::cli
