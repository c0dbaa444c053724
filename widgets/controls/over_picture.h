// A widget that lies over a picture and is seen above native windows in it.
#pragma once

#include <QRect>
#include <QWidget>

namespace echolucent {

/// Lies over a picture that is a sibling or lies deeper in the same window, and moves nothing. It has a native window
/// of its own, because an OpenGL window covers what Qt draws into its window, but not another native window above it.
class OverPicture : public QWidget {
    Q_OBJECT

public:
    explicit OverPicture(QWidget* parent = nullptr) : QWidget(parent) {}

    bool eventFilter(QObject* watched, QEvent* event) override;

    /// Takes its place and comes to the front. Call it when placeOver() may say something else, or another widget with
    /// a native window was laid over the picture.
    void place();

protected:
    /// Lies over this picture from now on. The picture outlives this widget.
    void setPicture(QWidget& picture);
    /// The place of the widget over a picture at `picture`, in the coordinates of the parent.
    [[nodiscard]] virtual QRect placeOver(const QRect& picture) const = 0;
    bool event(QEvent* event) override;

private:
    QWidget* m_picture = nullptr;
};

}  // namespace echolucent
