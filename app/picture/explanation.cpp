#include "app/picture/explanation.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "app/otf/editor_otfs.h"
#include "processing/designers/adaptive_words.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

QString explanationText(const char* text) { return QCoreApplication::translate("explanation", text); }

/// The designer's words on the picture's OTF. While the OTF that the document asks for is computed, the picture's OTF
/// is the one before it.
QStringList designSentences(const PictureFacts& facts, const DesignerConfig& config) {
    const QString follows = explanationText("What is seen and what is clear follows from the OTF of the designer %1.");
    if (facts.design == nullptr)
        return {explanationText("The OTF of %1 is not computed yet: the picture shows what it had before.")
                    .arg(labelOf(config))};
    const QString designer = labelOf(facts.design->asked.config);
    QStringList sentences{follows.arg(designer)};
    if (facts.design->asked.config.index() != config.index())
        sentences << explanationText("The OTF of %1 is not computed yet.").arg(labelOf(config));
    else if (!facts.designIsNewest)
        sentences << explanationText("It was made before the newest change, whose OTF is not there yet.");
    const Design& design = facts.design->design;
    QStringList said{QString::fromStdString(design.message)};
    for (const std::string& sentence : design.explanation) said << QString::fromStdString(sentence);
    said.removeAll(QString());
    if (!said.isEmpty()) sentences << explanationText("%1: %2").arg(designer, said.join(QLatin1Char(' ')));
    return sentences;
}

/// Eq. 1 with its numbers.
QString linearSentence(const CurveSet& curves) {
    const LinearCurve& curve = curves.linear;
    const auto hundredths = [](double value) { return QString::number(std::round(value * 100.0) / 100.0); };
    QString sentence = explanationText(
                           "A piecewise linear OTF (eq. 1): opacity is 0 up to an intensity of %1 (L_L), rises from "
                           "there by %2 (a) for "
                           "each unit of intensity up to %3 (L_H), and stays at %4 above.")
                           .arg(hundredths(curve.lower), hundredths(curve.slope), hundredths(curve.upper),
                                hundredths(opacityAt(curve, curve.upper)));
    sentence += QLatin1Char(' ') + explanationText("α(x) = a (x − L_L) between the two.");
    if (curves.adjustment != CurveAdjustment{})
        sentence += QLatin1Char(' ') + explanationText("The sliders threshold and transparency move it.");
    return sentence;
}

QString curveSentence(const PictureFacts& facts) {
    const CurveSet curves = curvesOf(facts.document, facts.pane);
    const auto scaled = [](double scale, const QString& power) {
        return scale == 1.0 ? power : QStringLiteral("%1 %2").arg(scale).arg(power);
    };
    switch (facts.document.panes.at(facts.pane).curve) {
        case CurveKind::adaptive:
            return explanationText(
                "What is seen and what is clear follows from the adaptive opacity transfer function (OTF), which was "
                "computed from this volume.");
        case CurveKind::manual:
            return explanationText(
                "What is seen and what is clear follows from the OTF drawn by hand. Between two nodes α(x) is linear.");
        case CurveKind::linear: return linearSentence(curves);
        case CurveKind::parabolic:
            return explanationText("A parabolic OTF: opacity grows with the square of the intensity, α(x) = %1.")
                .arg(scaled(curves.parabolic.scale, QStringLiteral("x²")));
        case CurveKind::quartic:
            return explanationText("A quartic OTF: opacity grows with the fourth power of the intensity, α(x) = %1.")
                .arg(scaled(curves.quartic.scale, QStringLiteral("x⁴")));
    }
    return {};
}

