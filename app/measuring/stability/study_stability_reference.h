// Reference values of 50 digits for `study stability`; tests/fixtures/make_reference.py makes them.
#pragma once

#include <string>
#include <vector>

namespace echolucent::reference {

/// g(intensity) of eq. 5 with its erratum.
struct BasisReference {
    double gap;  ///< high - low before rounding
    double intensity, low, high;
    std::string digits;
};
extern const std::vector<BasisReference> basisReferences;

/// ln x^2 + sum ln(1 + d) g(x) at x = intensity / 255, over the first `tubes` of tubeInput(t, dMax).
struct LogOpacityReference {
    int tubes;
    double dMax;
    int intensity;
    std::string digits;
    double magnitudes;  ///< sum of the terms' magnitudes
};
extern const std::vector<LogOpacityReference> logOpacityReferences;

/// The value is 1 - (1 - opacity)^ratio.
struct StepReference {
    double opacity, ratio;
    std::string digits;
};
extern const std::vector<StepReference> stepReferences;

}  // namespace echolucent::reference
