#include "widgets/document/document_steps.h"

#include <algorithm>
#include <utility>

#include "widgets/document/kept_bytes.h"

namespace echolucent {

DocumentSteps::DocumentSteps(Restore restore, std::size_t mostBytes)
    : m_restore(std::move(restore)), m_mostBytes(mostBytes) {
    const Document empty;  // GCC 12 takes a temporary for uninitialised
    begin(empty);
}

void DocumentSteps::setIndex(int index) {
    index = std::clamp(index, 0, count());
    if (index == m_index) return;
    const Document* framed = nullptr;
    for (auto step = static_cast<std::size_t>(m_index); step > static_cast<std::size_t>(index); --step)
        if (m_states[step].setsFrame) framed = &m_states[step - 1].document;
    for (auto step = static_cast<std::size_t>(m_index) + 1; step <= static_cast<std::size_t>(index); ++step)
        if (m_states[step].setsFrame) framed = &m_states[step].document;
    m_index = index;
    // A copy, as a slot may forget this state meanwhile.
    const Document restored = framed != nullptr ? withShown(shown().document, *framed) : shown().document;
    m_restore(restored, framed != nullptr);
    emit changed();
}

QString DocumentSteps::text(int step) const {
    return step >= 0 && step < count() ? m_states[static_cast<std::size_t>(step) + 1].what : QString();
}

void DocumentSteps::begin(const Document& document) {
    m_states.clear();
    m_states.push_back({document, {}, 0, 0, false});
    m_index = 0;
    m_bytes = 0;
    m_dropped = 0;
    measureLast();
}

std::shared_ptr<const DocumentSteps::Kept> DocumentSteps::keep() const {
    return std::make_shared<const Kept>(Kept{m_states, m_index, m_bytes, m_dropped});
}

void DocumentSteps::comeBack(const Kept& kept) {
    m_states = kept.states;
    m_index = kept.index;
    m_bytes = kept.bytes;
    m_dropped = kept.dropped;
}

void DocumentSteps::clear() {
    begin(Document(shown().document));
    emit changed();
}

void DocumentSteps::push(const Document& before, const Document& after, const QString& what, int gesture,
                         bool setsFrame) {
    while (canRedo()) removeLast();
    if (canUndo() && gesture != 0 && gesture == shown().gesture && what == shown().what) {
        const Document& began = m_states[static_cast<std::size_t>(m_index) - 1].document;
        if (withShown(after, began) == began) {
            removeLast();
            --m_index;
            return;
        }
        shown().document = after;
        measureLast();
    } else {
        shown().document = before;
        measureLast();
        m_states.push_back({after, what, gesture, 0, setsFrame});
        ++m_index;
        measureLast();
    }
    while (m_bytes > m_mostBytes && count() > 1) dropOldest();
}

void DocumentSteps::removeLast() {
    m_bytes -= m_states.back().bytes;
    m_states.pop_back();
}

void DocumentSteps::measureLast() {
    State& last = m_states.back();
    m_bytes -= last.bytes;
    last.bytes = bytesBeside(last.document, count() > 0 ? &m_states[m_states.size() - 2].document : nullptr);
    m_bytes += last.bytes;
}

void DocumentSteps::dropOldest() {
    m_bytes -= m_states[0].bytes + m_states[1].bytes;
    m_states.pop_front();
    State& oldest = m_states.front();
    oldest.bytes = bytesBeside(oldest.document, nullptr);
    oldest.what.clear();
    oldest.setsFrame = false;
    m_bytes += oldest.bytes;
    --m_index;
    ++m_dropped;
}

}  // namespace echolucent
