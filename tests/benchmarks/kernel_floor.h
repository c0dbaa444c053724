// The kernel's loops without all that makes a picture of samples: what a sample costs at least on the machine at hand.
#pragma once

#include <cstdint>

#include "processing/ray_caster/kernel_job.h"

namespace echolucent::bench {

enum class FloorOf {
    value,    ///< trilinear values
    gradient  ///< values, the differences of six others, and the light that falls on them
};

/// Takes every sample of a picture's rays in one thread, and adds up what it finds. The sum is of no meaning; nobody
/// may leave its parts out.
[[nodiscard]] double sumOfSamples(const ray_casting::KernelJob<std::uint8_t>& job, FloorOf floor);

}  // namespace echolucent::bench
