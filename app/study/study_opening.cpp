#include "app/study/study_opening.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QIcon>
#include <QMenu>
#include <QPixmap>

#include "app/study/dropped_files.h"
#include "app/study/recent_pictures.h"
#include "app/study/study_names.h"
#include "io/file_formats.h"
#include "io/lesson/lesson_file.h"
#include "io/voxels/gzip_file.h"
#include "processing/one_line.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/dialogs/raw_layout_dialog.h"

namespace echolucent {

namespace {

/// What could not be opened, or asks for an answer first, is told until the next study is asked for.
constexpr const char* openingTopic = "opening";
constexpr int widestName = 480, widestFolder = 320;  // logical pixels, in the list of recent files

/// "heart.mha". If its folder or a header beside it was opened: "slices/17.dcm".
QString shownName(const QString& opened, const QString& concerned) {
    const QString name = QFileInfo(opened).fileName();
    if (concerned.isEmpty() || QFileInfo(concerned) == QFileInfo(opened)) return name;
    return QFileInfo(opened).isDir() ? name + '/' + QDir(opened).relativeFilePath(concerned)
                                     : QFileInfo(concerned).fileName();
}

/// The sentences of a remedy that name no option of the command line. Those that do are buttons here.
QString withoutOptions(const QString& remedy) {
    QStringList kept;
    for (const QString& sentence : remedy.split(QStringLiteral(". "), Qt::SkipEmptyParts))
        if (!sentence.contains(QLatin1String("--"))) kept << (sentence.endsWith('.') ? sentence : sentence + '.');
    return kept.join(' ');
}

/// The length of a headerless file; 0 if it cannot be opened; below 0 if it is packed, since only reading tells its
/// length then.
std::int64_t bytesOfRawFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return 0;
    return looksLikeGzip(file.read(4).toStdString()) ? -1 : file.size();
}

}  // namespace

StudyOpening::StudyOpening(const Parts& parts)
    : QObject(&parts.window), m_parts(parts), m_series(parts.window, parts.names, parts.works) {
    connect(&m_parts.openStudy, &OpenStudy::seriesFound, this, &StudyOpening::askForSeries);
    connect(&m_parts.openStudy, &OpenStudy::openFailed, this, &StudyOpening::tellFailure);
    connect(&m_parts.openStudy, &OpenStudy::savedStudyAsked, this, &StudyOpening::askForSavedStudy);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &StudyOpening::noteOpened);
    connect(&m_parts.openStudy, &OpenStudy::loadingBegun, this, [this] { m_parts.messages.takeBack(openingTopic); });
    m_parts.openStudy.setStudySearch([this] { return studySearch(); });
}

void StudyOpening::noteOpened() {
    const auto& saved = m_parts.openStudy.saved();
    QString opened = saved ? QString::fromStdString(saved->file) : m_parts.openStudy.path();
    // A file that the program kept by itself is not the person's.
    if (QFileInfo(opened).absolutePath() == QFileInfo(m_parts.settings.autosaveFolder()).absoluteFilePath())
        opened = saved->session.file.empty() ? m_parts.openStudy.path() : QString::fromStdString(saved->session.file);
    m_parts.pictures.setOpened(opened);
    if (opened.isEmpty()) return;
    m_parts.settings.addRecentFile(opened);
    m_parts.settings.setLastFolder(QFileInfo(opened).absolutePath());
}

StudySearch StudyOpening::studySearch() const {
    StudySearch search;
    // Whether they exist is checked when they are looked through: here a drive that does not answer would stall.
    for (const QString& path : m_parts.settings.keptRecentFiles()) search.paths.push_back(path.toStdString());
    for (const QString& folder : {m_parts.settings.lastFolder(), m_parts.settings.lastSaveFolder()})
        search.folders.push_back(folder.toStdString());
    return search;
}

void StudyOpening::askForSavedStudy(const SavedStudyProblem& problem) {
    const QString file = QString::fromStdString(problem.file), study = QString::fromStdString(problem.study);
    const QString name = m_parts.names.nameOf(study);
    const auto openWith = [this, file](const QString& chosen, bool evenChanged) {
        if (!chosen.isEmpty()) m_parts.openStudy.openSaved(file, {chosen.toStdString(), evenChanged});
    };
    const QString folder = QFileInfo(file).absolutePath();
    const QList<MessageAction> choose{
        {tr("Choose the file…"),
         [this, openWith, folder] {
             openWith(QFileDialog::getOpenFileName(&m_parts.window, tr("The session's volume"), folder), false);
         }},
        {tr("Choose the folder…"), [this, openWith, folder] {
             openWith(QFileDialog::getExistingDirectory(&m_parts.window, tr("The session's folder of slices"), folder),
                      false);
         }}};
    if (problem.kind == SavedStudyProblem::Kind::missing)
        return m_parts.messages.showMessage(MessageKind::warning,
                                            tr("%1, the volume of this session, was not found.").arg(name),
                                            MessageEnd::whenTakenBack(openingTopic), choose);
    m_parts.messages.showMessage(
        MessageKind::warning,
        tr("%1 %2. What the session holds may not fit it.").arg(name, QString::fromStdString(problem.change)),
        MessageEnd::whenTakenBack(openingTopic),
        QList<MessageAction>{{tr("Open it all the same"), [openWith, study] { openWith(study, true); }}} + choose);
}

bool StudyOpening::isLesson(const QString& path) {
    return QFileInfo::exists(QDir(path).filePath(QString::fromLatin1(lessonFileName)));
}

void StudyOpening::open(const QString& path, const ReadOptions& options) {
    if (path.isEmpty()) return;
    if (isLesson(path)) return emit lessonChosen(QFileInfo(path).absoluteFilePath());
    m_parts.openStudy.open(QFileInfo(path).absoluteFilePath(), options);
}

