// A pane that shows one picture of a comparison, and tells what the hand does over it.
#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>

#include "widgets/camera_gestures.h"

namespace echolucent {

/// What stands under a picture and around it.
struct PaneFace {
    QString name;
    QString numbers{};
    std::optional<QColor> frame{};  ///< of the curve that has a colour of its own
    Qt::PenStyle frameStyle = Qt::SolidLine;
    friend bool operator==(const PaneFace&, const PaneFace&) = default;
};

/// Left drag orbits, middle or Shift + left drag pans, right drag and the wheel zoom, Ctrl + left drag moves the light,
/// a double click asks for the whole room, Escape ends a drag, as in the 3D view. Drags are told as they go, in shares
/// of the picture's height, to the right and down. Ctrl + arrows orbit, Shift + arrows pan, + and - zoom. Where two
/// pictures are wiped, the line between them is dragged, and Left and Right move it.
class ComparePane : public QWidget {
    Q_OBJECT

public:
    explicit ComparePane(const QString& name, QWidget* parent = nullptr);

    void setFace(const PaneFace& face);
    [[nodiscard]] const PaneFace& face() const { return m_face; }
    /// The picture is drawn as large as the pane has room, whatever its own size.
    void setImage(const QImage& image);
    [[nodiscard]] const QImage& image() const { return m_image; }
    /// The picture right of a line that stands at a share of the width; without a share there is one picture.
    void setWipe(const QImage& right, std::optional<double> share);
    /// Whether something of the pane is being computed.
    void setBusy(bool busy);
    [[nodiscard]] bool busy() const { return m_busy; }

    /// Where the picture stands, logical pixels.
    [[nodiscard]] QRect pictureRect() const;
    /// Its size in device pixels.
    [[nodiscard]] QSize pictureSize() const;
    [[nodiscard]] bool dragging() const { return m_drag != CameraDrag::none || m_wiping; }
    /// Ends a drag without change; false where there is none.
    bool cancelDrag();

    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }
    [[nodiscard]] QSize sizeHint() const override { return {400, 440}; }

signals:
    void dragEnded();  ///< by the hand that let go
    void dragCancelled();
    void orbited(double right, double down);
    void panned(double right, double down);
    void zoomed(double factor);  ///< above 1: things grow; about the picture's centre
    /// The same about a point, told in shares of the picture's height from its centre.
    void zoomedAbout(double right, double down, double factor);
    void lightMoved(double right, double down);
    void wipeMoved(double share);  ///< [0, 1]
    void maximiseRequested();
    /// A picture was painted, which took so many milliseconds.
    void painted(double milliseconds);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] bool onLine(const QPointF& place) const;
    [[nodiscard]] std::optional<double> wipeOf(const QKeyEvent& event) const;
    void paintCaption(QPainter& painter) const;
    void paintPicture(QPainter& painter) const;

    PaneFace m_face;
    QImage m_image, m_right;
    std::optional<double> m_wipe;
    bool m_busy = false;
    CameraDrag m_drag = CameraDrag::none;
    bool m_wiping = false;  ///< the drag moves the line
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_last;
};

}  // namespace echolucent
