#include "processing/designers/gradients/normal_derivatives.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "processing/parallel.h"
#include "processing/speckle_reduction/filter_spacing.h"

namespace echolucent {

namespace {

/// Derivatives of unit gradients reach this many voxels along an axis.
constexpr std::int64_t axisReach = 2;

/// The standard deviation in the unit of gaussianFiltered(), mean voxels.
double inMeanVoxels(const VolumeGeometry& geometry, double units) {
    const Vec3 apart = filterSpacing(geometry);
    int finest = -1;
    for (int axis = 0; axis < 3; ++axis)
        if (geometry.size[static_cast<std::size_t>(axis)] > 1 &&
            (finest < 0 || geometry.spacing[axis] < geometry.spacing[finest]))
            finest = axis;
    return finest < 0 ? units : units * geometry.unit() / geometry.spacing[finest] * apart[finest];
}

/// Makes room for `count` values. The old values may be lost.
template <typename Value>
void makeRoom(std::vector<Value>& values, std::int64_t count) {
    if (static_cast<std::int64_t>(values.size()) < count) values = std::vector<Value>(static_cast<std::size_t>(count));
}

/// Offsets from a voxel to those that must be scanned: all that the voxel's derivatives use. If the margin is wider,
/// also some on a ball with the margin as its radius.
std::vector<std::int64_t> neighboursAround(const std::array<std::int64_t, 3>& stride,
                                           const std::array<std::int64_t, 3>& margin) {
    std::vector<std::int64_t> offsets{0}, corners{0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (stride[axis] == 0) continue;
        for (std::int64_t step = 1; step <= axisReach; ++step)
            offsets.insert(offsets.end(), {step * stride[axis], -step * stride[axis]});
        for (std::size_t other = 0; other < axis; ++other)
            for (const std::int64_t sign : {-1, 1})
                offsets.insert(offsets.end(),
                               {stride[axis] + sign * stride[other], -stride[axis] + sign * stride[other]});
        if (margin[axis] == axisReach) continue;
        offsets.insert(offsets.end(), {margin[axis] * stride[axis], -margin[axis] * stride[axis]});
        const auto corner = std::lround(static_cast<double>(margin[axis]) / std::sqrt(3.0)) * stride[axis];
        std::vector<std::int64_t> both;
        for (const std::int64_t offset : corners) both.insert(both.end(), {offset - corner, offset + corner});
        corners = std::move(both);
    }
    offsets.insert(offsets.end(), corners.begin(), corners.end());
    std::ranges::sort(offsets);
    offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
    return offsets;
}

}  // namespace

NormalDerivativeSlices::NormalDerivativeSlices(const Volume& volume, double prefilter)
    : m_scanned(volume.withCut(nullptr)),
      m_geometry(volume.geometry()),
      m_slice(m_geometry.size[0] * m_geometry.size[1]) {
    // Derivatives and Gaussian must use the same lengths, whether the spacing is known or guessed.
    m_geometry.spacingKnown = true;
    const double sigma = inMeanVoxels(m_geometry, prefilter);
    const Vec3 apart = filterSpacing(m_geometry);
    std::int64_t stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int component = static_cast<int>(axis);
        // Slightly less, so that rounding does not add a voxel.
        const std::int64_t margin = axisReach + static_cast<std::int64_t>(std::ceil(sigma / apart[component] - 1e-6));
        if (m_geometry.size[axis] > 2 * margin) {
            m_stride[axis] = stride;
            m_margin[axis] = margin;
            m_perUnit[axis] = static_cast<float>(m_geometry.unit() / m_geometry.spacing[component]);
        }
        stride *= m_geometry.size[axis];
    }
    m_neighbours = neighboursAround(m_stride, m_margin);
    if (prefilter > 0.0) m_gaussian = std::make_unique<GaussianSlices>(m_geometry, m_scanned.dataMaskOrNull(), sigma);
}

void NormalDerivativeSlices::readIntensities(std::int64_t first, std::int64_t end) {
    m_firstHeld = first;
    makeRoom(m_held, (end - first) * m_slice);
    const std::uint8_t* const mask = m_scanned.dataMaskOrNull();
    const double white = m_scanned.whiteLevel();
    std::visit(
        [&](const auto& voxels) {
            parallelFor(first, end, [&](std::int64_t z) {
                float* const to = m_held.data() + (z - first) * m_slice;
                for (std::int64_t i = 0; i < m_slice; ++i) {
                    const std::int64_t from = z * m_slice + i;
                    const bool isData = mask == nullptr || mask[from] != 0;
                    const double stored = static_cast<double>(voxels[static_cast<std::size_t>(from)]);
                    // A mask may mark voxels that are not finite as data. NaN becomes 0 here.
                    const double share = isData ? stored / white : 0.0;
                    to[i] = share > 0.0 ? static_cast<float>(std::min(share, 1.0)) : 0.0F;
                }
            });
        },
        m_scanned.voxels());
}

