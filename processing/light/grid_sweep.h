// Sweeps of light through a coarse grid, slice by slice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/light/light_directions.h"
#include "processing/light/light_grid.h"
#include "processing/progress.h"

namespace echolucent::light {

/// The extinctions (per mm) of a grid's places in two orders, because a sweep along x would have long strides in the
/// first order.
struct GridExtinctions {
    const LightGrid& grid;
    const std::vector<float>& xFastest;  ///< places, and spareFloats more
    std::vector<float> yFastest;         ///< y fastest, then x, then z; empty if nothing is swept along x
};

/// Directions that are swept together: their light enters through the same face of the grid. Light goes from slice to
/// slice. Each place takes light from the point where the direction crosses the slice before, linear between the four
/// places around.
class DirectionBundle {
public:
    static constexpr std::size_t most = 4;  ///< directions

    /// The directions of a light in bundles. The order does not depend on the machine.
    [[nodiscard]] static std::vector<DirectionBundle> of(const std::vector<WeightedDirection>& directions,
                                                         const LightGrid& grid);

    [[nodiscard]] bool alongX() const { return m_axis == 0; }
    /// The light that reaches each place, a quarter of the way into it, times the directions' weights and `fullLight`.
    /// `attenuation` multiplies the extinctions. The places are in the order of `yFastest` if alongX(), else of
    /// `xFastest`. Polls progress.cancelled() in every slice; slices after a cancel stay 0.
    [[nodiscard]] std::vector<std::uint16_t> sweep(const GridExtinctions& extinctions, double attenuation,
                                                   const Progress& progress) const;

    /// All light, if the weights sum to 1.
    static constexpr int fullLight = 255 * 256;

private:
    DirectionBundle(int axis, bool fromHigh) : m_axis(axis), m_fromHigh(fromHigh) {}
    int m_axis;       ///< slices follow each other along this axis
    bool m_fromHigh;  ///< whether the light enters at the last slice
    std::vector<WeightedDirection> m_directions;
};

/// The floats of `xFastest` with x and y exchanged, and spareFloats more.
[[nodiscard]] std::vector<float> withYFastest(const std::vector<float>& xFastest, const LightGrid& grid);

}  // namespace echolucent::light