/// The paper's equations of the curve that tube cores made.
QString equationsOf(const AdaptiveOtf& otf) {
    const QString weights = explanationText(
        "The weight of a tube core is d = d_max w_I w_S (eq. 11). w_I is its rank by the largest mean before the "
        "surface "
        "(eqs. 8 and 9), w_S its rank by the slope at it (eq. 10).");
    if (std::holds_alternative<ProductRule>(otf.config.curve))
        return explanationText(
                   "α(x) is the initial function times the product of all f_t(x) (eq. 4). f_t(x) = (1 + d_t)^g_t(x) "
                   "(eq. 7): g_t is −1 at the intensity I_L before the surface and 1 at I_H on it (eqs. 5 and 6).") +
               QLatin1Char(' ') + weights;
    return explanationText("The mean of ramps, each counted by its d_t, stands in the place of the product of eq. 4.") +
           QLatin1Char(' ') + weights;
}

/// What the method found, how, and what it made of it.
QString methodSentences(const AdaptiveOtf& otf) {
    const bool made = tubeCoresMadeTheCurve(otf);
    QStringList sentences{QString::fromStdString(made ? surfaceSentence(otf) : otf.message),
                          QString::fromStdString(readingSentence(otf)),
                          QString::fromStdString(detectionSentence(otf.config))};
    if (otf.lengthsHalved)
        sentences << explanationText(
            "The volume has few voxels, so all lengths along the tube cores are half of what was set.");
    if (made) sentences << QString::fromStdString(curveSentence(otf)) << equationsOf(otf);
    sentences << QString::fromStdString(voxelsSentence(otf));
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char(' '));
}

QString motionSentence(const MotionChoice& motion, std::size_t phases) {
    switch (motion.otf) {
        case MotionOtf::oneOtf:
            return phases < 2 ? explanationText("In a motion this one OTF serves every frame.")
                              : explanationText("In a motion the OTF of volume %1 serves every frame.")
                                    .arg(motion.otfPhase + 1);
        case MotionOtf::eachView:
            return explanationText("In a motion every frame has an OTF of its own, not smoothed over time.");
        case MotionOtf::mean:
            return explanationText(
                "In a motion every frame gets an OTF of its own, and the mean of the newest five is shown.");
        case MotionOtf::movingLeastSquares:
            return explanationText(
                "In a motion every frame gets an OTF of its own, and what is shown is a polynomial of order two "
                "through the newest five (moving least squares).");
        case MotionOtf::leastFlicker:
            return explanationText(
                "In a motion every frame gets an OTF of its own, and these are smoothed over time with the weights "
                "that flicker least for their delay.");
    }
    return {};
}

QString lightSentence(const LightDirection& light) {
    return explanationText("Light from %1° to the %2 and %3° %4 shows the shape of surfaces.")
        .arg(std::abs(light.azimuthDegrees), 0, 'f', 0)
        .arg(light.azimuthDegrees < 0 ? explanationText("left") : explanationText("right"))
        .arg(std::abs(light.elevationDegrees), 0, 'f', 0)
        .arg(light.elevationDegrees < 0 ? explanationText("below") : explanationText("above"));
}

/// Of direct rendering: the effect of light, speckle and depth.
QStringList lookSentences(const PictureFacts& facts) {
    const Look& look = facts.document.scene.look;
    if (look.mode != RenderMode::direct) return {};
    QStringList sentences;
    if (look.lighting != Lighting::flat) sentences << lightSentence(look.light);
    if (look.lighting == Lighting::depth && look.reaching.shadow > 0)
        sentences << explanationText(
            "It falls only as far as it reaches through the tissue before it: hollows are dark, and what "
            "stands in front casts shadows.");
    if (look.reduction != SpeckleReduction::off && facts.speckle == ShownSpeckle::reduced)
        sentences << explanationText("Speckle was reduced (%1) in the voxels of the picture.")
                         .arg(textOf(nameOf(look.reduction)));
    if (look.depthColoured) sentences << explanationText("What is near is tinted warm, what is far blue.");
    return sentences;
}

