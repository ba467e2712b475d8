#pragma once
// The first half of pseudocode: a line of C++ without what a textbook does without. Types, qualifiers,
// conversions and captures go; declared names become assignments, braces with values in them those values.

#include "figure/listing/lexemes.hpp"

namespace gradus::lexemes {

/// The line's own C++ goes; what is left are names, values, signs and the braces of statements.
void drop_cpp(Lexemes& tokens);

/// Whether an expression can begin here, so that a sign is no binary one and a bracket no index.
bool begins_expression(const Lexemes& tokens, At i);

/// Whether braces here hold statements; others hold values.
bool opens_block(const Lexemes& tokens, At i);

}  // namespace gradus::lexemes
