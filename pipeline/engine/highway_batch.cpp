// Highway's library on demand: batches ask it for two things, which stand here in its place and load it when
// the first batch is run. Linked, it would be loaded by every command, and release 1.0 then measures the
// machine's clock, which takes longer than the rest of a short command.

#include <dlfcn.h>
#include <fmt/format.h>
#include <hwy/targets.h>

#include <cstdint>
#include <stdexcept>

namespace gradus {
namespace {

/// The library's own functions, under the names that compilers give them.
struct Highway {
  Highway() {
    library = dlopen(GRADUS_HIGHWAY, RTLD_NOW | RTLD_LOCAL);
    find(chosen_target, "_ZN3hwy15GetChosenTargetEv");
    find(supported_targets, "_ZN3hwy16SupportedTargetsEv");
  }

  decltype(&hwy::GetChosenTarget) chosen_target = nullptr;
  decltype(&hwy::SupportedTargets) supported_targets = nullptr;

 private:
  template <class Function>
  void find(Function& function, const char* name) const {
    void* const found = library ? dlsym(library, name) : nullptr;
    if (!found) throw std::runtime_error(fmt::format("pictures need Highway: {}", dlerror()));
    function = reinterpret_cast<Function>(found);
  }

  void* library = nullptr;
};

const Highway& highway() {
  static const Highway functions;
  return functions;
}

}  // namespace
}  // namespace gradus

hwy::ChosenTarget& hwy::GetChosenTarget() { return gradus::highway().chosen_target(); }

std::int64_t hwy::SupportedTargets() { return gradus::highway().supported_targets(); }
