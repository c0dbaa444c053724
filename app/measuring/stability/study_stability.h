// What `study stability` measures: numbers against references of 50 digits, and the method on extreme volumes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// One way to compute one quantity, in one condition.
struct NumericCheck {
    std::string quantity;           ///< its name, as "basis function"
    std::string condition;          ///< the condition, as "I_H - I_L = 1e-09"
    std::string way;                ///< "as here" or the textbook formula's name
    double value = 0.0;             ///< the value at the place with the largest error
    std::string reference;          ///< the reference at that place, with all its digits
    double error = 0.0;             ///< the largest error in the condition; infinite if the value is not finite
    std::optional<double> allowed;  ///< the largest error allowed; no value for a formula that the program does not use
    std::optional<double> abscissa;  ///< the condition as a number, for the plot
    [[nodiscard]] bool isOurs() const { return allowed.has_value(); }
    [[nodiscard]] bool fails() const { return allowed && !(error <= *allowed); }
};
[[nodiscard]] std::vector<NumericCheck> numericChecks();

/// An extreme small volume or setting.
struct ExtremeCase {
    std::string name;
    Volume volume;
    Viewpoint view;
    std::optional<double> dMax;      ///< d_max of a ProductRule that replaces the reading's rule of the curve
    std::optional<int> tubesAcross;  ///< columns and rows of tube cores across the volume's x axis; else the reading's
};
[[nodiscard]] std::vector<ExtremeCase> extremeCases();

/// The result of an extreme case with one reading.
struct ExtremeResult {
    std::string name, reading, message;
    int tubes = 0, surfaces = 0;
    bool finite = false;  ///< whether curve, logarithm, weights and tube cores hold no NaN and opacities lie in [0,1]
    double leastOpacity = 0.0, mostOpacity = 0.0;
    double deviation = 0.0;  ///< largest difference from the initial function
    /// Whether `finite` holds, and the case ended in a curve from surfaces, or in a message and the initial function.
    [[nodiscard]] bool isSound() const;
};
[[nodiscard]] ExtremeResult resultOf(const ExtremeCase& extreme, const std::string& reading,
                                     const AdaptiveOtfConfig& config);

}  // namespace echolucent::cli
