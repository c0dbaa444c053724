#include "processing/near_cut/tube_echo.h"

#include <cmath>

#include "processing/parallel.h"

namespace echolucent {

namespace {

/// Places a step apart that cover the volume along a direction. One of them is `pivot`.
struct Places {
    double first;
    int count;
};

Places placesAlong(const VolumeGeometry& geometry, const Vec3& direction, double pivot, double step) {
    const auto [nearest, farthest] = geometry.depthsAlong(direction);
    const int before = static_cast<int>(std::floor((pivot - nearest) / step));
    const int after = static_cast<int>(std::floor((farthest - pivot) / step));
    return {pivot - before * step, before + after + 1};
}

}  // namespace

TubeEcho readTubeEcho(const SmoothEcho& coarse, const VolumeGeometry& geometry, const Viewpoint& view) {
    TubeEcho tubes;
    tubes.frame = frameOf(view);
    tubes.stepMm = coarse.cellMm();
    const auto along = [&](const Vec3& direction) {
        return placesAlong(geometry, direction, direction.dot(coarse.dataCentreMm()), tubes.stepMm);
    };
    const Places right = along(tubes.frame.right), down = along(tubes.frame.down), deep = along(tubes.frame.forward);
    tubes.firstRightMm = right.first;
    tubes.columns = right.count;
    tubes.firstDownMm = down.first;
    tubes.rows = down.count;
    tubes.firstDepthMm = deep.first;
    tubes.samples = deep.count;
    const auto samples = static_cast<std::size_t>(tubes.samples);
    tubes.echo.resize(tubes.tubes() * samples);
    parallelFor(std::size_t{0}, tubes.tubes(), [&](std::size_t tube) {
        const auto columns = static_cast<std::size_t>(tubes.columns);
        const std::size_t column = tube % columns, row = tube / columns;
        const Vec3 across = tubes.frame.right * (right.first + static_cast<double>(column) * tubes.stepMm) +
                            tubes.frame.down * (down.first + static_cast<double>(row) * tubes.stepMm);
        for (std::size_t sample = 0; sample < samples; ++sample) {
            const double depth = tubes.depthMm(static_cast<double>(sample));
            tubes.echo[tube * samples + sample] = coarse.at(across + tubes.frame.forward * depth).value_or(-1.0F);
        }
    });
    return tubes;
}

}  // namespace echolucent
