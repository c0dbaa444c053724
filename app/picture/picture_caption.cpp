#include "app/picture/picture_caption.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/otf/editor_otfs.h"
#include "processing/document/side_taking.h"
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

/// "onto the scan plane" if the pose looks along one of the six sides, whether a motion has turned the picture from
/// there, and whether that side was taken last time. Empty else, and until the sides are found.
QString sideLine(const CaptionFacts& facts) {
    const Scene& scene = facts.document.scene;
    if (facts.sides == nullptr) return {};
    const auto place = sideAlong(*facts.sides, facts.document.beam.axis, scene.pose.direction);
    if (!place) return {};
    QString name = textOf(facts.sides->sides[*place].side.name);
    name[0] = name[0].toLower();
    if (scene.motionAngle != 0.0) return captionText("%1, turned").arg(name);
    return place == facts.remembered ? captionText("%1, as last time").arg(name) : name;
}

QString frontLine(const Front& front, bool lengthsKnown) {
    if (!cuts(front)) return {};
    const QString what = front.surface  ? captionText("front, bowed")
                         : lengthsKnown ? captionText("front %1 mm").arg(front.depthMm, 0, 'f', 1)
                                        : captionText("front");
    return front.source == FrontSource::found ? captionText("%1, found").arg(what) : what;
}

QString speckleLine(SpeckleReduction reduction, ShownSpeckle shown) {
    if (reduction == SpeckleReduction::off) return {};
    switch (shown) {
        case ShownSpeckle::asRead: return captionText("not smoothed");
        case ShownSpeckle::beingReduced: return captionText("being smoothed");
        case ShownSpeckle::reduced: break;
    }
    return captionText("smoothed: %1").arg(textOf(nameOf(reduction)));
}

/// One line of the facts that are true.
QString lineOf(QStringList facts) {
    facts.removeAll(QString());
    return facts.join(QStringLiteral(" · "));
}

/// If a motion changes the phase, every frame has the line. Else it would vanish in the frame whose OTF it is.
QString otfLine(const Document& document) {
    const MotionChoice& motion = document.motion;
    if (motion.otf != MotionOtf::oneOtf || !needsComputedOtf(document, firstPane)) return {};
    if (!movesObject(motion.scenario) && motion.otfPhase == phaseOf(document, firstPane)) return {};
    return captionText("curve of volume %1").arg(motion.otfPhase + 1);
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
    QStringList lines{lineOf({sideLine(facts), frontLine(facts.document.scene.front, facts.lengthsKnown),
                              speckleLine(look.reduction, facts.speckle)}),
                      lineOf({reductionLine(facts.reduction), designLine(facts.document, facts.designIsShown),
                              facts.curveIsTold ? otfLine(facts.document) : QString(),
                              facts.curveIsTold && facts.curveOfAnotherView
                                  ? captionText("curve of another view (A computes it for this one)")
                                  : QString()})};
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

}  // namespace echolucent
