#include "app/picture/curve_controls.h"

#include <QAction>

namespace echolucent {

CurveControls::CurveControls(DocumentModel& model, HandGesture& hand, CurveSliders& sliders, OtfEditor& editor,
                             QObject* parent)
    : QObject(parent) {
    connect(&sliders, &CurveSliders::adjustmentChanged, this,
            [&model, &hand](const CurveAdjustment& adjustment, const QString& what) {
                Document next = model.document();
                next.curves.adjustment = adjustment;
                model.edit(next, what, hand.current());
            });
    connect(&sliders, &CurveSliders::resetRequested, editor.resetAction(), &QAction::trigger);
    const auto show = [&model, &sliders] { sliders.setAdjustment(model.document().curves.adjustment); };
    connect(&model, &DocumentModel::curvesChanged, this, show);
    show();
}

}  // namespace echolucent
