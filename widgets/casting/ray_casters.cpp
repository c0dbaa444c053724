#include "widgets/casting/ray_casters.h"

#include <chrono>
#include <memory>
#include <utility>

#include "processing/ray_caster/ray_caster.h"

namespace echolucent {

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

class RayCasters {
public:
    CastResult cast(const PictureRequest& request, const Progress& progress) {
        prepare(request);
        CastResult made;
        std::size_t cast = 0, alike = 0;
        double shares = 0.0;
        for (std::size_t i = 0; i < m_panes.size(); ++i) {
            Pane& pane = m_panes[i];
            const PaneRequest& asked = request.panes[i];
            // Panes that stay exist only beside others: a single pane is requested only if it has changed.
            const bool stays = m_panes.size() > 1 && pane.made && pane.made->volume == asked.volume &&
                               pane.made->classification == asked.classification && pane.settings == request.settings;
            if (!stays && !castPane(pane, asked, request.settings, progress)) return {};
            if (m_panes.size() > 1) pane.picture.picture.reset();  // of panes side by side, only screens are read
            made.panes.push_back(pane.picture);
            if (stays) continue;
            ++cast;
            made.lightMilliseconds += pane.caster->lightMilliseconds();
            shares += pane.caster->castShare();
            const SampleUse use = pane.caster->sampleUse();
            alike += made.samples.value_or(use) == use ? 1 : 0;
            made.samples = use;
        }
        if (cast > 0) made.castShare = shares / static_cast<double>(cast);
        if (alike < cast || (cast < m_panes.size() && made.samples != SampleUse::kept)) made.samples.reset();
        return made;
    }

private:
    struct Pane {
        std::optional<RayCaster> caster;
        std::optional<PaneRequest> made;  ///< what `picture` shows
        RayCastSettings settings;
        CastPane picture;
    };

    static bool castPane(Pane& pane, const PaneRequest& asked, const RayCastSettings& settings,
                         const Progress& progress) {
        const auto begin = std::chrono::steady_clock::now();
        pane.made.reset();
        auto picture = pane.caster->cast(asked.classification, settings, progress);
        if (!picture) return false;
        auto screen = std::make_shared<const ScreenPicture>(screenPicture(*picture));
        pane.picture = {std::make_shared<const Picture>(std::move(*picture)),
                        std::move(screen),
                        millisecondsSince(begin),
                        pane.caster->sampleUse() != SampleUse::kept,
                        {},
                        {}};
        pane.made = asked;
        pane.settings = settings;
        return true;
    }

    /// Frees what another scan left before anything new is made.
    void prepare(const PictureRequest& request) {
        m_panes.resize(request.panes.size());
        for (std::size_t i = 0; i < m_panes.size(); ++i)
            if (m_panes[i].caster && !request.panes[i].volume->isSameScanAs(*m_panes[i].caster->volume()))
                m_panes[i] = Pane{};
        for (std::size_t i = 0; i < m_panes.size(); ++i) {
            std::optional<RayCaster>& caster = m_panes[i].caster;
            const auto& volume = request.panes[i].volume;
            for (const Pane& other : m_panes)
                if (!caster && other.caster && volume->isSameScanAs(*other.caster->volume()))
                    caster.emplace(other.caster->sharing());
            if (!caster) caster.emplace(volume);
            if (caster->volume() != volume) caster->setCut(volume);
        }
    }

    std::vector<Pane> m_panes;
};

}  // namespace

Cast castThroughRayCasters() {
    // std::function copies what it holds; casters must not be copied.
    return [casters = std::make_shared<RayCasters>()](const PictureRequest& request, const Progress& progress) {
        return casters->cast(request, progress);
    };
}

}  // namespace echolucent
