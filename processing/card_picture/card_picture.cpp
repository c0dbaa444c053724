#include "processing/card_picture/card_picture.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace echolucent {

namespace {

// Colours in single precision, of the picture shown and of the one that is drawn.
constexpr std::int64_t bytesOfPixel = 2 * 4 * sizeof(float);

std::int64_t bytesOfVoxel(const Volume& volume) {
    return std::visit(
        [](const auto& stored) { return std::int64_t{sizeof(typename std::decay_t<decltype(stored)>::value_type)}; },
        volume.voxels());
}

}  // namespace

std::int64_t bytesOnCard(const Volume& volume, int width, int height) {
    const std::int64_t voxels = volume.geometry().voxelCount(), pixels = std::int64_t{width} * height;
    // A light volume has at most two bytes for each voxel. Only a pass over floats would tell whether all are finite.
    const bool mayLackData = !volume.dataMask().empty() || std::holds_alternative<VoxelArray<float>>(volume.voxels());
    const std::int64_t each = bytesOfVoxel(volume) + 2 + (mayLackData ? 1 : 0);
    return voxels * each + pixels * bytesOfPixel;
}

double levelsBetween(const Picture& one, const Picture& other) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    if (one.rgba.size() != other.rgba.size() || one.rgba.empty()) return nowhere;
    double squares = 0.0;
    for (std::size_t i = 0; i < one.rgba.size(); ++i) {
        const double difference = static_cast<double>(one.rgba[i]) - static_cast<double>(other.rgba[i]);
        squares += difference * difference;
    }
    const double levels = 255.0 * std::sqrt(squares / static_cast<double>(one.rgba.size()));
    return std::isfinite(levels) ? levels : nowhere;
}

}  // namespace echolucent
