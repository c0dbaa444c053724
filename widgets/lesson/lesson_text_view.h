// Shows a lesson's Markdown, with the lesson's own images and nothing else.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QTextBrowser>

namespace echolucent {

/// As high as its text. It opens no link, reads no file and asks no network: an image that is not among those given, or
/// that is larger than a lesson's may be, is a clear pixel.
class LessonTextView : public QTextBrowser {
    Q_OBJECT

public:
    explicit LessonTextView(QWidget* parent = nullptr);

    /// Bytes of PNG and JPEG files, by name.
    void setImages(const QMap<QString, QByteArray>& images) { m_images = images; }
    void showMarkdown(const QString& markdown);

    [[nodiscard]] QVariant loadResource(int type, const QUrl& name) override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void fit();
    [[nodiscard]] QImage imageNamed(const QString& name) const;

    QMap<QString, QByteArray> m_images;
};

}  // namespace echolucent
