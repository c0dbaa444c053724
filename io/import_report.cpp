#include "io/import_report.h"

#include <fmt/format.h>

namespace echolucent {

std::vector<ImportFact> importReport(const Study& study, const BeamGuess& beam) {
    std::vector<ImportFact> facts = study.facts;
    if (beam.evidence == BeamEvidence::file) return facts;
    facts.push_back({"beam", std::string(nameOf(beam.axis)) + " of the voxel grid",
                     beam.sure
                         ? fmt::format("guess from the {}, confidence {:.2f}", nameOf(beam.evidence), beam.confidence)
                         : "assumed: " + beam.sentence});
    return facts;
}

}  // namespace echolucent
