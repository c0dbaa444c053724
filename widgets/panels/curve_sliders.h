// Threshold and transparency: two sliders that move whichever curve is rendered.
#pragma once

#include <QWidget>

#include "processing/document/curve_adjustment.h"

class QPushButton;

namespace echolucent {

class ValueSlider;

/// Objects: view.threshold (+ .value), view.transparency (+ .value), view.resetCurve. No setter emits a signal.
class CurveSliders : public QWidget {
    Q_OBJECT

public:
    explicit CurveSliders(QWidget* parent = nullptr);

    void setAdjustment(const CurveAdjustment& adjustment);

signals:
    void adjustmentChanged(const echolucent::CurveAdjustment& adjustment, const QString& what);
    /// The person wants the curve as it is without these sliders, and unedited.
    void resetRequested();

private:
    CurveAdjustment m_adjustment;
    ValueSlider* m_threshold = nullptr;
    ValueSlider* m_transparency = nullptr;
};

}  // namespace echolucent
