#pragma once
// What a run starts with where no inputs are given.

#include "request/inputs.hpp"

namespace gradus {

/// What is given, by the names of parameters and "method". Without any input, where the run's method or the
/// one beside it has an opening: with that; where it is faulty and the topic's defaults don't show that: with
/// the input that its exhibit opens with, in examples/errata.json. Throws UsageError for a method that does
/// not exist.
GivenTexts opened(const TopicEntry& topic, GivenTexts given, const Method* beside = nullptr);

}  // namespace gradus