bool NormalDerivativeSlices::make(std::int64_t first, std::int64_t end, const Progress& progress) {
    const std::int64_t slices = m_geometry.size[2];
    const auto below = [&](std::int64_t reach) { return std::max<std::int64_t>(0, first - reach); };
    const auto above = [&](std::int64_t reach) { return std::min(slices, end + reach); };
    const std::int64_t reach = m_stride[2] != 0 ? axisReach : 0;
    m_firstSmooth = below(reach);
    const std::int64_t endSmooth = above(reach);
    const std::int64_t filterReach = m_gaussian ? m_gaussian->reach() : 0;
    readIntensities(below(reach + filterReach), above(reach + filterReach));
    makeRoom(m_smooth, (endSmooth - m_firstSmooth) * m_slice);
    if (!m_gaussian)
        std::copy_n(m_held.begin(), (endSmooth - m_firstSmooth) * m_slice, m_smooth.begin());
    else if (!m_gaussian->make(m_held.data(), m_firstHeld, m_firstSmooth, endSmooth, m_smooth.data(), progress))
        return false;
    m_firstNormal = below(reach / 2);
    const std::int64_t endNormal = above(reach / 2);
    makeRoom(m_normals, (endNormal - m_firstNormal) * m_slice);
    makeRoom(m_gradients, (endNormal - m_firstNormal) * m_slice);
    parallelFor(m_firstNormal, endNormal, [&](std::int64_t z) {
        if (!progress.cancelled()) makeNormals(z);
    });
    return !progress.cancelled();
}

void NormalDerivativeSlices::makeNormals(std::int64_t z) {
    const auto edge = [&](std::size_t axis) { return std::int64_t{m_stride[axis] != 0 ? 1 : 0}; };
    if (z < edge(2) || z >= m_geometry.size[2] - edge(2)) return;
    const float* const smooth = m_smooth.data() + (z - m_firstSmooth) * m_slice;
    const std::int64_t normals = (z - m_firstNormal) * m_slice;
    for (std::int64_t y = edge(1); y < m_geometry.size[1] - edge(1); ++y)
        for (std::int64_t x = edge(0); x < m_geometry.size[0] - edge(0); ++x) {
            const std::int64_t at = x + m_geometry.size[0] * y;
            cv::Vec3f normal;
            for (std::size_t axis = 0; axis < 3; ++axis)
                normal[static_cast<int>(axis)] =
                    0.5F * (smooth[at + m_stride[axis]] - smooth[at - m_stride[axis]]) * m_perUnit[axis];
            const float gradient = std::sqrt(normal.dot(normal));
            m_gradients[static_cast<std::size_t>(normals + at)] = gradient;
            m_normals[static_cast<std::size_t>(normals + at)] = gradient > 0.0F ? normal * (1.0F / gradient) : normal;
        }
}

bool NormalDerivativeSlices::knownAt(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const std::array<std::int64_t, 3> place{x, y, z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (place[axis] < m_margin[axis] || place[axis] >= m_geometry.size[axis] - m_margin[axis]) return false;
    const std::uint8_t* const mask = m_scanned.dataMaskOrNull();
    if (mask == nullptr) return true;
    const std::uint8_t* const here = mask + m_geometry.offset(x, y, z);
    return std::ranges::all_of(m_neighbours, [&](std::int64_t apart) { return here[apart] != 0; });
}

NormalDerivatives NormalDerivativeSlices::at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const std::int64_t inSlice = x + m_geometry.size[0] * y;
    const float* const smooth = m_smooth.data() + (z - m_firstSmooth) * m_slice + inSlice;
    const cv::Vec3f* const normal = m_normals.data() + (z - m_firstNormal) * m_slice + inSlice;
    const float gradient = m_gradients[static_cast<std::size_t>((z - m_firstNormal) * m_slice + inSlice)];
    float laplacian = 0.0F, divergence = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t step = m_stride[axis];
        const int component = static_cast<int>(axis);
        laplacian += (smooth[step] - 2.0F * smooth[0] + smooth[-step]) * (m_perUnit[axis] * m_perUnit[axis]);
        divergence += 0.5F * (normal[step][component] - normal[-step][component]) * m_perUnit[axis];
    }
    return {smooth[0], gradient, laplacian - gradient * divergence};
}

std::span<const float> NormalDerivativeSlices::intensities(std::int64_t y, std::int64_t z) const {
    return {m_held.data() + (z - m_firstHeld) * m_slice + m_geometry.size[0] * y,
            static_cast<std::size_t>(m_geometry.size[0])};
}

}  // namespace echolucent
