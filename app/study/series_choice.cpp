#include "app/study/series_choice.h"

#include <new>
#include <utility>

#include "app/study/study_names.h"
#include "io/restricted/restricted_reader.h"
#include "widgets/dialogs/series_dialog.h"

namespace echolucent {

namespace {

SeriesRow rowOf(const SeriesEntry& entry, std::size_t number, const StudyNames& names) {
    SeriesRow row;
    row.title = entry.description.empty() || names.showsNumbers() ? SeriesChoice::tr("Series %1").arg(number)
                                                                  : QString::fromStdString(entry.description);
    const QString modality = entry.modality.empty() ? QString() : QString::fromStdString(entry.modality) + ", ";
    row.facts =
        modality + (entry.multiframe ? SeriesChoice::tr("%1 × %2, %3 frames") : SeriesChoice::tr("%1 × %2, %3 slices"))
                       .arg(entry.size[0])
                       .arg(entry.size[1])
                       .arg(entry.size[2]);
    if (entry.phases.count > 1) row.facts += SeriesChoice::tr(", %1 volumes").arg(entry.phases.count);
    if (!entry.distinction.empty()) row.facts += QStringLiteral(", ") + QString::fromStdString(entry.distinction);
    if (!entry.whyNot) return row;
    row.openable = entry.whyNot->framesCouldBeSlices;
    Failure shown = *entry.whyNot;
    shown.file.clear();
    if (shown.element.empty()) shown.element = SeriesChoice::tr("The series").toStdString();
    if (row.openable)
        shown.remedy =
            SeriesChoice::tr(
                "Opened, its pictures are taken as slices; their distance stays unknown unless the file states it.")
                .toStdString();
    row.hindrance = names.shownOfFile(QString::fromStdString(shown.sentence()));
    return row;
}

}  // namespace

SeriesChoice::SeriesChoice(QWidget& window, StudyNames& names, Works& works)
    : QObject(&window), m_window(window), m_names(names), m_pictures(works, QStringLiteral("pictures of series")) {}

void SeriesChoice::ask(const std::shared_ptr<const SeriesList>& list, std::function<void(std::size_t)> chosen) {
    delete m_dialog;
    QList<SeriesRow> rows;
    for (const SeriesEntry& entry : list->series)
        rows << rowOf(entry, static_cast<std::size_t>(rows.size()) + 1, m_names);
    m_dialog = new SeriesDialog(m_names.nameOf(QString::fromStdString(list->path)), rows, &m_window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &QDialog::accepted, this, [dialog = m_dialog.data(), chosen = std::move(chosen)] {
        chosen(static_cast<std::size_t>(dialog->selected()));
    });
    connect(m_dialog, &QObject::destroyed, this, [this] { m_pictures.cancel(); });
    m_dialog->open();
    readPicture(list, 0);
}

void SeriesChoice::readPicture(const std::shared_ptr<const SeriesList>& list, std::size_t index) {
    if (index >= list->series.size()) return;
    m_pictures.submit([this, list, index](const Progress& progress) -> NewestWinsThread::Deliver {
        QImage picture;
        try {
            if (const auto small = restricted::middlePicture(list->series[index], SeriesDialog::pictureEdge, progress))
                picture =
                    QImage(small->grey.data(), small->width, small->height, small->width, QImage::Format_Grayscale8)
                        .copy();
        } catch (const std::bad_alloc&) {
            // A row without a picture can still be opened.
        }
        return [this, list, index, picture] {
            if (!m_dialog) return;
            m_dialog->setPicture(static_cast<int>(index), picture);
            readPicture(list, index + 1);
        };
    });
}

}  // namespace echolucent
