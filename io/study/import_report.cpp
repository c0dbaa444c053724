#include "io/study/import_report.h"

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

std::string burnedInTextNote(const Study& study) {
    switch (study.burnedInText) {
        case BurnedInText::no: return {};
        case BurnedInText::yes:
            return "The file declares text in its pictures: what is saved may show names burnt into the pictures.";
        case BurnedInText::unknown: break;
    }
    return "The file does not declare its pictures free of text: what is saved may show names burnt into the pictures.";
}

}  // namespace echolucent
