// A pane that shows one picture of a comparison, and reports the gestures of the hand.
#pragma once

#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>

#include "widgets/camera_gestures.h"
#include "widgets/compare/pane_face.h"

namespace echolucent {

/// As in the 3D view: a left drag orbits, a middle or Shift + left drag pans, a right drag and the wheel zoom, a Ctrl +
/// left drag moves the light, a double click asks for the whole room, Escape ends a drag. Ctrl + arrows orbit, Shift +
/// arrows pan, + and - zoom. Drags are reported while they go on, in shares of the picture's height, to the right and
/// down. In a wipe, a left drag of the line between the two pictures moves the line, and so do Left and Right.
class ComparePane : public QWidget, public SpokenWidget {
    Q_OBJECT

public:
    explicit ComparePane(const QString& name, QWidget* parent = nullptr);

    void setFace(const PaneFace& face);
    [[nodiscard]] const PaneFace& face() const { return m_face; }
    /// Sets how the texts below the picture are laid out.
    void setCaption(const CaptionLayout& caption);
    /// Paints the pane as it is shown, without what is so on the screen alone: the focus, and signs of what is
    /// computed.
    void paintTo(QPainter& painter) const;
    /// Draws the picture as large as the pane has room, whatever its own size.
    void setImage(const QImage& image);
    [[nodiscard]] const QImage& image() const { return m_image; }
    /// The picture to the right of a line at a share of the width. Without a share there is one picture.
    void setWipe(const QImage& right, std::optional<double> share);
    /// Whether something for this pane is being computed.
    void setBusy(bool busy);
    [[nodiscard]] bool busy() const { return m_busy; }
    /// Dims what the pane shows, because another study is about to take its place.
    void setDimmed(bool dimmed);

    /// The place of the picture, logical pixels.
    [[nodiscard]] QRect pictureRect() const;
    /// The size of the picture in device pixels.
    [[nodiscard]] QSize pictureSize() const;
    [[nodiscard]] bool dragging() const { return m_drag != CameraDrag::none || m_wiping; }
    /// Ends a drag without change. False if there is none.
    bool cancelDrag();

    /// The camera's keys.
    [[nodiscard]] std::vector<SpokenAction> spokenActions() const override { return cameraActions(); }

    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }
    [[nodiscard]] QSize sizeHint() const override { return {400, 440}; }

signals:
    void dragEnded();  ///< the hand let go
    void dragCancelled();
    void orbited(double right, double down);
    void panned(double right, double down);
    void zoomed(double factor);  ///< above 1: things grow; about the picture's centre
    /// Zooms by `factor` about a point, given in shares of the picture's height from its centre.
    void zoomedAbout(double right, double down, double factor);
    void lightMoved(double right, double down);
    void wipeMoved(double share);  ///< [0, 1]
    void maximiseRequested();
    void focused();  ///< the keyboard's focus came to this pane
    /// A picture was painted. This took `milliseconds`.
    void painted(double milliseconds);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] bool onLine(const QPointF& place) const;
    [[nodiscard]] std::optional<double> wipeOf(const QKeyEvent& event) const;
    void paintBusy(QPainter& painter) const;
    void paintPicture(QPainter& painter) const;

    PaneFace m_face;
    mutable InsetMap m_map;  ///< as it was painted last
    CaptionLayout m_caption;
    QImage m_image, m_right;
    std::optional<double> m_wipe;
    bool m_busy = false, m_dimmed = false;
    CameraDrag m_drag = CameraDrag::none;
    bool m_wiping = false;  ///< the drag moves the line
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_last;
};

}  // namespace echolucent
