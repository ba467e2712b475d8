// Every method of iterated_functions as a function of its own; see machine_code_test.py.
#include "modeling/iterated_functions/iterated_functions.hpp"

#include "modeling/iterated_functions/iterated_functions_notes.hpp"
#include "modeling/iterated_functions/similarity_dimension.hpp"

using namespace gradus::iterated_functions;
using gradus::dvec2;

void plot_point(dvec2 p);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_deterministic(Maps<double> maps, int levels, Pieces<double>& pieces) {
  pieces = deterministic(maps, levels);
}
[[gnu::flatten]] void machine_code_chaos_game(Maps<double> maps, std::span<const double> shares,
                                              const Game<double>& game) {
  chaos_game(maps, shares, game, plot_point);
}
[[gnu::flatten]] void machine_code_equal_shares(Maps<double> maps, std::span<const double> shares,
                                                const Game<double>& game) {
  equal_shares(maps, shares, game, plot_point);
}
[[gnu::flatten]] void machine_code_low_bits(Maps<double> maps, std::span<const double> shares,
                                            const Game<double>& game) {
  low_bits(maps, shares, game, plot_point);
}
[[gnu::flatten]] double machine_code_similarity_dimension(std::span<const double> ratios, int halvings) {
  return similarity_dimension(ratios, halvings);
}
}
