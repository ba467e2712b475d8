#include "figure/text/notation.hpp"

namespace gradus {
namespace {

/// "n" as "−n", "−f" as "f".
std::string reversed(const std::string& name) {
  constexpr std::string_view minus = "−";
  return name.starts_with(minus) ? name.substr(minus.size()) : std::string(minus) + name;
}

}  // namespace

std::string Notation::axis_name(int axis, const std::string& direction) const {
  if (!axes.empty()) return axes[static_cast<std::size_t>(axis)];
  return axis == 2 && looks_backward() ? reversed(direction) : direction;
}

std::string Notation::forward_name(const std::string& direction) const {
  if (axes.empty()) return direction;
  return looks_backward() ? reversed(axes[2]) : axes[2];
}

}  // namespace gradus
