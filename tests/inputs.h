// How many inputs a test takes where it takes many.
#pragma once

namespace echolucent {

/// A sanitizer makes a test ten times as long: under one, tests of many inputs take some of them.
#ifdef ECHOLUCENT_SANITIZED
inline constexpr bool takesSomeInputs = true;
#else
inline constexpr bool takesSomeInputs = false;
#endif

}  // namespace echolucent
