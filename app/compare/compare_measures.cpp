#include "app/compare/compare_measures.h"

#include <algorithm>
#include <new>
#include <utility>

#include "app/compare/paper_figures.h"
#include "processing/comparison/plain_frames.h"
#include "processing/designers/choice/designer.h"
#include "processing/motion/flicker.h"
#include "processing/motion/motion_mode.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

CompareMeasures::CompareMeasures(const Parts& parts, const Work& work, QObject* parent)
    : QObject(parent),
      m_model(parts.model),
      m_openStudy(parts.openStudy),
      m_otfs(parts.otfs),
      m_views(parts.views),
      m_player(parts.player),
      m_thread(parts.works, "comparison measures", work),
      m_flickerThread(parts.works, "comparison flicker", work) {
    connect(&m_views, &ComparedViews::frameShown, this, &CompareMeasures::follow);
    connect(&m_views, &ComparedViews::followed, this, &CompareMeasures::follow);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, &CompareMeasures::forgetStudy);
    connect(&m_player, &MotionPlayer::playingChanged, this, &CompareMeasures::follow);
    connect(&m_flickerThread, &NewestWinsThread::busyChanged, this, &CompareMeasures::measuringFlicker);
}

std::optional<CompareMeasures::Asked> CompareMeasures::wanted() const {
    const Document& document = m_model.document();
    if (!m_views.shown() || !isCompared(document) || !m_openStudy.volume()) return std::nullopt;
    if (!m_otfs.isNewest(PaneOtfs::adaptiveOfScene)) return std::nullopt;
    const auto made = m_otfs.of(PaneOtfs::adaptiveOfScene);
    Asked asked{.raw = made->asked.raw,
                .shown = made->asked.shown,
                .reduction = made->asked.reduction,
                .otf = m_otfs.adaptive()};
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        const ShownPane& pane = m_views.paneAt(place);
        if (!pane.newest) return std::nullopt;
        if (pane.voxels != asked.shown) continue;
        asked.classifications.push_back(pane.classification);
        asked.places.push_back(place);
    }
    return asked;
}

void CompareMeasures::follow() {
    if (!m_views.shown()) return;
    const auto asked = wanted();
    // While a motion plays or a hand drags, every frame would ask for other measures.
    if (asked && asked != m_asked && !m_model.previewing() && !m_player.isPlaying()) {
        m_asked = asked;
        m_thread.submit([this, asked = *asked](const Progress& progress) -> NewestWinsThread::Deliver {
            std::optional<std::vector<ClassificationMeasures>> measures;
            try {
                measures = measuresOf(*asked.shown, *asked.otf, asked.classifications, progress);
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
    const bool measured = asked && asked == m_measured;
    const bool flickers = m_flickerOf && m_flickerOf == flickerWanted(asked);
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        CompareRow row{.name = captionOfPane(document, place)};
        m_views.addTimes(place, row);
        for (std::size_t i = 0; measured && i < asked->places.size(); ++i) {
            if (asked->places[i] != place || m_measures[i].light.rays == 0) continue;
            row.contrast = m_measures[i].contrast.contrastToNoise();
            row.nearSurfaces = m_measures[i].light.meanShare;
        }
        if (flickers && m_flickers.contains(place)) row.flicker = m_flickers.at(place);
        rows.push_back(row);
    }
    if (rows == m_rows) return;
    m_rows = rows;
    m_views.setRows(m_rows);
    emit rowsChanged(m_rows);
}

std::optional<CompareMeasures::FlickerAsked> CompareMeasures::flickerWanted(const std::optional<Asked>& asked) const {
    if (!asked) return std::nullopt;
    const Document& document = m_model.document();
    const bool motionsCompared =
        std::ranges::any_of(document.panes, [](const Pane& pane) { return pane.motionOtf.has_value(); });
    FlickerAsked flicker{.raw = asked->raw, .shown = asked->shown, .reduction = asked->reduction};
    flicker.start = motionStartOf(document);
    flicker.axis = document.motion.axis;
    flicker.adjustment = document.curves.adjustment;
    for (const std::size_t place : asked->places) {
        FlickeringPane pane{.place = place, .config = AdaptiveConfig{}, .method = configOf(document, place)};
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
        auto made = design(pane.config, {*asked.raw, *asked.shown, asked.reduction, frame.view, pane.method}, silent);
        if (!made) return std::nullopt;
        if (const auto* curve = std::get_if<SampledCurve>(&made->classification.curve()))
            made->classification = history.add(frame.time, *curve);
        classifications.push_back(adjustedClassification(made->classification, asked.adjustment));
    }
    const std::vector shown{asked.shown};
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
