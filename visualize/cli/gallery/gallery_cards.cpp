#include "cli/gallery/gallery_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "cli/commands/figure.hpp"
#include "cli/gallery/gallery_steps.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"
#include "text/snippet.hpp"
#include "web/topic_page.hpp"

namespace gradus::cli {

namespace {

/// Links to single files of one format on a card.
constexpr std::size_t most_links = 12;

const Method& method_of(const LectureFigure& figure) {
  return *std::ranges::find(figure.spec.topic->methods, figure.spec.arguments.text("method"), &Method::name);
}

/// What is wrong with the method; empty where nothing is.
std::string fault_of(const LectureFigure& figure) {
  const Method& method = method_of(figure);
  return method.standing == Standing::faulty ? method.note : "";
}

/// What the lecturer calls the figure among those of its topic: its title, else its name without the topic's,
/// else the method's title.
std::string short_title_of(const LectureFigure& figure) {
  if (!figure.spec.look.title.empty()) return figure.spec.look.title;
  std::string_view name = figure.name;
  if (name.starts_with(figure.spec.topic->name)) name.remove_prefix(figure.spec.topic->name.size());
  std::string words(name.substr(std::min(name.find_first_not_of("_-"), name.size())));
  std::ranges::replace(words, '_', ' ');
  return words.empty() ? method_of(figure).title : words;
}

/// The file that the card's command makes: a PDF, for it holds everything, else the first kind there is.
Format format_of_command(const LectureFigure& figure) {
  const bool has_pdf = std::ranges::find(figure.outputs, Format::pdf) != figure.outputs.end();
  return has_pdf ? Format::pdf : figure.outputs.front();
}

/// Whether the card's command has to say this flag.
bool figure_says(const LectureFigure& figure, const std::string& flag, Format format) {
  return flag != "caption" && fitting(figure.spec, format).said.contains(flag);
}

std::string title_of(const LectureRender& render) {
  return render.title.empty() ? render.brief.colophon.title : render.title;
}

/// Lines for slides that show the figure's files: for each kind of lecture the files that suit it best.
std::vector<std::pair<std::string, std::string>> snippets_of(const LectureFigure& figure,
                                                             const Takes& takes) {
  const FigureSpec& spec = figure.spec;
  const Trace& trace = takes.opening();
  const std::string stem = figure.name + "/" + figure.name;
  const std::string title = spec.look.title.empty() ? trace.title : spec.look.title;
  const std::string alt = figure.caption.empty() ? trace.goal : figure.caption;
  std::vector<std::pair<std::string, std::string>> snippets;
  const auto add = [&](std::string name, SnippetKind kind, Format format,
                       const std::vector<StepNumber>& steps) {
    SnippetFigure shown{std::string(name_of(format)),
                        fmt::format("{} {}", title, trace.subtitle),
                        spec.look.slots.contains(Slot::title),
                        {}};
    const bool series = is_picture(format) && steps.size() > 1;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string number = series ? "-" + text_of(steps[i]) : "";
      shown.steps.push_back({fmt::format("{}{}.{}", stem, number, name_of(format)),
                             format == Format::pdf ? static_cast<int>(i) + 1 : 0, alt});
    }
    snippets.emplace_back(std::move(name), snippet_of(kind, shown));
  };
  const auto makes = [&figure](Format format) {
    return std::ranges::find(figure.outputs, format) != figure.outputs.end();
  };
  if (makes(Format::pdf) && !spec.handout) {
    add("Beamer", SnippetKind::beamer, Format::pdf, page_steps(paged(spec, takes), takes));
  }
  for (const Format format : {Format::html, Format::svg, Format::png}) {
    if (!makes(format)) continue;
    add("reveal.js", SnippetKind::reveal, format,
        is_picture(format) ? picture_steps(spec, takes) : std::vector{StepNumber{}});
    break;
  }
  for (const Format format : {Format::svg, Format::png}) {
    if (!makes(format)) continue;
    add("Markdown", SnippetKind::markdown, format, picture_steps(spec, takes));
    break;
  }
  return snippets;
}

/// Links to the copies of its inputs.
void add_inputs(Card& card, const LecturePart& part) {
  for (const std::string& name : copied_names(part)) {
    card.downloads.emplace_back("input " + name, part.name + "/" + name);
  }
}

/// Links to the figure's files of one format.
void add_downloads(Card& card, const LectureFigure& figure, std::span<const ManifestFile> files,
                   Format format) {
  const std::string stem = figure.name + "/" + figure.name, ending = fmt::format(".{}", name_of(format));
  std::vector<std::string> steps;
  for (const ManifestFile& file : files) {
    if (file.path == stem + ending) {
      card.downloads.emplace_back(facts_of(format).label, file.path);
    } else if (file.path.starts_with(stem + "-") && file.path.ends_with(ending) &&
               file.path != card.thumbnail) {
      steps.push_back(file.path);
    }
  }
  if (steps.size() > most_links) {
    card.downloads.emplace_back(fmt::format("{} of {} steps", facts_of(format).label, steps.size()),
                                figure.name + "/");
    return;
  }
  for (const std::string& path : steps) {
    const std::size_t start = stem.size() + 1;
    const std::string step = path.substr(start, path.size() - ending.size() - start);
    card.downloads.emplace_back(fmt::format("{}, step {}", facts_of(format).label, step), path);
  }
}

/// Lines for slides that show the picture.
std::vector<std::pair<std::string, std::string>> snippets_of(const LectureRender& render) {
  const std::string& alt = render.caption.empty() ? render.brief.colophon.description : render.caption;
  const SnippetFigure shown{
      "png", title_of(render), false, {{fmt::format("{0}/{0}.png", render.name), 0, alt}}};
  return {{"Beamer", snippet_of(SnippetKind::beamer, shown)},
          {"reveal.js", snippet_of(SnippetKind::reveal, shown)},
          {"Markdown", snippet_of(SnippetKind::markdown, shown)}};
}

}  // namespace

