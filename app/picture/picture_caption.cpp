#include "app/picture/picture_caption.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/otf/shown_design.h"
#include "processing/document/view_caster.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {

namespace {

QString captionText(const char* text) { return QCoreApplication::translate("caption", text); }

QString reductionLine(const std::optional<Reduction>& reduction) {
    if (!reduction) return {};
    return captionText("reduced %1: fine detail is averaged")
        .arg(textOf(factorsText(*reduction)).replace('x', QChar(0x00d7)));
}

QString beamLine(const Beam& beam, bool simulated) {
    const QString axis = textOf(nameOf(beam.axis));
    if (simulated) return captionText("beam %1").arg(axis);
    switch (beam.source) {
        case BeamSource::assumed: return captionText("beam %1, assumed").arg(axis);
        case BeamSource::sectorShape: return captionText("beam %1, from the shape of the sector").arg(axis);
        case BeamSource::echo: return captionText("beam %1, from the echo").arg(axis);
        case BeamSource::file: return captionText("beam %1, seen from the probe as the file says").arg(axis);
        case BeamSource::person: break;
    }
    return captionText("beam %1").arg(axis);
}

QString cutLine(const Cut& cut, bool lengthsKnown) {
    if (!cut.surface && !(cut.nearCutMm > 0)) return {};
    const QString what = cut.surface    ? captionText("cut along a curved surface")
                         : lengthsKnown ? captionText("cut at %1 mm").arg(cut.nearCutMm, 0, 'f', 1)
                                        : captionText("cut");
    return cut.source == CutSource::found ? captionText("%1, found on opening (N takes it back)").arg(what) : what;
}

QString speckleLine(SpeckleReduction reduction, ShownSpeckle shown) {
    if (reduction == SpeckleReduction::off) return {};
    switch (shown) {
        case ShownSpeckle::asRead: return captionText("speckle not reduced");
        case ShownSpeckle::beingReduced: return captionText("speckle is being reduced");
        case ShownSpeckle::reduced: break;
    }
    return captionText("speckle reduced: %1").arg(textOf(nameOf(reduction)));
}

QString lightLine(const Look& look) {
    if (look.mode != RenderMode::direct || look.lighting == Lighting::flat) return {};
    return look.lighting == Lighting::depth ? captionText("light tells depth") : captionText("light on surfaces");
}

/// Where the phases move the line stands in every frame: else it would go for the one whose OTF it is.
QString otfLine(const Document& document, int view) {
    const MotionChoice& motion = document.motion;
    if (motion.otf != MotionOtf::oneOtf || !needsComputedOtf(document, view)) return {};
    if (!movesObject(motion.scenario) && motion.otfPhase == phaseOf(document, view)) return {};
    return captionText("OTF of phase %1").arg(motion.otfPhase + 1);
}

QString designLine(const Document& document, int view, bool isShown) {
    const DesignerConfig* config = designOf(document, view);
    if (config == nullptr || lookOf(document, view).mode != RenderMode::direct) return {};
    return (isShown ? captionText("OTF: %1") : captionText("OTF: %1 is not computed yet")).arg(labelOf(*config));
}

}  // namespace

bool curveIsOfAnotherView(const Document& document, int view, const AdaptiveOtf* otf) {
    if (designOf(document, view) != nullptr)
        return curveIsOfAnotherView(document, view, otfViewpointOf(document, view));
    return otf != nullptr && curveIsOfAnotherView(document, view, otf->view);
}

bool curveIsOfAnotherView(const Document& document, int view, const Viewpoint& ofOtf) {
    if (document.motionAngle != 0.0) return false;
    if (lookOf(document, view).mode != RenderMode::direct) return false;
    const DesignerConfig* config = designOf(document, view);
    if (config != nullptr ? !readsTubeCores(*config) : viewOf(document, view).curve != CurveKind::adaptive)
        return false;
    return directionOf(ofOtf) != poseOf(document, view).direction;
}

QString pictureCaption(const CaptionFacts& facts) {
    const Look& look = lookOf(facts.document, facts.view);
    QStringList lines{
        reductionLine(facts.reduction),
        beamLine(facts.document.beam, std::holds_alternative<SimulatedScan>(facts.document.study)),
        cutLine(cutOf(facts.document, facts.view), facts.lengthsKnown),
        speckleLine(look.reduction, facts.speckle),
        lightLine(look),
        designLine(facts.document, facts.view, facts.designIsShown),
        otfLine(facts.document, facts.view),
        facts.curveOfAnotherView ? captionText("curve of another view (A computes it for this one)") : QString()};
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

}  // namespace echolucent
