#include "app/compare/paper_figures.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "processing/adaptive/method_reading.h"
#include "processing/document/panes.h"
#include "processing/motion/motion_mode.h"
#include "widgets/compare/compare_panel.h"

namespace echolucent {

namespace {

/// The frames of figure 10: all of the motion, then the view in which it began.
std::vector<int> framesOfFigure10() {
    std::vector<int> frames(static_cast<std::size_t>(lastMotionAngle - firstMotionAngle) + 1);
    std::iota(frames.begin(), frames.end(), firstMotionAngle);
    frames.push_back(0);
    return frames;
}

std::vector<int> framesOfFigure11() {
    std::vector<int> frames(static_cast<std::size_t>(figure11Degrees) + 1);
    std::iota(frames.begin(), frames.end(), 0);
    return frames;
}

/// Everything that a figure sets, in one state; what belongs to the study stays.
Document begun(Document document) {
    document.scene.look = lookAtStart();
    document.scene.motionAngle = 0.0;
    document.curves.adjustment = CurveAdjustment{};
    document.method = MethodChoice{};
    document.motion = MotionChoice{};
    document.motion.otfPhase = document.scene.phase;
    document.comparison = Comparison{};
    document.panes = {Pane{}};
    return document;
}

std::vector<Pane> figure1Panes() {
    return {{.curve = CurveKind::linear, .linear = LinearCurve{.lower = 0.0, .slope = 1.0, .upper = 1.0}},
            {.curve = CurveKind::linear, .linear = LinearCurve{}},
            {.curve = CurveKind::adaptive}};
}

/// The paper's name for the curve of a pane of figure1Panes().
QString figure1Caption(std::size_t place) {
    constexpr std::array captions{QT_TRANSLATE_NOOP("compare", "(a) Linear OTF"),
                                  QT_TRANSLATE_NOOP("compare", "(b) Manually designed piecewise linear OTF"),
                                  QT_TRANSLATE_NOOP("compare", "(c) Adaptively designed OTF")};
    return QCoreApplication::translate("compare", captions.at(place));
}

/// Figure 6 draws its three curves as the paper does: the initial one dotted, the adaptive one solid, the other dashed.
Document figure6(Document document) {
    document.method.config = configOf(MethodReading::asPublished);
    document.curves.parabolic = CurveSet{}.parabolic;
    document.panes = {Pane{.linear = LinearCurve{}}};
    return document;
}

Document figure9(Document document) {
    document.scene.motionAngle = figure9Degrees;
    return withPanes(std::move(document), {{}, {.motionOtf = MotionOtf::eachView}});
}

Document figure11(Document document) {
    document.scene.motionAngle = figure11Degrees;
    document.motion.otf = MotionOtf::mean;
    return withPanes(std::move(document), {{}, {.motionOtf = MotionOtf::eachView}});
}

}  // namespace

std::span<const PaperFigure> paperFigures() {
    static const std::array figures{
        PaperFigure{1, QT_TRANSLATE_NOOP("compare", "linear, piecewise linear, adaptive OTF")},
        PaperFigure{5, QT_TRANSLATE_NOOP("compare", "basis functions"), "dock.tubeCores"},
        PaperFigure{6, QT_TRANSLATE_NOOP("compare", "initial, adaptive, piecewise linear curve"), "dock.otfEditor"},
        PaperFigure{9, QT_TRANSLATE_NOOP("compare", "one OTF, or each view's")},
        PaperFigure{10, QT_TRANSLATE_NOOP("compare", "the OTF over the angle"), "dock.motionMap", framesOfFigure10()},
        PaperFigure{11, QT_TRANSLATE_NOOP("compare", "smoothed over time, or not"), "dock.motionMap",
                    framesOfFigure11()}};
    return figures;
}

const PaperFigure& paperFigure(int number) {
    const auto found = std::ranges::find(paperFigures(), number, &PaperFigure::number);
    if (found == paperFigures().end()) throw std::invalid_argument("paperFigure: no figure has this number");
    return *found;
}

QString subjectOf(const PaperFigure& figure) { return QCoreApplication::translate("compare", figure.subject); }

Document withFigure(Document document, int number) {
    document = begun(std::move(document));
    switch (paperFigure(number).number) {
        case 1: return withPanes(std::move(document), figure1Panes());
        case 5: document.method.config = configOf(MethodReading::asPublished); return document;
        case 6: return figure6(std::move(document));
        case 9: return figure9(std::move(document));
        case 10: document.motion.otf = MotionOtf::eachView; return document;
        default: return figure11(std::move(document));
    }
}

QString captionOfPane(const Document& document, std::size_t place) {
    const bool isFigure1 = document.panes == figure1Panes() && document.curves.adjustment == CurveAdjustment{};
    if (isFigure1) return figure1Caption(place);
    // If another pane sets its own OTF in the motion, the choice of the motion bar is one of those that are compared.
    Pane named = document.panes.at(place);
    const bool compared =
        std::ranges::any_of(document.panes, [](const Pane& pane) { return pane.motionOtf.has_value(); });
    if (compared && !named.designer && named.curve == CurveKind::adaptive && !named.motionOtf)
        named.motionOtf = document.motion.otf;
    return nameOfPane(named);
}

QStringList captionsOfPanes(const Document& document) {
    QStringList captions;
    for (std::size_t place = 0; place < document.panes.size(); ++place) captions << captionOfPane(document, place);
    return captions;
}

Document motionSideBySide(Document document) {
    document.motion.otf = MotionOtf::oneOtf;
    document = withPanes(std::move(document),
                         {{}, {.motionOtf = MotionOtf::eachView}, {.motionOtf = MotionOtf::leastFlicker}});
    document.comparison.layout = ComparisonLayout::sideBySide;
    return document;
}

}  // namespace echolucent