/// The view and the front.
QStringList viewSentences(const PictureFacts& facts) {
    const Viewpoint shown = viewpointOf(facts.document);
    QStringList sentences;
    if (std::holds_alternative<SimulatedScan>(facts.document.study))
        sentences << explanationText("This is a simulated scan, not a patient.");
    const auto degrees = [](double angle) { return QString::number(std::round(angle) + 0.0, 'f', 0); };
    sentences << explanationText(
                     "The volume is looked at along its %1 axis, turned by %2° of azimuth and %3° of elevation.")
                     .arg(textOf(nameOf(shown.beamAxis)), degrees(shown.azimuthDegrees),
                          degrees(shown.elevationDegrees));
    if (std::round(shown.rollDegrees) != 0.0)
        sentences << explanationText("The picture is rolled by %1°.").arg(degrees(shown.rollDegrees));
    const Front& front = facts.document.scene.front;
    if (front.surface)
        sentences << explanationText("A bowed front cuts away what lies before it; the tube cores begin there too.");
    else if (cuts(front))
        sentences << explanationText(
                         "A front %1 mm deep cuts away what lies before it; the tube cores begin there too.")
                         .arg(front.depthMm, 0, 'f', 1);
    if (cuts(front)) sentences << explanationText("It stays in the body while the view turns.");
    return sentences;
}

/// What is known of the voxels, or is not.
QStringList dataSentences(const PictureFacts& facts) {
    QStringList sentences;
    if (!facts.volume.dataMask().empty())
        sentences << explanationText("Voxels outside the scanned sector hold no data and are left out.");
    if (!facts.volume.geometry().spacingKnown)
        sentences << explanationText("The spacing of the voxels is unknown, so proportions may be wrong.");
    if (const auto& reduction = facts.volume.geometry().reduction)
        sentences
            << explanationText(
                   "The file holds more voxels than are shown: each is the mean of %1, which averages fine detail.")
                   .arg(textOf(factorsText(*reduction)));
    if (facts.study.lossyCompression == LossyCompression::yes)
        sentences << explanationText("The data were compressed with loss, which changes intensities.");
    return sentences;
}

}  // namespace

/// What each mode shows of the volume; in direct rendering, the curve.
QStringList explainOtf(const PictureFacts& facts) {
    const Look& look = facts.document.scene.look;
    switch (look.mode) {
        case RenderMode::direct: break;
        case RenderMode::maximum:
            return {explanationText("Each pixel shows the brightest echo behind it; the OTF plays no part.")};
        case RenderMode::minimum:
            return {explanationText("Each pixel shows the darkest echo behind it; the OTF plays no part.")};
        case RenderMode::mean:
            return {explanationText(
                "Each pixel shows the mean of all echoes behind it, as an x-ray would; the OTF plays no part.")};
    }
    const Pane& pane = facts.document.panes.at(facts.pane);
    const DesignerConfig* config = designerConfigOf(facts.document, facts.pane);
    QStringList sentences = config != nullptr ? designSentences(facts, *config) : QStringList{curveSentence(facts)};
    if (config == nullptr && facts.otf != nullptr && pane.curve == CurveKind::adaptive) {
        MotionChoice motion = facts.document.motion;
        motion.otf = pane.motionOtf.value_or(motion.otf);
        sentences << methodSentences(*facts.otf) << motionSentence(motion, facts.study.phases.size());
    }
    if (facts.pane == firstPane && curveIsOfAnotherView(facts.document, facts.otf))
        sentences << explanationText(
            "The curve was computed for another view than this one: A computes it for this one.");
    if (pane.phase) sentences << explanationText("This pane shows volume %1.").arg(*pane.phase + 1);
    sentences << explanationText("Along each ray light and opacity are composited front to back (eqs. 2 and 3).");
    return sentences;
}

QStringList explainView(const PictureFacts& facts) {
    return viewSentences(facts) + lookSentences(facts) + dataSentences(facts);
}

QString explainPicture(const PictureFacts& facts) {
    QStringList sentences = viewSentences(facts);
    if (!facts.name.isEmpty()) sentences.prepend(explanationText("Pane %1").arg(facts.name));
    sentences << explainOtf(facts) << lookSentences(facts) << dataSentences(facts)
              << explanationText("Not a medical device.");
    return sentences.join(QStringLiteral("\n\n"));
}

}  // namespace echolucent
