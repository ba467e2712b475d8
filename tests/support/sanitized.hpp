#pragma once
// Whether this program runs under a sanitizer, where it takes ten times as long: tests that lay out thousands
// of sheets then look at fewer of them, since what they are for is measured in the other builds.

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

}  // namespace gradus::test
