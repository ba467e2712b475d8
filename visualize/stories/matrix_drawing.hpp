#pragma once
// What the stories of transformations share: matrices on the paper, factors in words.

#include <string>
#include <string_view>
#include <vector>

#include "stories/factor_text.hpp"
#include "stories/paper.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// Numbers by rows, as a matrix is printed.
using MatrixRows = std::vector<std::vector<double>>;

/// As the reader's notation has it: for vectors as rows transposed.
MatrixRows oriented(const Wording& words, MatrixRows rows);

/// A matrix in brackets with its name, if it has one, to the left; `right` is the middle of its right
/// bracket. aside: among many drawings, where its numbers have no room, it is left out.
void add_matrix(View& view, std::string_view id, dvec2 right, const std::string& name, const MatrixRows& rows,
                Role role, bool aside = false);

/// In smaller units its rows would lie on each other: of a paper with matrices aside, Grid::lines.
inline constexpr double least_unit_of_matrices = 13;

/// How wide and high its brackets are, in paper units.
dvec2 matrix_size(const MatrixRows& rows);

/// The same with one decimal or none, where it were wider than this.
MatrixRows fitted(MatrixRows rows, double wide);

/// A number as the user wrote it, with the typographic minus.
std::string figure_text(const Number& number);
/// The same for a point: "(1, 1)".
std::string figure_text(const Tuple& point);

/// What a factor does, in the reader's words: "rotate by 30° about (1, 1)". Keys begin with
/// "transformation.".
std::string factor_words(const Wording& words, const FactorText& factor);

/// The same of all factors, with semicolons between them.
std::string factors_words(const Wording& words, const std::vector<FactorText>& factors);

/// "M3·M2·M1", or "M" where there is no factor; "M1·M2·M3" for vectors as rows.
std::string product_name(const Wording& words, std::size_t factors);
/// "M2"; factors count from 0.
std::string factor_name(const Wording& words, std::size_t factor);

/// "M3·M2·M1" of names in this order, for vectors as rows the other way; of many names only the first two
/// and the last.
std::string chained(const Wording& words, std::vector<std::string> names);

/// Sums as they are computed: "1.732·2 + (−1)·1 + 0.268".
std::string sum_text(const std::vector<double>& factors, const std::vector<double>& values);

/// Every factor with a pivot as three: there, the factor about the origin, and back.
std::vector<FactorText> split_at_pivots(const std::vector<FactorText>& factors);

}  // namespace gradus
