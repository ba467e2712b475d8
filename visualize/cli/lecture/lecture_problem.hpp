#pragma once
// What is wrong with a lecture, said with the place where it stands.

#include <exception>
#include <string>
#include <string_view>

#include "cli/lecture/lecture.hpp"

namespace gradus::cli {

/// The message with the flag it is about in front: "--from: expected …".
std::string message_of(const std::exception& error);

/// "from" for "--from: expected …"; empty for a message about no flag.
std::string flag_in(std::string_view message);

/// `what` goes on from the way: ": expected …".
Problem problem_at(const Lecture& lecture, const Place& place, const std::string& what);

/// "figures[3]" and "method" make "figures[3].method".
std::string way(const std::string& path, const std::string& key);

}  // namespace gradus::cli
