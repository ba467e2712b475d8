#pragma once
// The rows behind a PLY file's header, number by number, whether text or binary.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "scene/models/ply_header.hpp"

namespace gradus::pipeline {

class PlyRows {
 public:
  virtual ~PlyRows() = default;

  /// Goes to the next row. row: which of this element, from 0.
  virtual void begin(const PlyElement& element, std::int64_t row) = 0;
  /// The next number of the row, nan and infinity included. what: how mistakes call it.
  virtual double any_number(const PlyType& type, std::string_view what) = 0;
  /// The next number as a whole one from least to most.
  virtual std::int64_t whole(const PlyType& type, std::string_view what, std::int64_t least,
                             std::int64_t most) = 0;
  /// The next number is nobody's.
  virtual void skip(const PlyType& type) = 0;
  /// The row has no more numbers.
  virtual void end() = 0;

  /// The line of the row, or 0.
  virtual int line() const = 0;
  /// What stands behind the last row, a remark; empty where nothing does.
  virtual std::string what_is_left() = 0;
  /// Throws InputError: where the row is, and the text.
  [[noreturn]] virtual void fail(std::string_view text) const = 0;

  /// The next number, finite and of at most Statement::largest in size.
  double number(const PlyType& type, std::string_view what);
};

/// The rows of a file whose header was read. All must outlive them.
std::unique_ptr<PlyRows> rows_of(std::string_view bytes, const PlyHeader& header, const TextFile& file);

}  // namespace gradus::pipeline
