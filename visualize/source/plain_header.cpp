#include "source/plain_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/refusal.hpp"
#include "figure/colophon.hpp"
#include "source/code.hpp"
#include "source/inlined.hpp"
#include "source/unobserved.hpp"

namespace gradus::source {
namespace {

constexpr std::string_view root = "algorithms/";

/// Parts of core that a plain header lacks: watching, and what stands on other libraries.
struct LeftOut {
  std::string_view header;  ///< as it is included
  std::string_view type{};  ///< functions of which are left out with it
};
constexpr std::array<LeftOut, 4> left_out{{
    {"core/observe.hpp"},
    {"core/tally.hpp"},
    {"core/record.hpp"},
    {"core/arithmetic/exact_scalar.hpp", "Exact"},
}};

/// Files of core whose other half, a .cpp file, needs more than the standard library.
constexpr std::string_view needs_libpng = "core/image.hpp";

/// Headers with a text of their own here, and those that it stands for.
constexpr std::string_view contract = "core/contract.hpp", refusal = "core/refusal.hpp";

bool is_exhibit(std::string_view path) { return path.ends_with("_notes.hpp"); }

std::string cpp_of(std::string_view header) {
  return std::string(header.substr(0, header.size() - std::string_view("hpp").size())) + "cpp";
}

/// A file cut into what it includes and the rest.
struct Cut {
  std::vector<std::string> ours, others;  ///< "core/geometry.hpp"; <vector>
  std::string rest;
};

/// Takes the includes out of a text. What is included only under a condition stays where it is.
Cut cut(std::string_view text) {
  Cut parts;
  int conditions = 0;
  for (const std::string_view line : lines_in(text)) {
    if (line.starts_with("#if")) ++conditions;
    if (line.starts_with("#endif")) --conditions;
    constexpr std::string_view include = "#include ";
    if (line.starts_with("#pragma once")) continue;
    if (conditions > 0 || !line.starts_with(include)) {
      parts.rest += std::string(line) + "\n";
      continue;
    }
    const std::string_view named = line.substr(include.size());
    const std::string_view name = named.substr(0, named.find_first_of("\">", 1) + 1);
    if (name.starts_with('<')) {
      parts.others.emplace_back(name);
    } else {
      parts.ours.emplace_back(name.substr(1, name.size() - 2));
    }
  }
  return parts;
}

/// A file's place in a plain header.
struct Part {
  std::string path;  ///< as it is included
  std::string text;
};

/// What is collected for one header.
struct Collected {
  std::vector<Part> parts;
  std::set<std::string> others;  ///< what is included of GLM and the standard library
};

/// All headers of the catalogue without observers: which steps are of no more use anywhere shows only there.
class Catalogue {
 public:
  explicit Catalogue(const Files& files) : files_(files) {
    for (const std::string_view path : files.topic_headers) {
      if (!path.starts_with(root) || is_exhibit(path)) continue;
      Unwatched part = without_observers(files.text(path));
      for (std::string& step : declared_in(part.text, part.steps)) steps_[std::string(path)].push_back(step);
      texts_[std::string(path)] = std::move(part.text);
    }
    for (auto& [path, steps] : steps_) erase_unused(path, steps);
  }

  /// The headers of a topic that it has something of, its own first.
  std::vector<std::string> headers_of(std::string_view topic) const {
    const std::string folder = fmt::format("{}{}/", root, topic);
    const std::string own = fmt::format("{}{}.hpp", folder, topic.substr(topic.find('/') + 1));
    std::vector<std::string> headers{own.substr(root.size())};
    for (const auto& [path, text] : texts_) {
      if (path.starts_with(folder) && path != own && !needs_more(path))
        headers.push_back(path.substr(root.size()));
    }
    return headers;
  }

  std::string text(const std::string& header) const {
    const std::string path = std::string(root) + header;
    if (header == contract) return std::string(files_.text("visualize/source/parts/contract.hpp"));
    if (const auto topic = texts_.find(path); topic != texts_.end()) return topic->second;
    return std::string(files_.text(path));
  }

  /// The .cpp file of core that belongs to a header; empty when there is none that a plain header takes.
  std::string_view other_half(const std::string& header) const {
    return header == contract || header == needs_libpng ? "" : files_.text(root_path(cpp_of(header)));
  }

 private:
  static std::string root_path(std::string_view header) { return std::string(root) + std::string(header); }

  /// Batches with a .cpp file of their own are not one header's matter, and most need Highway.
  bool needs_more(const std::string& path) const { return !files_.text(cpp_of(path)).empty(); }

  bool is_used(const std::string& step, const std::string& declared_by) const {
    return std::ranges::any_of(texts_, [&](const auto& file) {
      const auto& [path, text] = file;
      const auto declared = steps_.find(path);
      const bool has_own = path != declared_by && declared != steps_.end() &&
                           std::ranges::find(declared->second, step) != declared->second.end();
      return !has_own && text.find(step) != nowhere && uses(text, step);
    });
  }

