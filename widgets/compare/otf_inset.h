// The OTF of a single picture on the full screen, as the panes of a comparison show theirs.
#pragma once

#include "widgets/compare/pane_face.h"
#include "widgets/controls/over_picture.h"

namespace echolucent {

/// Lies in a corner of a picture, in a size that the last row of a class can read. The mouse and the keys go past it.
/// It is hidden at first.
class OtfInset : public OverPicture {
    Q_OBJECT

public:
    explicit OtfInset(QWidget* parent = nullptr);

    /// Lies over this picture, which is in the same window and outlives the inset.
    void lieOver(QWidget& picture) { setPicture(picture); }
    /// Only the OTF and its colour are shown.
    void setFace(const PaneFace& face);
    [[nodiscard]] const PaneFace& face() const { return m_face; }

protected:
    [[nodiscard]] QRect placeOver(const QRect& picture) const override;
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    PaneFace m_face;
    InsetMap m_map;
};

}  // namespace echolucent
