#include "app/otf/pane_otfs.h"

#include <QElapsedTimer>
#include <algorithm>
#include <new>
#include <utility>

#include "processing/designers/choice/designer.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

namespace {

/// Whether two requests differ in voxels alone, as those of the frames of a 4D study do.
bool differInVoxelsOnly(auto one, const auto& other) {
    one.raw = other.raw;
    one.shown = other.shown;
    return one == other;
}

std::size_t paneOf(std::size_t place) { return place == PaneOtfs::adaptiveOfScene ? firstPane : place; }

}  // namespace

PaneOtfs::PaneOtfs(DocumentModel& model, OpenStudy& openStudy, Works& works, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_openStudy(openStudy),
      m_run([](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
          return design(config, input, progress);
      }),
      m_thread(works, QStringLiteral("OTFs"), {.urgency = Urgency::designing, .cancel = [this] { cancel(); }}) {
    begin();
    connect(&m_model, &DocumentModel::changed, this, &PaneOtfs::follow);
    connect(&m_openStudy, &OpenStudy::volumeChanged, this, &PaneOtfs::follow);
    connect(&m_openStudy, &OpenStudy::phaseVoxelsChanged, this, &PaneOtfs::follow);
    // If the making of quiet voxels is cancelled, no OTF waits for them any longer.
    connect(&m_openStudy, &OpenStudy::quieteningChanged, this, &PaneOtfs::follow);
    // Strokes that cut nothing end without another signal: they change no voxels.
    connect(&m_openStudy, &OpenStudy::cuttingChanged, this, &PaneOtfs::follow);
    connect(&m_thread, &NewestWinsThread::progressed, this, &PaneOtfs::progressed);
}

void PaneOtfs::setComparing(bool comparing) {
    if (std::exchange(m_comparing, comparing) != comparing) follow();
}

void PaneOtfs::setPlaying(bool playing) {
    if (std::exchange(m_playing, playing) != playing) follow();
}

void PaneOtfs::setRun(Run run) {
    m_run = std::move(run);
    m_kept.clear();
}

std::shared_ptr<const ComputedOtf> PaneOtfs::of(std::size_t place) const {
    const auto found = m_made.find(place);
    return found == m_made.end() ? nullptr : found->second.otf;
}

std::shared_ptr<const ComputedOtf> PaneOtfs::designOf(std::size_t pane) const {
    const auto found = m_made.find(pane);
    const bool designed = designerConfigOf(m_model.document(), pane) != nullptr;
    return designed && found != m_made.end() && found->second.byDesigner ? found->second.otf : nullptr;
}

std::shared_ptr<const AdaptiveOtf> PaneOtfs::adaptive() const {
    const auto otf = of(adaptiveOfScene);
    return otf ? otf->design.tubeCores : nullptr;
}

bool PaneOtfs::isNewest(std::size_t place) const {
    const auto found = m_made.find(place);
    return found != m_made.end() && requestOf(place) == found->second.otf->asked;
}

bool PaneOtfs::isRefused(std::size_t place) const {
    const auto wanted = m_wanted.find(place);
    return wanted != m_wanted.end() && refused(wanted->second);
}

bool PaneOtfs::designing() const { return m_running && !std::holds_alternative<AdaptiveConfig>(m_running->config); }

void PaneOtfs::cancel() {
    if (!m_running) return;
    const OtfRequest running = *m_running;
    stop();
    for (const auto& [place, request] : m_wanted) {
        const bool ended = place != adaptiveOfScene || request == running;
        if (ended && !isNewest(place) && !refused(request)) m_refused.push_back(request);
    }
    computeNext();
    emit cancelled();
    emit followed();
}

void PaneOtfs::computeAgain() {
    m_refused.clear();
    follow();
}

void PaneOtfs::computeForThisView() {
    if (!m_openStudy.volume()) return;
    const Viewpoint shown = viewpointOf(m_model.document());
    Document next = m_model.document();
    next.scene.side = directionOf(shown);
    next.motion.otfPhase = phaseOf(next, firstPane);
    m_model.edit(next, tr("compute for this view"));
    m_view = shown;  // even if the side was this one before
    computeAgain();
}

bool PaneOtfs::isOfSomePhase(const OtfRequest& request) const {
    const Study* study = m_openStudy.study();
    const auto phases = study != nullptr ? static_cast<int>(study->phases.size()) : 0;
    for (int phase = 0; phase < phases; ++phase)
        if (request.raw == m_openStudy.rawVoxelsOf(phase) && request.shown == m_openStudy.newestVoxelsOf(phase))
            return true;
    return false;
}

std::vector<std::size_t> PaneOtfs::wantedPlaces() const {
    const Document& document = m_model.document();
    // The scene's OTF comes first: a designer may take long.
    std::vector<std::size_t> places{adaptiveOfScene};
    for (std::size_t pane = 0; pane < document.panes.size(); ++pane)
        if (needsComputedOtf(document, pane) && (pane == firstPane || m_comparing)) places.push_back(pane);
    return places;
}

Viewpoint PaneOtfs::viewOf(std::size_t pane) const {
    const Document& document = m_model.document();
    return document.panes.at(pane).motionOtf ? otfViewpointOf(document, pane) : m_view;
}

bool PaneOtfs::waitsForVoxels(std::size_t place, int phase) const {
    const std::shared_ptr<const Volume> raw = m_openStudy.rawVoxelsOf(phase);
    const auto made = of(place);
    const bool shown = made && made->asked.raw->isSameScanAs(*raw);
    if (!shown && m_openStudy.isCutting(phase)) return true;
    const QuietPhases& quiet = m_openStudy.quietPhases();
    if (m_playing || !quiet.busy() || quiet.of(phase)) return false;
    return shown || raw->geometry().voxelCount() <= quietFirstVoxels;
}

std::optional<OtfRequest> PaneOtfs::requestOf(std::size_t place) const {
    const Document& document = m_model.document();
    const std::vector<std::size_t> all = wantedPlaces();
    const Study* study = m_openStudy.study();
    if (study == nullptr || std::ranges::find(all, place) == all.end()) return std::nullopt;
    const std::size_t pane = paneOf(place);
    // A pane may name a phase of a longer study: it shows the last phase.
    const int phases = static_cast<int>(study->phases.size());
    const int phase = std::min(otfPhaseOf(document, pane, phases), phases - 1);
    if (waitsForVoxels(place, phase)) return std::nullopt;
    const DesignerConfig* config = place == adaptiveOfScene ? nullptr : designerConfigOf(document, pane);
    OtfRequest request{.config = config != nullptr ? *config : AdaptiveConfig{},
                       .raw = m_openStudy.rawVoxelsOf(phase),
                       .shown = m_openStudy.newestVoxelsOf(phase)};
    const QuietPhases& quiet = m_openStudy.quietPhases();
    if (quiet.of(phase)) request.reduction = quiet.reduction();
    if (readsTubeCores(request.config)) {
        request.view = viewOf(pane);
        request.method = configOf(document, pane);
    }
    return request;
}

/// Forgets the OTFs of the study before, because another study is open.
void PaneOtfs::begin() {
    m_study = m_openStudy.study();
    m_kept.clear();
    m_made.clear();
    m_refused.clear();
    stop();
    const Document& document = m_model.document();
    m_followed = {.fromSide = otfViewpointOf(document, firstPane),
                  .otf = document.motion.otf,
                  .angle = document.scene.motionAngle,
                  .phase = phaseOf(document, firstPane),
                  .pose = document.scene.pose};
    m_view = document.motion.otf == MotionOtf::oneOtf ? m_followed.fromSide : viewpointOf(document);
}

void PaneOtfs::followView() {
    const Document& document = m_model.document();
    const Followed now{.fromSide = otfViewpointOf(document, firstPane),
                       .otf = document.motion.otf,
                       .angle = document.scene.motionAngle,
                       .phase = phaseOf(document, firstPane),
                       .pose = document.scene.pose};
    const Followed before = std::exchange(m_followed, now);
    // Front and box limit a frame of the motion, but do not change its direction.
    const auto limit = [&now](Viewpoint view) {
        view.frontPlane = now.fromSide.frontPlane;
        view.cutSurface = now.fromSide.cutSurface;
        view.box = now.fromSide.box;
        return view;
    };
    m_view = limit(before.fromSide) == now.fromSide ? limit(m_view) : now.fromSide;
    const bool oneOtf = now.otf == MotionOtf::oneOtf;
    // If the hand turns the camera, the motion ends, so this is no frame of it.
    const bool anotherFrame = (now.angle != before.angle || now.phase != before.phase) && now.pose == before.pose;
    if (now.otf != before.otf)
        m_view = oneOtf ? now.fromSide : viewpointOf(document);
    else if (!oneOtf && anotherFrame)
        m_view = viewpointOf(document);
}

void PaneOtfs::follow() {
    m_stale = true;
    if (m_openStudy.beginning()) return;           // the document still belongs to the study before
    if (std::exchange(m_following, true)) return;  // a receiver of computed() has changed the document
    while (m_stale) {
        askForVoxels();
        m_stale = false;
        giveWhatIsKept();
    }
    m_following = false;
    computeNext();
    emit followed();
}

/// Asks for the phase shown, the phase of a motion's one OTF, the speckle reduction, and the cuts.
void PaneOtfs::askForVoxels() {
    const Document& document = m_model.document();
    m_openStudy.setReduction(document.scene.look.reduction);
    const Study* study = m_openStudy.study();
    if (study == nullptr) return;
    const auto phases = static_cast<int>(study->phases.size());
    m_openStudy.setStrokes(document.scene.strokes);
    if (const int phase = phaseOf(document, firstPane); phase < phases) m_openStudy.setPhase(phase);
    m_openStudy.alsoWant(otfPhaseOf(document, firstPane, phases));
}

void PaneOtfs::giveWhatIsKept() {
    if (m_study != m_openStudy.study())
        begin();
    else
        followView();
    m_wanted.clear();
    const std::vector<std::size_t> all = wantedPlaces();
    std::erase_if(m_made, [&](const auto& made) { return std::ranges::find(all, made.first) == all.end(); });
    for (const std::size_t place : all)
        if (auto request = requestOf(place)) m_wanted.emplace(place, std::move(*request));
    std::erase_if(m_refused, [this](const OtfRequest& request) {
        return std::ranges::none_of(m_wanted, [&](const auto& wanted) { return wanted.second == request; });
    });
    const std::map<std::size_t, OtfRequest> wanted = m_wanted;
    for (const auto& [place, request] : wanted) {
        const auto made = m_made.find(place);
        if (made != m_made.end() && made->second.otf->asked == request) continue;
        // Another place may have this OTF already.
        const auto same = std::ranges::find_if(
            m_made, [&asked = request](const auto& each) { return each.second.otf->asked == asked; });
        if (same != m_made.end())
            give(place, same->second.otf);
        else if (auto found = m_kept.find(request))
            give(place, std::move(found));
    }
}

bool PaneOtfs::refused(const OtfRequest& request) const {
    return std::ranges::find(m_refused, request) != m_refused.end();
}

void PaneOtfs::computeNext() {
    if (m_running) {
        // If the motion goes on, its frame is still computed and kept for the next turn: else a slow designer would
        // finish none. If voxels were cut or quietened since, no frame needs the OTF.
        const bool goesOn = std::ranges::any_of(m_wanted, [this](const auto& wanted) {
            return wanted.second == *m_running || differInVoxelsOnly(wanted.second, *m_running);
        });
        if (goesOn && isOfSomePhase(*m_running)) return;
    }
    for (const std::size_t place : wantedPlaces()) {
        const auto wanted = m_wanted.find(place);
        const auto made = of(place);
        if (wanted == m_wanted.end() || (made && made->asked == wanted->second) || refused(wanted->second)) continue;
        return compute(wanted->second);
    }
    stop();
}

/// Ends the computation: nobody waits for it.
void PaneOtfs::stop() {
    if (!std::exchange(m_running, std::nullopt)) return;
    m_thread.cancel();
    m_thread.setWords({});
}

void PaneOtfs::compute(const OtfRequest& request) {
    m_running = request;
    m_thread.setWords(designing() ? tr("computing the curve") : QString());
    m_thread.submit([this, run = m_run, request](const Progress& progress) -> NewestWinsThread::Deliver {
        QElapsedTimer clock;
        clock.start();
        std::optional<Design> made;
        try {
            made = run(request.config, {*request.raw, *request.shown, request.reduction, request.view, request.method},
                       progress);
        } catch (const std::bad_alloc&) {
            const bool adaptive = std::holds_alternative<AdaptiveConfig>(request.config);
            return [this, request,
                    sentence = adaptive ? tr("The adaptive curve needs more memory than this machine has.")
                                        : tr("The designer needs more memory than this machine has.")] {
                fail(request, sentence);
            };
        }
        if (!made) return {};
        const double milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        return [this, request, made = std::move(*made), milliseconds] { take(request, made, milliseconds); };
    });
}

void PaneOtfs::take(const OtfRequest& request, Design design, double milliseconds) {
    if (m_running != request) return;
    m_running.reset();
    const auto made = std::make_shared<const ComputedOtf>(ComputedOtf{request, std::move(design), milliseconds});
    m_kept.keep(*made);
    const std::map<std::size_t, OtfRequest> wanted = m_wanted;
    for (const auto& [place, asked] : wanted)
        if (asked == request && m_wanted.contains(place) && m_wanted.at(place) == request) give(place, made);
    computeNext();
    emit followed();
}

void PaneOtfs::fail(const OtfRequest& request, const QString& sentence) {
    if (m_running != request) return;
    m_running.reset();
    m_refused.push_back(request);
    const std::map<std::size_t, OtfRequest> wanted = m_wanted;
    for (const auto& [place, asked] : wanted)
        if (asked == request) emit failed(place, sentence);
    computeNext();
    emit followed();
}

void PaneOtfs::give(std::size_t place, std::shared_ptr<const ComputedOtf> otf) {
    const bool byDesigner = place != adaptiveOfScene && designerConfigOf(m_model.document(), place) != nullptr;
    m_made[place] = {std::move(otf), byDesigner};
    emit computed(place);
}

}  // namespace echolucent
