#include "app/explain/tube_core_choice.h"

#include <utility>

namespace echolucent {

TubeCoreChoice::TubeCoreChoice(PaneOtfs& otfs, OpenStudy& openStudy, QObject* parent) : QObject(parent), m_otfs(otfs) {
    connect(&openStudy, &OpenStudy::studyOpened, this, [this] { choose(std::nullopt); });
    connect(&m_otfs, &PaneOtfs::computed, this, [this](std::size_t place) {
        if (place == PaneOtfs::adaptiveOfScene) choose(m_number);
    });
}

bool TubeCoreChoice::holds(int number) const {
    const auto otf = m_otfs.adaptive();
    return otf && number >= 0 && static_cast<std::size_t>(number) < otf->tubes.size();
}

void TubeCoreChoice::choose(std::optional<int> number) {
    if (number && !holds(*number)) number.reset();
    if (std::exchange(m_number, number) != number) emit chosen();
}

void TubeCoreChoice::setShown(bool shown) {
    if (std::exchange(m_shown, shown) != shown) emit shownChanged(shown);
}

}  // namespace echolucent
