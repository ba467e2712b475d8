#include "cli/commands.hpp"

#include <fmt/format.h>

#include "cli/errors.hpp"
#include "cli/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

const Flag output{"output", 'o', "FILE", ""};
const Flag step{"step", 0, "N", "one step: a number like 4, or 4.1 for a finer event after it"};
const Flag steps{"steps", 0, "LIST", "several: 3-9, or 1,4,9-12; 0-100/5 takes every fifth"};
const Flag slots{"slots", 0, "LIST", "parts to show: title,drawing,listing,table,sentence,footer"};
const Flag theme{"theme", 0, "NAME", "light, dark, greyscale or high_contrast"};
const Flag size{"size", 0, "WxH", "width and height in pixels; default 1280x720"};
const Flag format{"format", 0, "NAME",
                  "svg, png, pdf, html, csv, json or txt; default: by the file's ending"};

Flag with_help(Flag flag, const char* help) {
  flag.help = help;
  return flag;
}

std::vector<Command> all_commands() {
  return {
      {"list",
       "one WORD",
       "the topics, by chapter; WORD searches names, aliases and titles",
       0,
       1,
       false,
       {{"json", 0, "", "as JSON"}},
       {"gradus list", "gradus list fill", "gradus list --json"}},
      {"help",
       "one TOPIC or command",
       "a topic's inputs, units and methods, with examples to paste",
       0,
       1,
       false,
       {},
       {"gradus help", "gradus help TOPIC", "gradus help figure"}},
      {"run",
       "a TOPIC",
       "runs a topic and prints its step table",
       1,
       1,
       true,
       {{"json", 0, "", "as JSON: topic, method, input, steps, result"}, step, steps},
       {"gradus run TOPIC", "gradus run TOPIC --method NAME --json", "gradus run TOPIC --steps 3-9"}},
      {"figure",
       "a TOPIC",
       "draws steps of a topic into files",
       1,
       1,
       true,
       {with_help(output, "where to; {step} in the name makes one file a step; - is standard output"), step,
        steps, slots, theme, size, format},
       {"gradus figure TOPIC -o line.svg", "gradus figure TOPIC --step 4 --theme dark -o line.png",
        "gradus figure TOPIC -o 'line-{step}.png'    one file a step",
        "gradus figure TOPIC -o line.pdf             one page a step",
        "gradus figure TOPIC -o line.html            the player, to step through in a browser"}},
      {"figures",
       "one LECTURE",
       "draws every figure of a lecture, or of the built-in gallery; only what has changed",
       0,
       1,
       false,
       {with_help(output, "the folder; default out"),
        {"check", 0, "", "reads the lecture and reports every problem; draws nothing"},
        {"schema", 0, "", "prints the JSON Schema of lectures, for editors that check while you type"},
        {"only", 0, "GLOB", "only figures or topics with such a name; * and ? stand for any letters"},
        {"jobs", 'j', "N", "how many at once; default: the usable cores"},
        {"force", 'f', "", "all anew"}},
       {"gradus figures -o out/", "gradus figures my_lecture.json -o out/",
        "gradus figures my_lecture.json --check", "gradus figures -o out/ --only 'TOPIC*'",
        "gradus figures -o out/ --jobs 2 --force"}},
      {"again",
       "a FILE",
       "makes a figure again from what it carries in its metadata",
       1,
       1,
       false,
       {with_help(output, "where to; default: beside the figure, with -again in its name"), step, steps,
        slots, theme, size, format},
       {"gradus again line.svg", "gradus again line.svg --theme dark",
        "gradus again line.svg --step 2 -o line-2.png"}},
  };
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> all = all_commands();
  return all;
}

std::span<const Flag> common_flags() {
  static const std::vector<Flag> flags{
      {"color", 0, "WHEN", "auto, always or never: colours in the terminal"},
      {"quiet", 'q', "", "no progress and no remarks"},
      {"help", 'h', "", "this help"},
      {"version", 0, "", "the version of gradus and of the libraries it uses"},
  };
  return flags;
}

Color Request::color() const {
  const auto wanted = flags.find("color");
  return wanted == flags.end() ? Color::automatic : read_color(wanted->second);
}

const TopicEntry& find_topic(std::string_view word) {
  // All names and aliases in one list; each points back to its topic
  std::vector<std::string> names;
  std::vector<const TopicEntry*> owners;
  for (const TopicEntry* topic : catalogue()) {
    names.push_back(topic->name);
    owners.push_back(topic);
    for (const std::string& alias : topic->aliases) {
      names.push_back(alias);
      owners.push_back(topic);
    }
  }
  const std::vector<std::size_t> matches = matching_names(word, names);
  std::vector<std::string> meant;
  for (const std::size_t i : matches) {
    if (meant.empty() || meant.back() != owners[i]->name) meant.push_back(owners[i]->name);
  }
  if (meant.size() == 1) return *owners[matches.front()];
  if (meant.empty()) {
    throw UsageError(fmt::format("TOPIC: expected the name of a topic (`gradus list` shows all), found {}{}",
                                 shown(word), suggestion(word, names)));
  }
  return *owners[matches[choose_name("TOPIC", word, meant)]];
}

}  // namespace gradus::cli
