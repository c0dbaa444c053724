#include "widgets/lesson/lesson_text_view.h"

#include <QBuffer>
#include <QEvent>
#include <QImageReader>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QWheelEvent>
#include <cmath>

#include "processing/lesson/lesson.h"

namespace echolucent {

LessonTextView::LessonTextView(QWidget* parent) : QTextBrowser(parent) {
    setProperty("plain", true);  // the theme draws no field around it
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    viewport()->setAutoFillBackground(false);
    document()->setDocumentMargin(0);
}

void LessonTextView::showMarkdown(const QString& markdown) {
    // No HTML: a stranger's text is words, lists, tables and images.
    QTextDocument::MarkdownFeatures features = QTextDocument::MarkdownDialectGitHub;
    features |= QTextDocument::MarkdownNoHTML;
    document()->setMarkdown(markdown, features);
    fit();
}

QVariant LessonTextView::loadResource(int type, const QUrl& name) {
    // An invalid answer would let Qt look for the file itself.
    QImage image = type == QTextDocument::ImageResource ? imageNamed(name.toString()) : QImage();
    if (image.isNull()) {
        image = QImage(1, 1, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
    }
    const int most = std::max(64, viewport()->width());
    if (image.width() > most) image = image.scaledToWidth(most, Qt::SmoothTransformation);
    return image;
}

QImage LessonTextView::imageNamed(const QString& name) const {
    const auto found = m_images.constFind(name);
    if (found == m_images.constEnd() || found->size() > static_cast<qsizetype>(largestLessonImage)) return {};
    QByteArray bytes = *found;
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer, name.endsWith(QLatin1String(".png")) ? "png" : "jpeg");
    reader.setAutoDetectImageFormat(false);
    const QSize size = reader.size();
    if (size.isEmpty() || size.width() > largestLessonImageSide || size.height() > largestLessonImageSide) return {};
    return reader.read();
}

void LessonTextView::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    fit();
}

void LessonTextView::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fit();
}

/// The panel scrolls, not the text in it.
void LessonTextView::wheelEvent(QWheelEvent* event) { event->ignore(); }

void LessonTextView::fit() {
    document()->setTextWidth(viewport()->width());
    setFixedHeight(static_cast<int>(std::ceil(document()->size().height())) + 2 * frameWidth());
}

}  // namespace echolucent
