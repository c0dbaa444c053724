#include "widgets/otf_editor/curve_legend.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include "widgets/controls/panel_controls.h"
#include "widgets/otf_editor/curve_style.h"

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
    // The fifth kind leaves this place free.
    grid->addWidget(secondaryLabel(tr("○ render   □ show")), 2, 2, 1, 2);
    m_designActive = new QRadioButton;
    m_designActive->setObjectName("otfEditor.active.design");
    m_designVisible = new QCheckBox;
    m_designVisible->setObjectName("otfEditor.legend.design.visible");
    m_designVisible->setIconSize(curveSampleSize);
    connect(m_designVisible, &QCheckBox::toggled, this, [this](bool on) { m_model.setDesignVisible(on); });
    grid->addWidget(m_designActive, 3, 0, 1, 3, Qt::AlignLeft);
    grid->addWidget(m_designVisible, 3, 3, Qt::AlignLeft);
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
    m_designVisible->setIcon(designSample(themeOf(palette())));
}

void CurveLegend::showState() {
    const OtfEditorState& state = m_model.state();
    QRadioButton* rendered = state.designed ? m_designActive : m_active[indexOf(state.active)];
    rendered->setChecked(true);
    const QString designer = QString::fromStdString(state.designer);
    m_designActive->setText(designer);
    m_designActive->setAccessibleName(tr("The OTF of the designer %1 is rendered").arg(designer));
    m_designActive->setToolTip(tr("The OTF of the designer %1 is rendered. Any other choice leaves it").arg(designer));
    m_designVisible->setAccessibleName(tr("Show the upper curve of %1 in the plot").arg(designer));
    m_designVisible->setToolTip(tr("Show the largest opacity of each intensity in the plot"));
    m_designVisible->setChecked(state.designVisible);
    m_designActive->setVisible(state.designed);
    m_designVisible->setVisible(state.designed);
    for (const CurveKind kind : allCurveKinds) m_visible[indexOf(kind)]->setChecked(state.visible[indexOf(kind)]);
}

}  // namespace echolucent
