// What stands below and over a picture that is compared: its name, its numbers, its OTF, and how they are laid out.
#pragma once

#include <QColor>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <QRect>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "processing/classification.h"
#include "widgets/compare/surface_legend.h"

namespace echolucent {

/// The texts below a picture, its frame, and its OTF.
struct PaneFace {
    QString name;
    QString numbers{};
    SurfaceLegend legend{};         ///< of a picture that is coloured; it is painted in place of the numbers
    std::optional<QColor> frame{};  ///< colour of the curve, if it has one of its own
    Qt::PenStyle frameStyle = Qt::SolidLine;
    bool coloured = false;  ///< pictures may have the colours of shown depths: frame and focus are neutral
    /// Drawn small in a corner of the picture: a curve over the intensity, or a map over intensity (to the right) and
    /// gradient magnitude (upwards), the lighter the more opaque.
    std::optional<Classification> otf{};
    friend bool operator==(const PaneFace&, const PaneFace&) = default;
};

/// The map of an OTF over two numbers as it was painted last. It is made again only for another OTF or another size.
struct InsetMap {
    std::shared_ptr<const TwoDimensionalOtf> otf;
    QImage image;
};

/// How the texts below pictures are set. All panes that stand beside each other share it.
struct CaptionLayout {
    QFont font{};
    int height = 0;  ///< of all texts with what is around them, pixels
    friend bool operator==(const CaptionLayout&, const CaptionLayout&) = default;
};

/// The layout for panes of this width: names break between words into as many lines as the longest needs, and the
/// longest numbers that a pane may have find room too. If a word is wider than a pane, letters are smaller than those
/// of `font`.
[[nodiscard]] CaptionLayout captionLayout(const QStringList& names, int width, const QFont& font);
/// The place of the picture in a pane.
[[nodiscard]] QRect pictureIn(const QRect& pane, const CaptionLayout& caption);
/// The place of the OTF in a corner of a picture; empty if the picture is too small for it.
[[nodiscard]] QRectF insetIn(const QRect& picture);
/// Paints the OTF of a face at such a place. `kept` is the map of the same place, if it is painted again and again. Any
/// thread may call this, with a map of its own.
void paintInset(QPainter& painter, const QRectF& inset, const PaneFace& face, InsetMap* kept = nullptr);
/// Paints texts, frame and OTF of a pane whose picture is painted. `kept` and threads as above.
void paintFace(QPainter& painter, const QRect& pane, const PaneFace& face, const CaptionLayout& caption,
               InsetMap* kept = nullptr);

}  // namespace echolucent
