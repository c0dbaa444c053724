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

/// The extinctions (per mm) of a grid's places in two orders, because slices along x are strided badly in the first.
struct GridExtinctions {
    const LightGrid& grid;
    const std::vector<float>& xFastest;  ///< places, and spareFloats more
    std::vector<float> yFastest;         ///< y fastest, then x, then z; empty where nothing is swept along x
};

/// Directions that are swept together: their light enters through the same face of the grid. Light goes from slice to
/// slice; a slice's place takes what has passed the slice before at the place where the direction crosses it, linear
/// between the four places around.
class DirectionBundle {
public:
    static constexpr std::size_t most = 4;  ///< directions

    /// Directions of a light in bundles, in an order that does not depend on the machine.
    [[nodiscard]] static std::vector<DirectionBundle> of(const std::vector<WeightedDirection>& directions,
                                                         const LightGrid& grid);

    [[nodiscard]] bool alongX() const { return m_axis == 0; }
    /// What reaches each place, a quarter of it on the way, times the directions' weights and `fullLight`, in the order
    /// of the extinctions that it was swept through, times `attenuation`. Cancel is polled in every slice.
    [[nodiscard]] std::vector<std::uint16_t> sweep(const GridExtinctions& extinctions, double attenuation,
                                                   const Progress& progress) const;

    /// All light, where the weights sum to 1.
    static constexpr int fullLight = 255 * 256;

private:
    DirectionBundle(int axis, bool fromHigh) : m_axis(axis), m_fromHigh(fromHigh) {}
    int m_axis;       ///< along which slices follow each other
    bool m_fromHigh;  ///< whether the light enters at the last slice
    std::vector<WeightedDirection> m_directions;
};

/// The same floats with x and y exchanged, and spareFloats more.
[[nodiscard]] std::vector<float> withYFastest(const std::vector<float>& xFastest, const LightGrid& grid);

}  // namespace echolucent::light
