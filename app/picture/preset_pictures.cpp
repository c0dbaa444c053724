#include "app/picture/preset_pictures.h"

#include <algorithm>
#include <new>
#include <utility>

#include "app/study/freed_elsewhere.h"
#include "app/study/voxels_now.h"
#include "processing/pane_picture/small_picture.h"
#include "widgets/casting/picture_image.h"

namespace echolucent {

namespace {

/// Keeps only the parts of the document that pictures of one view depend on, so that other changes ask for no picture.
/// A picture depends on the rendered curve. The adaptive curve depends on the curve with which the method begins.
Document pictured(Document document) {
    document.scene.planes = {};
    document.panes.resize(1);
    document.comparison = {};
    document.measurements = {};
    document.scene.phase = 0;  // the voxels are of one phase already
    document.panes.at(firstPane).phase.reset();
    // At another angle the motion's axis matters: the pose turns about it.
    if (document.scene.motionAngle == 0.0) document.motion = {};
    const Preset rendered = presetOf(document, firstPane, {});
    document.curves = rendered.curves;
    document.panes.at(firstPane).linear.reset();
    if (document.scene.look.mode != RenderMode::direct) {
        document.curves = {};
        document.method = {};
        document.scene.side = {};
        document.panes.at(firstPane).curve = CurveKind::adaptive;
        document.panes.at(firstPane).designer.reset();
    }
    return document;
}

}  // namespace

PresetPictures::PresetPictures(DocumentModel& model, OpenStudy& openStudy, Works& works, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_openStudy(openStudy),
      m_works(works),
      m_wanted(works, {.countsForRest = false}),
      m_thread(works, QStringLiteral("preset pictures"), {.countsForRest = false}) {
    connect(&m_works, &Works::changed, this, &PresetPictures::followRest);
    connect(&m_model, &DocumentModel::changed, this, &PresetPictures::follow);
    connect(&m_openStudy, &OpenStudy::volumeChanged, this, &PresetPictures::follow);
    connect(&m_openStudy, &OpenStudy::volumeCut, this, &PresetPictures::follow);
    connect(&m_openStudy, &OpenStudy::quietVoxelsMade, this, &PresetPictures::follow);
}

void PresetPictures::setPresets(std::vector<Preset> presets) {
    std::vector<Entry> before = std::exchange(m_entries, {});
    for (Preset& preset : presets) {
        const auto known = std::ranges::find(before, preset, &Entry::preset);
        if (known != before.end())
            m_entries.push_back(std::move(*known));
        else
            m_entries.push_back({std::move(preset), {}, {}, {}});
    }
    follow();
}

void PresetPictures::setSeen(bool seen) {
    if (seen == m_seen) return;
    m_seen = seen;
    follow();
    if (seen) return;
    m_caster.reset();
    m_cast = {};
}

void PresetPictures::followRest() { m_works.atRest() ? makeNext() : drop(); }

QImage PresetPictures::picture(int index) const { return m_entries.at(static_cast<std::size_t>(index)).picture; }

std::optional<PresetPictures::Asked> PresetPictures::askedOf(const Preset& preset) const {
    Asked asked{pictured(withPreset(m_model.document(), firstPane, preset)), voxelsNow(m_openStudy)};
    if (asked.voxels.scans.empty()) return std::nullopt;
    asked.document.scene.look.reduction = asked.voxels.reduction;
    return asked;
}

void PresetPictures::follow() {
    for (Entry& entry : m_entries) {
        entry.wanted = m_seen ? askedOf(entry.preset) : std::nullopt;
        // An unseen picture keeps no volume that is gone from the window.
        if (!m_seen && entry.made && entry.made->voxels != voxelsNow(m_openStudy)) entry.made.reset();
    }
    const bool current =
        std::ranges::any_of(m_entries, [this](const Entry& entry) { return m_making && entry.wanted == m_making; });
    if (!m_seen || !current) drop();
    makeNext();
    m_wanted.set(next() >= 0);
}

int PresetPictures::next() const {
    if (!m_seen) return -1;
    const auto found =
        std::ranges::find_if(m_entries, [](const Entry& entry) { return entry.wanted && entry.wanted != entry.made; });
    return found == m_entries.end() ? -1 : static_cast<int>(found - m_entries.begin());
}

void PresetPictures::makeNext() {
    const int index = next();
    if (index < 0 || m_making || !m_works.atRest()) return;
    m_making = m_entries[static_cast<std::size_t>(index)].wanted;
    if (!m_caster || m_cast != m_making->voxels) {
        m_cast = m_making->voxels;
        m_caster = freedElsewhere(std::make_shared<PaneCaster>(m_cast));
    }
    m_thread.submit(
        [this, asked = *m_making, caster = m_caster](const Progress& progress) -> NewestWinsThread::Deliver {
            QImage image;
            try {
                const auto picture = smallPicture(*caster, asked.document, firstPane, width, height, progress);
                if (!picture) return {};
                image = imageOf(*picture);
            } catch (const std::bad_alloc&) {
                // The gallery shows the name alone, and the 3D view tells of missing memory. A half-made caster is
                // dropped.
                *caster = PaneCaster(asked.voxels);
            }
            return [this, asked, image] { take(asked, image); };
        });
}

void PresetPictures::drop() {
    m_making.reset();
    m_thread.cancel();
}

void PresetPictures::take(const Asked& asked, const QImage& picture) {
    m_making.reset();
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        Entry& entry = m_entries[i];
        if (entry.wanted != asked || entry.made == asked) continue;
        entry.made = asked;
        entry.picture = picture;
        emit made(static_cast<int>(i));
    }
    makeNext();
    m_wanted.set(next() >= 0);
}

}  // namespace echolucent
