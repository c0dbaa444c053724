#include "app/picture/loading_picture.h"

#include <new>

#include "processing/pane_picture/coarse_picture.h"
#include "widgets/casting/picture_image.h"
#include "widgets/volume_view/still_picture.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

LoadingPicture::LoadingPicture(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_thread(parts.works, QStringLiteral("coarse picture")) {
    OpenStudy& openStudy = m_parts.openStudy;
    connect(&openStudy, &OpenStudy::loadingBegun, this, &LoadingPicture::end);
    connect(&openStudy, &OpenStudy::coarseVolumeRead, this, &LoadingPicture::make);
    connect(&openStudy, &OpenStudy::studyOpened, this, [this] {
        m_thread.cancel();
        m_opened = true;
        if (!m_parts.picture.isVisible()) end();  // a hidden view draws no first picture
    });
    connect(&openStudy, &OpenStudy::loadingChanged, this, [this](bool loading) {
        if (!loading && !m_opened) end();
    });
    connect(&m_parts.picture, &VolumeViewWidget::pictureDrawn, this, [this] {
        const bool isOfStudy = m_opened && !m_parts.documentView.held() && m_parts.picture.pictureIsCurrent();
        if (isOfStudy) end();
    });
    connect(&m_parts.picture, &VolumeViewWidget::pictureFailed, this, [this] {
        if (m_opened) end();
    });
}

void LoadingPicture::make(const CoarseVolume& coarse) {
    if (!m_parts.picture.isVisible()) return;
    const RayCastSettings settings = m_parts.picture.settings();
    m_thread.submit([this, coarse, document = m_parts.model.document(), width = settings.width,
                     height = settings.height](const Progress& progress) -> NewestWinsThread::Deliver {
        try {
            const auto picture = coarsePicture(document, firstPane, coarse, width, height, progress);
            if (!picture) return {};
            return [this, image = imageOf(*picture)] { show(image); };
        } catch (const std::bad_alloc&) {
            return {};  // the study's own picture tells of missing memory
        }
    });
}

void LoadingPicture::show(const QImage& image) {
    if (m_still == nullptr) {
        m_still = new StillPicture(m_parts.picture);
        m_still->setObjectName(QStringLiteral("view3d.coarse"));
        m_still->setAccessibleName(tr("Coarse picture of the volume that is being loaded"));
    }
    m_still->showImage(image);
    emit shown();
    m_parts.openStudy.setLoadingWords(tr("coarse picture, loading goes on"));
}

void LoadingPicture::end() {
    m_thread.cancel();
    m_opened = false;
    m_parts.openStudy.setLoadingWords(tr("loading"));
    if (m_still != nullptr) m_still->hide();
}

}  // namespace echolucent
