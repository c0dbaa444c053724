// Lets a person choose studies to open, and offers ways out if one cannot be opened.
#pragma once

#include <QList>
#include <QObject>
#include <QUrl>

#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "app/study/series_choice.h"

class QAction;
class QMenu;
class QWidget;

namespace echolucent {

class MessageBar;
class RecentPictures;
class StudyNames;
class Works;

class StudyOpening : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;  ///< parent of the dialogs
        OpenStudy& openStudy;
        Works& works;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        RecentPictures& pictures;
    };
    /// The parts outlive this object, which belongs to the window.
    explicit StudyOpening(const Parts& parts);

    /// Whether a path is that of a lesson's folder.
    [[nodiscard]] static bool isLesson(const QString& path);
    /// Opens a file, a DICOM folder or a session. Of a lesson's folder only lessonChosen() is emitted. If the file has
    /// no header and no layout is remembered, the message of the failure offers to state the layout.
    void open(const QString& path, const ReadOptions& options = {});
    /// Opens what was dropped on the window (droppedFiles()), or says why not.
    void openDropped(const QList<QUrl>& urls);
    void chooseFile();
    void chooseFolder();
    void chooseRawFile();
    /// Asks again which series of the folder to open. Does nothing if there is no other.
    void chooseSeries();
    /// Fills a menu with the recent files, each with its small picture.
    void fillRecentFiles(QMenu& menu);

signals:
    /// The person wants the lesson in this folder.
    void lessonChosen(const QString& folder);
    /// The person wants to open this file as a curve.
    void curveChosen(const QString& path);
    /// The person wants the presets of a file that is not a volume.
    void presetsChosen(const QString& path);

private:
    void openRaw(const QString& path);
    [[nodiscard]] StudySearch studySearch() const;
    void askForSavedStudy(const SavedStudyProblem& problem);
    void noteOpened();
    void askForSeries(const std::shared_ptr<const SeriesList>& list, const ReadOptions& options);
    [[nodiscard]] QAction* recentFile(QMenu& menu, const QString& path, int place) const;
    void tellFailure(const QString& path, const Failure& failure, const ReadOptions& options);

    Parts m_parts;
    SeriesChoice m_series;
};

}  // namespace echolucent
