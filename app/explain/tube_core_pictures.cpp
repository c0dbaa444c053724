#include "app/explain/tube_core_pictures.h"

#include <new>
#include <utility>

#include "app/explain/newest_run.h"
#include "app/study/freed_elsewhere.h"
#include "app/study/voxels_now.h"
#include "processing/pane_picture/small_picture.h"
#include "widgets/casting/picture_image.h"

namespace echolucent {

namespace {

/// The document with only what pictures of the adaptive curve depend on.
Document pictured(const Document& document, SpeckleReduction reduction) {
    Document next;
    next.study = document.study;
    next.beam = document.beam;
    next.scene = document.scene;
    next.scene.planes = {};
    next.scene.phase = 0;  // the voxels are of one phase already
    next.scene.look.mode = RenderMode::direct;
    next.scene.look.reduction = reduction;
    next.scene.side = {};
    next.curves.adjustment = document.curves.adjustment;
    // At another angle the motion's axis matters: the pose turns about it.
    if (next.scene.motionAngle != 0.0) next.motion = document.motion;
    return next;
}

}  // namespace

std::optional<CurvePictureSource> curvePictureSource(const Document& document, const OpenStudy& openStudy) {
    if (openStudy.study() == nullptr || openStudy.beginning()) return std::nullopt;
    StudyPhases voxels = voxelsNow(openStudy);
    return CurvePictureSource{pictured(document, voxels.reduction), std::move(voxels)};
}

TubeCorePictures::TubeCorePictures(DocumentModel& model, OpenStudy& openStudy, Works& works, const PaneOtfs& otfs,
                                   TubeCorePanel& panel, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_openStudy(openStudy),
      m_works(works),
      m_otfs(otfs),
      m_panel(panel),
      m_work(works, {.countsForRest = false}),
      m_thread(works, QStringLiteral("tube core pictures"), {.countsForRest = false}) {
    connect(&m_works, &Works::changed, this, [this] { m_works.atRest() ? makeNext() : drop(); });
    connect(&m_model, &DocumentModel::changed, this, &TubeCorePictures::follow);
    connect(&m_openStudy, &OpenStudy::volumeChanged, this, &TubeCorePictures::follow);
    connect(&m_openStudy, &OpenStudy::quietVoxelsMade, this, &TubeCorePictures::follow);
    connect(&m_otfs, &PaneOtfs::followed, this, &TubeCorePictures::follow);
    connect(&m_panel, &TubeCorePanel::grownChanged, this, &TubeCorePictures::follow);
}

void TubeCorePictures::setSeen(bool seen) {
    if (std::exchange(m_seen, seen) == seen) return;
    follow();
    if (seen) return;
    m_caster.reset();
    m_cast = {};
}

void TubeCorePictures::setExplanation(std::shared_ptr<const ShownExplanation> explanation) {
    m_explanation = std::move(explanation);
    follow();
}

std::optional<TubeCorePictures::Asked> TubeCorePictures::askedOf(int which) const {
    if (!m_seen || !m_explanation || !isNewestRun(m_otfs, m_explanation->run)) return std::nullopt;
    auto source = curvePictureSource(m_model.document(), m_openStudy);
    if (!source) return std::nullopt;
    const TubeExplanation& explanation = *m_explanation->explanation;
    switch (which) {
        case TubeCorePanel::withAll: return Asked{std::move(*source), explanation.full.curve};
        case TubeCorePanel::without: return Asked{std::move(*source), explanation.without.curve};
        default: return Asked{std::move(*source), m_panel.thirdCurve()};
    }
}

void TubeCorePictures::follow() {
    bool stale = false;
    for (int which = 0; which < TubeCorePanel::pictures; ++which) {
        auto& wanted = m_wanted[static_cast<std::size_t>(which)];
        auto asked = askedOf(which);
        if (which == m_making && asked != wanted) stale = true;
        wanted = std::move(asked);
        auto& made = m_made[static_cast<std::size_t>(which)];
        // An unseen picture keeps no volume that is gone from the window.
        const bool gone = !m_explanation || (!m_seen && made && made->source.voxels != voxelsNow(m_openStudy));
        if (!made || !gone) continue;
        made.reset();
        m_panel.setPicture(static_cast<TubeCorePanel::Picture>(which), {});
    }
    if (stale || !m_seen) drop();
    makeNext();
    m_work.set(next().has_value());
}

std::optional<int> TubeCorePictures::next() const {
    for (int which = 0; which < TubeCorePanel::pictures; ++which) {
        const auto place = static_cast<std::size_t>(which);
        if (m_wanted[place] && m_wanted[place] != m_made[place]) return which;
    }
    return std::nullopt;
}

void TubeCorePictures::makeNext() {
    const std::optional<int> which = next();
    if (!which || m_making || !m_works.atRest()) return;
    m_making = which;
    const Asked& wanted = *m_wanted[static_cast<std::size_t>(*which)];
    if (!m_caster || m_cast != wanted.source.voxels) {
        m_cast = wanted.source.voxels;
        m_caster = freedElsewhere(std::make_shared<PaneCaster>(m_cast));
    }
    m_thread.submit([this, which = *which, asked = wanted,
                     caster = m_caster](const Progress& progress) -> NewestWinsThread::Deliver {
        QImage image;
        try {
            const auto picture = smallPictureWith(*caster, {.curve = asked.curve}, asked.source.document, firstPane,
                                                  TubeCorePanel::pictureWidth, TubeCorePanel::pictureHeight, progress);
            if (!picture) return {};
            image = imageOf(*picture);
        } catch (const std::bad_alloc&) {
            // The 3D view tells of missing memory. A half-made caster is dropped.
            *caster = PaneCaster(asked.source.voxels);
        }
        return [this, which, asked, image] {
            m_making.reset();
            m_made[static_cast<std::size_t>(which)] = asked;
            m_panel.setPicture(static_cast<TubeCorePanel::Picture>(which), image);
            makeNext();
            m_work.set(next().has_value());
        };
    });
}

void TubeCorePictures::drop() {
    m_making.reset();
    m_thread.cancel();
}

}  // namespace echolucent
