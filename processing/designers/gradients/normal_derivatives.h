// The derivatives of a volume along its gradient, a slab of slices at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "processing/progress.h"
#include "processing/speckle_reduction/gaussian_filter.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Intensity, gradient magnitude and second derivative of one voxel: normalised intensity, per unit, per square unit.
struct NormalDerivatives {
    float intensity = 0.0F, gradient = 0.0F, second = 0.0F;
};

/// Derivatives under a Gaussian, as HistogramVolume defines them. Voxels that a scalpel cut are read as they were
/// scanned.
class NormalDerivativeSlices {
public:
    /// Shares the voxels of `volume`. `prefilter` is the Gaussian's standard deviation in units; 0: no Gaussian.
    NormalDerivativeSlices(const Volume& volume, double prefilter);

    /// Makes slices [first, end). False if the work was cancelled.
    [[nodiscard]] bool make(std::int64_t first, std::int64_t end, const Progress& progress);
    /// Whether enough was scanned around a voxel for it to count.
    [[nodiscard]] bool knownAt(std::int64_t x, std::int64_t y, std::int64_t z) const;
    /// At a voxel of the slices made last; knownAt() must be true there.
    [[nodiscard]] NormalDerivatives at(std::int64_t x, std::int64_t y, std::int64_t z) const;
    /// A row of normalised intensities, without the Gaussian, of the slices made last; 0 for voxels not scanned.
    [[nodiscard]] std::span<const float> intensities(std::int64_t y, std::int64_t z) const;

private:
    void readIntensities(std::int64_t first, std::int64_t end);
    void makeNormals(std::int64_t z);

    Volume m_scanned;
    VolumeGeometry m_geometry;
    std::int64_t m_slice;                    ///< voxels of a slice
    std::array<std::int64_t, 3> m_stride{};  ///< voxels from neighbour to neighbour; 0 along an axis without derivative
    std::array<std::int64_t, 3> m_margin{};  ///< voxels that must be scanned to both sides along each axis
    std::array<float, 3> m_perUnit{};        ///< steps between voxels in a unit
    std::vector<std::int64_t> m_neighbours;  ///< offsets of voxels that must be scanned
    std::unique_ptr<GaussianSlices> m_gaussian;
    std::vector<float> m_held, m_smooth;  ///< intensities, without and under the Gaussian
    std::vector<cv::Vec3f> m_normals;     ///< unit gradients
    std::vector<float> m_gradients;       ///< their lengths
    std::int64_t m_firstHeld = 0, m_firstSmooth = 0, m_firstNormal = 0;
};

}  // namespace echolucent
