#pragma once
// Whether this program runs under a sanitizer, where it takes up to thirty times as long: tests that lay out
// thousands of sheets then look at fewer of them, and tests that read what all runs say return at once: what
// they judge is the same in the other builds, and other tests tell and lay out every topic here.

#include <algorithm>
#include <cstddef>

namespace gradus::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// So many; under a sanitizer one in `every`, but at least one.
constexpr std::size_t thinned(std::size_t count, std::size_t every) {
  return sanitized ? std::max<std::size_t>(1, count / every) : count;
}

}  // namespace gradus::test
