#include "app/explain/tube_core_page.h"

#include <QApplication>
#include <string>
#include <utility>

#include "app/explain/newest_run.h"
#include "app/explain/tube_core_explaining.h"
#include "app/files/save_dialog.h"
#include "app/pages/explanation_page.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/output/atomic_file.h"
#include "processing/pane_picture/small_picture.h"
#include "widgets/controls/message_bar.h"

namespace echolucent {

namespace {

constexpr const char* pageTopic = "tube core page";
constexpr int pageWidth = 320, pageHeight = 240;  // of a picture, pixels

Result<void> writePage(const std::string& file, ExplanationPage page, const ShownExplanation& shown,
                       const CurvePictureSource& source, const Progress& progress) {
    const TubeExplanation& explanation = *shown.explanation;
    PaneCaster caster(source.voxels);
    for (const auto& [curve, caption] : {std::pair(&explanation.full.curve, TubeCorePage::tr("All tube cores")),
                                         std::pair(&explanation.without.curve, TubeCorePage::tr("Without this one")),
                                         std::pair(&explanation.alone.curve, TubeCorePage::tr("This one alone"))}) {
        auto picture =
            smallPictureWith(caster, {.curve = *curve}, source.document, firstPane, pageWidth, pageHeight, progress);
        if (!picture) return fail(FailureKind::cancelled, file, {}, "was not written: cancelled");
        page.pictures.emplace_back(std::move(*picture), caption.toStdString());
    }
    return writeFileAtomically(file, explanationPage(page, explanation, *shown.run));
}

}  // namespace

TubeCorePage::TubeCorePage(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_writing(parts.works, "tube core page", {.words = tr("saving the page"), .urgency = Urgency::saving}) {}

void TubeCorePage::choose() {
    const auto shown = m_parts.explaining.explanation();
    if (!shown) return;
    const QString what = QStringLiteral("tube-core-%1").arg(shown->explanation->number);
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save page"),
                                           .filter = tr("Pages (*.html)"),
                                           .name = m_parts.proposedName(what),
                                           .suffix = QStringLiteral("html")});
    if (!path.isEmpty()) save(path);
}

void TubeCorePage::save(const QString& path) {
    const auto shown = m_parts.explaining.explanation();
    const auto source = curvePictureSource(m_parts.model.document(), m_parts.openStudy);
    if (!shown || !source || m_writing.busy()) return;
    if (!isNewestRun(m_parts.otfs, shown->run))
        return m_parts.messages.showMessage(
            MessageKind::info,
            tr("The newest curve is not explained yet, so no page was saved. Try it again once it is."),
            MessageEnd::soon(pageTopic));
    const OpenStudy& study = m_parts.openStudy;
    const auto raw = m_parts.otfs.of(PaneOtfs::adaptiveOfScene)->asked.raw;
    const QString scan =
        m_parts.openStudy.isSimulatedScan() ? tr("simulated scan") : m_parts.names.nameOf(m_parts.openStudy.path());
    const ExplanationPage page{.scan = scan.toStdString(),
                               .program = tr("Echolucent %1").arg(QApplication::applicationVersion()).toStdString(),
                               .lighting = source->document.scene.look.lighting,
                               .phase = study.phaseOfVoxels(*raw).value_or(study.phase()),
                               .phases = static_cast<int>(study.study()->phases.size())};
    m_writing.begin(
        path,
        [file = path.toStdString(), page, shown, source = *source](const Progress& progress) {
            return writePage(file, page, *shown, source, Progress{{}, progress.cancel});
        },
        [this, path](const Result<void>& written) {
            if (written)
                m_parts.messages.showMessage(MessageKind::info,
                                             tr("The page was saved as %1.").arg(m_parts.names.nameOfOther(path)),
                                             MessageEnd::soon(pageTopic));
            else if (written.error().kind != FailureKind::cancelled)
                m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(written.error().sentence()),
                                             MessageEnd::withStudy(pageTopic));
        });
}

}  // namespace echolucent
