// The instruction sets for which the kernel is compiled. Include this before any header of Highway.
#pragma once

/// Here vectors are members of classes. Vectors of SVE cannot be, since no compiler knows their length. (The build
/// disables these and more: cmake/EcholucentCompiler.cmake.)
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif

/// Every compiler also makes the route of one ray at a time, without vectors. All others are compared with it.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_BROKEN_EMU128 1
