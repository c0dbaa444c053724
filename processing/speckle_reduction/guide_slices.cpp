#include "processing/speckle_reduction/guide_slices.h"

#include <algorithm>
#include <memory>
#include <span>
#include <type_traits>

#include "processing/parallel.h"

namespace echolucent {

namespace {

float intensityOf(double stored, double white) { return static_cast<float>(std::clamp(stored / white, 0.0, 1.0)); }

/// Makes room for at least `count` floats. Old values may be lost.
void makeRoom(std::vector<float>& floats, std::int64_t count) {
    if (static_cast<std::int64_t>(floats.size()) < count) floats = std::vector<float>(static_cast<std::size_t>(count));
}

}  // namespace

GuideSlices::GuideSlices(const Volume& volume, double sigma)
    : m_volume(volume),
      m_slice(volume.geometry().size[0] * volume.geometry().size[1]),
      m_gaussian(volume.geometry(), volume.dataMaskOrNull(), sigma) {
    for (std::size_t byte = 0; byte < m_intensityOfByte.size(); ++byte)
        m_intensityOfByte[byte] = intensityOf(static_cast<double>(byte), volume.whiteLevel());
}

bool GuideSlices::make(std::int64_t first, std::int64_t end, const Progress& progress) {
    m_first = first;
    m_end = end;
    m_firstHeld = std::max<std::int64_t>(0, first - m_gaussian.reach());
    const std::int64_t heldEnd = std::min(m_volume.geometry().size[2], end + m_gaussian.reach());
    makeRoom(m_held, (heldEnd - m_firstHeld) * m_slice);
    makeRoom(m_guide, (end - first) * m_slice);
    readIntensities(m_firstHeld, heldEnd);
    return m_gaussian.make(m_held.data(), m_firstHeld, first, end, m_guide.data(), progress);
}

void GuideSlices::readIntensities(std::int64_t first, std::int64_t end) {
    const std::uint8_t* const mask = m_volume.dataMaskOrNull();
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            parallelFor(first, end, [&](std::int64_t z) {
                const Voxel* const from = voxels.data() + z * m_slice;
                const std::uint8_t* const isData = mask != nullptr ? mask + z * m_slice : nullptr;
                float* const to = m_held.data() + (z - m_firstHeld) * m_slice;
                for (std::int64_t i = 0; i < m_slice; ++i) {
                    if (isData != nullptr && isData[i] == 0)
                        to[i] = 0.0F;
                    else if constexpr (std::is_same_v<Voxel, std::uint8_t>)
                        to[i] = m_intensityOfByte[from[i]];
                    else
                        to[i] = intensityOf(static_cast<double>(from[i]), m_volume.whiteLevel());
                }
            });
        },
        m_volume.voxels());
}

Volume GuideSlices::guideVolume() const {
    VolumeGeometry geometry = m_volume.geometry();
    geometry.size[2] = m_end - m_first;
    // A filter needs no probe and no reduction.
    geometry.probe.reset();
    geometry.reduction.reset();
    const auto count = static_cast<std::size_t>(geometry.voxelCount());
    const std::shared_ptr<const void> notOwned;
    Volume guide(geometry, VoxelArray<float>(notOwned, std::span(m_guide).first(count)), 1.0);
    const std::uint8_t* const mask = m_volume.dataMaskOrNull();
    if (mask == nullptr) return guide;
    const DataMask slices(notOwned, std::span(mask + m_first * m_slice, count));
    return guide.withDataMask(std::make_shared<const DataMask>(slices), guide.dataBox());
}

}  // namespace echolucent
