// A picture that covers a 3D view for a while.
#pragma once

#include <QImage>
#include <QWidget>

namespace echolucent {

/// Covers a view with an image on black, as large as fits in the image's own proportions. The view goes on below it,
/// out of sight. The mouse does nothing over it.
class StillPicture : public QWidget {
    Q_OBJECT

public:
    /// Lies over `view`, which owns it and may be a native window. It is hidden at first.
    explicit StillPicture(QWidget& view);

    /// Shows an image (not null) over the view.
    void showImage(const QImage& image);
    [[nodiscard]] const QImage& image() const { return m_image; }

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QImage m_image;
};

}  // namespace echolucent
