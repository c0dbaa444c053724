// What the program remembers from one start to the next: paths and looks only, nothing of a study's content.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

#include "app/settings/face.h"
#include "app/settings/settings_store.h"
#include "processing/document/document.h"
#include "processing/picture/look.h"
#include "processing/picture/renderer_choice.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/theme_colours.h"

namespace echolucent {

class Settings {
public:
    static constexpr int recentFilesLimit = 10;

    /// Keeps the settings in `file`, an INI file, for tests and portable use. If the name is empty, they are in the
    /// person's standard place.
    explicit Settings(const QString& file = {});

    /// Absolute paths, newest first, at most recentFilesLimit. Files that are missing are left out. The store keeps
    /// their paths, since a drive may come back.
    [[nodiscard]] QStringList recentFiles() const;
    /// The paths of recentFiles() and of the files that are missing.
    [[nodiscard]] QStringList keptRecentFiles() const;
    /// Puts a file (or DICOM folder) first; a path already there moves up.
    void addRecentFile(const QString& path);
    void clearRecentFiles();
    /// Whether the window shows numbers instead of names of files and folders. [false]
    [[nodiscard]] bool numbersForNames() const;
    void setNumbersForNames(bool numbers);
    /// The number of a study, from 1 on: its place in the list of all studies that were ever asked for. The list holds
    /// hashes of their paths and no name. A study that is not in the list is added. A session has the number that
    /// setStudyOfSession() gave it.
    [[nodiscard]] int studyNumber(const QString& path);
    /// From here on the file at `session` is a session and has the number of the study at `study`. Both paths are kept
    /// as hashes. An empty `study` means a study without a path; the session then has its own number.
    void setStudyOfSession(const QString& session, const QString& study);
    /// Whether setStudyOfSession() was called for the file at `path`.
    [[nodiscard]] bool isSession(const QString& path) const;
    /// The folder for what the program keeps by itself, small pictures for example. It stands beside `file` if the
    /// settings were given one, else in the person's standard place. It may not exist yet.
    [[nodiscard]] QString dataFolder() const;
    /// 16 hexadecimal digits that name the file at a path and tell nothing of its name.
    [[nodiscard]] static QString hashOf(const QString& path);

    /// Folder in which the next dialog for opening starts; empty at first.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);
    /// Folder in which the next dialog for saving starts; lastFolder() at first.
    [[nodiscard]] QString lastSaveFolder() const;
    void setLastSaveFolder(const QString& folder);

    /// As QMainWindow::saveGeometry and saveState gave them; empty at first.
    [[nodiscard]] QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    [[nodiscard]] QByteArray windowState() const;
    void setWindowState(const QByteArray& state);

    /// lookAtStart() if the stored look is not understood. Its step stays the default.
    [[nodiscard]] Look look() const;
    void setLook(const Look& look);
    [[nodiscard]] RendererChoice renderer() const;  ///< [automatic]
    void setRenderer(RendererChoice renderer);
    [[nodiscard]] bool histogramLogarithmic() const;  ///< [true]
    void setHistogramLogarithmic(bool logarithmic);
    [[nodiscard]] bool earlyLightShown() const;  ///< [false]
    void setEarlyLightShown(bool shown);
    [[nodiscard]] Theme theme() const;  ///< [dark]
    void setTheme(Theme theme);
    [[nodiscard]] Face face() const;  ///< [review]
    void setFace(Face face);
    [[nodiscard]] PaneLayout paneLayout() const;  ///< [only3d]
    void setPaneLayout(PaneLayout layout);
    /// Path of the file of a person's own presets (io/document/preset_file.h), beside the settings file.
    [[nodiscard]] QString presetsFile() const;
    /// The program's own folder for sessions that nobody saved. It is below the person's standard place for data, or
    /// beside a settings file that was given.
    [[nodiscard]] QString autosaveFolder() const;
    /// Names of files in autosaveFolder() whose sessions a person does not want to be offered any more.
    [[nodiscard]] QStringList leftSessionsPutAway() const;
    void setLeftSessionsPutAway(const QStringList& files);
    /// The folder for the small pictures of recent files, in dataFolder().
    [[nodiscard]] QString recentPicturesFolder() const;
    /// The side that a person took last of a kind of scan (kindOfScan()), by kind: Side::word. The last fifty kinds.
    [[nodiscard]] QMap<QString, QString> sidesTaken() const;
    /// An empty `word` forgets the kind.
    void setSideTaken(const QString& kind, const QString& word);
    [[nodiscard]] bool sidesShown() const;  ///< [true]: whether the strip of sides is shown
    void setSidesShown(bool shown);
    [[nodiscard]] bool presetsOpen() const;  ///< [false]: whether the gallery of presets is open
    void setPresetsOpen(bool open);
    /// Axis, OTF, speed and order of the frames. What moves and the phases belong to the study and stay the default.
    [[nodiscard]] MotionChoice motion() const;
    void setMotion(const MotionChoice& motion);
    [[nodiscard]] CurveKind activeCurve() const;  ///< [adaptive]
    void setActiveCurve(CurveKind kind);
    /// Parameters and initial function. The tube cores that are never placed belong to the study.
    [[nodiscard]] MethodChoice method() const;
    void setMethod(const MethodChoice& method);

    /// Writes to disc now and waits for it; false if that failed. Without a call, a thread writes the changes.
    bool save();

private:
    SettingsStore m_store;
    QString m_dataFolder;
};

}  // namespace echolucent
