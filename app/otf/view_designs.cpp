#include "app/otf/view_designs.h"

#include <QElapsedTimer>
#include <algorithm>
#include <new>
#include <utility>

#include "processing/designers/designer.h"
#include "processing/document/view_caster.h"

namespace echolucent {

namespace {

/// Whether two requests ask for the same but of other voxels, as the frames of a 4D study do.
bool differInVoxelsOnly(auto one, const auto& other) {
    one.raw = other.raw;
    one.shown = other.shown;
    return one == other;
}

}  // namespace

ViewDesigns::ViewDesigns(DocumentModel& model, OpenStudy& openStudy, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_openStudy(openStudy),
      m_run([](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
          return design(config, input, progress);
      }),
      m_thread(QStringLiteral("OTF designers")) {
    connect(&m_model, &DocumentModel::changed, this, &ViewDesigns::follow);
    connect(&m_openStudy, &OpenStudy::volumeChanged, this, &ViewDesigns::follow);
    connect(&m_openStudy, &OpenStudy::phaseVoxelsChanged, this, &ViewDesigns::follow);
    // Of speckle that is no longer reduced no voxels are made, and what was cancelled is waited for no more.
    connect(&m_openStudy, &OpenStudy::quietVoxelsMade, this, &ViewDesigns::follow);
    connect(&m_openStudy, &OpenStudy::quieteningChanged, this, &ViewDesigns::follow);
    connect(&m_thread, &NewestWinsThread::busyChanged, this, &ViewDesigns::busyChanged);
    connect(&m_thread, &NewestWinsThread::progressed, this, &ViewDesigns::progressed);
}

void ViewDesigns::setExtraPanes(std::vector<std::size_t> panes) {
    m_extraPanes = std::move(panes);
    follow();
}

std::shared_ptr<const ViewDesign> ViewDesigns::of(std::size_t pane) const {
    const auto found = m_made.find(pane);
    return found == m_made.end() ? nullptr : found->second.design;
}

bool ViewDesigns::isNewest(std::size_t pane) const {
    const auto found = m_made.find(pane);
    return found != m_made.end() && requestOf(pane) == found->second.request;
}

void ViewDesigns::cancel() {
    if (!m_running) return;
    m_running.reset();
    m_thread.cancel();
    for (const auto& [pane, request] : m_wanted)
        if (!isNewest(pane) && !refused(request)) m_refused.push_back(request);
    emit cancelled();
}

bool ViewDesigns::isRefused(std::size_t pane) const {
    const auto wanted = m_wanted.find(pane);
    return wanted != m_wanted.end() && refused(wanted->second);
}

bool ViewDesigns::isOfSomePhase(const Request& request) const {
    const Study* study = m_openStudy.study();
    const auto phases = study != nullptr ? static_cast<int>(study->phases.size()) : 0;
    for (int phase = 0; phase < phases; ++phase)
        if (request.raw == m_openStudy.rawVoxelsOf(phase) && request.shown == m_openStudy.newestVoxelsOf(phase))
            return true;
    return false;
}

void ViewDesigns::computeAgain() {
    m_refused.clear();
    follow();
}

std::vector<std::size_t> ViewDesigns::wantedPanes() const {
    const Document& document = m_model.document();
    std::vector<std::size_t> panes;
    for (std::size_t pane = 0; pane < document.panes.size(); ++pane)
        if (needsComputedOtf(document, pane) && ((pane == firstPane && document.panes[pane].designer) ||
                                                 std::ranges::find(m_extraPanes, pane) != m_extraPanes.end()))
            panes.push_back(pane);
    return panes;
}

const DesignerConfig* ViewDesigns::configFor(std::size_t pane) const {
    static const DesignerConfig adaptive = AdaptiveConfig{};
    const DesignerConfig* config = designerConfigOf(m_model.document(), pane);
    return config != nullptr ? config : &adaptive;
}

std::optional<ViewDesigns::Request> ViewDesigns::requestOf(std::size_t pane) const {
    const Document& document = m_model.document();
    const std::vector<std::size_t> all = wantedPanes();
    const Study* study = m_openStudy.study();
    if (study == nullptr || std::ranges::find(all, pane) == all.end()) return std::nullopt;
    const int phases = static_cast<int>(study->phases.size());
    int phase = otfPhaseOf(document, pane, phases);
    if (pane != firstPane) phase = std::min(phase, phases - 1);  // a pane of a longer study shows the last one
    if (phase >= phases) return std::nullopt;                    // the document is that of the study before
    const QuietPhases& quiet = m_openStudy.quietPhases();
    Request request{.config = *configFor(pane)};
    request.raw = m_openStudy.rawVoxelsOf(phase);
    request.shown = m_openStudy.newestVoxelsOf(phase);
    if (quiet.of(phase))
        request.reduction = quiet.reduction();
    else if (quiet.busy() && request.raw->geometry().voxelCount() <= OpenStudy::quietFirstVoxels)
        return std::nullopt;
    if (readsTubeCores(request.config)) {
        const DesignerInput input = designerInputOf(document, pane, *request.raw, *request.shown, request.reduction);
        request.view = input.view;
        request.method = input.method;
    }
    return request;
}

void ViewDesigns::follow() {
    m_stale = true;
    if (std::exchange(m_following, true)) return;  // who was given something has changed the document
    while (std::exchange(m_stale, false)) giveWhatIsKept();
    m_following = false;
    computeNext();
}

void ViewDesigns::giveWhatIsKept() {
    if (std::exchange(m_study, m_openStudy.study()) != m_openStudy.study()) {
        m_kept.clear();
        m_made.clear();
        m_refused.clear();
        if (m_running.has_value()) m_thread.cancel();
        m_running.reset();
    }
    m_wanted.clear();
    const std::vector<std::size_t> all = wantedPanes();
    std::erase_if(m_made, [&](const auto& made) { return std::ranges::find(all, made.first) == all.end(); });
    for (const std::size_t pane : all)
        if (auto request = requestOf(pane)) m_wanted.emplace(pane, std::move(*request));
    std::erase_if(m_refused, [this](const Request& request) {
        return std::ranges::none_of(m_wanted, [&](const auto& wanted) { return wanted.second == request; });
    });
    const std::map<std::size_t, Request> wanted = m_wanted;
    for (const auto& [pane, request] : wanted) {
        const auto made = m_made.find(pane);
        if (made != m_made.end() && made->second.request == request) continue;
        if (const Kept* found = kept(request))
            give(pane, request,
                 std::make_shared<const ViewDesign>(
                     ViewDesign{found->design, found->milliseconds, request.raw, request.shown, request.config}));
    }
}

const ViewDesigns::Kept* ViewDesigns::kept(const Request& request) const {
    Request voxelless = request;
    voxelless.raw = voxelless.shown = nullptr;
    const auto found = std::ranges::find_if(m_kept, [&](const Kept& each) {
        return each.request == voxelless && each.raw.lock() == request.raw && each.shown.lock() == request.shown;
    });
    return found == m_kept.end() ? nullptr : &*found;
}

bool ViewDesigns::refused(const Request& request) const {
    return std::ranges::find(m_refused, request) != m_refused.end();
}

void ViewDesigns::computeNext() {
    if (m_running) {
        // The frame of a motion that has gone on is kept for its next turn; else a slow designer would make none.
        // Voxels that were cut or quietened since are nobody's frame.
        const bool goesOn = std::ranges::any_of(
            m_wanted, [this](const auto& wanted) { return differInVoxelsOnly(wanted.second, *m_running); });
        if (goesOn && isOfSomePhase(*m_running)) return;
    }
    for (const auto& [pane, request] : m_wanted) {
        const auto made = m_made.find(pane);
        if ((made != m_made.end() && made->second.request == request) || refused(request)) continue;
        return compute(request);
    }
    if (std::exchange(m_running, std::nullopt)) m_thread.cancel();
}

void ViewDesigns::compute(const Request& request) {
    m_running = request;
    m_thread.submit([this, run = m_run, request](const Progress& progress) -> NewestWinsThread::Deliver {
        QElapsedTimer clock;
        clock.start();
        std::optional<Design> made;
        try {
            made = run(request.config, {*request.raw, *request.shown, request.reduction, request.view, request.method},
                       progress);
        } catch (const std::bad_alloc&) {
            return [this, request] { fail(request, tr("The designer needs more memory than this machine has.")); };
        }
        if (!made) return {};
        const double milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        return [this, request, made = std::move(*made), milliseconds] { take(request, made, milliseconds); };
    });
}

void ViewDesigns::take(const Request& request, Design design, double milliseconds) {
    if (m_running != request) return;
    m_running.reset();
    Request voxelless = request;
    voxelless.raw = voxelless.shown = nullptr;
    std::erase_if(m_kept, [](const Kept& each) { return each.raw.expired() || each.shown.expired(); });
    if (m_kept.size() >= keptCount) m_kept.erase(m_kept.begin());
    m_kept.push_back({voxelless, request.raw, request.shown, design, milliseconds});
    const auto made = std::make_shared<const ViewDesign>(
        ViewDesign{std::move(design), milliseconds, request.raw, request.shown, request.config});
    const std::map<std::size_t, Request> wanted = m_wanted;
    for (const auto& [pane, asked] : wanted)
        if (asked == request && m_wanted.contains(pane) && m_wanted.at(pane) == request) give(pane, request, made);
    computeNext();
}

void ViewDesigns::fail(const Request& request, const QString& sentence) {
    if (m_running != request) return;
    m_running.reset();
    m_refused.push_back(request);
    const std::map<std::size_t, Request> wanted = m_wanted;
    for (const auto& [pane, asked] : wanted)
        if (asked == request) emit failed(pane, sentence);
    computeNext();
}

void ViewDesigns::give(std::size_t pane, const Request& request, std::shared_ptr<const ViewDesign> design) {
    m_made[pane] = {request, std::move(design)};
    emit computed(pane);
}

}  // namespace echolucent
