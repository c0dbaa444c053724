#include "app/compare/compare_measures.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "app/compare/paper_figures.h"
#include "processing/comparison/plain_frames.h"
#include "processing/designers/choice/designer.h"
#include "processing/median.h"
#include "processing/motion/flicker.h"
#include "processing/motion/motion_mode.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

namespace {

/// The median wall time of a designer, ms: of CompareMeasures::timedRuns runs, or of the first that takes long. No
/// value if the work was cancelled.
std::optional<double> medianTimeOf(const OtfRequest& asked, const Progress& progress) {
    std::vector<double> times;
    for (int run = 0; run < CompareMeasures::timedRuns; ++run) {
        const auto begun = std::chrono::steady_clock::now();
        if (!design(asked.config, {*asked.raw, *asked.shown, asked.reduction, asked.view, asked.method}, progress))
            return std::nullopt;
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
        if (times.back() >= CompareMeasures::retimedBelow) return times.back();
    }
    return medianOf(std::move(times));
}

}  // namespace

CompareMeasures::CompareMeasures(const Parts& parts, const Work& work, QObject* parent)
    : QObject(parent),
      m_model(parts.model),
      m_openStudy(parts.openStudy),
      m_otfs(parts.otfs),
      m_views(parts.views),
      m_player(parts.player),
      m_surfaces(parts.surfaces),
      m_thread(parts.works, "comparison measures", work),
      m_flickerThread(parts.works, "comparison flicker", work) {
    connect(&m_views, &ComparedViews::frameShown, this, &CompareMeasures::follow);
    connect(&m_views, &ComparedViews::followed, this, &CompareMeasures::follow);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, &CompareMeasures::forgetStudy);
    connect(&m_player, &MotionPlayer::playingChanged, this, &CompareMeasures::follow);
    // A drag has ended: nothing else tells, if the last preview was the result.
    connect(&m_model.steps(), &DocumentSteps::changed, this, &CompareMeasures::follow);
    connect(&m_flickerThread, &NewestWinsThread::busyChanged, this, &CompareMeasures::measuringFlicker);
}

std::optional<CompareMeasures::Asked> CompareMeasures::wanted() const {
    const Document& document = m_model.document();
    if (!m_views.shown() || !isCompared(document) || !m_openStudy.volume()) return std::nullopt;
    Asked asked{.source = surfaceSourceOf(document)};
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        const ShownPane& pane = m_views.paneAt(place);
        if (!pane.newest || !pane.voxels || !pane.measured) return std::nullopt;
        asked.panes.push_back({.raw = pane.measured, .shown = pane.voxels, .classification = pane.classification});
        if (const auto otf = m_otfs.of(place); otf && m_otfs.isNewest(place)) asked.panes.back().otf = otf->asked;
    }
    return asked;
}

/// What is known of the times of the panes' OTFs: those that are measured, and those that took so long that their one
/// run counts.
std::vector<CompareMeasures::TimedOtf> CompareMeasures::timedBefore(const Asked& asked) const {
    std::vector<TimedOtf> timed;
    for (std::size_t place = 0; place < asked.panes.size(); ++place) {
        const auto& otf = asked.panes[place].otf;
        if (!otf) continue;
        if (const auto made = m_otfs.of(place); made && made->milliseconds >= retimedBelow)
            timed.push_back({*otf, made->milliseconds});
        for (std::size_t i = 0; m_measured && i < m_measured->panes.size(); ++i)
            if (m_measures[i].milliseconds && m_measured->panes[i].otf == otf)
                timed.push_back({*otf, *m_measures[i].milliseconds});
    }
    return timed;
}

