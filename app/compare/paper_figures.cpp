#include "app/compare/paper_figures.h"

#include <QCoreApplication>
#include <array>
#include <utility>
#include <vector>

#include "processing/document/panes.h"
#include "widgets/compare/compare_panel.h"

namespace echolucent {

namespace {

/// Panes side by side, without the adjustment that would bend their curves.
Document sideBySide(Document document, const std::vector<Pane>& panes) {
    document.curves.adjustment = CurveAdjustment{};
    document = withPanes(std::move(document), panes);
    document.comparison.layout = ComparisonLayout::sideBySide;
    return document;
}

ManualCurve figure1Manual() { return {{{0.0, 0.0}, {1.0, 1.0}}}; }

std::vector<Pane> figure1Panes() {
    return {{.curve = CurveKind::manual}, {.curve = CurveKind::linear}, {.curve = CurveKind::adaptive}};
}

/// Whether the panes are those of figure 1 and nothing bends their curves.
bool isFigure1(const Document& document) {
    const CurveSet& curves = document.curves;
    return document.panes == figure1Panes() && curves.manual == figure1Manual() && curves.linear == LinearCurve{} &&
           curves.adjustment == CurveAdjustment{};
}

/// The paper's name for the curve of a pane of figure1Panes().
QString figure1Caption(std::size_t place) {
    constexpr std::array captions{QT_TRANSLATE_NOOP("compare", "(a) Linear OTF"),
                                  QT_TRANSLATE_NOOP("compare", "(b) Manually designed piecewise linear OTF"),
                                  QT_TRANSLATE_NOOP("compare", "(c) Adaptively designed OTF")};
    return QCoreApplication::translate("compare", captions.at(place));
}

}  // namespace

Document figure1(Document document) {
    document.curves.manual = figure1Manual();
    document.curves.linear = LinearCurve{};  // the paper's
    return sideBySide(std::move(document), figure1Panes());
}

QString captionOfPane(const Document& document, std::size_t place) {
    return isFigure1(document) ? figure1Caption(place) : nameOfPane(document.panes.at(place));
}

QStringList captionsOfPanes(const Document& document) {
    QStringList captions;
    for (std::size_t place = 0; place < document.panes.size(); ++place) captions << captionOfPane(document, place);
    return captions;
}

Document figure9(Document document) {
    document.motion.otf = MotionOtf::oneOtf;
    document.motion.scenario = MotionScenario::probe;
    return sideBySide(std::move(document), {{}, {.motionOtf = MotionOtf::eachView}});
}

Document motionSideBySide(Document document) {
    document.motion.otf = MotionOtf::oneOtf;
    document = withPanes(std::move(document),
                         {{}, {.motionOtf = MotionOtf::eachView}, {.motionOtf = MotionOtf::leastFlicker}});
    document.comparison.layout = ComparisonLayout::sideBySide;
    return document;
}

}  // namespace echolucent
