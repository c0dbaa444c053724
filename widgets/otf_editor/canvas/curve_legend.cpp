#include "widgets/otf_editor/canvas/curve_legend.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include "widgets/otf_editor/canvas/curve_style.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {

namespace {
constexpr int kindsInARow = 2;  // so that the legend fits a narrow column
}

CurveLegend::CurveLegend(OtfEditorModel& model, QWidget* parent) : QWidget(parent), m_model(model) {
    setObjectName("otfEditor.legend");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    for (const CurveKind kind : allCurveKinds) {
        const int place = static_cast<int>(indexOf(kind));
        const int row = place / kindsInARow;
        const int column = 2 * (place % kindsInARow);
        auto* active = new QRadioButton(curveShortName(kind));
        active->setObjectName("otfEditor.active." + curveKey(kind));
        active->setAccessibleName(tr("Render the %1 curve").arg(curveName(kind)));
        active->setToolTip(tr("Render the %1 curve (%2)").arg(curveName(kind)).arg(place + 1));
        connect(active, &QRadioButton::clicked, this, [this, kind] { m_model.setActive(kind); });
        grid->addWidget(active, row, column, Qt::AlignLeft);
        auto* visible = new QCheckBox;
        visible->setObjectName("otfEditor.legend." + curveKey(kind) + ".visible");
        visible->setAccessibleName(tr("Show the %1 curve in the plot").arg(curveName(kind)));
        visible->setToolTip(visible->accessibleName());
        visible->setIconSize(curveSampleSize);
        connect(visible, &QCheckBox::toggled, this, [this, kind](bool on) { m_model.setVisible(kind, on); });
        grid->addWidget(visible, row, column + 1, Qt::AlignLeft);
        m_active[indexOf(kind)] = active;
        m_visible[indexOf(kind)] = visible;
    }
    // In the place that the fifth kind leaves free.
    grid->addWidget(secondaryLabel(tr("○ render   □ show")), 2, 2, 1, 2);
    for (const int visibleColumn : {1, 3}) grid->setColumnStretch(visibleColumn, 1);
    connect(&m_model, &OtfEditorModel::changed, this, &CurveLegend::showState);
    showState();
    showSamples();
}

void CurveLegend::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) showSamples();
    QWidget::changeEvent(event);
}

void CurveLegend::showSamples() {
    for (const CurveKind kind : allCurveKinds) m_visible[indexOf(kind)]->setIcon(curveSample(kind, themeOf(palette())));
}

void CurveLegend::showState() {
    const OtfEditorState& state = m_model.state();
    m_active[indexOf(state.active)]->setChecked(true);
    for (const CurveKind kind : allCurveKinds) m_visible[indexOf(kind)]->setChecked(state.visible[indexOf(kind)]);
}

}  // namespace echolucent
