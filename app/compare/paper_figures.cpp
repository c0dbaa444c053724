#include "app/compare/paper_figures.h"

#include <QCoreApplication>
#include <utility>

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

}  // namespace

Document figure1(Document document) {
    document.curves.manual = ManualCurve{{{0.0, 0.0}, {1.0, 1.0}}};
    document.curves.linear = LinearCurve{};  // the paper's
    return sideBySide(std::move(document),
                      {{.curve = CurveKind::manual}, {.curve = CurveKind::linear}, {.curve = CurveKind::adaptive}});
}

QStringList captionsOfPanes(const Document& document) {
    // What setting the figure up again does not change is the figure.
    const Document figure = figure1(document);
    if (document.panes == figure.panes && document.curves == figure.curves)
        return {QCoreApplication::translate("compare", "(a) Linear OTF"),
                QCoreApplication::translate("compare", "(b) Manually designed piecewise linear OTF"),
                QCoreApplication::translate("compare", "(c) Adaptively designed OTF")};
    QStringList names;
    for (const Pane& pane : document.panes) names << nameOfPane(pane);
    return names;
}

QString captionOfPane(const Document& document, std::size_t place) {
    return captionsOfPanes(document).at(static_cast<qsizetype>(place));
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
