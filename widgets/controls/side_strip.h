// A strip of small pictures beside the picture: the six sides of a scan.
#pragma once

#include <QAction>
#include <QImage>
#include <QWidget>
#include <array>

class QBoxLayout;
class QToolButton;

namespace echolucent {

/// One picture for each of six actions, which name and take the sides. Objects: sides (this), sides.picture1 to
/// sides.picture6. An upright strip makes its pictures as high as its height lets them be, a level one as wide as its
/// width does.
class SideStrip : public QWidget {
    Q_OBJECT

public:
    static constexpr std::size_t count = 6;

    explicit SideStrip(QWidget* parent = nullptr);

    /// Upright (Qt::Vertical) at first.
    void setOrientation(Qt::Orientation orientation);
    /// The actions that the pictures trigger. Text, tool tip and state of each are shown. They outlive the strip.
    void setActions(const std::array<QAction*, count>& actions);
    /// A null picture leaves the place dark.
    void setPicture(std::size_t side, const QImage& picture);

signals:
    void seenChanged(bool seen);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void fit();
    [[nodiscard]] QBoxLayout& row();

    Qt::Orientation m_orientation = Qt::Vertical;
    std::array<QToolButton*, count> m_buttons{};
};

}  // namespace echolucent
