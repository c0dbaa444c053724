#include <algorithm>
#include <optional>

#include "app/measuring/aim/study_aim.h"
#include "app/measuring/designers/study_designers.h"
#include "app/measuring/study_phantoms.h"
#include "processing/adaptive/found_ramp.h"

namespace echolucent::cli {

namespace {

Classification rampCurve(const FoundRamp& ramp) {
    SampledCurve curve;
    for (std::size_t i = 0; i < AdaptiveOtf::sampleCount; ++i)
        curve.opacities.push_back(opacityAt(ramp, AdaptiveOtf::intensityOf(i)));
    return OpacityCurve(std::move(curve));
}

std::vector<Classification> triedRamps() {
    std::vector<Classification> ramps;
    for (int begin = 0; begin < 40; ++begin)
        for (const double width : {0.02, 0.05, 0.1, 0.2, 0.3, 0.45})
            for (const double opacity : {1.0, 0.6, 0.35, 0.2, 0.1})
                ramps.push_back(rampCurve({0.02 * begin, 0.02 * begin + width, opacity}));
    return ramps;
}

struct BestRamps {
    std::optional<Classification> forObjects;  ///< no value if the scan has no object
    Classification forAll;
};

BestRamps bestRamps(const Volume& quiet, const Viewpoint& view, const PhantomTruth& truth) {
    static const std::vector<Classification> ramps = triedRamps();
    constexpr double raySpacing = 4.0;
    constexpr std::size_t atOnce = 100;  // their measures of all rays fit into memory
    const auto raysInto = [&](InterfaceInto into) {
        return trueSurfaces(quiet.geometry(), truth, view, into, raySpacing);
    };
    const auto objects = raysInto(InterfaceInto::object), walls = raysInto(InterfaceInto::tissue);
    const Classification *bestForObjects = &ramps.front(), *bestForAll = &ramps.front();
    int mostObjects = -1, mostOfAll = -1;
    for (std::size_t first = 0; first < ramps.size(); first += atOnce) {
        const auto some = std::span(ramps).subspan(first, std::min(atOnce, ramps.size() - first));
        const auto ofObjects = measuresOf(quiet, view, objects, some).value();
        const auto ofWalls = measuresOf(quiet, view, walls, some).value();
        for (std::size_t i = 0; i < some.size(); ++i) {
            const int right = ofObjects[i].depth.right, all = right + ofWalls[i].depth.right;
            if (right > mostObjects) {
                mostObjects = right;
                bestForObjects = &some[i];
            }
            if (all > mostOfAll) {
                mostOfAll = all;
                bestForAll = &some[i];
            }
        }
    }
    return {objects.empty() ? std::nullopt : std::optional(*bestForObjects), *bestForAll};
}

}  // namespace

std::vector<AimRow> measureAims(const PhantomConfig& base, const AimCase& one) {
    PhantomConfig scan = defaultPhantom(one.scene);
    scan.size = base.size;
    scan.seed = base.seed;
    std::vector<NamedPhantom> conditions = ordinaryConditions(scan);
    for (NamedPhantom& hard : hardConditions(scan)) conditions.push_back(std::move(hard));
    const Viewpoint view = one.oblique ? obliqueView : Viewpoint{};
    std::vector<AimRow> rows;
    for (const NamedPhantom& condition : conditions) {
        const StudyPhantom phantom(condition.config);
        const Volume quiet = *quietVolume(phantom.volume, one.reduction);
        const DesignerInput input{phantom.volume, quiet, one.reduction, view, AdaptiveOtfConfig{}};
        std::vector<std::string> names;
        std::vector<Classification> classifications;
        const auto add = [&](const std::string& name, const Classification& classification) {
            names.push_back(name);
            classifications.push_back(classification);
        };
        for (const ComparedDesigner& designer : comparedDesigners(input.method, measuredAims))
            add(designer.name, timedDesign(designer, input, 1).design.classification);
        const BestRamps best = bestRamps(quiet, view, phantom.truth);
        if (best.forObjects) add(boundOfObjects, *best.forObjects);
        add(boundOfAll, best.forAll);
        const auto surfaces = shownSurfacesOf(phantom.volume, quiet, view, &phantom.truth, classifications);
        for (std::size_t i = 0; i < names.size(); ++i)
            rows.push_back({one, base.seed, {names[i], condition.name, surfaces[i]}});
    }
    return rows;
}

}  // namespace echolucent::cli
