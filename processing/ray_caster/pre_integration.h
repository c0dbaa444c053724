// Opacity and colour of a step from all intensities between its two ends.
#pragma once

#include <vector>

#include "processing/opacity_curve.h"
#include "processing/ray_caster.h"
#include "processing/ray_caster/transfer_table.h"

namespace echolucent::ray_casting {

/// Integrals over the intensity, from 0 to each table position, of the extinction tau = -log(1 - opacity) per reference
/// step, and of tau times the table position. Between two intensities a and b the mean extinction is
/// (T(b) - T(a)) / (b - a), the step's opacity 1 - exp(-step * mean), its colour that of the tau-weighted mean intensity
/// (attenuation within the step left out): Engel, Kraus and Ertl 2001, section 4, in one dimension.
class PreIntegration {
public:
    /// Entries are intensities i / intervals; between them the integrals are linear.
    static constexpr int intervals = TransferTable::intervals;
    /// Closer ends, in table intervals, are taken as one point.
    static constexpr float closest = 0.5f;
    /// Opacity 1 has no finite extinction: more than that per reference step is as opaque in float.
    static constexpr double largestExtinction = 40.0;

    PreIntegration(const OpacityCurve& curve, double stepRatio);

    /// 0: of the step's extinction, 1: of that times the table position; per table interval. intervals + 2 values.
    [[nodiscard]] const float* integrals(int component) const {
        return (component == 0 ? m_extinction : m_weighted).data();
    }

private:
    std::vector<float> m_extinction, m_weighted;
};

}  // namespace echolucent::ray_casting
