#include "widgets/otf_editor/editor_tool_row.h"

#include <QAction>
#include <QCheckBox>
#include <QMenu>
#include <QToolButton>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

QToolButton* buttonFor(QAction* action, const QString& objectName, Qt::ToolButtonStyle style) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setObjectName(objectName);
    button->setAccessibleName(action->text().remove('&'));
    button->setToolButtonStyle(style);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

EditorToolRow::EditorToolRow(const Tools& tools) : FlowLayout(4) {
    addWidget(buttonFor(tools.undo, "otfEditor.undo", Qt::ToolButtonIconOnly));
    addWidget(buttonFor(tools.redo, "otfEditor.redo", Qt::ToolButtonIconOnly));
    addWidget(buttonFor(tools.reset, "otfEditor.reset", Qt::ToolButtonTextOnly));
    auto* presets = named(new QToolButton, "otfEditor.presets", tr("Curves that the manual curve begins with"),
                          tr("Begins the manual curve with one of these"));
    presets->setText(tools.presets->title());
    presets->setMenu(tools.presets);
    presets->setPopupMode(QToolButton::InstantPopup);
    presets->setFocusPolicy(Qt::StrongFocus);
    addWidget(presets);
    addStretch();
    auto* logarithmic = new QCheckBox(tr("Log histogram"));
    logarithmic->setObjectName("otfEditor.histogramLog");
    logarithmic->setToolTip(tr("Logarithmic heights show rare intensities too"));
    logarithmic->setChecked(true);
    connect(logarithmic, &QCheckBox::toggled, this, &EditorToolRow::histogramLogarithmic);
    addWidget(logarithmic);
    m_earlyLight = named(
        new QCheckBox(tr("Early light")), "otfEditor.earlyLight", tr("Show the light that is held back early"),
        tr("Bars show at which intensities light is held back more than 2 units before the surface: haze, or a wall. "
           "They add up to the mean share of a ray's light. The plot is 10 % of it high, or 20, 50 or 100 % if a bar "
           "is higher: the words in it say which."));
    addWidget(m_earlyLight);
}

}  // namespace echolucent
