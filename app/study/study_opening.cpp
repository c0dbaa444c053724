#include "app/study/study_opening.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "io/gzip_file.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/raw_layout_dialog.h"

namespace echolucent {

namespace {

/// "heart.mha"; of a file that was read because its folder, or a header beside it, was opened: "slices/17.dcm".
QString shownName(const QString& opened, const QString& concerned) {
    const QString name = QFileInfo(opened).fileName();
    if (concerned.isEmpty() || QFileInfo(concerned) == QFileInfo(opened)) return name;
    return QFileInfo(opened).isDir() ? name + '/' + QDir(opened).relativeFilePath(concerned)
                                     : QFileInfo(concerned).fileName();
}

/// The sentences of a remedy that name no option of the command line: these ways out are buttons here.
QString withoutOptions(const QString& remedy) {
    QStringList kept;
    for (const QString& sentence : remedy.split(QStringLiteral(". "), Qt::SkipEmptyParts))
        if (!sentence.contains(QLatin1String("--"))) kept << (sentence.endsWith('.') ? sentence : sentence + '.');
    return kept.join(' ');
}

/// The length of a headerless file; below 0 where it is packed, so that only reading tells.
std::int64_t bytesOfRawFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return 0;
    return looksLikeGzip(file.read(4).toStdString()) ? -1 : file.size();
}

}  // namespace

StudyOpening::StudyOpening(QWidget& window, Session& session, Settings& settings, MessageBar& messages)
    : QObject(&window),
      m_window(window),
      m_session(session),
      m_settings(settings),
      m_messages(messages),
      m_series(window) {
    connect(&m_session, &Session::seriesFound, this, &StudyOpening::askForSeries);
    connect(&m_series, &SeriesChoice::busyChanged, this, &StudyOpening::busyChanged);
    connect(&m_session, &Session::openFailed, this, &StudyOpening::tellFailure);
    connect(&m_session, &Session::studyOpened, this, [this] {
        if (m_session.isSimulatedScan()) return;
        m_settings.addRecentFile(m_session.path());
        m_settings.setLastFolder(QFileInfo(m_session.path()).absolutePath());
    });
}

void StudyOpening::open(const QString& path, const ReadOptions& options) {
    if (path.isEmpty()) return;
    m_session.open(QFileInfo(path).absoluteFilePath(), options);
}

void StudyOpening::chooseFile() {
    open(QFileDialog::getOpenFileName(&m_window, tr("Open volume"), m_settings.lastFolder(),
                                      tr("3D ultrasound volumes (*.dcm *.vol *.v0? *.mha *.mhd *.nrrd *.nhdr *.nii "
                                         "*.hdr *.img *.raw *.gz DICOMDIR*);;"
                                         "All files (*)")));
}

void StudyOpening::chooseFolder() {
    open(QFileDialog::getExistingDirectory(&m_window, tr("Open folder of DICOM slices"), m_settings.lastFolder()));
}

void StudyOpening::chooseRawFile() {
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open raw volume"), m_settings.lastFolder());
    if (!path.isEmpty()) openRaw(path);
}

void StudyOpening::chooseSeries() {
    if (const auto list = m_session.seriesBeside()) askForSeries(list, {});
}

void StudyOpening::askForSeries(const std::shared_ptr<const SeriesList>& list, const ReadOptions& options) {
    m_series.ask(list, [this, list, options](std::size_t entry) {
        ReadOptions wanted = options;
        // The dialog has said that these are no slices.
        if (list->series[entry].whyNot) wanted.framesAsSlices = true;
        m_session.openSeries(list, entry, wanted);
    });
}

void StudyOpening::openRaw(const QString& path) {
    auto* dialog = new RawLayoutDialog(QFileInfo(path).fileName(), bytesOfRawFile(path), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto remembered = recalledRawLayout(path.toStdString()); remembered && *remembered)
        dialog->setValues(**remembered);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        ReadOptions options;
        options.raw = dialog->values();
        // A folder that cannot be written to is no reason not to open the file: then the person is asked again.
        (void)rememberRawLayout(path.toStdString(), *options.raw);
        open(path, options);
    });
    dialog->open();
}

void StudyOpening::tellFailure(const QString& path, const Failure& failure, const ReadOptions& options) {
    if (!path.isEmpty()) m_settings.setLastFolder(QFileInfo(path).absolutePath());
    QList<MessageAction> actions;
    if (failure.framesCouldBeSlices)
        actions << MessageAction{tr("Take the frames as slices"), [this, path, options] {
                                     ReadOptions wanted = options;
                                     wanted.framesAsSlices = true;
                                     open(path, wanted);
                                 }};
    if (failure.layoutUnknown) actions << MessageAction{tr("Say how it is laid out…"), [this, path] { openRaw(path); }};
    if (failure.opacityCurve)
        actions << MessageAction{tr("Open it as a curve"), [this, path] { emit curveChosen(path); }};
    if (failure.presets)
        actions << MessageAction{tr("Import them as presets"), [this, path] { emit presetsChosen(path); }};
    Failure shown = failure;
    shown.file = shownName(path, QString::fromStdString(failure.file)).toStdString();
    if (failure.opacityCurve || failure.presets)
        shown.remedy.clear();  // the button says it
    else
        shown.remedy = withoutOptions(QString::fromStdString(shown.remedy)).toStdString();
    m_messages.showMessage(MessageKind::error, QString::fromStdString(shown.sentence()), actions);
}

void StudyOpening::fillRecentFiles(QMenu& menu) {
    menu.clear();
    for (const QString& path : m_settings.recentFiles())
        connect(menu.addAction(path), &QAction::triggered, this, [this, path] { open(path); });
    if (menu.isEmpty()) {
        menu.addAction(tr("None yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    connect(menu.addAction(tr("Forget these files")), &QAction::triggered, this,
            [this] { m_settings.clearRecentFiles(); });
}

}  // namespace echolucent
