// The OTFs that are computed, in the curve editor.
#pragma once

#include <QObject>
#include <QString>

#include "app/otf/shown_panes.h"

namespace echolucent {

class MessageBar;
class OtfEditor;

/// Brings the adaptive curve and what the designer of the first pane made to the editor, and says what failed.
class EditorOtfs : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        PaneOtfs& otfs;
        ShownPanes& panes;
        OtfEditor& editor;
        MessageBar& messages;
    };
    /// All of them must outlive this.
    explicit EditorOtfs(const Parts& parts, QObject* parent = nullptr);

private:
    void showAdaptive();
    void showDesign();
    void tellFailure(std::size_t place, const QString& sentence);

    Parts m_parts;
};

/// "Levoy", ...
[[nodiscard]] QString labelOf(const DesignerConfig& config);

}  // namespace echolucent
