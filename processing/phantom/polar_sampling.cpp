#include "processing/phantom/polar_sampling.h"

#include <algorithm>

namespace echolucent {

PhantomSampling polarSampling(const PolarGeometry& polar, const ConversionGrid& grid) {
    const auto size = polar.size();
    const auto block = [polar, size, origin = grid.geometry.origin](const std::array<std::int64_t, 3>& first,
                                                                    SampledBlock& at) {
        std::size_t i = 0;
        Vec3 low, high;
        for (std::int64_t sample = first[2]; sample < first[2] + paintedEdge; ++sample)
            for (std::int64_t plane = first[1]; plane < first[1] + paintedEdge; ++plane)
                for (std::int64_t line = first[0]; line < first[0] + paintedEdge; ++line, ++i) {
                    // Samples beyond the last index get the place of the last index.
                    const Vec3 mm = probeMmFromPolar(polar, {static_cast<double>(std::min(sample, size[0] - 1)),
                                                             static_cast<double>(std::min(line, size[1] - 1)),
                                                             static_cast<double>(std::min(plane, size[2] - 1))}) -
                                    origin;
                    at.x[i] = mm[0];
                    at.y[i] = mm[1];
                    at.z[i] = mm[2];
                    for (int axis = 0; axis < 3; ++axis) {
                        low[axis] = i == 0 ? mm[axis] : std::min(low[axis], mm[axis]);
                        high[axis] = i == 0 ? mm[axis] : std::max(high[axis], mm[axis]);
                    }
                }
        at.centre = (low + high) * 0.5;
        at.radius = 0.5 * length(high - low);
    };
    return {{size[1], size[2], size[0]}, polar.rangeStepMm, block};
}

EvenPolar usualPolar(PolarKind kind, std::int64_t samples, double stepMm) {
    const double depth = static_cast<double>(samples - 1) * stepMm;
    const double side = 0.45 * depth;
    EvenPolar even;
    even.kind = kind;
    even.rangeStepMm = stepMm;
    const PolarGeometry spread = polarGeometry(even, {2, 2, 2});
    even.lines = spread.lines.spread == PolarSpread::angles ? std::array{-40.0, 40.0} : std::array{-side, side};
    even.planes = spread.planes.spread == PolarSpread::angles ? std::array{-38.0, 38.0} : std::array{-side, side};
    even.lineRadiusMm = 0.4 * depth;
    even.planeRadiusMm = 0.25 * depth;
    return even;
}

}  // namespace echolucent
