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
    double value = 0.0;             ///< the value where the error is largest
    std::string reference;          ///< the reference there, with all its digits
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
    std::optional<double> dMax;      ///< instead of the reading's strength
    std::optional<int> tubesAcross;  ///< instead of 15
};
[[nodiscard]] std::vector<ExtremeCase> extremeCases();

/// The result of an extreme case with one reading.
struct ExtremeResult {
    std::string name, reading, message;
    int tubes = 0, surfaces = 0;
    bool finite = false;  ///< whether curve, logarithm, weights and tube cores hold no NaN and opacities lie in [0,1]
    double leastOpacity = 0.0, mostOpacity = 0.0;
    double deviation = 0.0;  ///< largest difference from the initial function
    /// Whether it ended in a curve, or in a message and the initial function.
    [[nodiscard]] bool isSound() const;
};
[[nodiscard]] ExtremeResult resultOf(const ExtremeCase& extreme, const std::string& reading,
                                     const AdaptiveOtfConfig& config);

}  // namespace echolucent::cli
