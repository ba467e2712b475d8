#pragma once
// A shared library that most commands do without: it is loaded when it is first asked for. What is linked is
// loaded, with all that it needs itself, at the start of every command.

#include <string_view>

namespace gradus {

/// One that stays loaded to the end of the program.
class LibraryOnDemand {
 public:
  /// file: its name as the linker knows it, "libm.so.6". purpose: what can't be done without it, "zips".
  /// Throws std::runtime_error "zips need libm.so.6: why it can't be loaded".
  LibraryOnDemand(const char* file, std::string_view purpose);

  /// One of its functions, also of a library that it needs. Throws std::runtime_error.
  template <class Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(address_of(name));
  }

 private:
  void* address_of(const char* name) const;
  [[noreturn]] void refuse() const;

  const char* file_;
  std::string_view purpose_;
  void* library_;
};

}  // namespace gradus

/// A member, beside the LibraryOnDemand `library`: the function of this name, with the type that its header
/// says.
#define GRADUS_ON_DEMAND(name) GRADUS_ON_DEMAND_AS(name, name)
/// The same under a name of its own.
#define GRADUS_ON_DEMAND_AS(own, name) decltype(&::name) own = library.find<decltype(&::name)>(#name)
