#include "app/otf/editor_otfs.h"

#include <utility>

#include "widgets/controls/message_bar.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/designer_panel.h"

namespace echolucent {

namespace {
constexpr const char* otfTopic = "OTF";
}  // namespace

QString labelOf(const DesignerConfig& config) { return textOf(labelOf(designerOf(config))); }

EditorOtfs::EditorOtfs(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connect(&m_parts.panes, &ShownPanes::changed, this, &EditorOtfs::showAdaptive);
    connect(&m_parts.otfs, &PaneOtfs::computed, this, [this](std::size_t place) {
        if (place == firstPane || place == PaneOtfs::adaptiveOfScene) m_parts.messages.takeBack(otfTopic);
        if (place == firstPane) showDesign();
    });
    connect(&m_parts.model, &DocumentModel::panesChanged, this, &EditorOtfs::showDesign);
    connect(&m_parts.otfs, &PaneOtfs::failed, this, &EditorOtfs::tellFailure);
    connect(&m_parts.otfs, &PaneOtfs::followed, this, &EditorOtfs::showInPanel);
    connect(&m_parts.otfs, &PaneOtfs::progressed, &m_parts.designers, &DesignerPanel::setProgress);
    connect(&m_parts.designers, &DesignerPanel::cancelRequested, &m_parts.otfs, &PaneOtfs::cancel);
    connect(&m_parts.designers, &DesignerPanel::computeRequested, &m_parts.otfs, &PaneOtfs::computeAgain);
}

/// Keeps the curve that the editor shows until the next one is there, or until it is known that none will come.
void EditorOtfs::showAdaptive() {
    const SampledCurve& curve = m_parts.panes.adaptiveCurve();
    const bool comes = curve.opacities.empty() && !m_parts.otfs.isRefused(PaneOtfs::adaptiveOfScene);
    if (!comes && m_parts.editor.state().adaptive != curve) m_parts.editor.setAdaptiveCurve(curve);
}

void EditorOtfs::showDesign() {
    const DesignerConfig* config = designerConfigOf(m_parts.model.document(), firstPane);
    // The panel forgets what was made if another designer is chosen.
    const auto kind = config != nullptr ? std::optional(config->index()) : std::nullopt;
    if (std::exchange(m_kindInPanel, kind) != kind) m_inPanel.reset();
    if (config == nullptr) return;
    const auto made = m_parts.otfs.designOf(firstPane);
    m_parts.editor.setDesign(labelOf(made ? made->asked.config : *config),
                             made ? std::optional(upperCurveOf(made->design.classification)) : std::nullopt);
}

void EditorOtfs::showInPanel() {
    const DesignerConfig* config = designerConfigOf(m_parts.model.document(), firstPane);
    auto made = m_parts.otfs.designOf(firstPane);
    // The picture may still show the design of the designer before. The panel of the chosen designer does not show it.
    if (made && (config == nullptr || config->index() != made->asked.config.index())) made.reset();
    if (made != m_inPanel) m_parts.designers.setDesign(made ? &made->design : nullptr, made ? made->milliseconds : 0.0);
    m_inPanel = made;
    m_parts.designers.setComputing(m_parts.otfs.designing(), m_parts.otfs.isAnyRefused());
}

/// Tells the failure of the scene's adaptive OTF, and that of the first pane if a designer was to make its OTF. If the
/// first pane shows the scene's OTF, one failure is thus told once. CompareRoom tells of the other panes.
void EditorOtfs::tellFailure(std::size_t place, const QString& sentence) {
    const bool designed = designerConfigOf(m_parts.model.document(), firstPane) != nullptr;
    if (place == PaneOtfs::adaptiveOfScene || (place == firstPane && designed))
        m_parts.messages.showMessage(MessageKind::error, sentence, MessageEnd::withStudy(otfTopic));
}

}  // namespace echolucent
