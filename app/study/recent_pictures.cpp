#include "app/study/recent_pictures.h"

#include <QDir>
#include <QSet>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/settings/settings.h"
#include "io/writers/picture_file.h"
#include "widgets/casting/picture_image.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

QString pictureFileOf(const QString& path) { return Settings::hashOf(path) + QStringLiteral(".png"); }

/// The square in the middle of a picture, where the study is, made small.
QImage smallSquare(const QImage& image) {
    const int side = std::min(image.width(), image.height());
    const QImage square = image.copy((image.width() - side) / 2, (image.height() - side) / 2, side, side);
    return square.scaled(RecentPictures::edge, RecentPictures::edge, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void removeOthers(const QString& folder, const QStringList& recent) {
    QSet<QString> kept;
    for (const QString& path : recent) kept << pictureFileOf(path);
    QDir pictures(folder);
    for (const QString& name : pictures.entryList({QStringLiteral("*.png")}, QDir::Files))
        if (!kept.contains(name)) pictures.remove(name);
}

}  // namespace

RecentPictures::RecentPictures(const Settings& settings, Works& works, VolumeViewWidget& view, QObject* parent)
    : QObject(parent),
      m_settings(settings),
      m_works(works),
      m_view(view),
      m_folder(settings.recentPicturesFolder()),
      m_thread(works, QStringLiteral("recent pictures"), {.countsForRest = false}) {
    connect(&m_works, &Works::changed, this, &RecentPictures::followRest);
}

void RecentPictures::setOpened(const QString& path) {
    if (path != m_opened) m_kept.reset();  // the same picture may be wanted under another name
    m_opened = path;
}

void RecentPictures::followRest() {
    const bool atRest = m_works.atRest(), cameToRest = atRest && !m_atRest;
    m_atRest = atRest;
    const QString path = m_opened;
    if (!atRest || path.isEmpty() || !m_view.volume() || !m_view.pictureIsFine() || !m_view.pictureIsCurrent()) return;
    if (!m_settings.keptRecentFiles().contains(path)) return;
    const std::shared_ptr<const Picture> picture = m_view.picture();
    if (picture) {
        if (m_kept.lock() == picture) return;
        m_kept = picture;
        keep(path, [picture] { return imageOf(*picture); });
    } else if (cameToRest) {
        // The graphics card renders: read back what it has drawn.
        keep(path, [image = m_view.screenImage()] { return image; });
    }
}

void RecentPictures::keep(const QString& path, std::function<QImage()> make) {
    m_thread.submit(
        [folder = m_folder, path, recent = m_settings.keptRecentFiles(),
         make = std::move(make)](const Progress&) -> NewestWinsThread::Deliver {
            removeOthers(folder, recent);
            // If the picture cannot be made or written, the list does without.
            try {
                const QImage image = make();
                if (image.isNull() || !QDir().mkpath(folder)) return {};
                const QImage small = smallSquare(image);
                (void)writePng(QDir(folder).filePath(pictureFileOf(path)).toStdString(), small.width(), small.height(),
                               rgbBytesOf(small));
            } catch (const std::exception&) {
            }
            return {};
        },
        NewestWinsThread::WhenSuperseded::finish);
}

void RecentPictures::clear() {
    m_thread.submit(
        [folder = m_folder](const Progress&) -> NewestWinsThread::Deliver {
            removeOthers(folder, {});
            return {};
        },
        NewestWinsThread::WhenSuperseded::finish);
}

QImage RecentPictures::of(const QString& path) const { return QImage(QDir(m_folder).filePath(pictureFileOf(path))); }

}  // namespace echolucent
