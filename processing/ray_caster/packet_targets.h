// Which instruction sets the kernel is compiled for. To be included before anything of Highway's.
#pragma once

/// Vectors are members of classes here; SVE's, whose length no compiler knows, cannot be. (For a sanitizer
/// cmake/EcholucentCompiler.cmake disables these and more.)
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif

/// Every compiler makes the route of one ray at a time too, without vectors: what all others are compared to.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_BROKEN_EMU128 1
