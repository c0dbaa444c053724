// The picture by an obvious, slow route in double precision: every sample of every ray, back to front by eq. 2 of
// Petersch 2005. Beside the kernel and PlainCaster it is the only other route. It reads the volume by itself, so it
// checks the rays, steps and samples that those two share. From the program it takes only the curve, the colours, the
// frame of the view, the filled voxels and the light that reaches them.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "processing/light/light_sweep.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/volume/filled_volume.h"

namespace echolucent {

using ReferencePixel = std::array<double, 4>;

inline bool isOfBytes(const Volume& volume) {
    return std::holds_alternative<VoxelArray<std::uint8_t>>(volume.voxels());
}

/// How far the kernel's pixels may be from the reference's if neighbouring voxels are unrelated. The kernel's shares
/// between bytes have 7 bits along y, so a sample of such noise may be off by 1/127 of white. For other voxel types the
/// tolerance is small. Steps, cuts, masks and curves are the same for all.
inline double noiseTolerance(const Volume& volume, bool shaded) {
    if (isOfBytes(volume)) return shaded ? 0.08 : 0.02;
    return shaded ? 3e-3 : 2e-4;
}

class ReferenceCaster {
public:
    ReferenceCaster(const Volume& volume, Classification classification, const RayCastSettings& settings)
        : m_filled(filledVolume(volume)),
          m_volume(m_filled.voxels),
          m_geometry(volume.geometry()),
          m_classification(std::move(classification)),
          m_settings(settings) {
        if (!settings.shading || !settings.shading->asksWhatReaches()) return;
        const LightScene scene = lightSceneOf(settings, volume.geometry());
        m_light = LightSweep(std::make_shared<const Volume>(volume)).lightVolume(m_classification, scene);
    }

    /// Whether the last pixel has an undecided sample: data is present there by half, to the precision of the kernel's
    /// positions. Such a sample may be in the picture or not. It matters if presence is all or nothing.
    [[nodiscard]] bool undecided() const { return m_closestToHalf < (isOfBytes(m_volume) ? 0.01 : 5e-5); }

    [[nodiscard]] ReferencePixel pixel(int column, int row) const;

    /// A sample of a ray. Samples go from front to back.
    struct Sample {
        Vec3 colour;
        double alpha, intensity;
        double depthMm;  ///< along the camera's forward, from the grid origin
        double length;   ///< steps; below 1 if it is cut
    };
    [[nodiscard]] std::vector<Sample> samplesOf(int column, int row) const;

private:
    [[nodiscard]] double startDepth() const;

    /// The rendered part of a ray, in steps from its origin.
    [[nodiscard]] std::pair<double, double> partInside(const Vec3& origin, const Vec3& direction, double stepMm) const;

    [[nodiscard]] std::vector<Sample> alongRay(const Vec3& origin, const Vec3& direction) const;

    /// `unlit` is the share of a cut's face: on entry behind the sample before, on return behind this one.
    [[nodiscard]] std::optional<Sample> sampleAt(const Vec3& point, const Vec3& direction, double before, double length,
                                                 double& unlit) const;

    [[nodiscard]] double opacityOf(const Vec3& voxel, double intensity) const;
    /// Of a voxel, clamped into the grid, from differences of its neighbours along each axis; normalised intensity per
    /// unit.
    [[nodiscard]] double gradientMagnitude(std::array<std::int64_t, 3> at) const;

    [[nodiscard]] double value(const Volume& volume, std::array<std::int64_t, 3> at) const;
    [[nodiscard]] double nearest(const Volume& volume, const Vec3& voxel) const;
    [[nodiscard]] double trilinear(const Volume& volume, const Vec3& voxel) const;

    [[nodiscard]] Vec3 lit(const Vec3& colour, const Vec3& voxel, const Vec3& direction, double seen,
                           double unlit) const;

    FilledVolume m_filled;
    const Volume& m_volume;
    const VolumeGeometry& m_geometry;
    Classification m_classification;
    const RayCastSettings& m_settings;
    std::optional<LightVolume> m_light;
    mutable double m_closestToHalf = 1.0;
};

/// The largest difference of any channel of any pixel between the reference and a picture.
inline double largestDifference(const Picture& picture, const Volume& volume, const Classification& classification,
                                const RayCastSettings& settings) {
    const ReferenceCaster reference(volume, classification, settings);
    double largest = 0.0;
    const int mayBeUndecided = settings.width * settings.height / (isOfBytes(volume) ? 20 : 100);
    int undecided = 0;
    for (int row = 0; row < settings.height; ++row)
        for (int column = 0; column < settings.width; ++column) {
            const ReferencePixel expected = reference.pixel(column, row);
            if (reference.undecided() && ++undecided < mayBeUndecided) continue;
            const float* actual = &picture.rgba[static_cast<std::size_t>(row * settings.width + column) * 4];
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const double difference = std::abs(expected[channel] - static_cast<double>(actual[channel]));
                largest = difference <= largest ? largest : difference;  // a NaN counts as largest
            }
        }
    return largest;
}
inline double largestDifference(const Volume& volume, const Classification& classification,
                                const RayCastSettings& settings) {
    return largestDifference(*castRays(volume, classification, settings), volume, classification, settings);
}

/// Random voxels, with a share of zeros so that some regions are transparent.
template <typename Voxel>
Volume randomVolume(const std::array<std::int64_t, 3>& size, const Vec3& spacing, unsigned seed) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const double top = std::is_same_v<Voxel, std::uint8_t>    ? 255.0
                       : std::is_same_v<Voxel, std::uint16_t> ? 4095.0
                                                              : 3.5;
    std::vector<Voxel> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (Voxel& voxel : voxels) voxel = static_cast<Voxel>(share(random) < 0.3 ? 0.0 : share(random) * top);
    return Volume(geometry, std::move(voxels), top);
}

/// A curve of one opacity at every intensity.
inline OpacityCurve everywhere(double opacity) { return ManualCurve{{{0.0, opacity}}}; }

inline RayCastSettings settingsFor(const Volume& volume, const Viewpoint& view, int width, int height) {
    RayCastSettings settings;
    settings.width = width;
    settings.height = height;
    settings.camera = defaultCamera(volume.geometry(), view, static_cast<double>(width) / height);
    if (view.frontPlane) settings.front = cuttingFaceOf(*view.frontPlane, volume.geometry());
    settings.terminationTransmittance = 0.0;
    return settings;
}

inline const float* pixelAt(const Picture& picture, int column, int row) {
    return &picture.rgba[(static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(column)) *
                         4];
}

inline const float* centreOf(const Picture& picture) { return pixelAt(picture, picture.width / 2, picture.height / 2); }

}  // namespace echolucent
