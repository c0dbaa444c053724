// The panel of OTF designers, with the document and what is computed behind it.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/otf/pane_otfs.h"
#include "processing/designers/choice/designer_config.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class DesignerPanel;

/// Makes steps of what is chosen in the panel, and shows there what the document says and what was made.
class DesignerControls : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        PaneOtfs& otfs;
        DesignerPanel& panel;
    };
    /// All of them must outlive this.
    explicit DesignerControls(const Parts& parts, QObject* parent = nullptr);

private:
    void choose(std::optional<Designer> designer);
    void showDocument();
    void showDesign();

    Parts m_parts;
    std::shared_ptr<const ComputedOtf> m_shown;  ///< in the panel
    std::optional<std::size_t> m_designer;       ///< in the panel; no value: a curve
};

}  // namespace echolucent
