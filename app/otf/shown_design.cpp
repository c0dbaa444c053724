#include "app/otf/shown_design.h"

#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {

QString labelOf(const DesignerConfig& config) { return textOf(labelOf(designerOf(config))); }

ShownDesign::ShownDesign(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    const int view = m_parts.view.view();
    connect(&m_parts.designs, &ViewDesigns::computed, this, [this, view](int made) {
        if (made == view) show();
    });
    connect(&m_parts.designs, &ViewDesigns::failed, this, [this, view](int failed, const QString& sentence) {
        if (failed != view) return;
        m_parts.messages.showMessage(MessageKind::error, sentence);
        goOnWithout();
    });
    connect(&m_parts.view, &DocumentView::designAwaited, this, &ShownDesign::goOnWithout);
    connect(&m_parts.designs, &ViewDesigns::cancelled, this, &ShownDesign::goOnWithout);
    connect(&m_parts.model, &DocumentModel::viewsChanged, this, &ShownDesign::show);
    connect(&m_parts.model, &DocumentModel::designsChanged, this, &ShownDesign::show);
}

void ShownDesign::show() {
    const int view = m_parts.view.view();
    const DesignerConfig* config = designOf(m_parts.model.document(), view);
    if (config == nullptr) return;
    const std::shared_ptr<const ViewDesign> made = m_parts.designs.of(view);
    if (made) m_parts.view.setDesigned(made->design.classification);
    m_parts.editor.setDesign(labelOf(made ? made->config : *config),
                             made ? std::optional(upperCurveOf(made->design.classification)) : std::nullopt);
}

void ShownDesign::goOnWithout() {
    const int view = m_parts.view.view();
    if (!m_parts.designs.of(view) && m_parts.designs.isRefused(view)) m_parts.view.doWithoutDesign();
}

}  // namespace echolucent
