#include "app/otf/designer_controls.h"

#include <utility>

#include "app/otf/editor_otfs.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/panels/designer_panel.h"

namespace echolucent {

DesignerControls::DesignerControls(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    DesignerPanel* panel = &m_parts.panel;
    DocumentModel* model = &m_parts.model;
    connect(panel, &DesignerPanel::chosen, this, &DesignerControls::choose);
    connect(panel, &DesignerPanel::configChanged, this, [this](const DesignerConfig& config, const QString& what) {
        m_parts.model.edit(withDesigner(m_parts.model.document(), firstPane, config), what);
    });
    connect(panel, &DesignerPanel::configPreviewed, this, [this](const DesignerConfig& config, const QString& what) {
        m_parts.model.preview(withDesigner(m_parts.model.document(), firstPane, config), what);
    });
    connect(panel, &DesignerPanel::dragEnded, model, &DocumentModel::commitPreview);
    connect(panel, &DesignerPanel::dragCancelled, model, &DocumentModel::cancelPreview);
    connect(panel, &DesignerPanel::cancelRequested, &m_parts.otfs, &PaneOtfs::cancel);
    connect(panel, &DesignerPanel::computeRequested, &m_parts.otfs, &PaneOtfs::computeAgain);
    connect(model, &DocumentModel::panesChanged, this, &DesignerControls::showDocument);
    connect(&m_parts.otfs, &PaneOtfs::followed, this, &DesignerControls::showDesign);
    connect(&m_parts.otfs, &PaneOtfs::progressed, panel, &DesignerPanel::setProgress);
    showDocument();
    showDesign();
}

void DesignerControls::choose(std::optional<Designer> designer) {
    const Document& document = m_parts.model.document();
    if (!designer)
        m_parts.model.edit(withCurve(document, firstPane, document.panes.at(firstPane).curve), tr("choose curve"));
    else
        m_parts.model.edit(withDesigner(document, firstPane, defaultConfigOf(*designer)),
                           tr("choose designer %1").arg(textOf(labelOf(*designer))));
}

void DesignerControls::showDocument() {
    const DesignerConfig* config = designerConfigOf(m_parts.model.document(), firstPane);
    m_parts.panel.setConfig(config != nullptr ? std::optional(*config) : std::nullopt);
    const std::optional<std::size_t> designer = config != nullptr ? std::optional(config->index()) : std::nullopt;
    if (std::exchange(m_designer, designer) != designer) m_shown.reset();  // the panel has nothing of another one
    showDesign();
}

void DesignerControls::showDesign() {
    const DesignerConfig* config = designerConfigOf(m_parts.model.document(), firstPane);
    auto made = m_parts.otfs.designOf(firstPane);
    // What another designer made before is shown still, and is nothing of this one's.
    if (made && (config == nullptr || config->index() != made->asked.config.index())) made.reset();
    if (made != m_shown) m_parts.panel.setDesign(made ? &made->design : nullptr, made ? made->milliseconds : 0.0);
    m_shown = made;
    m_parts.panel.setComputing(m_parts.otfs.designing(), m_parts.otfs.isAnyRefused());
}

}  // namespace echolucent
