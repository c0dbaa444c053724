#include "app/picture/panes_saving.h"

#include <QBuffer>
#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "app/files/save_dialog.h"
#include "app/otf/shown_panes.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/output/atomic_file.h"
#include "io/output/overwriting.h"
#include "io/study/import_report.h"
#include "processing/motion/motion_mode.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/controls/message_bar.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

constexpr const char* panesTopic = "picture of panes";
constexpr double plainDotsPerInch = 96.0;  ///< of a plain screen
constexpr double metresPerInch = 0.0254;

/// Writes a PNG that a printer makes as large as its dots per inch say.
Result<void> writePicture(const std::string& file, QImage image, double dotsPerInch) {
    const int dotsPerMetre = qRound(dotsPerInch / metresPerInch);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    if (!image.save(&bytes, "PNG")) throw std::bad_alloc();  // nothing else ends it in memory
    return writeFileAtomically(file, bytes.data().toStdString());
}

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
    const bool compares = m_parts.compared.isVisible();
    if (!m_parts.panes.isVisible() && !compares) return;
    const Document& document = m_parts.model.document();
    const bool isSmoothed = needsComputedOtf(document, firstPane) && designerConfigOf(document, firstPane) == nullptr &&
                            smoothingOf(document.motion.otf).value_or(OtfSmoothing::none) != OtfSmoothing::none;
    bool planesAreShown = compares;
    for (const PlanePane* plane : m_parts.planes) planesAreShown = planesAreShown || plane->isVisible();
    const QWidget& panes = compares ? static_cast<const QWidget&>(m_parts.compared) : m_parts.panes;
    const double ratio = panes.devicePixelRatioF();
    PictureDialog dialog(
        {.of3d = m_parts.picture.isVisible() ? m_parts.picture.size() * ratio : QSize(),
         .ofPanes = panes.size() * ratio,
         .planesAreShown = planesAreShown,
         .note = isSmoothed && !compares ? tr("The 3D picture gets the curve of its own volume and view. A motion "
                                              "also smooths curves over time; this picture does not.")
                                         : QString()},
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
                         .sides = m_parts.sides.finding(),
                         .curveIsTold = m_parts.settings.face() == Face::teach,
                         .remembered = m_parts.rememberedSide()};
    for (int phase = 0; phase < quiet.phaseCount(); ++phase) panes.phases.quiet.push_back(quiet.of(phase));
    const bool compares = m_parts.compared.isVisible();
    const QRect whole = compares          ? m_parts.compared.rect()
                        : choice.allPanes ? m_parts.panes.rect()
                                          : QRect({}, m_parts.picture.size());
    panes.scale = static_cast<double>(choice.width) / std::max(1, whole.width());
    panes.size = scaled(whole, panes.scale).size();
    panes.words = std::max(1.0, choice.dotsPerInch / plainDotsPerInch / panes.scale);
    if (compares) {
        panes.letters = m_parts.compared.font();
        const std::vector<PaneFace> faces = m_parts.compared.faces();
        const std::vector<std::size_t> shown = m_parts.compared.shownPanes();
        const std::vector<QRect> places = placesOfPanes(std::max<std::size_t>(1, shown.size()), panes.size);
        for (std::size_t i = 0; i < shown.size(); ++i)
            panes.compared.push_back(
                {places[i], shown[i], faces.at(shown[i]), m_parts.otfs.at(shown[i]).classification});
        // The colours of shown depths belong to the pictures of the screen.
        for (ComparedInPicture& each : panes.compared) {
            each.face.legend.clear();
            each.face.coloured = false;
        }
        return panes;
    }
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
                            plane->drawings(panes.scale, panes.words)};
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
    const bool compares = m_parts.compared.isVisible();
    const QWidget& shown = compares          ? static_cast<const QWidget&>(m_parts.compared)
                           : choice.allPanes ? static_cast<const QWidget&>(m_parts.panes)
                                             : m_parts.picture;
    const QSize whole = shown.size();
    const bool isShown = shown.isVisible();
    if (!isShown || whole.isEmpty() || choice.width < 1)
        return say(tr("No pane is shown that could be saved, so nothing was saved."));
    const double height = static_cast<double>(choice.width) / whole.width() * whole.height();
    if (choice.width > PictureDialog::longestEdge || height > PictureDialog::longestEdge)
        return say(tr("No edge of a picture may have more than %1 pixels, so nothing was saved.")
                       .arg(PictureDialog::longestEdge));
    if (const auto allowed = refuseToOverwrite(m_parts.openStudy.study()->files, {path.toStdString()}); !allowed)
        return tell(path, allowed);
    m_writing.begin(
        path,
        [panes = std::make_shared<const PanesInPicture>(taken(choice)),
         dotsPerInch = choice.dotsPerInch > 0 ? choice.dotsPerInch : plainDotsPerInch,
         file = path.toStdString()](const Progress& progress) -> Result<void> {
            const std::optional<QImage> image = panesPicture(*panes, progress);
            if (!image || progress.cancelled())
                return fail(FailureKind::cancelled, file, {}, "was not written: cancelled");
            return writePicture(file, *image, dotsPerInch);
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
