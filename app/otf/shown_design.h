// What a designer made, in the 3D view and in the curve editor.
#pragma once

#include <QObject>

#include "app/document/document_view.h"
#include "app/otf/view_designs.h"

namespace echolucent {

class MessageBar;
class OtfEditor;

/// Brings what the designer of a view made to its picture and to the editor, and says what failed.
class ShownDesign : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        ViewDesigns& designs;
        DocumentView& view;
        OtfEditor& editor;
        MessageBar& messages;
    };
    /// All of them must outlive this.
    explicit ShownDesign(const Parts& parts, QObject* parent = nullptr);

private:
    void show();
    void goOnWithout();

    Parts m_parts;
};

/// "Levoy", ...
[[nodiscard]] QString labelOf(const DesignerConfig& config);

}  // namespace echolucent
