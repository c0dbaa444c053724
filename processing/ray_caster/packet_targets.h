// Which instruction sets the kernel is compiled for. To be included before anything of Highway's.
#pragma once

/// Vectors are members of classes here; SVE's, whose length no compiler knows, cannot be. Under a sanitizer AVX2 and
/// scalar code stand for the others, which come from the same lines and would compile for minutes.
#ifdef ECHOLUCENT_SANITIZED
#define HWY_DISABLED_TARGETS \
    (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif

/// Every compiler makes the route of one ray at a time too, without vectors: what all others are compared to.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_BROKEN_EMU128 1
