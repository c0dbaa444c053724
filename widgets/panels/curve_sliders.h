// Threshold and transparency: two sliders that move the curve that is rendered.
#pragma once

#include <QWidget>

#include "widgets/controls/parameter_controls.h"
#include "widgets/document/document_model.h"

namespace echolucent {

/// Shows and edits the document's CurveAdjustment. Objects: view.threshold (+ .value), view.transparency (+ .value),
/// view.resetCurve.
class CurveSliders : public QWidget {
    Q_OBJECT

public:
    /// The document outlives the sliders.
    explicit CurveSliders(DocumentModel& document, QWidget* parent = nullptr);

signals:
    /// The person wants the curve as it is without these sliders, and unedited.
    void resetRequested();

private:
    ParameterControls<CurveAdjustment> m_controls;
};

}  // namespace echolucent