  void erase_unused(const std::string& path, const std::vector<std::string>& steps) {
    bool erased = true;
    while (erased) {
      erased = false;
      for (const std::string& step : steps) {
        std::string& text = texts_[path];
        if (declared_in(text, {step}).empty() || is_used(step, path)) continue;
        text = without_type(text, step);
        erased = true;
      }
    }
  }

  const Files& files_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::vector<std::string>> steps_;
};

const LeftOut* find_left_out(std::string_view header) {
  const auto* const found = std::ranges::find(left_out, header, &LeftOut::header);
  return found == left_out.end() ? nullptr : found;
}

/// Puts parts behind those that they include.
class Collector {
 public:
  explicit Collector(const Catalogue& catalogue) : catalogue_(catalogue) {}

  void add(const std::string& header) {
    if (header == refusal) return add(std::string(contract));
    if (find_left_out(header) || !known_.insert(header).second) return;
    Cut own = cut(catalogue_.text(header));
    add_included(own);
    std::string text = std::move(own.rest);
    for (const std::string& included : own.ours) {
      const LeftOut* missing = find_left_out(included);
      if (missing && !missing->type.empty()) text = without_functions_of(text, missing->type);
    }
    if (header == needs_libpng) text = without_bare_declarations(text);
    if (const std::string_view half = catalogue_.other_half(header); !half.empty()) {
      Cut other = cut(half);
      add_included(other);
      text += inlined(other.rest, stem(header) + "_parts");
    }
    collected_.parts.push_back({header, std::move(text)});
  }

  Collected collected() && { return std::move(collected_); }

 private:
  static std::string stem(std::string_view header) {
    header = header.substr(header.rfind('/') + 1);
    return std::string(header.substr(0, header.find('.')));
  }

  void add_included(const Cut& file) {
    collected_.others.insert(file.others.begin(), file.others.end());
    for (const std::string& included : file.ours) add(included);
  }

  const Catalogue& catalogue_;
  std::set<std::string> known_;
  Collected collected_;
};

/// "core/geometry.hpp" as GRADUS_PLAIN_CORE_GEOMETRY_HPP.
std::string guard_of(std::string_view header) {
  std::string guard = "GRADUS_PLAIN_";
  for (const char c : header) {
    guard += c == '/' || c == '.' || c == '-' ? '_' : 'a' <= c && c <= 'z' ? static_cast<char>(c - 32) : c;
  }
  return guard;
}

std::string commented(std::string_view text) {
  std::string comment;
  for (const std::string_view line : lines_in(text)) {
    comment += line.empty() ? "//\n" : fmt::format("// {}\n", line);
  }
  return comment;
}

/// Several empty lines in a row become one.
std::string single_spaced(std::string_view text) {
  std::string result;
  for (const std::string_view line : lines_in(text)) {
    if (line.empty() && (result.empty() || result.ends_with("\n\n"))) continue;
    result += std::string(line) + "\n";
  }
  return std::string(trimmed(result)) + "\n";
}

std::string guarded(const Part& part) {
  const std::string guard = guard_of(part.path);
  return fmt::format("#ifndef {0}\n#define {0}\n{1}#endif  // {0}\n", guard, single_spaced(part.text));
}

std::string preface(const Files& files, std::string_view topic) {
  const std::string text = fmt::format(
      "{} of Gradus {}, in one header for your own program.\n\nNeeds GLM and a C++20 compiler (GCC or "
      "Clang); "
      "compile with -ffp-contract=off. Made by\n`gradus source {} --plain`; a part that headers of several "
      "topics share is read once.\n\n{}",
      topic, release_version, topic.substr(topic.find('/') + 1), files.licence);
  return commented(text);
}

}  // namespace

std::string_view watched_header(const Files& files, std::string_view topic) {
  return files.text(fmt::format("{}{}/{}.hpp", root, topic, topic.substr(topic.find('/') + 1)));
}

std::string plain_header(const Files& files, std::string_view topic) {
  const Catalogue catalogue(files);
  Collector collector(catalogue);
  for (const std::string& header : catalogue.headers_of(topic)) collector.add(header);
  const Collected collected = std::move(collector).collected();
  std::string text = preface(files, topic) + "\n#pragma once\n\n";
  for (const std::string& name : collected.others) text += fmt::format("#include {}\n", name);
  for (const Part& part : collected.parts) {
    if (is_watched(part.text)) {
      refuse_usage(fmt::format(
          "source: expected a topic whose observers can be taken out, but {} has one that can't", part.path));
    }
    text += "\n" + guarded(part);
  }
  return text;
}

}  // namespace gradus::source
