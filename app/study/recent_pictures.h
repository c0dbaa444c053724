// The small pictures beside the files opened last: kept in the program's own data folder under names that tell nothing.
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

/// Writes, finds and removes one PNG file for each study in the list of recent files. Files are written and removed in
/// a thread of its own. The picture of the study that is open is kept at rest, each time that the 3D view shows another
/// one; none is cast for it. Pictures of studies that have left the list go then. A picture that cannot be written is
/// left out: the list does without.
class RecentPictures : public QObject {
    Q_OBJECT

public:
    /// Pixels along the edge of a picture, which is square.
    static constexpr int edge = 96;

    /// All must outlive this. The folder of the pictures is made with the first of them.
    RecentPictures(const Settings& settings, Works& works, VolumeViewWidget& view, QObject* parent = nullptr);

    /// The path under which what is open now stands in the list of recent files, a session's where one was opened;
    /// empty where it does not stand there.
    void setOpened(const QString& path);
    /// The list of recent files was cleared: all pictures go.
    void clear();
    /// The picture kept of a study; null where there is none.
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
