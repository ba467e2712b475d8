#pragma once
// Somebody's answer as a trace, so that it is drawn beside our run as any two runs are.

#include "check/judge.hpp"
#include "request/takes.hpp"

namespace gradus::check {

/// A step for each whole one of ours: cells that were taken in it, wrong ones crossed; else the values that
/// are given of it, with ours beside those that differ. The result stands in the last one.
/// Errors: as judge() does.
GivenRun own_run(const Task& task, const OwnAnswers& answers, const OwnAnswer& answer);

}  // namespace gradus::check
