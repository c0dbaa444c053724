#include "widgets/document/document_steps.h"

#include <algorithm>
#include <utility>

namespace echolucent {

DocumentSteps::DocumentSteps(Restore restore, QObject* parent) : QObject(parent), m_restore(std::move(restore)) {}

void DocumentSteps::setIndex(int index) {
    index = std::clamp(index, 0, count());
    if (index == m_index) return;
    m_index = index;
    m_restore(Document(m_states[static_cast<std::size_t>(index)].document));  // a slot may forget this state
    emit changed();
}

QString DocumentSteps::text(int step) const {
    return step >= 0 && step < count() ? m_states[static_cast<std::size_t>(step) + 1].what : QString();
}

void DocumentSteps::begin(const Document& document) {
    m_states.clear();
    m_states.push_back({document, {}, 0});
    m_index = 0;
    emit changed();
}

void DocumentSteps::push(const Document& before, const Document& after, const QString& what, int gesture) {
    m_states.resize(static_cast<std::size_t>(m_index) + 1);
    State& shown = m_states.back();
    if (m_index > 0 && gesture != 0 && gesture == shown.gesture && what == shown.what) {
        shown.document = after;
        const Document& began = m_states[static_cast<std::size_t>(m_index) - 1].document;
        if (withShown(after, began) != began) return;
        m_states.pop_back();
        --m_index;
        return;
    }
    shown.document = before;
    m_states.push_back({after, what, gesture});
    ++m_index;
}

}  // namespace echolucent
