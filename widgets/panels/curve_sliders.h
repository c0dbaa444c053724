// The aim of the adaptive curve, and threshold and transparency, which move the curve that is rendered.
#pragma once

#include <QWidget>

#include "processing/volume/value_scale.h"
#include "widgets/document/document_model.h"

class QGridLayout;

namespace echolucent {

class ValueSlider;

/// Shows and edits RampRule::aim of the document's method and the document's CurveAdjustment, in percent. The aim can
/// be set if it moves a picture on the screen: the 3D view or, in a comparison, any pane shows the adaptive curve, and
/// the method's form is the ramp. Objects: view.aim (+ .value, .reset), view.threshold (+ .value), view.transparency
/// (+ .value), view.resetCurve.
class CurveSliders : public QWidget {
    Q_OBJECT

public:
    /// The document outlives the sliders.
    explicit CurveSliders(DocumentModel& document, QWidget* parent = nullptr);

    /// The file's values, by which the tool tip says how far the threshold moves the curve.
    void setValueWindow(const ValueWindow& window);
    /// Whether all panes of the document are on the screen, or the 3D view alone [the 3D view].
    void setComparing(bool comparing);

signals:
    /// The person wants the curve as it is without these sliders, and unedited.
    void resetRequested();

private:
    void addAim(QGridLayout& grid);
    void showAim();
    void showThreshold();

    DocumentModel& m_document;
    bool m_comparing = false;
    ValueSlider* m_aim = nullptr;
    ValueSlider* m_threshold = nullptr;
    double m_shownThreshold = 0.0;  ///< CurveAdjustment::threshold of the document
    ValueWindow m_values;
    QString m_meaning;  // of the threshold
};

}  // namespace echolucent
