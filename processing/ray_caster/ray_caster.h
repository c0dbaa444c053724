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

/// Renders the volume. A ray takes one sample in the middle of each step. Steps of parallel rays lie between planes
/// across the view, counted from the near plane or the box's foremost corner, whichever is farther. Steps of
/// perspective rays lie between distances from the eye, counted from the depth of that plane. If the rendered part
/// begins or ends within a step, the ray samples the middle of the rest of the step and weights it by its length. So
/// the picture converges with the square of the step, also at the box's faces.
///
/// Trilinear samples fill voxels without data from their neighbours (FilledVolume). The presence of data scales a
/// step's opacity: none up to 1/4, all from 3/4 (PresenceUse). Positions are exact to 1/8192 voxel. Bytes are
/// interpolated with shares of 15 bits, along y of 7 bits, as if a sample lay up to 1/128 voxel beside its place (a
/// tenth of a level if neighbours differ by 12). Other voxels are interpolated in float. Opacities come from one table
/// of 2041 intensities: the 8-bit values and seven between each two. The table is linear between its nodes: exact to
/// 2e-7 for x^2 of scale 1, and to 1/2040 in intensity at a step of a curve. Bytes of a white level from 128 on take
/// the nearest of 16 intensities between two values: exact to 1/8160 in intensity. Opacity is added up in float over at
/// most 64 samples and then in double, as opacity, not as transmittance. It is exact to 1e-5 over 2e5 samples. A ray
/// ends at a multiple of 8 steps. If a step adds less than min(1, step) / 128 to its pixel's opacity, it is lit evenly
/// (w = 0), and if it adds less than a 16th of that, as if all light reached it. Memory: twice the volume's, and two
/// bytes a voxel more if voxels lack data.
///
/// For a two-dimensional OTF, the caster interpolates the nodes' opacities bilinearly and then corrects them for the
/// step. It interpolates gradient magnitudes (GradientLevels) as it does bytes. They take three bytes a voxel more.
/// They are made for the first such picture, and again for another largest gradient.
///
/// Empty only if the caller set progress.cancel (polled once a tile of 32 x 32 pixels). Works in the calling thread's
/// oneTBB arena. The pixels are the same for any number of threads. Throws std::invalid_argument for settings that make
/// no sense.
[[nodiscard]] std::optional<Picture> castRays(const Volume& volume, const Classification& classification,
                                              const RayCastSettings& settings, const Progress& progress = {});

/// Casts rays through one volume (not null) again and again, and keeps what its pictures have in common. It keeps the
/// voxels in the order the kernel reads them, and the empty regions under the curve. For edits of the curve under a
/// fixed camera it keeps the samples themselves, 16 bits each. Pictures are those of castRays(); from kept samples they
/// differ by up to half an 8-bit level (RMSE 0.02). Only one thread at a time may use it.
class RayCaster {
public:
    explicit RayCaster(const std::shared_ptr<const Volume>& volume);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;

    /// Another caster of the same volume. It shares the packed voxels, the largest part of a caster's memory, and
    /// nothing else. So each of several OTFs of one volume can have its own caster. This one must not cast during the
    /// call. Afterwards both may cast at once, in different threads.
    [[nodiscard]] RayCaster sharing() const;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// Casts from now on through the same scan with another scalpel cut. It packs no voxel again and renews only what
    /// lies around changed rows of the mask. It forgets the kept samples. Pictures are those of a new RayCaster, to the
    /// bit. If memory runs out it throws, and the caller must make a new caster. Throws std::invalid_argument for
    /// another scan (Volume::isSameScanAs()).
    void setCut(std::shared_ptr<const Volume> volume);
    /// As castRays(). If a call in direct mode samples as an earlier one did (only the curve, colours or light differ),
    /// the caster keeps the view's samples (up to sampleMemoryLimit). From then on it only classifies and composites
    /// them again. It keeps no samples for two-dimensional OTFs.
    [[nodiscard]] std::optional<Picture> cast(const Classification& classification, const RayCastSettings& settings,
                                              const Progress& progress = {});

    /// How the newest cast() that was not cancelled used samples.
    [[nodiscard]] SampleUse sampleUse() const;

    /// Wall time that the newest cast() took to make its light volume; 0 if it made none.
    [[nodiscard]] double lightMilliseconds() const;

    /// Share of the pixels that may show the volume through which the newest cast() cast a ray: 1 unless
    /// RayCastSettings::pixelTolerance let it interpolate others.
    [[nodiscard]] double castShare() const;

    /// The most bytes that the samples of one view may take, 2 each. If they need more, the caster keeps none.
    static constexpr std::size_t sampleMemoryLimit = std::size_t{512} << 20;
    /// Bytes of kept samples now.
    [[nodiscard]] std::size_t keptSampleBytes() const;

private:
    class Parts;
    explicit RayCaster(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
