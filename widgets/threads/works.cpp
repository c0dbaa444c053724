#include "widgets/threads/works.h"

#include <algorithm>
#include <utility>

namespace echolucent {

Works::UnderWay::~UnderWay() {
    if (!isKnown()) return;
    std::erase(m_works->m_underWay, this);
    QMetaObject::invokeMethod(m_works, &Works::changed, Qt::QueuedConnection);
}

bool Works::UnderWay::isKnown() const {
    return m_works && std::ranges::find(m_works->m_underWay, this) != m_works->m_underWay.end();
}

// A receiver of changed() may end this work or begin others, so read nothing after emitting it.
void Works::UnderWay::set(bool underWay) {
    if (!m_works || underWay == isKnown()) return;
    if (underWay)
        m_works->m_underWay.push_back(this);
    else
        std::erase(m_works->m_underWay, this);
    emit m_works->changed();
}

void Works::UnderWay::setWords(const QString& words) {
    if (std::exchange(m_work.words, words) != words && isKnown()) emit m_works->changed();
}

void Works::UnderWay::setProgress(double share) {
    if (m_works && m_works->shown() == this) emit m_works->progressed(share);
}

bool Works::atRest() const {
    return std::ranges::none_of(m_underWay, [](const UnderWay* each) { return each->m_work.countsForRest; });
}

const Works::UnderWay* Works::shown() const {
    const UnderWay* first = nullptr;
    for (const UnderWay* each : m_underWay)
        if (!each->m_work.words.isEmpty() && (first == nullptr || each->m_work.urgency < first->m_work.urgency))
            first = each;
    return first;
}

QString Works::words() const {
    const UnderWay* work = shown();
    return work != nullptr ? work->m_work.words : QString();
}

void Works::cancelShown() {
    const UnderWay* work = shown();
    if (work == nullptr) return;
    const auto cancel = work->m_work.cancel;  // cancel() may destroy the work
    if (cancel) cancel();
}

}  // namespace echolucent
