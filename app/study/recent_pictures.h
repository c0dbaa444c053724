// Keeps the small pictures of the recent files in the program's own data folder, under names that tell nothing.
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "processing/picture/picture.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class Settings;
class VolumeViewWidget;

/// Writes, finds and removes one PNG file for each study in the list of recent files. A thread of its own writes and
/// removes the files. Each time the 3D view rests with another picture, that picture of the open study is kept; none is
/// cast for it. Pictures of studies that have left the list go then. A picture that cannot be written is left out.
class RecentPictures : public QObject {
    Q_OBJECT

public:
    /// Pixels along the edge of a square picture.
    static constexpr int edge = 96;

    /// What the parameters refer to must outlive this object. The folder of the pictures is made with the first of
    /// them.
    RecentPictures(const Settings& settings, Works& works, VolumeViewWidget& view, QObject* parent = nullptr);

    /// The path of the open study in the list of recent files, or of the session if one was opened. Empty if it is not
    /// in the list.
    void setOpened(const QString& path);
    /// The list of recent files was cleared: all pictures go.
    void clear();
    /// The picture of a study; null if there is none.
    [[nodiscard]] QImage of(const QString& path) const;

private:
    void followRest();
    void keep(const QString& path, std::function<QImage()> make);

    const Settings& m_settings;
    Works& m_works;
    VolumeViewWidget& m_view;
    QString m_folder;
    QString m_opened;
    bool m_atRest = false;
    std::weak_ptr<const Picture> m_kept;  ///< the 3D view's picture that was kept last
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
