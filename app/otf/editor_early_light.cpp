#include "app/otf/editor_early_light.h"

#include <new>
#include <utility>

#include "widgets/controls/message_bar.h"
#include "widgets/otf_editor/otf_editor.h"

namespace echolucent {

namespace {
constexpr const char* earlyLightTopic = "early light";
}  // namespace

EditorEarlyLight::EditorEarlyLight(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_thread(parts.works, "early light", {.words = tr("measuring early light"), .urgency = Urgency::comparing}) {
    connect(&m_parts.editor, &OtfEditor::earlyLightSwitched, this, &EditorEarlyLight::follow);
    connect(&m_parts.panes, &ShownPanes::changed, this, &EditorEarlyLight::follow);
    // A drag has ended: nothing else tells, if the last preview was the result.
    connect(&m_parts.model.steps(), &DocumentSteps::changed, this, &EditorEarlyLight::follow);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &EditorEarlyLight::forgetStudy);
}

void EditorEarlyLight::setSeen(bool seen) {
    m_seen = seen;
    follow();
}

std::optional<EditorEarlyLight::Asked> EditorEarlyLight::wanted() const {
    if (!m_seen || !m_parts.editor.showsEarlyLight() || !m_parts.openStudy.volume()) return std::nullopt;
    const ShownPane& pane = m_parts.panes.at(firstPane);
    if (!pane.newest || !pane.voxels || !pane.measured) return std::nullopt;
    return Asked{surfaceSourceOf(m_parts.model.document()), pane.measured, pane.voxels, pane.classification};
}

void EditorEarlyLight::follow() {
    const auto asked = wanted();
    const bool atRest = !m_parts.model.previewing() && !m_parts.panes.playing();
    if (!asked) {
        if (std::exchange(m_asked, std::nullopt)) m_thread.cancel();
    } else if (atRest && asked != m_asked && !(m_measured && m_measured->asked == asked)) {
        measure(*asked);
    }
    const bool known = asked && atRest && m_measured && m_measured->asked == *asked;
    m_parts.editor.setEarlyLight(known ? std::optional(m_measured->light) : std::nullopt);
}

void EditorEarlyLight::measure(const Asked& asked) {
    m_asked = asked;
    m_thread.submit([this, asked](const Progress& progress) -> NewestWinsThread::Deliver {
        std::optional<EarlyLight> light;
        try {
            const Progress silent{{}, progress.cancel};
            const auto surfaces = m_parts.surfaces.of(asked.source, asked.raw, silent);
            if (!surfaces) return {};
            light = earlyLightOf(*asked.shown, asked.source.view, surfaces->rays, asked.classification, silent);
        } catch (const std::bad_alloc&) {
            return [this] {
                m_parts.messages.showMessage(MessageKind::error,
                                             tr("Measuring early light needs more memory than this machine has."),
                                             MessageEnd::withStudy(earlyLightTopic));
            };
        }
        if (!light) return {};
        return [this, measured = Measured{asked, *light}] {
            m_measured = measured;
            m_parts.messages.takeBack(earlyLightTopic);
            follow();
        };
    });
}

/// Forgets the study before, and with it its voxels.
void EditorEarlyLight::forgetStudy() {
    m_thread.cancel();
    m_asked.reset();
    m_measured.reset();
    follow();
}

}  // namespace echolucent
