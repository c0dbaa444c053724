// Where the scale bar and the orientation marker stand in a picture, their texts, and the lines of the caption. The
// screen and movies share them.
#pragma once

#include <array>
#include <functional>
#include <opencv2/core/matx.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// Red, green, blue, each 0..255.
using Colour = std::array<unsigned char, 3>;
/// Pixels: x right, y up, from the picture's lower left corner.
using Point2 = cv::Vec2d;

/// The share of the light that a shade takes from a picture which another is about to replace.
inline constexpr double oldPictureShade = 0.65;
inline constexpr double annotationMargin = 18.0;  ///< from the picture's edges, pixels of a plain screen
inline constexpr int annotationFontSize = 14;     ///< pixels of a plain screen (72 dpi)
inline constexpr Colour annotationColour{0xd8, 0xdd, 0xe2};

struct AnnotationLine {
    Point2 from, to;
    double width = 1.0;  ///< pixels
    Colour colour{};
};

struct AnnotationDisc {
    Point2 centre;
    double radius = 1.0;  ///< pixels
    Colour colour{};
};

/// The part of a text that lies at the text's place: shares of its width from the left and of its height from below.
struct TextAnchor {
    double right = 0.0, up = 0.0;
};

/// Words of one or more lines.
struct AnnotationText {
    std::string words;
    Point2 at;
    TextAnchor anchor{};
    Colour colour{};
};

/// Shapes in the order in which they are drawn, and texts over them.
struct AnnotationLayout {
    std::vector<std::variant<AnnotationLine, AnnotationDisc>> shapes{};
    std::vector<AnnotationText> texts{};
};

/// A caption of one or more lines whose facts are parted by " · ". A line that is wider than `width` goes on in the
/// next one, before a fact; one fact alone may be wider. `widthOf` tells how wide a line is, in the unit of `width`.
[[nodiscard]] std::string captionWithin(std::string_view caption, double width,
                                        const std::function<double(const std::string& line)>& widthOf);

/// The longest length up to a limit (> 0), in mm, that is 1, 2 or 5 times a power of ten. Its text: "10 mm", "0.5 mm".
struct RoundLength {
    double mm = 1.0;
    std::string text;
};
[[nodiscard]] RoundLength roundLengthUpTo(double mm);

/// A bar of a round number of millimetres in the lower right corner of a picture of width x height pixels. The picture
/// shows `heightMm` from top to bottom. If the volume's spacing is unknown, a sentence says so, and there is no bar.
/// `scale` is the number of pixels per pixel of a plain screen.
[[nodiscard]] AnnotationLayout scaleBarLayout(int width, int height, double scale, double heightMm, bool spacingKnown);

/// Where an axis (a unit vector in grid mm) points in the picture: x right, y up, z towards the viewer.
[[nodiscard]] Vec3 seenFrom(const ViewFrame& frame, const Vec3& axis);

/// Three arms along the grid's axes x, y and z from a common foot, lettered in this order, in the lower left corner.
/// `scale` is as in scaleBarLayout(). The arm nearest the viewer is drawn last. An axis nearly along the line of sight
/// is a disc. What points away from the viewer is darker.
[[nodiscard]] AnnotationLayout orientationLayout(double scale, const ViewFrame& frame);

}  // namespace echolucent
