#pragma once
// Worksheets and keys as LaTeX documents.

#include <string>
#include <vector>

#include "worksheet/pages.hpp"
#include "worksheet/task.hpp"

namespace gradus::worksheet {

/// A document of its own for pdflatex, lualatex or xelatex, with the packages babel, booktabs, colortbl,
/// fontenc, geometry, graphicx and inputenc: a page per task, blanks as rules 14 mm long in rows of 8 mm.
/// `figures` names a PDF beside it whose n-th page is the drawing of the n-th task (see drawing_of), students
/// one after the other; empty: without drawings. Letters that LaTeX knows under no name are declared.
std::string latex_document(const std::vector<StudentSheet>& sheets, Part part, const PageStyle& style,
                           const std::string& figures);

}  // namespace gradus::worksheet
