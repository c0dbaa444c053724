#include "io/study/study_facts.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "processing/beam/probe_view.h"
#include "processing/volume/value_digits.h"

namespace echolucent {

namespace {

std::string maskSource(const StudyParts& parts, const ReadOptions& options) {
    if (parts.dataMask) return parts.dataMaskSource + "; or not finite";
    if (!options.guessNoData) return "only voxels that are not finite";
    return fmt::format("guess: {} and connected to the border; or not finite",
                       parts.voxels.scale.black == 0.0 ? "0" : "black, or else 0,");
}

std::string vectorText(const Vec3& vector) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", vector[0], vector[1], vector[2]);
}

/// Adds what the file says of the probe. What the echo says is found after reading.
void addProbeFacts(const StudyParts& parts, Study& study) {
    const auto& probe = parts.geometry.probe;
    if (!probe) return;
    const Viewpoint view = viewFromProbe(*probe);
    const bool leans = view.azimuthDegrees != 0.0 || view.elevationDegrees != 0.0;
    study.facts.push_back({"beam",
                           std::string(nameOf(view.beamAxis)) + " of the voxel grid" +
                               (leans ? ", leaning: direction " + vectorText(probe->forward) : ""),
                           parts.probeSource});
    if (probe->apexMm)
        study.facts.push_back(
            {"apex of the beams", vectorText(*probe->apexMm) + " mm from the first voxel", parts.probeSource});
}

void addGeometryFacts(const StudyParts& parts, Study& study) {
    study.facts.push_back({"size", sizeText(parts.geometry.size) + " voxels", parts.sizeSource});
    if (parts.reduction)
        study.facts.push_back({"reduced",
                               fmt::format("means of {} of {} voxels", factorsText(parts.reduction->reduction),
                                           sizeText(parts.reduction->reduction.storedSize)),
                               parts.reduction->reason});
    std::string source = parts.spacingSource.empty() ? "assumed" : parts.spacingSource;
    if (parts.inPlaneSpacingKnown) source += "; distance of slices assumed";
    study.facts.push_back({"spacing", spacingText(parts.geometry.spacing), source});
    study.facts.push_back({"voxel type", parts.voxels.story, parts.typeSource});
}

std::string timesText(const PhaseTimes& times) {
    const auto gaps = gapsOf(times);
    if (!gaps) return "unknown";
    if (times.starts.empty()) return fmt::format("{:.6g} s", *times.meanSeconds);
    return fmt::format("{:.4g} to {:.4g} s; played as they are", gaps->first, gaps->second);
}

/// Adds white, and where it is no matter of course, black and what the file holds.
void addValueFacts(const StudyParts& parts, const std::string& whiteSource, Study& study) {
    const Volume& volume = *study.phases.front();
    if (!parts.shown) {
        study.facts.push_back({"white level", fmt::format("{}", volume.whiteLevel()), whiteSource});
        return;
    }
    const auto text = [digits = digitsToTell(volume.valueWindow(), 6)](double value) {
        return fmt::format("{:.{}g}", value, digits);
    };
    const std::string values = text(parts.shown->lowest) + " to " + text(parts.shown->highest);
    const std::string black = text(volume.blackValue()), white = text(volume.whiteValue());
    study.facts.push_back({"values", values, "all voxels"});
    study.facts.push_back({"black level", black, parts.shown->blackSource});
    study.facts.push_back({"white level", white, whiteSource});
    study.warnings.push_back(fmt::format("The voxels hold {}: black is {}, white {}.", values, black, white));
}

void addPhaseFacts(const StudyParts& parts, Study& study) {
    if (study.phases.size() < 2) return;
    study.facts.push_back({"phases", std::to_string(study.phases.size()),
                           parts.phasesSource.empty() ? parts.sizeSource : parts.phasesSource});
    study.facts.push_back({"time between phases", timesText(parts.phaseTimes),
                           parts.phaseSource.empty() ? "the file does not say it" : parts.phaseSource});
}

void addLossFact(const StudyParts& parts, Study& study) {
    const char* value = "unknown";
    if (parts.lossyCompression != LossyCompression::unknown)
        value = parts.lossyCompression == LossyCompression::yes ? "yes" : "no";
    study.facts.push_back(
        {"lossy compression", value, parts.lossSource.empty() ? "the format has no entry for it" : parts.lossSource});
}

/// Adds the fact on burnt-in text, if the format has an entry for it.
void addBurnedInTextFact(const StudyParts& parts, Study& study) {
    if (parts.burnedInTextSource.empty()) return;
    const char* value = "unknown";
    if (parts.burnedInText != BurnedInText::unknown) value = parts.burnedInText == BurnedInText::yes ? "yes" : "no";
    study.facts.push_back({"burnt-in text", value, parts.burnedInTextSource});
}

/// Adds the notes on what was assumed or lost.
void addNotes(const StudyParts& parts, Study& study) {
    if (!study.phaseTimes.starts.empty())
        study.warnings.push_back("The times between phases are uneven (" + timesText(study.phaseTimes) + ").");
    if (parts.reduction) study.warnings.push_back(reductionWarning(*parts.reduction));
    if (!parts.voxels.warning.empty()) study.warnings.push_back(parts.voxels.warning);
    if (parts.inPlaneSpacingKnown && !parts.geometry.spacingKnown)
        study.warnings.push_back(
            fmt::format("The distance of the slices is unknown; {:.6g} mm is assumed, so lengths "
                        "across them cannot be trusted. Within a slice the spacing is known.",
                        parts.geometry.spacing[parts.sliceAxis]));
    else if (!parts.geometry.spacingKnown)
        study.warnings.push_back("The spacing of the voxels is unknown; " + spacingText(parts.geometry.spacing) +
                                 " is assumed, so lengths and proportions cannot be trusted.");
}

}  // namespace

std::string sizeText(const std::array<std::int64_t, 3>& size) {
    return fmt::format("{} x {} x {}", size[0], size[1], size[2]);
}

std::string spacingText(const Vec3& spacing) {
    return fmt::format("{:.6g} x {:.6g} x {:.6g} mm", spacing[0], spacing[1], spacing[2]);
}

double noDataShare(const std::vector<std::shared_ptr<const Volume>>& phases) {
    double outside = 0.0;
    double total = 0.0;
    for (const auto& phase : phases) {
        outside += static_cast<double>(std::count(phase->dataMask().begin(), phase->dataMask().end(), 0));
        total += static_cast<double>(phase->geometry().voxelCount());
    }
    return outside / total;
}

void addAssembledFacts(const StudyParts& parts, const ReadOptions& options, const std::string& whiteSource,
                       Study& study) {
    addGeometryFacts(parts, study);
    addValueFacts(parts, whiteSource, study);
    addPhaseFacts(parts, study);
    study.facts.push_back(
        {"voxels without data", fmt::format("{:.1f} %", 100.0 * noDataShare(study.phases)),
         (parts.missingSlices.empty() ? "" : "slices that could not be read; ") + maskSource(parts, options)});
    addProbeFacts(parts, study);
    addLossFact(parts, study);
    addBurnedInTextFact(parts, study);
    addNotes(parts, study);
}

}  // namespace echolucent
