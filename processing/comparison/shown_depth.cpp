#include "processing/comparison/shown_depth.h"

#include <cmath>

namespace echolucent {

namespace {

constexpr double halfOfTheLight = 0.5;

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
    double transmittance = 1.0;
    for (std::size_t i = 0; i < ray.intensities.size(); ++i) {
        const double intensity = ray.intensities[i];
        if (std::isnan(intensity)) continue;
        const double before = transmittance;
        transmittance *= 1.0 - table.at(intensity, ray.gradients.empty() ? 0.0 : ray.gradients[i]);
        if (transmittance <= 1.0 - halfOfTheLight)
            return static_cast<double>(i) - 1.0 + (before - (1.0 - halfOfTheLight)) / (before - transmittance);
    }
    return std::nullopt;
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