std::string base_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::vector<std::string> copied_names(const LecturePart& part) {
  std::vector<std::string> names;
  for (const std::string& path : part.copies) {
    const std::string name = base_of(path);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

bool has_zip(const LectureFigure& figure) {
  return std::ranges::all_of(std::array{Format::svg, Format::png}, [&figure](Format format) {
    return std::ranges::find(figure.outputs, format) != figure.outputs.end();
  });
}

bool has_thumbnail(const LectureRender& render) {
  return std::max(render.brief.width, render.brief.height) > largest_thumbnail;
}

std::string thumbnail_name(const LectureRender& render) {
  return render.name + (has_thumbnail(render) ? "-small.png" : ".png");
}

std::string title_of(const LectureFigure& figure) {
  const std::string& given = figure.spec.look.title;
  const std::string title =
      given.empty() ? fmt::format("{}: {}", figure.spec.topic->title, method_of(figure).title) : given;
  const std::string fault = fault_of(figure);
  return fault.empty() ? title : fmt::format("{} (faulty: {})", title, fault);
}

std::string short_command(const LectureFigure& figure) {
  const Request& request = figure.request;
  const Format format = format_of_command(figure);
  std::string line = fmt::format("gradus figure {}", figure.spec.topic->name);
  for (const Arguments::Entry& entry : figure.spec.arguments.entries()) {
    const auto given = request.arguments.find(entry.name);
    if (given == request.arguments.end()) continue;
    line += " " + flag_with(hyphened(entry.name), entry.hash.empty() ? given->second : entry.text);
  }
  for (const auto& [flag, value] : request.flags) {
    if (!figure_says(figure, flag, format)) continue;
    line += " " + (value.empty() ? "--" + flag : flag_with(flag, value));
  }
  for (const std::string& label : request.labels) line += " --label " + shell_quoted(label);
  const bool series = is_picture(format) && request.has("steps");
  return fmt::format(
      "{} -o {}", line,
      shell_quoted(fmt::format("{}{}.{}", figure.name, series ? "-{step}" : "", name_of(format))));
}

namespace {

Card card_of(const LectureFigure& figure, std::span<const ManifestFile> files, const Takes& takes) {
  const auto makes = [&figure](Format format) {
    return std::ranges::find(figure.outputs, format) != figure.outputs.end();
  };
  const std::string stem = figure.name + "/" + figure.name;
  Card card;
  card.slug = figure.name;
  card.title = title_of(figure);
  card.chapter = figure.spec.topic->chapter;
  card.caption = figure.caption;
  if (makes(Format::pdf) && !figure.spec.chooses_steps() && is_cut(takes.last())) {
    card.caption += fmt::format("{}(The PDF shows at most {} of the {} steps, evenly spaced.)",
                                card.caption.empty() ? "" : " ", most_gallery_pages, takes.last() + 1);
  }
  card.command = short_command(figure);
  card.thumbnail = stem + "-drawing.svg";
  if (makes(Format::html)) card.player = stem + ".html";
  // The most useful first, whatever the order in the lecture
  for (const Format format : {Format::pdf, Format::pptx, Format::svg, Format::png, Format::gif, Format::mp4,
                              Format::webp, Format::csv, Format::md, Format::tex, Format::json, Format::txt,
                              Format::obj, Format::ply, Format::stl}) {
    if (makes(format)) add_downloads(card, figure, files, format);
  }
  add_inputs(card, figure);
  if (has_zip(figure)) card.zip = stem + "-steps.zip";
  const TopicEntry& topic = *figure.spec.topic;
  card.group = {topic.name, topic.title, topic_page_path(topic)};
  card.name = short_title_of(figure);
  card.faulty = fault_of(figure);
  const bool drawn = std::ranges::find(files, stem + ".svg", &ManifestFile::path) != files.end();
  if (drawn) card.slide = stem + ".svg";
  card.snippets = snippets_of(figure, takes);
  card.words = figure.spec.topic->aliases;
  card.words.insert(card.words.end(), {figure.spec.topic->name, figure.spec.arguments.text("method")});
  return card;
}

Card card_of(const LectureRender& render) {
  const std::string folder = render.name + "/", picture = folder + render.name + ".png";
  Card card;
  card.slug = render.name;
  card.title = title_of(render);
  card.chapter = "pipeline";
  card.group = {"render", "Rendered models", ""};
  card.caption = render.caption;
  card.command = fmt::format("{} -o {}.png", render.brief.colophon.command, render.name);
  card.thumbnail = folder + thumbnail_name(render);
  card.opened = picture;
  card.downloads.emplace_back("PNG", picture);
  add_inputs(card, render);
  card.snippets = snippets_of(render);
  card.words = {"render", base_of(render.files.front())};
  return card;
}

/// "run lengths: (0, 0) to (14, 5)", for the topic's page.
TopicFigure topic_figure(const LectureFigure& figure, const Card& card, const Trace& trace) {
  const std::string faulty = trace.faulty.empty() ? "" : " (faulty)";
  return {figure.spec.topic, fmt::format("{}{}: {}", trace.method_title, faulty, trace.subtitle),
          card.player};
}

}  // namespace

GalleryEntry entry_of(const LectureFigure& figure, std::span<const ManifestFile> files, const Takes& takes) {
  Card card = card_of(figure, files, takes);
  TopicFigure linked = topic_figure(figure, card, takes.opening());
  return {std::move(card), std::move(linked)};
}

GalleryEntry entry_of(const LectureFigure& figure, std::span<const ManifestFile> files) {
  const FigureSpec& spec = figure.spec;
  return entry_of(figure, files,
                  Takes(*spec.topic, spec.arguments, spec.wording, spec.listing, beside_of(spec)));
}

GalleryEntry entry_of(const LectureRender& render) { return {card_of(render), {}}; }

}  // namespace gradus::cli
