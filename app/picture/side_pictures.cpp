#include "app/picture/side_pictures.h"

#include <new>
#include <utility>

#include "processing/document/preset.h"
#include "processing/document/side_taking.h"
#include "processing/pane_picture/small_picture.h"
#include "widgets/casting/picture_image.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

/// What pictures of sides show of a document: its beam, and how its first pane is made. No designer is asked: the
/// pane's curve stands in for its OTF.
Document seenInStrip(const Document& document) {
    Document shown;
    shown.beam = document.beam;
    shown = withPreset(std::move(shown), firstPane, presetOf(document, firstPane, {}));
    shown.scene.look.reduction = SpeckleReduction::off;  // nobody sees it at this size
    return shown;
}

}  // namespace

SidePictures::SidePictures(const DocumentModel& model, const StudySides& sides, const VolumeViewWidget& picture,
                           Works& works, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_sides(sides),
      m_works(works),
      m_thread(works, QStringLiteral("pictures of sides"), {.countsForRest = false}) {
    connect(&m_sides, &StudySides::changed, this, [this] {
        if (m_volume != m_sides.volume()) m_shown = false;
        m_volume = m_sides.volume();
        stop();
        m_images = {};
        emit changed();
        follow();
    });
    connect(&picture, &VolumeViewWidget::pictureDelivered, this, [this] {
        if (std::exchange(m_shown, true)) return;
        follow();
    });
    connect(&m_works, &Works::changed, this, [this] {
        if (m_works.atRest()) return follow();
        const bool complete = !m_images.back().isNull();
        if (complete && m_thread.busy()) stop();
    });
}

void SidePictures::setSeen(bool seen) {
    if (seen == m_seen) return;
    m_seen = seen;
    seen ? follow() : stop();
}

void SidePictures::stop() {
    if (m_thread.busy() || m_images.back().isNull()) m_asked.reset();
    m_thread.cancel();
}

std::optional<SidePictures::Asked> SidePictures::wanted() const {
    if (!m_seen || !m_shown || !m_sides.finding()) return std::nullopt;
    return Asked{m_sides.finding(), seenInStrip(m_model.document())};
}

void SidePictures::follow() {
    auto asked = wanted();
    if (!asked || asked == m_asked) return;
    m_asked = std::move(asked);
    m_thread.submit(
        [this, asked = *m_asked, volume = m_sides.volume()](const Progress& progress) -> NewestWinsThread::Deliver {
            try {
                PaneCaster caster(StudyPhases{.scans = {volume}});
                for (std::size_t i = 0; i < std::tuple_size_v<Images>; ++i) {
                    const Document document =
                        withSideTaken(asked.document, asked.sides->sides[i], volume->dataBox(), double{width} / height);
                    const auto picture = smallPicture(caster, document, firstPane, width, height, progress);
                    if (!picture) return {};
                    m_thread.deliverMeanwhile([this, i, image = imageOf(*picture)] {
                        m_images[i] = image;
                        emit changed();
                    });
                }
                return {};
            } catch (const std::bad_alloc&) {
                return {};  // the strip shows the names alone, and the 3D view tells of missing memory
            }
        });
}

}  // namespace echolucent