std::optional<std::vector<CompareMeasures::Measured>> CompareMeasures::measured(const Asked& asked,
                                                                                const std::vector<TimedOtf>& timed,
                                                                                KeptSurfaces& kept,
                                                                                const Progress& progress) {
    std::vector<Measured> all(asked.panes.size());
    const Progress silent{{}, progress.cancel};
    std::vector<bool> done(asked.panes.size(), false);
    for (std::size_t first = 0; first < asked.panes.size(); ++first) {
        if (done[first]) continue;
        // Panes of one phase share its surfaces and samples.
        const AskedPane& one = asked.panes[first];
        std::vector<std::size_t> places;
        std::vector<Classification> classifications;
        for (std::size_t place = first; place < asked.panes.size(); ++place)
            if (asked.panes[place].raw == one.raw && asked.panes[place].shown == one.shown) {
                done[place] = true;
                places.push_back(place);
                classifications.push_back(asked.panes[place].classification);
            }
        const auto surfaces = kept.of(asked.source, one.raw, silent);
        if (!surfaces) return std::nullopt;
        const auto measures = measuresOf(*one.shown, asked.source.view, surfaces->rays, classifications, silent);
        if (!measures) return std::nullopt;
        if (surfaces->rays.empty()) continue;
        const double unit = one.raw->geometry().unit();
        const auto rectangles = std::make_shared<const SurfaceRectangles>(
            SurfaceRectangles{surfaces->rays,
                              frameOf(asked.source.view),
                              {surfaces->apartUnits[0] * unit, surfaces->apartUnits[1] * unit}});
        for (std::size_t i = 0; i < places.size(); ++i) {
            all[places[i]].measures = {surfaces->from, (*measures)[i]};
            all[places[i]].colours =
                std::make_shared<const ColouredRays>(ColouredRays{rectangles, (*measures)[i].shown});
        }
    }
    for (std::size_t place = 0; place < asked.panes.size(); ++place) {
        const auto& otf = asked.panes[place].otf;
        if (!otf) continue;
        const auto known = std::ranges::find(timed, *otf, &TimedOtf::otf);
        const auto milliseconds =
            known != timed.end() ? std::optional(known->milliseconds) : medianTimeOf(*otf, silent);
        if (!milliseconds) return std::nullopt;
        all[place].milliseconds = milliseconds;
    }
    return all;
}

void CompareMeasures::follow() {
    if (!m_views.shown()) return;
    const auto asked = wanted();
    // While a motion plays or a hand drags, every frame would ask for other measures.
    if (asked && asked != m_asked && !m_model.previewing() && !m_player.isPlaying()) {
        m_asked = asked;
        m_thread.submit(
            [this, asked = *asked, timed = timedBefore(*asked)](const Progress& progress) -> NewestWinsThread::Deliver {
                std::optional<std::vector<Measured>> measures;
                try {
                    measures = measured(asked, timed, m_surfaces, progress);
                } catch (const std::bad_alloc&) {
                    return [this] { fail(); };
                }
                if (!measures) return {};
                return [this, asked, measures = std::move(*measures)] {
                    m_measured = asked;
                    m_measures = measures;
                    showMeasured();
                };
            });
    }
    showRows(asked);
}

void CompareMeasures::fail() { emit failed(tr("Measuring the panes needs more memory than this machine has.")); }

void CompareMeasures::showRows(const std::optional<Asked>& asked) {
    const Document& document = m_model.document();
    std::vector<CompareRow> rows;
    const bool known = asked && asked == m_measured;
    const bool flickers = m_flickerOf && m_flickerOf == flickerWanted(asked);
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        CompareRow row{.name = captionOfPane(document, place)};
        m_views.addTime(place, row);
        if (known) {
            row.designMilliseconds = m_measures[place].milliseconds;
            if (const auto& measured = m_measures[place].measures) {
                row.surfaces = measured->from;
                row.depth = measured->measures.depth;
                row.contrast = measured->measures.contrast.contrastToNoise();
                row.nearSurfaces = measured->measures.light.meanShare;
            }
        }
        if (flickers && m_flickers.contains(place)) row.flicker = m_flickers.at(place);
        rows.push_back(row);
    }
    showColours(known);
    if (rows == m_rows) return;
    m_rows = rows;
    m_views.setRows(m_rows);
    emit rowsChanged(m_rows);
}

void CompareMeasures::showColours(bool known) {
    std::vector<std::shared_ptr<const ColouredRays>> colours;
    if (known && m_model.document().comparison.colours && !m_model.previewing() && !m_player.isPlaying())
        for (const Measured& measured : m_measures) colours.push_back(measured.colours);
    m_views.setColours(colours);
}

