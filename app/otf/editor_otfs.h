// Shows computed OTFs in the curve editor and in the panel of designers.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>

#include "app/otf/shown_panes.h"

namespace echolucent {

class DesignerPanel;
class MessageBar;
class OtfEditor;

/// Brings the adaptive curve to the editor, and the design of the first pane to editor and panel. Tells of failures.
/// Cancels and computes again if the panel asks for it.
class EditorOtfs : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        PaneOtfs& otfs;
        ShownPanes& panes;
        OtfEditor& editor;
        DesignerPanel& designers;
        MessageBar& messages;
    };
    /// What the parameters refer to must outlive this object.
    explicit EditorOtfs(const Parts& parts, QObject* parent = nullptr);

private:
    void showAdaptive();
    void showDesign();
    void showInPanel();
    void tellFailure(std::size_t place, const QString& sentence);

    Parts m_parts;
    std::shared_ptr<const ComputedOtf> m_inPanel;
    std::optional<std::size_t> m_kindInPanel;  ///< index() of the first pane's DesignerConfig; no value without one
};

/// "Levoy", ...
[[nodiscard]] QString labelOf(const DesignerConfig& config);

}  // namespace echolucent
