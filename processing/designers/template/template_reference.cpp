#include "processing/designers/template/template_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "processing/intensity/histogram.h"
#include "processing/volume/volume.h"

namespace echolucent {

namespace {

/// The volume with voxels that are not finite masked as no data: its own mask may mark them as data.
Volume withoutNotFinite(const Volume& volume) {
    const auto* voxels = std::get_if<VoxelArray<float>>(&volume.voxels());
    const auto isFinite = [](float value) { return std::isfinite(value); };
    if (voxels == nullptr || std::ranges::all_of(*voxels, isFinite)) return volume;
    std::vector<std::uint8_t> mask(voxels->size());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = isFinite((*voxels)[i]) && volume.hasData(static_cast<std::int64_t>(i)) ? 1 : 0;
    return volume.withDataMask(std::move(mask));
}

}  // namespace

TemplateReference templateFrom(const Volume& volume, OpacityCurve curve, std::string name) {
    const IntensityHistogram histogram = intensityHistogram(withoutNotFinite(volume));
    TemplateReference reference{std::move(name), {}, std::move(curve)};
    const auto total = static_cast<double>(std::max<std::uint64_t>(histogram.total, 1));
    for (const std::uint64_t count : histogram.counts)
        reference.histogram.push_back(static_cast<double>(count) / total);
    return reference;
}

}  // namespace echolucent
