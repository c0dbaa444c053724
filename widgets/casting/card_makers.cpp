#include "widgets/casting/card_makers.h"

#include <chrono>
#include <list>
#include <memory>
#include <utility>

#include "processing/card_picture/card_pictures.h"

namespace echolucent {

namespace {

class CardMakers {
public:
    CastResult make(const PictureRequest& request, const Progress& progress) {
        if (request.panes.empty()) {
            m_makers.clear();
            return {};
        }
        const auto begin = std::chrono::steady_clock::now();
        const PaneRequest& pane = request.panes.front();
        auto picture = makerOf(pane.volume).make(pane.classification, request.settings, progress);
        if (!picture) return {};
        if (!m_known) m_known = std::make_shared<const KnownCardPicture>(knownCardPicture());
        CastResult made;
        made.lightMilliseconds = picture->lightMilliseconds;
        CastPane& cast = made.panes.emplace_back();
        cast.card = std::make_shared<const CardPicture>(std::move(*picture));
        cast.known = m_known;
        cast.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        return made;
    }

private:
    /// The newest stands first.
    CardPictures& makerOf(const std::shared_ptr<const Volume>& volume) {
        for (auto at = m_makers.begin(); at != m_makers.end(); ++at)
            if (at->volume()->isSameScanAs(*volume)) {
                m_makers.splice(m_makers.begin(), m_makers, at);
                m_makers.front().setCut(volume);
                return m_makers.front();
            }
        dropOldest(*volume);
        return m_makers.emplace_front(volume);
    }
    /// A volume of another grid is another study, and nothing of the one before is wanted any more.
    void dropOldest(const Volume& volume) {
        std::size_t bytes = 0;
        std::erase_if(m_makers, [&](const CardPictures& maker) {
            bytes += maker.keptBytes();
            return bytes > keptBytesForCard || maker.volume()->geometry().size != volume.geometry().size;
        });
    }

    std::list<CardPictures> m_makers;
    std::shared_ptr<const KnownCardPicture> m_known;
};

}  // namespace

Cast makeForCard() {
    // std::function copies what it holds; makers must not be copied.
    return [makers = std::make_shared<CardMakers>()](const PictureRequest& request, const Progress& progress) {
        return makers->make(request, progress);
    };
}

}  // namespace echolucent
