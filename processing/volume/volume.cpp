#include "processing/volume/volume.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "processing/volume/white_level.h"

namespace echolucent {

double VolumeGeometry::unit() const { return std::min({spacing[0], spacing[1], spacing[2]}); }

Vec3 VolumeGeometry::voxelFromGridMm(const Vec3& mm) const {
    return {mm[0] / spacing[0], mm[1] / spacing[1], mm[2] / spacing[2]};
}

Vec3 VolumeGeometry::boxMaxMm() const {
    return {(static_cast<double>(size[0]) - 0.5) * spacing[0], (static_cast<double>(size[1]) - 0.5) * spacing[1],
            (static_cast<double>(size[2]) - 0.5) * spacing[2]};
}

Vec3 VolumeGeometry::centreMm() const { return (boxMinMm() + boxMaxMm()) * 0.5; }

VolumeGeometry::DepthRange VolumeGeometry::depthsAlong(const Vec3& forward) const {
    const Vec3 low = boxMinMm(), high = boxMaxMm();
    DepthRange depths{0.0, 0.0};
    for (int axis = 0; axis < 3; ++axis) {
        const double atLow = forward[axis] * low[axis], atHigh = forward[axis] * high[axis];
        depths.nearest += std::min(atLow, atHigh);
        depths.farthest += std::max(atLow, atHigh);
    }
    return depths;
}

namespace {

void requireValid(const VolumeGeometry& geometry, std::size_t voxels) {
    for (int axis = 0; axis < 3; ++axis) {
        if (geometry.size[axis] < 1) throw std::invalid_argument("Volume: every size must be at least 1");
        if (!std::isfinite(geometry.spacing[axis]) || !(geometry.spacing[axis] > 0))
            throw std::invalid_argument("Volume: every spacing must be finite and above 0");
    }
    if (static_cast<std::uint64_t>(geometry.voxelCount()) != voxels)
        throw std::invalid_argument("Volume: the number of voxels does not match the size");
}

DataMask finiteMask(const Voxels& voxels) {
    const auto* values = std::get_if<VoxelArray<float>>(&voxels);
    if (values == nullptr || std::all_of(values->begin(), values->end(), [](float v) { return std::isfinite(v); }))
        return {};
    std::vector<std::uint8_t> mask(values->size());
    std::transform(values->begin(), values->end(), mask.begin(),
                   [](float v) { return static_cast<std::uint8_t>(std::isfinite(v) ? 1 : 0); });
    return mask;
}

}  // namespace

Volume::Volume(VolumeGeometry geometry, Voxels voxels, std::optional<double> whiteLevel)
    : m_geometry(std::move(geometry)), m_voxels(std::make_shared<const Voxels>(std::move(voxels))) {
    requireValid(m_geometry, std::visit([](const auto& values) { return values.size(); }, *m_voxels));
    if (whiteLevel && std::isfinite(*whiteLevel) && *whiteLevel > 0)
        m_whiteLevel = *whiteLevel;
    else if (std::holds_alternative<VoxelArray<std::uint8_t>>(*m_voxels))
        m_whiteLevel = 255.0;
    else if (const double level = whiteLevelOf({m_voxels.get(), 1}).level; level > 0)
        m_whiteLevel = level;
    m_dataMask = std::make_shared<const DataMask>(finiteMask(*m_voxels));
    m_scannedMask = m_dataMask;
    m_dataBox = dataBoxOf(m_geometry, *m_dataMask);
}

std::string_view Volume::typeName() const {
    constexpr std::string_view names[] = {"uint8", "uint16", "float32"};
    return names[m_voxels->index()];
}

double Volume::storedValue(std::int64_t offset) const {
    return std::visit([&](const auto& values) { return static_cast<double>(values[static_cast<std::size_t>(offset)]); },
                      *m_voxels);
}

double Volume::normalisedIntensity(std::int64_t offset) const {
    const double value = storedValue(offset) / m_whiteLevel;
    return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

Volume Volume::withDataMask(DataMask mask) const {
    return withDataMask(std::make_shared<const DataMask>(std::move(mask)));
}

Volume Volume::withDataMask(SharedMask mask) const {
    // This call checks the mask's size. dataBoxOf() reads the mask only after that.
    Volume marked = withDataMask(std::move(mask), m_dataBox);
    marked.m_dataBox = dataBoxOf(m_geometry, *marked.m_dataMask);
    return marked;
}

Volume Volume::withDataMask(SharedMask mask, const DataBox& box) const {
    if (!mask->empty() && mask->size() != static_cast<std::size_t>(m_geometry.voxelCount()))
        throw std::invalid_argument("Volume: the data mask does not match the size");
    Volume marked = *this;
    marked.m_dataMask = std::move(mask);
    marked.m_scannedMask = marked.m_dataMask;
    marked.m_dataBox = box;
    return marked;
}

Volume Volume::withCut(const SharedMask& mask) const {
    if (mask && mask->size() != static_cast<std::size_t>(m_geometry.voxelCount()))
        throw std::invalid_argument("Volume: the mask of the cut does not match the size");
    Volume left = *this;
    left.m_dataMask = mask ? mask : m_scannedMask;
    return left;
}

Volume Volume::withValueScale(const ValueScale& scale) const {
    Volume meant = *this;
    meant.m_valueScale = scale;
    return meant;
}

Volume Volume::withDataBox(const DataBox& box) const {
    Volume framed = *this;
    framed.m_dataBox = box;
    return framed;
}

}  // namespace echolucent
