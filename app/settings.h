// What the program remembers from one start to the next. Paths and looks only, nothing of a study's content.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

#include "processing/picture/light_direction.h"
#include "processing/ray_caster.h"
#include "widgets/panels/preferred_renderer.h"

namespace echolucent {

class Settings {
public:
    static constexpr int recentFilesLimit = 10;

    /// Empty: the person's standard place. Else an INI file, for tests and for portable use.
    explicit Settings(const QString& file = {});

    /// Absolute paths, newest first, at most recentFilesLimit. Files that are not there now are left out, but kept in
    /// the store: a drive may come back.
    [[nodiscard]] QStringList recentFiles() const;
    /// Puts a file (or DICOM folder) first; a path already there moves up.
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    void clearRecentFiles();
    /// Folder in which the next file dialog opens; empty at first.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);

    /// As QMainWindow::saveGeometry and saveState gave them; empty at first.
    [[nodiscard]] QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    [[nodiscard]] QByteArray windowState() const;
    void setWindowState(const QByteArray& state);

    /// The picture's looks; a value that is not understood gives the default in brackets.
    [[nodiscard]] ColourMap colourMap() const;  ///< [sepia]
    void setColourMap(ColourMap map);
    [[nodiscard]] Interpolation interpolation() const;  ///< [trilinear]
    void setInterpolation(Interpolation interpolation);
    [[nodiscard]] Projection projection() const;  ///< [parallel]
    void setProjection(Projection projection);
    [[nodiscard]] RenderMode mode() const;  ///< [direct]
    void setMode(RenderMode mode);
    [[nodiscard]] bool shaded() const;  ///< [true]
    void setShaded(bool shaded);
    [[nodiscard]] LightDirection light() const;  ///< [LightDirection{}], each angle by itself
    void setLight(const LightDirection& light);
    [[nodiscard]] bool depthColoured() const;  ///< [false]
    void setDepthColoured(bool coloured);
    [[nodiscard]] PreferredRenderer renderer() const;  ///< [automatic]
    void setRenderer(PreferredRenderer renderer);
    [[nodiscard]] bool histogramLogarithmic() const;  ///< [true]
    void setHistogramLogarithmic(bool logarithmic);
    [[nodiscard]] bool motionPingPong() const;  ///< [true]
    void setMotionPingPong(bool pingPong);

    /// Writes to disc now; false where that failed.
    bool save();

private:
    QSettings m_store;
};

}  // namespace echolucent
