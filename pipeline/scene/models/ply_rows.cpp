#include "scene/models/ply_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::pipeline {
namespace {

std::string name_of(const PlyElement& element, const TextFile& file) {
  return file.quotable ? visible(element.name) : "an element";
}

/// A row per line.
class TextRows : public PlyRows {
 public:
  TextRows(std::string_view bytes, const PlyHeader& header, const TextFile& file)
      : file_(file), lines_(bytes, file, Statements::Backslash::is_a_letter) {
    do row_ = lines_.next();
    while (row_ && row_->line() < header.lines);
  }

  void begin(const PlyElement& element, std::int64_t row) override {
    row_ = lines_.next();
    if (row_) return;
    refuse_input(fmt::format("{}: expected {} rows of {}, found {}", shown_name(file_.name), element.rows,
                             name_of(element, file_), row));
  }

  double any_number(const PlyType&, std::string_view what) override {
    const std::string_view word = next(what);
    return Statement::is_no_number(word) ? std::numeric_limits<double>::quiet_NaN()
                                         : row_->number(what, word);
  }

  std::int64_t whole(const PlyType&, std::string_view what, std::int64_t least, std::int64_t most) override {
    return row_->whole(what, least, most);
  }

  void skip(const PlyType&) override { next("a property that is not used"); }
  void end() override { row_->end("the properties that the header tells of"); }
  int line() const override { return row_->line(); }

  std::string what_is_left() override {
    const std::optional<Statement> more = lines_.next();
    return more ? more->place("what stands behind the last row is left out") : "";
  }

  [[noreturn]] void fail(std::string_view text) const override { row_->fail(text); }

 private:
  std::string_view next(std::string_view what) {
    const std::string_view word = row_->word();
    if (word.empty()) fail(fmt::format("expected a number for {}, found none", what));
    return word;
  }

  const TextFile& file_;
  Statements lines_;
  std::optional<Statement> row_;
};

class BinaryRows : public PlyRows {
 public:
  BinaryRows(std::string_view bytes, const PlyHeader& header, const TextFile& file)
      : bytes_(bytes.substr(header.size)),
        file_(file),
        least_first_(header.form == PlyHeader::Form::little_endian) {}

  void begin(const PlyElement& element, std::int64_t row) override { element_ = &element, row_ = row; }

  double any_number(const PlyType& type, std::string_view) override {
    const std::uint64_t bits = take(type.size);
    if (type.kind == PlyType::Kind::floating)
      return type.size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                            : std::bit_cast<double>(bits);
    const std::uint64_t all = std::uint64_t{1} << (8 * type.size);
    const bool negative = type.kind == PlyType::Kind::with_sign && bits >= all / 2;
    return static_cast<double>(bits) - (negative ? static_cast<double>(all) : 0);
  }

  std::int64_t whole(const PlyType& type, std::string_view what, std::int64_t least,
                     std::int64_t most) override {
    const double number = any_number(type, what);
    if (static_cast<double>(least) <= number && number <= static_cast<double>(most) &&
        number == std::floor(number))
      return static_cast<std::int64_t>(number);
    fail(fmt::format("expected {}, a whole number from {} to {}, found {}", what, least, most,
                     file_.quotable ? fmt::format("{}", number) : "another"));
  }

  void skip(const PlyType& type) override { take(type.size); }
  void end() override {}
  int line() const override { return 0; }

  std::string what_is_left() override {
    if (at_ == bytes_.size()) return "";
    return fmt::format("{}: {} bytes behind the last row are left out", shown_name(file_.name),
                       bytes_.size() - at_);
  }

  [[noreturn]] void fail(std::string_view text) const override {
    refuse_input(fmt::format("{}: row {} of {}: {}", shown_name(file_.name), row_ + 1,
                             name_of(*element_, file_), text));
  }

 private:
  std::uint64_t take(std::size_t size) {
    if (bytes_.size() - at_ < size)
      fail(fmt::format("expected {} rows of it, found the end of the file", element_->rows));
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t next = least_first_ ? size - 1 - i : i;
      number = number << 8 | static_cast<unsigned char>(bytes_[at_ + next]);
    }
    at_ += size;
    return number;
  }

  std::string_view bytes_;
  const TextFile& file_;
  bool least_first_;
  std::size_t at_ = 0;
  const PlyElement* element_ = nullptr;
  std::int64_t row_ = 0;
};

}  // namespace

double PlyRows::number(const PlyType& type, std::string_view what) {
  const double value = any_number(type, what);
  if (!(std::abs(value) <= Statement::largest))
    fail(fmt::format("expected a finite number of at most {} for {}, found {}", Statement::largest, what,
                     std::isfinite(value) ? "a larger one" : "one that is not finite"));
  return value;
}

std::unique_ptr<PlyRows> rows_of(std::string_view bytes, const PlyHeader& header, const TextFile& file) {
  if (header.form == PlyHeader::Form::text) return std::make_unique<TextRows>(bytes, header, file);
  return std::make_unique<BinaryRows>(bytes, header, file);
}

}  // namespace gradus::pipeline
