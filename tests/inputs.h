// Whether a test takes all of its inputs.
#pragma once

namespace echolucent {

/// A sanitizer makes tests ten times as slow, so long lists of inputs are shortened.
#ifdef ECHOLUCENT_SANITIZED
inline constexpr bool takesSomeInputs = true;
#else
inline constexpr bool takesSomeInputs = false;
#endif

}  // namespace echolucent
