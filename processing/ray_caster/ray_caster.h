// Direct volume rendering on the CPU: Petersch 2005, eqs. 2 and 3 (Levoy's compositing), front to back, in float.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "processing/classification.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/ray_caster/sample_use.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Renders the volume. Steps of parallel rays lie between planes across the view, counted from the near plane or the
/// box's foremost corner, whichever is farther; those of perspective rays between distances from the eye, counted from
/// the depth of that plane. Each is sampled in its middle. Where what is rendered begins or ends within a step, what is
/// left of the step is sampled in its own middle and counts with its length, so that the picture converges with the
/// square of the step also at the faces of the box.
///
/// Trilinear samples read voxels without data as what lies beside them, and the presence of data says how much of a
/// step's opacity counts: nothing up to 1/4, all from 3/4 (FilledVolume, PresenceUse). Positions are exact to 1/8192
/// voxel. Bytes are interpolated with shares of 15 bits, along y of 7, as if a sample lay up to 1/128 voxel beside its
/// place (a tenth of a level where neighbours differ by 12); other voxels in float. Opacities come from one table of
/// 2041 intensities, linear between (its nodes are the 8-bit values and seven between each two): exact to 2e-7 for x^2
/// of scale 1, to 1/2040 in intensity at a step of a curve; those of bytes of a white level from 128 on from the
/// nearest of 16 intensities between two values: to 1/8160 in intensity. Opacity is gathered in float over at most 64
/// samples and then in double, as opacity, not as transmittance: exact to 1e-5 over 2
/// * 10^5 samples. A ray ends at a multiple of 8 steps. Lighting is left out (w = 0) where a step adds less than min(1,
/// step) / 128 to its pixel's opacity. Memory: twice the volume's, and two bytes a voxel more where voxels lack data.
///
/// Of a two-dimensional OTF the nodes themselves are read, bilinear, and corrected for the step behind the
/// interpolation; gradient magnitudes are GradientLevels, interpolated as bytes are. They take three bytes a voxel
/// more, made for the first such picture.
///
/// The result is empty only where progress.cancel was raised (it is polled once a tile of 32 x 32 pixels). The work is
/// done in the calling thread's oneTBB arena, and the pixels are the same for any number of threads. Throws
/// std::invalid_argument for settings that make no sense.
[[nodiscard]] std::optional<Picture> castRays(const Volume& volume, const Classification& classification,
                                              const RayCastSettings& settings, const Progress& progress = {});

/// Casts rays through one volume again and again, and keeps what pictures have in common: the voxels in the order the
/// kernel reads them, where they are empty under the curve, and, for an edit of the curve under a fixed camera, the
/// samples themselves. Pictures are those of castRays(), from kept samples to half an 8-bit level (RMSE 0.02): 16 bits
/// are kept of each. Only one thread at a time may use it.
class RayCaster {
public:
    explicit RayCaster(std::shared_ptr<const Volume> volume);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;

    /// Another caster of the same volume that shares the packed voxels, the largest part of what a caster holds, and
    /// otherwise knows nothing of this one: several OTFs of one volume have a caster each. This one must not cast
    /// meanwhile; afterwards both may cast at once, in different threads.
    [[nodiscard]] RayCaster sharing() const;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// Casts from now on through the same scan, of which a scalpel cut other voxels. No voxel is packed anew, and only
    /// what lies around changed rows of the mask is worked out anew; pictures are those of a RayCaster made for it, to
    /// the bit. Where it throws for want of memory, the object is to be made anew. Throws std::invalid_argument for
    /// another scan (Volume::isSameScanAs()).
    void setCut(std::shared_ptr<const Volume> volume);
    /// As castRays(). Where all but the curve and the colour map is as in the call before, the samples of that view are
    /// kept (see sampleMemoryLimit) and from then on only classified and composited anew; not those of two-dimensional
    /// OTFs.
    [[nodiscard]] std::optional<Picture> cast(const Classification& classification, const RayCastSettings& settings,
                                              const Progress& progress = {});

    /// How the newest cast() that was not cancelled used samples.
    [[nodiscard]] SampleUse sampleUse() const;

    /// What the light volume of the newest cast() took, wall time; 0 where none was made.
    [[nodiscard]] double lightMilliseconds() const;

    /// Bytes that the samples of one view may take, 2 each; where they would take more, none are kept.
    static constexpr std::size_t sampleMemoryLimit = std::size_t{512} << 20;
    /// Bytes of kept samples now; 0 where none are kept.
    [[nodiscard]] std::size_t keptSampleBytes() const;

private:
    class Parts;
    explicit RayCaster(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
