// What an OTF designer takes, and what it gives: a classification and why it is so.
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

/// All that designers may read. The volumes outlive the call.
struct DesignerInput {
    const Volume& raw;    ///< as read from the file: tube cores read it
    const Volume& shown;  ///< the picture's voxels, on the same grid: designers read them for all else
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of `shown`
    Viewpoint view{};                                    ///< tube cores lie along it
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

/// A function over the intensity, for a plot.
struct DesignPlot {
    std::string name;   ///< key in JSON: "position", "area"
    std::string label;  ///< for a person: "Position p(v)"
    std::string unit{};
    std::vector<double> intensities;  ///< ascending, [0,1]
    std::vector<double> values;       ///< one an intensity; NaN if the function is not known there
};

/// What a designer made of a volume.
struct Design {
    Classification classification;
    /// Sentences for a person, in order, with numbers: what was found, and why the OTF is as it is.
    std::vector<std::string> explanation{};
    std::vector<DesignFact> facts{};
    std::vector<DesignPlot> plots{};
    /// If something could not be done, a sentence that says so and what is shown instead; else empty. It is no part of
    /// the explanation.
    std::string message{};
    /// What the tube cores saw, if the designer is the adaptive method; else null.
    std::shared_ptr<const AdaptiveOtf> tubeCores{};
};

}  // namespace echolucent
