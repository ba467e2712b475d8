#include "cli/files/zip.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <memory>

#include "cairo/library_on_demand.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/files/own_files.hpp"
#include "figure/colophon.hpp"

namespace gradus::cli {
namespace {

/// The format counts from 1980-01-01 in whatever zone the writer lives in, and earlier times become that: the
/// day before is so in every zone.
constexpr std::time_t entry_time = 315'446'400;  // 1979-12-31 00:00 UTC

/// libarchive's functions, loaded by the first zip: it needs a dozen other libraries.
struct Archives {
  LibraryOnDemand library{GRADUS_ARCHIVE, "zips"};
  GRADUS_ON_DEMAND(archive_entry_free);
  GRADUS_ON_DEMAND(archive_entry_new);
  GRADUS_ON_DEMAND(archive_entry_set_filetype);
  GRADUS_ON_DEMAND(archive_entry_set_mtime);
  GRADUS_ON_DEMAND(archive_entry_set_pathname_utf8);
  GRADUS_ON_DEMAND(archive_entry_set_perm);
  GRADUS_ON_DEMAND(archive_entry_set_size);
  GRADUS_ON_DEMAND(archive_error_string);
  GRADUS_ON_DEMAND(archive_write_close);
  GRADUS_ON_DEMAND(archive_write_data);
  GRADUS_ON_DEMAND(archive_write_free);
  GRADUS_ON_DEMAND(archive_write_header);
  GRADUS_ON_DEMAND(archive_write_new);
  GRADUS_ON_DEMAND(archive_write_open);
  GRADUS_ON_DEMAND(archive_write_set_bytes_per_block);
  GRADUS_ON_DEMAND(archive_write_set_format_zip);
  GRADUS_ON_DEMAND(archive_write_set_options);
  GRADUS_ON_DEMAND(archive_write_zip_set_compression_deflate);
  GRADUS_ON_DEMAND(archive_write_zip_set_compression_store);
};

const Archives& archives() {
  static const Archives functions;
  return functions;
}

struct Release {
  void operator()(archive* writer) const { archives().archive_write_free(writer); }
  void operator()(archive_entry* entry) const { archives().archive_entry_free(entry); }
};

la_ssize_t append(archive* /*writer*/, void* out, const void* bytes, std::size_t size) {
  static_cast<std::string*>(out)->append(static_cast<const char*>(bytes), size);
  return static_cast<la_ssize_t>(size);
}

class Zip {
 public:
  Zip() : writer_(archives().archive_write_new()) {
    check(archives().archive_write_set_format_zip(writer_.get()));
    check(archives().archive_write_set_options(
        writer_.get(), "zip:compression=deflate,zip:compression-level=3,zip:hdrcharset=UTF-8"));
    check(archives().archive_write_set_bytes_per_block(writer_.get(), 0));
    check(archives().archive_write_open(writer_.get(), &bytes_, nullptr, append, nullptr));
  }
  Zip(const Zip&) = delete;
  Zip& operator=(const Zip&) = delete;

  void add(const ZipEntry& file) {
    check(file.stored ? archives().archive_write_zip_set_compression_store(writer_.get())
                      : archives().archive_write_zip_set_compression_deflate(writer_.get()));
    const std::unique_ptr<archive_entry, Release> entry(archives().archive_entry_new());
    archives().archive_entry_set_pathname_utf8(entry.get(), file.name.c_str());
    archives().archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.bytes.size()));
    archives().archive_entry_set_filetype(entry.get(), AE_IFREG);
    archives().archive_entry_set_perm(entry.get(), 0644);
    archives().archive_entry_set_mtime(entry.get(), entry_time, 0);
    check(archives().archive_write_header(writer_.get(), entry.get()));
    const la_ssize_t written =
        archives().archive_write_data(writer_.get(), file.bytes.data(), file.bytes.size());
    if (written != static_cast<la_ssize_t>(file.bytes.size())) check(ARCHIVE_FATAL);
  }

  std::string finish() {
    check(archives().archive_write_close(writer_.get()));
    add_comment(zip_comment());
    return std::move(bytes_);
  }

 private:
  /// The last record of a zip ends in the comment's length and the comment, which libarchive leaves empty.
  void add_comment(std::string_view comment) {
    constexpr std::size_t last_record = 22;
    const bool as_expected =
        bytes_.size() >= last_record &&
        std::string_view(bytes_).substr(bytes_.size() - last_record).starts_with("PK\5\6");
    if (!as_expected || comment.size() > 0xff) throw WorkError("can't write the zip: it doesn't end as one");
    bytes_[bytes_.size() - 2] = static_cast<char>(comment.size());
    bytes_ += comment;
  }

  void check(int status) const {
    if (status == ARCHIVE_OK) return;
    const char* error = archives().archive_error_string(writer_.get());
    throw WorkError(fmt::format("can't write the zip: {}", error ? error : "unknown reason"));
  }

  std::string bytes_;
  std::unique_ptr<archive, Release> writer_;
};

/// "03" among 12 steps; "4.1" stays behind "04".
std::string sortable(StepNumber number, StepNumber last) {
  const std::string fine = number.fine == 0 ? "" : fmt::format(".{}", number.fine);
  return fmt::format("{:0{}}{}", number.step, std::to_string(last.step).size(), fine);
}

std::string readme(std::string_view title, std::string_view command, std::size_t count, StepNumber last) {
  const std::int64_t whole = last.step + 1;
  const std::string which = static_cast<std::int64_t>(count) == whole
                                ? fmt::format("All {} steps", whole)
                                : fmt::format("{} of the {} steps, evenly spaced", count, whole);
  return fmt::format(
      "{}\n\n{} as SVG, for print and slides, and as PNG. The number in a file's name is the step's.\n\n"
      "Any step, size, theme and format:\n\n  {}\n\n{}. {}: use the figures as you like, without asking.\n",
      title, which, command, zip_comment(), figure_licence);
}

/// What is packed by itself: to deflate it again takes as long as to make it, for a few percent.
bool is_packed(std::string_view name) {
  return name.ends_with(".png") || name.ends_with(".pdf") || name.ends_with(".zip");
}

}  // namespace

std::string zip_of(std::span<const ZipEntry> entries) {
  Zip zip;
  for (const ZipEntry& entry : entries) zip.add(entry);
  return zip.finish();
}

void zip_folder(const std::filesystem::path& folder, const std::vector<std::string>& files,
                const std::string& output, Replace replace) {
  Zip zip;
  for (const std::string& file : files)
    zip.add({file, read_input((folder / file).string(), "zip"), is_packed(file)});
  write_output(output, zip.finish(), replace);
}

std::vector<ZipEntry> step_entries(std::string_view slug, std::string_view title, std::string_view command,
                                   std::span<const StepNumber> steps, StepNumber last,
                                   const std::function<StepPicture(StepNumber)>& draw) {
  std::vector<ZipEntry> entries{{"README.txt", readme(title, command, steps.size(), last)}};
  for (const StepNumber step : steps) {
    StepPicture picture = draw(step);
    const std::string name = fmt::format("{}-{}", slug, sortable(step, last));
    entries.push_back({name + ".svg", std::move(picture.svg)});
    entries.push_back({name + ".png", std::move(picture.png), true});
  }
  return entries;
}

}  // namespace gradus::cli
