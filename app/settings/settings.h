// What the program remembers from one start to the next. Paths and looks only, nothing of a study's content.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

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

    /// Keeps the settings in `file`, an INI file, for tests and for portable use; where the name is empty, in the
    /// person's standard place.
    explicit Settings(const QString& file = {});

    /// Absolute paths, newest first, at most recentFilesLimit. Files that are not there now are left out, but kept in
    /// the store: a drive may come back.
    [[nodiscard]] QStringList recentFiles() const;
    /// The same with those that are not there now.
    [[nodiscard]] QStringList keptRecentFiles() const;
    /// Puts a file (or DICOM folder) first; a path already there moves up.
    void addRecentFile(const QString& path);
    void clearRecentFiles();
    /// Whether the window shows numbers where it would show names of files and folders. [false]
    [[nodiscard]] bool numbersForNames() const;
    void setNumbersForNames(bool numbers);
    /// The number of a study, from 1 on: its place in a list of all studies that were ever asked for, which holds
    /// hashes of their paths and no name. A study that was not asked for before is added.
    [[nodiscard]] int studyNumber(const QString& path);
    /// From here on the file at `session` has the number of the study at `study`, and is a session; both are kept as
    /// hashes. Where `study` is empty, its study has no path, and its number is its own.
    void setStudyOfSession(const QString& session, const QString& study);
    /// Whether the study of the file at `path` was set.
    [[nodiscard]] bool isSession(const QString& path) const;
    /// The folder that holds what the program keeps by itself, small pictures for example. It stands beside `file`
    /// where the settings were given one, else in the person's standard place; it may not be there yet.
    [[nodiscard]] QString dataFolder() const;
    /// 16 hexadecimal digits that name the file at a path and tell nothing of its name.
    [[nodiscard]] static QString hashOf(const QString& path);

    /// Folder in which the next file dialog opens; empty at first.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);
    /// Folder in which the next dialog for saving opens; lastFolder() at first.
    [[nodiscard]] QString lastSaveFolder() const;
    void setLastSaveFolder(const QString& folder);

    /// As QMainWindow::saveGeometry and saveState gave them; empty at first.
    [[nodiscard]] QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    [[nodiscard]] QByteArray windowState() const;
    void setWindowState(const QByteArray& state);

    /// Of lookAtStart() if what is kept is not understood. Its step stays as by default.
    [[nodiscard]] Look look() const;
    void setLook(const Look& look);
    [[nodiscard]] RendererChoice renderer() const;  ///< [automatic]
    void setRenderer(RendererChoice renderer);
    [[nodiscard]] bool histogramLogarithmic() const;  ///< [true]
    void setHistogramLogarithmic(bool logarithmic);
    [[nodiscard]] Theme theme() const;  ///< [dark]
    void setTheme(Theme theme);
    [[nodiscard]] PaneLayout paneLayout() const;  ///< [only3d]
    void setPaneLayout(PaneLayout layout);
    /// Path of the file that holds a person's own presets (io/document/preset_file.h), beside that of the settings.
    [[nodiscard]] QString presetsFile() const;
    /// The program's own folder for what is kept of sessions that nobody saved: below the person's standard place for
    /// data, or beside a settings file that was given.
    [[nodiscard]] QString autosaveFolder() const;
    /// The program's own folder for the small pictures of recent files, in dataFolder().
    [[nodiscard]] QString recentPicturesFolder() const;
    [[nodiscard]] bool presetsOpen() const;  ///< [false]: whether the gallery of presets is open
    void setPresetsOpen(bool open);
    /// Axis, OTF, speed and order of the frames; what moves and which phases are a matter of the study and stay as by
    /// default.
    [[nodiscard]] MotionChoice motion() const;
    void setMotion(const MotionChoice& motion);
    [[nodiscard]] CurveKind activeCurve() const;  ///< [adaptive]
    void setActiveCurve(CurveKind kind);
    /// Parameters and initial function; the tube cores that are never placed are a matter of the study.
    [[nodiscard]] MethodChoice method() const;
    void setMethod(const MethodChoice& method);

    /// Writes to disc now, and waits for it; false where that failed. Without it a thread of its own writes what
    /// changed.
    bool save();

private:
    SettingsStore m_store;
    QString m_dataFolder;
};

}  // namespace echolucent
