#include "app/otf/shown_design.h"

#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {

QString labelOf(const DesignerConfig& config) { return textOf(labelOf(designerOf(config))); }

ShownDesign::ShownDesign(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connect(&m_parts.designs, &ViewDesigns::computed, this, [this](std::size_t made) {
        if (made == firstPane) show();
    });
    connect(&m_parts.designs, &ViewDesigns::failed, this, [this](std::size_t failed, const QString& sentence) {
        if (failed != firstPane) return;
        m_parts.messages.showMessage(MessageKind::error, sentence);
        goOnWithout();
    });
    connect(&m_parts.view, &DocumentView::designAwaited, this, &ShownDesign::goOnWithout);
    connect(&m_parts.designs, &ViewDesigns::cancelled, this, &ShownDesign::goOnWithout);
    connect(&m_parts.model, &DocumentModel::panesChanged, this, &ShownDesign::show);
}

void ShownDesign::show() {
    const DesignerConfig* config = designerConfigOf(m_parts.model.document(), firstPane);
    if (config == nullptr) return;
    const std::shared_ptr<const ViewDesign> made = m_parts.designs.of(firstPane);
    if (made) m_parts.view.setDesigned(made->design.classification);
    m_parts.editor.setDesign(labelOf(made ? made->config : *config),
                             made ? std::optional(upperCurveOf(made->design.classification)) : std::nullopt);
}

void ShownDesign::goOnWithout() {
    if (!m_parts.designs.of(firstPane) && m_parts.designs.isRefused(firstPane)) m_parts.view.doWithoutDesign();
}

}  // namespace echolucent
