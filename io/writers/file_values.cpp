#include "io/writers/file_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace echolucent {

namespace {

/// Writes values one after the other as `To`.
template <typename To, typename Value>
void addAs(const VoxelArray<Value>& values, const ValueScale& scale,
           const std::function<void(std::span<const std::uint8_t>)>& add) {
    constexpr std::size_t blockLength = 4096;
    std::vector<To> block;
    for (std::size_t begin = 0; begin < values.size(); begin += blockLength) {
        block.clear();
        for (std::size_t i = begin; i < std::min(begin + blockLength, values.size()); ++i)
            block.push_back(static_cast<To>(scale.fileValue(static_cast<double>(values[i]))));
        add({reinterpret_cast<const std::uint8_t*>(block.data()), block.size() * sizeof(To)});
    }
}

}  // namespace

StoredType typeOfFileValues(const Volume& volume) {
    constexpr StoredType own[] = {StoredType::uint8, StoredType::uint16, StoredType::float32};
    const ValueScale& scale = volume.valueScale();
    if (scale.isIdentity()) return own[volume.voxels().index()];
    const bool isWhole = !std::holds_alternative<VoxelArray<float>>(volume.voxels()) && scale.factor == 1.0 &&
                         scale.black == std::floor(scale.black);
    const double most = volume.voxels().index() == 0 ? 255.0 : 65535.0;
    const auto fits = [&]<typename Whole>(Whole) {
        return isWhole && scale.black >= static_cast<double>(std::numeric_limits<Whole>::min()) &&
               scale.black + most <= static_cast<double>(std::numeric_limits<Whole>::max());
    };
    if (fits(std::int16_t{})) return StoredType::int16;
    return fits(std::int32_t{}) ? StoredType::int32 : StoredType::float64;
}

void addFileValues(const Volume& volume, const std::function<void(std::span<const std::uint8_t>)>& add) {
    const StoredType type = typeOfFileValues(volume);
    std::visit(
        [&](const auto& values) {
            const ValueScale& scale = volume.valueScale();
            if (type == StoredType::int16) return addAs<std::int16_t>(values, scale, add);
            if (type == StoredType::int32) return addAs<std::int32_t>(values, scale, add);
            if (type == StoredType::float64) return addAs<double>(values, scale, add);
            add({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(values[0])});
        },
        volume.voxels());
}

bool canBeWrittenTogether(const Volume& one, const Volume& other) {
    return one.geometry().size == other.geometry().size && one.voxels().index() == other.voxels().index() &&
           one.valueScale() == other.valueScale();
}

}  // namespace echolucent
