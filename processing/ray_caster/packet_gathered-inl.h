// The light that a packet of rays gathers on its way.
#include <limits>
#include <optional>

#include "processing/ray_caster/packet_colour-inl.h"
#include "processing/ray_caster/packet_cut_face-inl.h"

#if defined(ECHOLUCENT_PACKET_GATHERED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_GATHERED_INL
#undef ECHOLUCENT_PACKET_GATHERED_INL
#else
#define ECHOLUCENT_PACKET_GATHERED_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// The light gathered so far, in double. It takes the opacity of each run, not its transmittance, so that a product of
/// many factors near 1 keeps its digits.
struct Gathered {
    alignas(64) double transmittance[lanes];
    alignas(64) double colour[3][lanes];
    alignas(64) float depthMm[lanes];

    Gathered() {
        for (int i = 0; i < lanes; ++i) {
            transmittance[i] = 1.0;
            colour[0][i] = colour[1][i] = colour[2][i] = 0.0;
            depthMm[i] = std::numeric_limits<float>::infinity();
        }
    }
};

/// The light of one run, in shares of the light that reaches it.
struct Blend {
    FloatVector opacity, red, green, blue;
    FloatVector half;  ///< the sample at which the pixel's opacity reaches one half; below 0 if there is none
};

/// A packet of rays on its way.
template <typename Voxel>
struct DirectRays {
    Packet<Voxel> packet;
    KeptSamples::Packet* kept;  ///< null if samples are not kept
    std::optional<Light<Voxel>> light;
    Gathered gathered;
    CutFaces cutFaces;

    DirectRays(const KernelJob<Voxel>& job, const PacketPixels& pixels, KeptSamples::Packet* keptSamples)
        : packet(job, pixels), kept(keptSamples) {
        if (job.light != nullptr && !packet.empty()) light.emplace(job, packet.rays());
    }
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
