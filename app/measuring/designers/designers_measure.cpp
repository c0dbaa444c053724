#include <fmt/format.h>

#include <utility>
#include <variant>

#include "app/measuring/designers/study_designers.h"
#include "app/measuring/run_time.h"
#include "app/measuring/study_phantoms.h"
#include "processing/designers/choice/designer.h"
#include "processing/median.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent::cli {

namespace {

Design designOnce(const ComparedDesigner& designer, const DesignerInput& input) {
    if (!designer.config) return Design{parabolaCurve()};
    if (!designer.aim) return *design(*designer.config, input);
    DesignerInput aimed = input;
    std::get<RampRule>(aimed.method.curve).aim = *designer.aim;
    return *design(*designer.config, aimed);
}

/// The error of the kernel's small picture from the plain route's with equal settings.
PictureError errorOf(const Classification& classification, const DesignerCase& one) {
    constexpr int edge = 96;
    RayCastSettings settings = one.settings;
    settings.width = settings.height = edge;
    settings.terminationTransmittance = 0.0;
    const PlainCasting casting{.leastLitOpacity = std::min(1.0, settings.step) / 128};
    return pictureError(*castRays(*one.shown, classification, settings),
                        *castRaysPlainly(*one.shown, classification, settings, casting));
}

/// The median time of a picture, ms. Each picture is seen from a view that is turned a little farther, so that no
/// earlier result can be used again.
double castTime(RayCaster& caster, const Classification& classification, const DesignerCase& one, int repeats) {
    std::vector<double> times;
    (void)caster.cast(classification, one.settings);
    for (int turn = 1; turn <= repeats; ++turn) {
        RayCastSettings settings = one.settings;
        Viewpoint view = one.view;
        view.azimuthDegrees += 0.01 * turn;
        settings.camera = defaultCamera(one.shown->dataBox(), view, 1.0);
        times.push_back(millisecondsOf([&] { (void)caster.cast(classification, settings); }));
    }
    return medianOf(std::move(times));
}

}  // namespace

std::string nameOfAim(double aim) { return fmt::format("aim {:g}", aim); }

std::vector<ComparedDesigner> comparedDesigners(const AdaptiveOtfConfig& method, std::span<const double> aims) {
    std::vector<ComparedDesigner> all{{"x2", std::nullopt}};
    for (const Designer designer : allDesigners) {
        all.push_back({std::string(echolucent::nameOf(designer)), defaultConfigOf(designer)});
        if (designer != designerOf(AdaptiveConfig{}) || !std::holds_alternative<RampRule>(method.curve)) continue;
        for (const double aim : aims) all.push_back({nameOfAim(aim), all.back().config, aim});
    }
    return all;
}

DesignTimed timedDesign(const ComparedDesigner& designer, const DesignerInput& input, int repeats) {
    DesignTimed timed{designOnce(designer, input)};
    if (!designer.config) return timed;
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(repeats));
    for (int run = 0; run < repeats; ++run) times.push_back(millisecondsOf([&] { (void)designOnce(designer, input); }));
    timed.milliseconds = medianOf(std::move(times));
    return timed;
}

std::vector<DesignerRow> measureDesigners(const PhantomConfig& base, const DesignersSetting& setting) {
    std::vector<DesignerRow> rows;
    for (const NamedPhantom& condition : contrastConditions(base)) {
        const StudyPhantom phantom(condition.config);
        const Volume quiet = *quietVolume(phantom.volume, setting.reduction);
        std::vector<Classification> classifications;
        const std::size_t first = rows.size();
        for (const ComparedDesigner& designer : comparedDesigners(setting.method, endsOfAim)) {
            const DesignTimed made = timedDesign(
                designer, {phantom.volume, quiet, setting.reduction, setting.view, setting.method}, setting.repeats);
            classifications.push_back(made.design.classification);
            rows.push_back({designer.name, condition.name, base.seed, {}, made.milliseconds});
        }
        const auto surfaces = shownSurfacesOf(phantom.volume, quiet, setting.view, &phantom.truth, classifications);
        for (std::size_t i = 0; i < surfaces.size(); ++i) rows[first + i].surfaces = surfaces[i];
    }
    return rows;
}

std::vector<DesignerPicture> showDesigners(const DesignerCase& one, int repeats) {
    std::vector<DesignerPicture> pictures;
    std::vector<Classification> classifications;
    const RayCaster packed(one.shown);
    const DesignerInput input{*one.raw, *one.shown, one.reduction, one.view, one.method};
    for (const ComparedDesigner& designer : comparedDesigners(one.method, endsOfAim)) {
        DesignTimed made = timedDesign(designer, input, repeats);
        const Classification& classification = made.design.classification;
        RayCaster caster = packed.sharing();
        Picture picture = *caster.cast(classification, one.settings);
        const double castMilliseconds = castTime(caster, classification, one, repeats);
        classifications.push_back(classification);
        const PictureError error = errorOf(classification, one);
        pictures.push_back({designer.name, std::move(made), std::move(picture), castMilliseconds, error, {}});
    }
    const auto surfaces =
        shownSurfacesOf(*one.raw, *one.shown, one.view, one.truth ? &*one.truth : nullptr, classifications);
    for (std::size_t i = 0; i < pictures.size(); ++i) pictures[i].surfaces = surfaces[i];
    return pictures;
}

}  // namespace echolucent::cli
