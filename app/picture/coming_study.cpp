#include "app/picture/coming_study.h"

#include <QEvent>
#include <utility>

#include "app/study/study_names.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/controls/opening_label.h"
#include "widgets/planes/plane_pane.h"
#include "widgets/threads/works.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

ComingStudy::ComingStudy(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    OpenStudy& openStudy = m_parts.openStudy;
    VolumeViewWidget& picture = m_parts.picture;
    connect(&openStudy, &OpenStudy::loadingBegun, this, &ComingStudy::begin);
    connect(&openStudy, &OpenStudy::studyOpened, this, [this] {
        m_asked = m_parts.openStudy.loading();  // another one may have been asked for since
        m_awaits = true;
        follow();
    });
    connect(&openStudy, &OpenStudy::loadingChanged, this, [this](bool loading) {
        m_asked = loading;
        follow();
    });
    connect(&m_parts.documentView, &DocumentView::studyGiven, this, &ComingStudy::follow);
    const auto end = [this] {
        const bool isOfStudy = !m_parts.documentView.held() && m_parts.picture.pictureIsCurrent();
        if (m_awaits && isOfStudy) {
            m_awaits = false;
            follow();
        }
    };
    connect(&picture, &VolumeViewWidget::pictureDrawn, this, end);
    connect(&picture, &VolumeViewWidget::pictureFailed, this, [this] {
        m_awaits = false;
        follow();
    });
    connect(&m_parts.works, &Works::changed, this, [this] { m_parts.label.setActivity(m_parts.works.words()); });
    connect(&m_parts.works, &Works::progressed, &m_parts.label, &OpeningLabel::setShare);
    connect(&m_parts.names, &StudyNames::changed, this, &ComingStudy::nameStudy);
    picture.installEventFilter(this);
    if (openStudy.loading()) begin();
}

bool ComingStudy::eventFilter(QObject* watched, QEvent* event) {
    const bool seenAnew = event->type() == QEvent::Show || event->type() == QEvent::Hide;
    if (watched == &m_parts.picture && seenAnew)
        QMetaObject::invokeMethod(this, &ComingStudy::follow, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

void ComingStudy::begin() {
    m_asked = true;
    nameStudy();
    m_parts.label.setActivity(tr("loading"));
    follow();
}

void ComingStudy::follow() {
    m_parts.picture.setDimmed(m_asked || m_parts.documentView.held());
    for (PlanePane* pane : m_parts.planes) pane->setDimmed(m_asked);
    m_parts.compared.setDimmed(m_asked);
    const bool inView = m_parts.picture.isVisible();
    if (!m_asked && !(m_awaits && inView)) return m_parts.label.hide();
    m_parts.label.lieOver(inView ? static_cast<QWidget&>(m_parts.picture) : m_parts.rooms);
    m_parts.label.show();
}

void ComingStudy::nameStudy() {
    const QString& path = m_parts.openStudy.asked();
    m_parts.label.setName(path.isEmpty() ? tr("Simulated scan") : m_parts.names.nameOfAsked(path));
}

}  // namespace echolucent
