// Opacity and colour of a step from all intensities between its two ends.
#pragma once

#include <vector>

#include "processing/opacity_curve.h"
#include "processing/ray_caster.h"

namespace echolucent::ray_casting {

/// Integrals over the intensity, from 0 to each table position, of the extinction tau = -log(1 - opacity) per reference
/// step, and of tau times colour. Between two intensities a and b the mean extinction is (T(b) - T(a)) / (b - a), the
/// step's opacity 1 - exp(-step * mean), its colour the tau-weighted mean (attenuation within the step left out): Engel,
/// Kraus and Ertl 2001, section 4, in one dimension.
class PreIntegration {
public:
    /// Entries are intensities i / intervals; between them the integrals are linear.
    static constexpr int intervals = 255 * 8;
    /// Closer ends are taken as one point.
    static constexpr float closest = 0.5f;
    /// Opacity 1 has no finite extinction: more than that per reference step is as opaque in float.
    static constexpr double largestExtinction = 40.0;

    PreIntegration(const OpacityCurve& curve, ColourMap colourMap, double stepRatio);

    /// Four floats an entry: of tau * red, tau * green, tau * blue, tau; times the step, per table interval.
    [[nodiscard]] const float* integrals() const { return m_integrals.data(); }

private:
    std::vector<float> m_integrals;
};

}  // namespace echolucent::ray_casting
