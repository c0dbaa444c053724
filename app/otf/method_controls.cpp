#include "app/otf/method_controls.h"

#include "widgets/panels/method_panel.h"

namespace echolucent {

MethodControls::MethodControls(DocumentModel& model, HandGesture& hand, MethodPanel& panel, QObject* parent)
    : QObject(parent), m_model(model), m_hand(hand), m_panel(panel) {
    connect(&m_panel, &MethodPanel::configChanged, this, &MethodControls::takeFromPanel);
    connect(&m_model, &DocumentModel::methodChanged, this, &MethodControls::showDocument);
    showDocument();
}

void MethodControls::takeFromPanel() {
    Document next = m_model.document();
    next.method.config = m_panel.config();
    next.method.config.initial = AdaptiveOtfConfig{}.initial;  // its name and scale stand beside it
    next.method.initial = m_panel.initialKind();
    next.method.initialScale = m_panel.opacityScale();
    m_model.edit(next, tr("method"), m_hand.current());
}

void MethodControls::showDocument() { m_panel.setConfig(configOf(m_model.document())); }

}  // namespace echolucent
