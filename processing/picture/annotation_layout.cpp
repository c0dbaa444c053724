#include "processing/picture/annotation_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace echolucent {

namespace {

// Of the scale bar.
constexpr double longestShare = 0.22;    // of the picture's width
constexpr double longestPixels = 200.0;  // pixels of a plain screen
constexpr double tickHeight = 4.0;       // above and below the bar
constexpr double barWidth = 2.0;
constexpr const char* unknownSpacing = "spacing unknown:\nproportions may be wrong";

// Of the orientation marker.
constexpr double armLength = 40.0;       // pixels of a plain screen
constexpr double letterDistance = 10.0;  // beyond the arm's end
constexpr double armWidth = 3.0;
constexpr double discRadius = 5.0;
constexpr double alongSight = 0.2;  // an arm seen shorter than this share is a disc
constexpr double dimming = 0.55;    // of what points away from the viewer
constexpr std::array<Colour, 3> axisColours{Colour{0xe0, 0x7b, 0x7b}, Colour{0x8f, 0xbc, 0x8f},
                                            Colour{0x7d, 0xae, 0xe8}};
constexpr std::array<const char*, 3> axisNames{"x", "y", "z"};

Colour dimmedAway(const Colour& colour, double towardsViewer) {
    const double brightness = 1.0 - (1.0 - dimming) * std::clamp(-towardsViewer, 0.0, 1.0);
    Colour dimmed{};
    std::transform(colour.begin(), colour.end(), dimmed.begin(),
                   [&](unsigned char part) { return static_cast<unsigned char>(std::lround(part * brightness)); });
    return dimmed;
}

}  // namespace

std::string captionWithin(std::string_view caption, double width,
                          const std::function<double(const std::string& line)>& widthOf) {
    constexpr std::string_view between = " \xC2\xB7 ";
    std::string lines, line;
    const auto end = [&] {
        lines += (lines.empty() ? "" : "\n") + line;
        line.clear();
    };
    for (std::size_t at = 0; at < caption.size();) {
        const std::size_t endOfLine = std::min(caption.find('\n', at), caption.size());
        const std::size_t endOfFact = std::min(caption.find(between, at), endOfLine);
        const std::string fact(caption.substr(at, endOfFact - at));
        const std::string longer = line.empty() ? fact : line + std::string(between) + fact;
        if (!line.empty() && widthOf(longer) > width) {
            end();
            line = fact;
        } else {
            line = longer;
        }
        if (endOfFact == endOfLine) end();
        at = endOfFact + (endOfFact == endOfLine ? 1 : between.size());
    }
    return lines;
}

RoundLength roundLengthUpTo(double mm) {
    const double decade = std::pow(10.0, std::floor(std::log10(mm)));
    RoundLength rounded{decade, {}};
    for (const double times : {2.0, 5.0, 10.0}) {
        // Allow the limit itself, though rounding may put the logarithm just below it.
        if (times * decade <= mm * (1 + 1e-12)) rounded.mm = times * decade;
    }
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), rounded.mm, std::chars_format::general, 10).ptr;
    rounded.text = std::string(text.data(), end) + " mm";
    return rounded;
}

AnnotationLayout scaleBarLayout(int width, int height, double scale, double heightMm, bool spacingKnown) {
    const double margin = annotationMargin * scale;
    const double right = width - margin;
    if (!spacingKnown) return {.texts = {{unknownSpacing, {right, margin}, {1.0, 0.0}, annotationColour}}};
    const double pixelsPerMm = height / heightMm;
    const double longest = std::min(longestShare * width, longestPixels * scale);
    const RoundLength length = roundLengthUpTo(longest / pixelsPerMm);
    const double y = std::round(margin + tickHeight * scale);
    const double left = right - length.mm * pixelsPerMm;
    const double tick = tickHeight * scale, thick = barWidth * scale;
    AnnotationLayout layout;
    layout.shapes.emplace_back(AnnotationLine{{left, y - tick}, {left, y + tick}, thick, annotationColour});
    layout.shapes.emplace_back(AnnotationLine{{right, y - tick}, {right, y + tick}, thick, annotationColour});
    layout.shapes.emplace_back(AnnotationLine{{left, y}, {right, y}, thick, annotationColour});
    layout.texts.push_back({length.text, {(left + right) / 2, y + tick + 3 * scale}, {0.5, 0.0}, annotationColour});
    return layout;
}

Vec3 seenFrom(const ViewFrame& frame, const Vec3& axis) {
    return {frame.right.dot(axis), -frame.down.dot(axis), -frame.forward.dot(axis)};
}

AnnotationLayout orientationLayout(double scale, const ViewFrame& frame) {
    const double reach = annotationMargin + armLength + letterDistance;
    const Point2 foot{reach * scale, reach * scale};
    std::array<Vec3, 3> seen;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction{0, 0, 0};
        direction[axis] = 1.0;
        seen[static_cast<std::size_t>(axis)] = seenFrom(frame, direction);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return seen[a][2] < seen[b][2]; });

    AnnotationLayout layout;
    layout.texts.resize(3);
    for (const std::size_t axis : order) {
        const Point2 inPicture{seen[axis][0], seen[axis][1]};
        const double share = cv::norm(inPicture);
        const Colour colour = dimmedAway(axisColours[axis], seen[axis][2]);
        Point2 letter;
        if (share < alongSight) {
            layout.shapes.emplace_back(AnnotationDisc{foot, discRadius * scale, colour});
            // Put the letter opposite the other two arms, so that it covers neither.
            const Point2 others{seen[(axis + 1) % 3][0] + seen[(axis + 2) % 3][0],
                                seen[(axis + 1) % 3][1] + seen[(axis + 2) % 3][1]};
            letter = foot - others * ((discRadius + letterDistance) * scale / std::max(cv::norm(others), 1e-9));
        } else {
            const Point2 tip = foot + inPicture * (armLength * scale);
            layout.shapes.emplace_back(AnnotationLine{foot, tip, armWidth * scale, colour});
            letter = tip + inPicture * (letterDistance * scale / share);
        }
        layout.texts[axis] = {axisNames[axis], letter, {0.5, 0.5}, axisColours[axis]};
    }
    return layout;
}

}  // namespace echolucent
