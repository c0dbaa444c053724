// The row on top of the curve editor: what acts on curves, and switches of what the plot shows.
#pragma once

#include "widgets/controls/flow_layout.h"

class QAction;
class QCheckBox;
class QMenu;
class QToolButton;

namespace echolucent {

/// A button of the editor that does what the action does. Its accessible name is the action's text.
[[nodiscard]] QToolButton* buttonFor(QAction* action, const QString& objectName, Qt::ToolButtonStyle style);

/// Objects: otfEditor.undo, otfEditor.redo, otfEditor.reset, otfEditor.presets, otfEditor.histogramLog,
/// otfEditor.earlyLight.
class EditorToolRow : public FlowLayout {
    Q_OBJECT

public:
    /// They outlive the row.
    struct Tools {
        QAction* undo;
        QAction* redo;
        QAction* reset;
        QMenu* presets;
    };
    explicit EditorToolRow(const Tools& tools);

    /// Whether a person wants to see at which intensities light is held back early. Off at first.
    [[nodiscard]] QCheckBox& earlyLight() { return *m_earlyLight; }

signals:
    /// Whether the histogram has logarithmic heights. True at first.
    void histogramLogarithmic(bool logarithmic);

private:
    QCheckBox* m_earlyLight;
};

}  // namespace echolucent
