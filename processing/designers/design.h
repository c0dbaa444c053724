// What an OTF designer is given, and what it gives: a classification and why it is so.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/classification.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

struct AdaptiveOtf;

/// What designers may look at. The volumes outlive the call.
struct DesignerInput {
    const Volume& raw;    ///< as it was read: tube cores read it
    const Volume& shown;  ///< what the picture is made of, on the same grid: designers read it for all else
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of `shown`
    Viewpoint view{};                                    ///< along which tube cores are placed
    AdaptiveOtfConfig method{};                          ///< how tube cores are read and weighed
};

/// One number that a designer found or used.
struct DesignFact {
    std::string name;   ///< key in JSON, words joined by underscores: "fluid_level"
    std::string label;  ///< for a person, sentence case: "Fluid level"
    double value = 0.0;
    std::string unit{};  ///< "units", "share", ...; normalised intensities, opacities and counts have none
    friend bool operator==(const DesignFact&, const DesignFact&) = default;
};

/// A function over the intensity that a designer looked at, to be plotted.
struct DesignPlot {
    std::string name;   ///< key in JSON: "position", "area"
    std::string label;  ///< for a person: "Position p(v)"
    std::string unit{};
    std::vector<double> intensities;  ///< ascending, [0,1]
    std::vector<double> values;       ///< one an intensity; NaN where the function is not known
};

/// What a designer made of a volume.
struct Design {
    Classification classification;
    /// Sentences, in order, that say to a person what was found and why the OTF is as it is, with numbers.
    std::vector<std::string> explanation{};
    std::vector<DesignFact> facts{};
    std::vector<DesignPlot> plots{};
    /// A sentence where something could not be done, and what is shown in place; else empty. It is no part of the
    /// explanation.
    std::string message{};
    /// What the tube cores saw, if the designer is the adaptive method; else null.
    std::shared_ptr<const AdaptiveOtf> tubeCores{};
};

}  // namespace echolucent
