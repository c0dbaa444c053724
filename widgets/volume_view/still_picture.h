// A picture that lies over a 3D view for a while.
#pragma once

#include <QImage>
#include <QWidget>

namespace echolucent {

/// Covers a view with an image, as large as fits into it in its own proportions, on black. What the view shows goes on
/// below it, out of sight. The mouse does nothing over it.
class StillPicture : public QWidget {
    Q_OBJECT

public:
    /// Lies over `view`, which owns it and may be a native window; hidden at first.
    explicit StillPicture(QWidget& view);

    /// Shows an image, which is not null, before what the view shows.
    void showImage(const QImage& image);
    [[nodiscard]] const QImage& image() const { return m_image; }

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QImage m_image;
};

}  // namespace echolucent
