// The numbers of the linear, parabolic and quartic curves.
#pragma once

#include <QWidget>

#include "widgets/otf_editor/parameter_spin_box.h"

namespace echolucent {

/// The piecewise linear curve's lower bound L_L, slope a and upper bound L_H (Petersch 2005, eq. 1).
class LinearParameters : public QWidget {
    Q_OBJECT

public:
    explicit LinearParameters(OtfEditorModel& model, QWidget* parent = nullptr);

private:
    void showState();

    OtfEditorModel& m_model;
    ParameterSpinBox* m_lower;
    ParameterSpinBox* m_slope;
    ParameterSpinBox* m_upper;
};

/// The scale a of a x^2 or a x^4.
class PowerParameters : public QWidget {
    Q_OBJECT

public:
    /// `kind` is parabolic or quartic.
    PowerParameters(OtfEditorModel& model, CurveKind kind, QWidget* parent = nullptr);

private:
    void showState();

    OtfEditorModel& m_model;
    CurveKind m_kind;
    ParameterSpinBox* m_scale;
};

}  // namespace echolucent
