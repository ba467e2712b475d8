#include "figure/text/language.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/contract.hpp"

namespace gradus {

std::string_view language_text(std::string_view path);  // made by the build: see figure/text/wording.hpp

namespace {

std::string_view stripped(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the first line off a text.
std::string_view next_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

bool is_section(std::string_view line) {
  return line.size() >= 2 && line.front() == '[' && line.back() == ']';
}

}  // namespace

/// The sections of a catalogue, each read when a text of it is first asked for: a command says the texts of
/// one topic, out of thousands. The texts stay where they are in the catalogue.
class Language::Catalogue {
 public:
  struct Entry {
    std::string_view name, text;
  };

  Catalogue(std::string_view code, std::string_view whole);

  const Entry* find(std::string_view key);
  Texts texts(std::string_view start);

 private:
  struct Section {
    explicit Section(std::string_view its_lines) : lines(its_lines) {}

    std::string_view lines;
    std::once_flag asked;
    std::vector<Entry> entries;             ///< by name
    std::optional<std::string_view> wrong;  ///< the line, or what of it is told
  };

  static void read(Section& section);
  const std::vector<Entry>& entries_of(Section& section) const;
  void refuse(std::string_view line) const;

  std::string_view code_, whole_;
  std::multimap<std::string_view, Section> sections_;  ///< by name; that of the texts above all is empty
};

Language::Catalogue::Catalogue(std::string_view code, std::string_view whole) : code_(code), whole_(whole) {
  std::string_view name;
  const char* begin = whole.data();
  const auto add_section_to = [&](const char* end) {
    const std::string_view lines(begin, static_cast<std::size_t>(end - begin));
    sections_.emplace(std::piecewise_construct, std::tuple(name), std::tuple(lines));
  };
  for (std::string_view rest = whole; !rest.empty();) {
    const char* const line_begin = rest.data();
    const std::string_view line = stripped(next_line(rest));
    if (!is_section(line)) continue;
    add_section_to(line_begin);
    name = line.substr(1, line.size() - 2);
    begin = rest.data();
  }
  add_section_to(whole.data() + whole.size());
}

void Language::Catalogue::refuse(std::string_view line) const {
  const auto above = whole_.substr(0, static_cast<std::size_t>(line.data() - whole_.data()));
  expects(false, "language {}, line {}: expected a new \"key = text\", found {}", code_,
          std::ranges::count(above, '\n') + 1, line);
}

void Language::Catalogue::read(Section& section) {
  std::vector<Entry>& entries = section.entries;
  for (std::string_view rest = section.lines; !rest.empty();) {
    const std::string_view line = stripped(next_line(rest));
    if (line.empty() || line.front() == '#') continue;
    const std::size_t equals = line.find('=');
    if (equals == line.npos || equals == 0) {
      section.wrong = line;
      return;
    }
    entries.push_back({stripped(line.substr(0, equals)), stripped(line.substr(equals + 1))});
  }
  // Of two that are called the same, the one that stands below is wrong
  std::ranges::sort(entries, {}, [](const Entry& e) { return std::pair(e.name, e.name.data()); });
  const auto same = std::ranges::adjacent_find(entries, {}, &Entry::name);
  if (same != entries.end()) section.wrong = std::next(same)->name;
}

const std::vector<Language::Catalogue::Entry>& Language::Catalogue::entries_of(Section& section) const {
  std::call_once(section.asked, read, section);
  if (section.wrong) refuse(*section.wrong);
  return section.entries;
}

const Language::Catalogue::Entry* Language::Catalogue::find(std::string_view key) {
  // Sections' and texts' names may have dots: this is b.c in [a] or c in [a.b]
  for (std::string_view section, name = key;;) {
    for (auto [at, end] = sections_.equal_range(section); at != end; ++at) {
      const std::vector<Entry>& entries = entries_of(at->second);
      const auto found = std::ranges::lower_bound(entries, name, {}, &Entry::name);
      if (found != entries.end() && found->name == name) return &*found;
    }
    const std::size_t dot = name.find('.');
    if (dot == name.npos) return nullptr;
    name.remove_prefix(dot + 1);
    section = key.substr(0, key.size() - name.size() - 1);
  }
}

Language::Texts Language::Catalogue::texts(std::string_view start) {
  Texts all;
  for (auto& [name, section] : sections_) {
    const std::string before = name.empty() ? "" : std::string(name) + ".";
    const std::size_t common = std::min(before.size(), start.size());
    if (before.compare(0, common, start, 0, common) != 0) continue;
    for (const Entry& entry : entries_of(section)) {
      if (!entry.name.starts_with(start.substr(common))) continue;
      const bool is_new = all.emplace(before + std::string(entry.name), entry.text).second;
      if (!is_new) refuse(entry.name);
    }
  }
  return all;
}

Language::Language(std::string code, std::string_view catalogue)
    : code_(std::move(code)), own_(catalogue), whole_(own_) {
  texts();
}

Language::Language(WhenAsked, std::string code, std::string_view catalogue)
    : code_(std::move(code)), whole_(catalogue) {}

Language Language::read_when_asked(std::string code, std::string_view catalogue) {
  return Language(WhenAsked{}, std::move(code), catalogue);
}

Language::~Language() = default;

Language::Catalogue& Language::catalogue() const {
  std::call_once(asked_, [this] { catalogue_ = std::make_unique<Catalogue>(code_, whole_); });
  return *catalogue_;
}

std::string_view Language::text(std::string_view key) const {
  const Catalogue::Entry* found = catalogue().find(key);
  expects(found, "language {} has no text {}", code_, key);
  return found->text;
}

bool Language::has(std::string_view key) const { return catalogue().find(key) != nullptr; }

Language::Texts Language::texts(std::string_view start) const { return catalogue().texts(start); }

std::span<const Language> languages() {
  // Never taken down: at a command's end nobody asks them any more
  static const auto& all = *new std::array{Language::read_when_asked("en", language_text("en.txt")),
                                           Language::read_when_asked("de", language_text("de.txt"))};
  return all;
}

const Language* find_language(std::string_view code) {
  const auto found = std::ranges::find(languages(), code, &Language::code);
  return found == languages().end() ? nullptr : &*found;
}

}  // namespace gradus
