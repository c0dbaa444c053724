#include "processing/comparison/shown_depth.h"

#include <cstddef>

#include "processing/sampling/sample_at_half.h"

namespace echolucent {

namespace {

template <typename Depth>
auto& countOf(Depth& depth, ShownSurface shown) {
    switch (shown) {
        case ShownSurface::right: return depth.right;
        case ShownSurface::early: return depth.early;
        case ShownSurface::late: return depth.late;
        case ShownSurface::never: break;
    }
    return depth.never;
}

}  // namespace

std::optional<double> shownSample(const RaySamples& ray, const OpacityTable& table) {
    return sampleAtHalf(ray.intensities, [&](std::size_t i, double intensity) {
        return table.at(intensity, ray.gradients.empty() ? 0.0 : ray.gradients[i]);
    });
}

ShownSurface shownSurfaceAt(std::optional<double> unitsBehindSurface) {
    if (!unitsBehindSurface) return ShownSurface::never;
    if (*unitsBehindSurface < -rightUnits) return ShownSurface::early;
    return *unitsBehindSurface > rightUnits ? ShownSurface::late : ShownSurface::right;
}

std::optional<double> ShownDepth::share(ShownSurface shown) const {
    if (rays() == 0) return std::nullopt;
    return static_cast<double>(countOf(*this, shown)) / rays();
}

void ShownDepth::count(ShownSurface shown) { ++countOf(*this, shown); }

ShownDepth& ShownDepth::operator+=(const ShownDepth& other) {
    right += other.right;
    early += other.early;
    late += other.late;
    never += other.never;
    return *this;
}

}  // namespace echolucent
