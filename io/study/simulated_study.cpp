#include "io/study/simulated_study.h"

#include <memory>
#include <utility>

#include "processing/phantom/phantom.h"

namespace echolucent {

Result<Study> simulatedStudy(const SimulatedScan& scan, const Progress& progress) {
    PhantomConfig config = defaultPhantom(scan.scene);
    config.size = scan.size;
    config.seed = scan.seed;
    auto volume = makePhantom(config, progress);
    if (!volume) return fail(FailureKind::cancelled, {}, {}, "cancelled");
    Study study;
    study.name = "Simulated fetal scan";
    study.phases.push_back(std::make_shared<const Volume>(std::move(*volume)));
    study.lossyCompression = LossyCompression::no;
    study.facts.push_back({"origin", "simulated by the program, no patient", "built in"});
    return study;
}

}  // namespace echolucent
