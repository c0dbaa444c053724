// Opacity and colour of a step from all intensities between its two ends.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/ray_caster.h"
#include "processing/ray_caster/transfer_table.h"

namespace echolucent::ray_casting {

/// Integrals over the intensity, from 0 to each table position, of the extinction tau = -log(1 - opacity) per reference
/// step, and of tau times the table position. Between two intensities a and b the mean extinction is
/// (T(b) - T(a)) / (b - a), the step's opacity 1 - exp(-step * mean), its colour that of the tau-weighted mean
/// intensity (attenuation within the step left out): Engel, Kraus and Ertl 2001, section 4, in one dimension.
class PreIntegration {
public:
    /// Entries are intensities i / intervals; between them the integrals are linear.
    static constexpr int intervals = TransferTable::intervals;
    /// Closer ends, in table intervals, are taken as one point.
    static constexpr float closest = 0.5f;
    /// Opacity 1 has no finite extinction: more than that per reference step is as opaque in float.
    static constexpr double largestExtinction = 40.0;

    PreIntegration(const OpacityCurve& curve, double stepRatio);

    /// intervals + 2 values in fixed point, so that differences are exact: what is faint keeps its opacity where the
    /// curve is opaque below it.
    struct Integral {
        std::vector<std::int32_t> entries;
        float unit = 0.0f;  ///< what 1 stands for
    };
    /// Of the step's extinction, and of that times the table position; per table interval.
    [[nodiscard]] const Integral& extinction() const { return m_extinction; }
    [[nodiscard]] const Integral& weighted() const { return m_weighted; }

private:
    Integral m_extinction, m_weighted;
};

}  // namespace echolucent::ray_casting
