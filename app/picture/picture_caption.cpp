#include "app/picture/picture_caption.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/otf/editor_otfs.h"
#include "processing/pane_picture/pane_caster.h"
#include "widgets/controls/panel_controls.h"

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

QString cutLine(const Front& cut, bool lengthsKnown) {
    if (!cut.surface && !(cut.depthMm > 0)) return {};
    const QString what = cut.surface    ? captionText("cut along a curved surface")
                         : lengthsKnown ? captionText("cut at %1 mm").arg(cut.depthMm, 0, 'f', 1)
                                        : captionText("cut");
    return cut.source == FrontSource::found ? captionText("%1, found on opening (N takes it back)").arg(what) : what;
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

/// If a motion changes the phase, every frame has the line. Else it would vanish in the frame whose OTF it is.
QString otfLine(const Document& document) {
    const MotionChoice& motion = document.motion;
    if (motion.otf != MotionOtf::oneOtf || !needsComputedOtf(document, firstPane)) return {};
    if (!movesObject(motion.scenario) && motion.otfPhase == phaseOf(document, firstPane)) return {};
    return captionText("OTF of phase %1").arg(motion.otfPhase + 1);
}

QString designLine(const Document& document, bool isShown) {
    const DesignerConfig* config = designerConfigOf(document, firstPane);
    if (config == nullptr || document.scene.look.mode != RenderMode::direct) return {};
    return (isShown ? captionText("OTF: %1") : captionText("OTF: %1 is not computed yet")).arg(labelOf(*config));
}

}  // namespace

bool curveIsOfAnotherView(const Document& document, const AdaptiveOtf* otf) {
    if (designerConfigOf(document, firstPane) != nullptr)
        return curveIsOfAnotherView(document, otfViewpointOf(document, firstPane));
    return otf != nullptr && curveIsOfAnotherView(document, otf->view);
}

bool curveIsOfAnotherView(const Document& document, const Viewpoint& ofOtf) {
    if (document.scene.motionAngle != 0.0) return false;
    if (document.scene.look.mode != RenderMode::direct) return false;
    const DesignerConfig* config = designerConfigOf(document, firstPane);
    if (config != nullptr ? !readsTubeCores(*config) : document.panes.at(firstPane).curve != CurveKind::adaptive)
        return false;
    return directionOf(ofOtf) != document.scene.pose.direction;
}

QString pictureCaption(const CaptionFacts& facts) {
    const Look& look = facts.document.scene.look;
    QStringList lines{
        reductionLine(facts.reduction),
        beamLine(facts.document.beam, std::holds_alternative<SimulatedScan>(facts.document.study)),
        cutLine(facts.document.scene.front, facts.lengthsKnown),
        speckleLine(look.reduction, facts.speckle),
        lightLine(look),
        designLine(facts.document, facts.designIsShown),
        otfLine(facts.document),
        facts.curveOfAnotherView ? captionText("curve of another view (A computes it for this one)") : QString()};
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

}  // namespace echolucent
