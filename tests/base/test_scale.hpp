// How much work a test does: all of it in an optimised build, less where sanitizers or missing optimisation make
// every ray many times slower.
#pragma once

namespace penumbra::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
inline constexpr bool slow_build = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
inline constexpr bool slow_build = true;
#else
inline constexpr bool slow_build = false;
#endif
#else
inline constexpr bool slow_build = false;
#endif

// `count` in an optimised build, else `fewer`.
constexpr int scaled(int count, int fewer) { return slow_build ? fewer : count; }

}  // namespace penumbra::test
