#include "cairo/library_on_demand.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace gradus {

LibraryOnDemand::LibraryOnDemand(const char* file, std::string_view purpose)
    : file_(file), purpose_(purpose), library_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
  if (!library_) refuse();
}

void* LibraryOnDemand::address_of(const char* name) const {
  void* const found = dlsym(library_, name);
  if (!found) refuse();
  return found;
}

void LibraryOnDemand::refuse() const {
  // Begins with a file's name, mostly this one's
  std::string_view reason = dlerror();
  if (reason.starts_with(file_)) reason.remove_prefix(std::string_view(file_).size());
  if (reason.starts_with(": ")) reason.remove_prefix(2);
  throw std::runtime_error(fmt::format("{} need {}: {}", purpose_, file_, reason));
}

}  // namespace gradus
