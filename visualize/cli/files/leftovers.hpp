#pragma once
// Files that are being written have names of their own; what a killed process left of them is removed later.

#include <filesystem>
#include <string>

namespace gradus::cli {

/// A new name for a file that is being written: ".gradus.HOST-PROCESS-START-N.tmp". HOST stands for the
/// running system and what its process numbers mean, START tells processes with one number apart.
std::string temporary_name();

/// Removes from a folder (empty: the current one) the temporary files of processes of this system that are no
/// more. What came from elsewhere, another machine in a shared folder or the time before a restart, can't be
/// judged so: it goes when it has not been written to for a week. Looks into each folder once per process.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace gradus::cli