void StudyOpening::openDropped(const QList<QUrl>& urls) {
    const DroppedFiles dropped = droppedFiles(urls);
    if (!dropped.whyNot.isEmpty())
        m_parts.messages.showMessage(MessageKind::warning, dropped.whyNot, MessageEnd::whenTakenBack(openingTopic));
    else if (!dropped.study.isEmpty())
        m_parts.openStudy.openSaved(dropped.path, {dropped.study.toStdString(), false});
    else if (!dropped.slices.isEmpty())
        m_parts.openStudy.openSlices(dropped.path, dropped.slices);
    else
        open(dropped.path);
}

void StudyOpening::chooseFile() {
    open(QFileDialog::getOpenFileName(&m_parts.window, tr("Open volume"), m_parts.settings.lastFolder(),
                                      tr("3D ultrasound volumes and sessions (%1 *.session.json);;All files (*)")
                                          .arg(QString::fromStdString(namesOfVolumes()))));
}

void StudyOpening::chooseFolder() {
    open(QFileDialog::getExistingDirectory(&m_parts.window, tr("Open folder of DICOM slices"),
                                           m_parts.settings.lastFolder()));
}

void StudyOpening::chooseRawFile() {
    const QString path =
        QFileDialog::getOpenFileName(&m_parts.window, tr("Open raw volume"), m_parts.settings.lastFolder());
    if (!path.isEmpty()) openRaw(path);
}

void StudyOpening::chooseSeries() {
    if (const auto list = m_parts.openStudy.seriesBeside()) askForSeries(list, {});
}

void StudyOpening::askForSeries(const std::shared_ptr<const SeriesList>& list, const ReadOptions& options) {
    m_series.ask(list, [this, list, options](std::size_t entry) {
        ReadOptions wanted = options;
        // The dialog has said that the pictures of this series are taken as slices.
        if (list->series[entry].whyNot) wanted.framesAsSlices = true;
        m_parts.openStudy.openSeries(list, entry, wanted);
    });
}

void StudyOpening::openRaw(const QString& path) {
    auto* dialog = new RawLayoutDialog(m_parts.names.nameOf(path), bytesOfRawFile(path), &m_parts.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto remembered = recalledRawLayout(path.toStdString()); remembered && *remembered)
        dialog->setValues(**remembered);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        ReadOptions options;
        options.raw = dialog->values();
        // If the folder cannot be written to, the file still opens. The person is asked again next time.
        (void)rememberRawLayout(path.toStdString(), *options.raw);
        open(path, options);
    });
    dialog->open();
}

void StudyOpening::tellFailure(const QString& path, const Failure& failure, const ReadOptions& options) {
    if (!path.isEmpty()) m_parts.settings.setLastFolder(QFileInfo(path).absolutePath());
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
    m_parts.names.know(path, {QString::fromStdString(failure.file)});
    Failure shown = failure;
    const QString name = m_parts.names.nameOf(path);
    shown.file =
        (m_parts.names.showsNumbers() ? name : shownName(path, QString::fromStdString(failure.file))).toStdString();
    if (failure.opacityCurve || failure.presets)
        shown.remedy.clear();  // the button says it
    else
        shown.remedy = withoutOptions(QString::fromStdString(shown.remedy)).toStdString();
    m_parts.messages.showMessage(MessageKind::error,
                                 m_parts.names.shownOfFile(QString::fromStdString(shown.sentence())),
                                 MessageEnd::whenTakenBack(openingTopic), actions);
}

/// "1 heart.mha" with the folder beside it, or "1 Study 3" alone; the digit is its key.
QAction* StudyOpening::recentFile(QMenu& menu, const QString& path, int place) const {
    const auto elided = [&menu](const QString& words, int widest) {
        return literalMenuText(menu.fontMetrics().elidedText(words, Qt::ElideMiddle, widest));
    };
    QString text = QStringLiteral("&%1  %2").arg(place % 10).arg(elided(m_parts.names.nameOf(path), widestName));
    if (!m_parts.names.showsNumbers()) {
        const QString folder = QDir::toNativeSeparators(QFileInfo(path).absolutePath());
        // Text after a tab stands in the column of keys.
        text += QLatin1Char('\t') + elided(QString::fromStdString(oneLine(folder.toStdString())), widestFolder);
    }
    QPixmap square(RecentPictures::edge, RecentPictures::edge);
    square.fill(Qt::black);
    if (const QImage picture = m_parts.pictures.of(path); !picture.isNull()) square = QPixmap::fromImage(picture);
    QAction* action = menu.addAction(QIcon(square), text);
    action->setObjectName(QStringLiteral("file.recent.%1").arg(place));
    action->setIconVisibleInMenu(true);
    return action;
}

void StudyOpening::fillRecentFiles(QMenu& menu) {
    menu.clear();
    // The menu is filled again before it is shown.
    connect(&m_parts.names, &StudyNames::changed, &menu, &QMenu::clear, Qt::UniqueConnection);
    int place = 0;
    for (const QString& path : m_parts.settings.recentFiles())
        connect(recentFile(menu, path, ++place), &QAction::triggered, this, [this, path] { open(path); });
    if (menu.isEmpty()) {
        menu.addAction(tr("None yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    QAction* forget = menu.addAction(tr("&Clear the list"));
    forget->setObjectName(QStringLiteral("file.recent.clear"));
    connect(forget, &QAction::triggered, this, [this] {
        m_parts.settings.clearRecentFiles();
        m_parts.pictures.clear();
    });
}

}  // namespace echolucent
