#include "app/picture/panes_saving.h"

#include <memory>
#include <utility>

#include "app/files/save_dialog.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/output/overwriting.h"
#include "io/study/import_report.h"
#include "io/writers/picture_file.h"
#include "widgets/casting/picture_image.h"
#include "widgets/controls/message_bar.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

constexpr const char* panesTopic = "picture of panes";

QRect scaled(const QRect& place, double scale) {
    const QPoint first = (QPointF(place.topLeft()) * scale).toPoint();
    const QPoint end = (QPointF(place.left() + place.width(), place.top() + place.height()) * scale).toPoint();
    return {first, QSize(end.x() - first.x(), end.y() - first.y())};
}

}  // namespace

PanesSaving::PanesSaving(Parts parts)
    : QObject(&parts.window),
      m_parts(std::move(parts)),
      m_writing(m_parts.works, QStringLiteral("picture of panes"), {tr("saving the picture"), Urgency::report}) {}

void PanesSaving::choose() {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    bool planesAreShown = false;
    for (const PlanePane* plane : m_parts.planes) planesAreShown = planesAreShown || plane->isVisible();
    const double ratio = m_parts.panes.devicePixelRatioF();
    PictureDialog dialog({.of3d = m_parts.picture.isVisible() ? m_parts.picture.size() * ratio : QSize(),
                          .ofPanes = m_parts.panes.size() * ratio,
                          .planesAreShown = planesAreShown},
                         &m_parts.window);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, &dialog, &QDialog::reject);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save picture"),
                                           .filter = tr("Pictures (*.png)"),
                                           .name = m_parts.proposedName(QStringLiteral("picture")),
                                           .suffix = QStringLiteral("png"),
                                           .note = QString::fromStdString(burnedInTextNote(*study))});
    if (!path.isEmpty()) save(path, dialog.choice());
}

PanesInPicture PanesSaving::taken(const PictureChoice& choice) const {
    OpenStudy& openStudy = m_parts.openStudy;
    const QuietPhases& quiet = openStudy.quietPhases();
    PanesInPicture panes{.document = m_parts.model.document(),
                         .phases = {.scans = openStudy.study()->phases, .quiet = {}, .reduction = quiet.reduction()},
                         .sides = m_parts.sides.finding()};
    for (int phase = 0; phase < quiet.phaseCount(); ++phase) panes.phases.quiet.push_back(quiet.of(phase));
    const QRect whole = choice.allPanes ? m_parts.panes.rect() : QRect({}, m_parts.picture.size());
    panes.scale = static_cast<double>(choice.width) / std::max(1, whole.width());
    panes.size = scaled(whole, panes.scale).size();
    if (!choice.allPanes) {
        panes.of3d = QRect({}, panes.size);
        return panes;
    }
    if (m_parts.picture.isVisible()) panes.of3d = scaled(m_parts.picture.geometry(), panes.scale);
    const std::shared_ptr<const Volume> voxels =
        panes.document.scene.planes.quiet ? openStudy.newestVoxels() : openStudy.volume();
    for (const PlanePane* plane : m_parts.planes) {
        const std::optional<PlaneRequest> request = plane->wanted(voxels);
        if (!request) continue;
        PlaneInPicture next{scaled(plane->geometry(), panes.scale), *request, plane->greys(),
                            plane->drawings(panes.scale)};
        next.request.columns = next.place.width();
        next.request.rows = next.place.height();
        panes.planes.push_back(std::move(next));
    }
    return panes;
}

void PanesSaving::save(const QString& path, const PictureChoice& choice) {
    if (m_parts.openStudy.study() == nullptr) return;
    const auto say = [this](const QString& sentence) {
        m_parts.messages.showMessage(MessageKind::info, sentence, MessageEnd::soon(panesTopic));
    };
    if (m_writing.busy()) return say(tr("A picture is being written. Wait for it, or cancel it."));
    if (m_parts.shown.held())
        return say(tr("The picture of this study is not there yet, so nothing was saved. Try it again once it is."));
    if (const auto allowed = refuseToOverwrite(m_parts.openStudy.study()->files, {path.toStdString()}); !allowed)
        return tell(path, allowed);
    m_writing.begin(
        path,
        [panes = std::make_shared<const PanesInPicture>(taken(choice)),
         file = path.toStdString()](const Progress& progress) -> Result<void> {
            const std::optional<QImage> image = panesPicture(*panes, progress);
            if (!image || progress.cancelled())
                return fail(FailureKind::cancelled, file, {}, "was not written: cancelled");
            return writePng(file, image->width(), image->height(), rgbBytesOf(*image));
        },
        [this, path](const Result<void>& written) { tell(path, written); });
}

void PanesSaving::tell(const QString& path, const Result<void>& written) {
    const QString name = m_parts.names.nameOfOther(path);
    if (written)
        m_parts.messages.showMessage(MessageKind::info, tr("The picture was saved as %1.").arg(name),
                                     MessageEnd::soon(panesTopic));
    else if (written.error().kind == FailureKind::cancelled)
        m_parts.messages.showMessage(MessageKind::info, cancelledSentence(name), MessageEnd::soon(panesTopic));
    else
        m_parts.messages.showMessage(MessageKind::error, m_parts.names.sentenceOf(written.error()),
                                     MessageEnd::withStudy(panesTopic));
}

}  // namespace echolucent