std::optional<CompareMeasures::FlickerAsked> CompareMeasures::flickerWanted(const std::optional<Asked>& asked) const {
    if (!asked) return std::nullopt;
    const Document& document = m_model.document();
    const bool motionsCompared =
        std::ranges::any_of(document.panes, [](const Pane& pane) { return pane.motionOtf.has_value(); });
    FlickerAsked flicker{.start = motionStartOf(document)};
    flicker.axis = document.motion.axis;
    flicker.adjustment = document.curves.adjustment;
    for (std::size_t place = 0; place < asked->panes.size(); ++place) {
        const AskedPane& one = asked->panes[place];
        FlickeringPane pane{.place = place,
                            .config = AdaptiveConfig{},
                            .raw = one.raw,
                            .shown = one.shown,
                            .method = configOf(document, place)};
        if (pane.shown != pane.raw) pane.reduction = document.scene.look.reduction;
        const DesignerConfig* config = designerConfigOf(document, place);
        if (config != nullptr) pane.config = *config;
        const bool changes =
            config != nullptr ? readsTubeCores(*config) : document.panes[place].curve == CurveKind::adaptive;
        const MotionOtf mode = document.panes[place].motionOtf.value_or(document.motion.otf);
        // If no pane has a motionOtf of its own, the flicker tells what an OTF for each view would do.
        pane.steady = !changes || (mode == MotionOtf::oneOtf && motionsCompared);
        if (!pane.steady) pane.smoothing = smoothingOf(mode).value_or(OtfSmoothing::none);
        flicker.panes.push_back(std::move(pane));
    }
    return flicker;
}

/// No value if the work was cancelled.
std::optional<double> CompareMeasures::flickerOf(const FlickerAsked& asked, const FlickeringPane& pane,
                                                 const Progress& progress) {
    if (pane.steady) return 0.0;  // one OTF for all frames does not flicker
    const std::vector<SweepFrame> frames =
        sweepFrames(asked.start, asked.axis, -flickerDegrees, flickerDegrees, flickerStep, 1);
    const Progress silent{{}, progress.cancel};
    OtfHistory history(pane.smoothing);
    std::vector<Classification> classifications;
    for (const SweepFrame& frame : frames) {
        auto made = design(pane.config, {*pane.raw, *pane.shown, pane.reduction, frame.view, pane.method}, silent);
        if (!made) return std::nullopt;
        if (const auto* curve = std::get_if<SampledCurve>(&made->classification.curve()))
            made->classification = history.add(frame.time, *curve);
        classifications.push_back(adjustedClassification(made->classification, asked.adjustment));
    }
    const std::vector shown{pane.shown};
    const auto flicker =
        pictureFlicker(frames, classifications, plainFrameRenderer(shown, flickerRaySpacing, silent), progress);
    return flicker ? std::optional(flicker->flicker) : std::nullopt;
}

void CompareMeasures::measureFlicker() {
    const auto asked = flickerWanted(wanted());
    if (!asked) return;
    m_flickerThread.submit([this, asked = *asked](const Progress& progress) -> NewestWinsThread::Deliver {
        std::map<std::size_t, double> flickers;
        try {
            for (const FlickeringPane& pane : asked.panes) {
                const auto flicker = flickerOf(asked, pane, progress);
                if (!flicker) return {};
                flickers[pane.place] = *flicker;
            }
        } catch (const std::bad_alloc&) {
            return [this] { fail(); };
        }
        return [this, asked, flickers] {
            m_flickerOf = asked;
            m_flickers = flickers;
            showMeasured();
        };
    });
}

/// Forgets all requests and measures of the study before, and with them its voxels.
void CompareMeasures::forgetStudy() {
    cancel();
    m_asked.reset();
    m_measured.reset();
    m_measures.clear();
    m_flickerOf.reset();
    m_flickers.clear();
}

void CompareMeasures::cancel() {
    m_thread.cancel();
    m_flickerThread.cancel();
}

}  // namespace echolucent
