#include "widgets/otf_editor/parameter_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "widgets/controls/panel_controls.h"
#include "widgets/otf_editor/curve_style.h"

namespace echolucent {

namespace {

constexpr double maxSlope = 255.0;  // opacity rises from 0 to 1 between two neighbouring 8-bit values
constexpr double maxScale = 100.0;

ParameterSpinBox* spinBox(OtfEditorModel& model, const QString& objectName, const QString& name, double maximum) {
    auto* box = new ParameterSpinBox(model);
    box->setObjectName(objectName);
    box->setAccessibleName(name);
    box->setRange(0.0, maximum);
    return box;
}

QLabel* formula(const QString& richText) {
    QLabel* label = secondaryLabel(richText);
    label->setTextFormat(Qt::RichText);
    label->setWordWrap(true);
    return label;
}

}  // namespace

LinearParameters::LinearParameters(OtfEditorModel& model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_lower(spinBox(model, "otfEditor.linear.lower", tr("Lower bound of the piecewise linear curve"), 1.0)),
      m_slope(spinBox(model, "otfEditor.linear.slope", tr("Slope of the piecewise linear curve"), maxSlope)),
      m_upper(spinBox(model, "otfEditor.linear.upper", tr("Upper bound of the piecewise linear curve"), 1.0)) {
    m_lower->setToolTip(tr("Intensity below which all is clear"));
    m_slope->setToolTip(tr("Opacity gained for each unit of intensity between the bounds"));
    m_upper->setToolTip(tr("Intensity above which opacity no longer rises"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(4);
    int row = 0;
    for (const auto& [box, text] :
         {std::pair{m_lower, tr("Lower, L<sub>L</sub>")}, std::pair{m_slope, tr("Slope, <i>a</i>")},
          std::pair{m_upper, tr("Upper, L<sub>H</sub>")}}) {
        auto* label = new QLabel(text);
        label->setBuddy(box);
        grid->addWidget(label, row, 0);
        grid->addWidget(box, row++, 1);
    }
    grid->setColumnStretch(2, 1);
    grid->addWidget(formula(tr("Eq. 1: 0 below L<sub>L</sub>, <i>a</i> (<i>x</i> − L<sub>L</sub>) up to L<sub>H</sub>, "
                               "then constant")),
                    row, 0, 1, 3);
    grid->setRowStretch(row + 1, 1);
    connect(m_lower, &ParameterSpinBox::edited, this, [this](double value, OtfEditorModel::Gesture gesture) {
        LinearCurve curve = m_model.state().linear;
        curve.lower = value;
        m_model.setLinear(curve, gesture);
        showState();
    });
    connect(m_slope, &ParameterSpinBox::edited, this, [this](double value, OtfEditorModel::Gesture gesture) {
        LinearCurve curve = m_model.state().linear;
        curve.slope = value;
        m_model.setLinear(curve, gesture);
        showState();
    });
    connect(m_upper, &ParameterSpinBox::edited, this, [this](double value, OtfEditorModel::Gesture gesture) {
        LinearCurve curve = m_model.state().linear;
        curve.upper = value;
        m_model.setLinear(curve, gesture);
        showState();
    });
    connect(&m_model, &OtfEditorModel::changed, this, &LinearParameters::showState);
    showState();
}

void LinearParameters::showState() {
    const LinearCurve& curve = m_model.state().linear;
    m_lower->show(curve.lower, 0.0, curve.upper);
    m_slope->show(curve.slope, 0.0, maxSlope);
    m_upper->show(curve.upper, curve.lower, 1.0);
}

PowerParameters::PowerParameters(OtfEditorModel& model, CurveKind kind, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_kind(kind),
      m_scale(spinBox(model, "otfEditor." + curveKey(kind) + ".scale", tr("Scale of the %1 curve").arg(curveName(kind)),
                      maxScale)) {
    m_scale->setToolTip(tr("Opacity at full intensity, before it is cut at 1"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    auto* label = new QLabel(tr("Scale, <i>a</i>"));
    label->setBuddy(m_scale);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_scale, 1, 0);
    const int exponent = kind == CurveKind::parabolic ? 2 : 4;
    grid->addWidget(formula(tr("<i>a</i> <i>x</i><sup>%1</sup>, at most 1").arg(exponent)), 2, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(3, 1);
    connect(m_scale, &ParameterSpinBox::edited, this, [this](double value, OtfEditorModel::Gesture gesture) {
        m_model.setScale(m_kind, value, gesture);
        showState();
    });
    connect(&m_model, &OtfEditorModel::changed, this, &PowerParameters::showState);
    showState();
}

void PowerParameters::showState() {
    const OtfEditorState& state = m_model.state();
    m_scale->show(m_kind == CurveKind::parabolic ? state.parabolic.scale : state.quartic.scale, 0.0, maxScale);
}

}  // namespace echolucent
