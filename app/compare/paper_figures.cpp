#include "app/compare/paper_figures.h"

#include <utility>

#include "processing/document/panes.h"

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
