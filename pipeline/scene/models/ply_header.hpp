#pragma once
// What the header of a PLY file says of what follows.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/models/statements.hpp"

namespace gradus::pipeline {

/// A type of numbers.
struct PlyType {
  std::string_view name, other_name;
  std::size_t size;  ///< in bytes
  enum class Kind { with_sign, without_sign, floating } kind;
};

inline constexpr std::array<PlyType, 8> ply_types{{{"char", "int8", 1, PlyType::Kind::with_sign},
                                                   {"uchar", "uint8", 1, PlyType::Kind::without_sign},
                                                   {"short", "int16", 2, PlyType::Kind::with_sign},
                                                   {"ushort", "uint16", 2, PlyType::Kind::without_sign},
                                                   {"int", "int32", 4, PlyType::Kind::with_sign},
                                                   {"uint", "uint32", 4, PlyType::Kind::without_sign},
                                                   {"float", "float32", 4, PlyType::Kind::floating},
                                                   {"double", "float64", 8, PlyType::Kind::floating}}};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count{};  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::int64_t rows;
  std::vector<PlyProperty> properties{};
};

struct PlyHeader {
  enum class Form { text, little_endian, big_endian } form = Form::text;
  std::vector<PlyElement> elements;
  std::string picture, picture_place;  ///< what a comment TextureFile names, and where
  std::size_t size = 0;                ///< bytes up to the first row
  int lines = 0;                       ///< its last line
};

/// Errors: InputError "file:line: expected …, found …" for what is no header.
PlyHeader read_ply_header(std::string_view bytes, const TextFile& file);

}  // namespace gradus::pipeline
