#pragma once
// Formulas of the pages: in TeX where they are written, as MathML where they are read.

#include <string>
#include <string_view>

namespace gradus {

/// The contents of a <math> element for a formula of docs/, from docs/topics/formulas.txt. Throws
/// std::logic_error for a formula that is not in it.
std::string_view mathml_of(std::string_view tex);

/// A whole element: inside a line, or on a line of its own.
std::string formula_in_line(std::string_view tex);
std::string formula_on_line(std::string_view tex);

}  // namespace gradus
