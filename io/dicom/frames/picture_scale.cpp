#include "io/dicom/frames/picture_scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/frames/frame_times.h"

namespace echolucent {

namespace {

constexpr DicomTag regionsTag{0x0018, 0x6011};

bool isScale(double mm) { return std::isfinite(mm) && mm >= 1e-4 && mm <= 1e4; }

/// Takes the mean of x and y along z, which is a guess.
Vec3 spacingFrom(double x, double y) { return {x, y, (x + y) / 2}; }

double numberOr(DcmItem& item, DicomTag tag, double missing) { return dicomNumber(item, tag).value_or(missing); }

/// The number of pixels in a region; 0 if its corners are missing or make no sense.
double areaOf(DcmItem& region) {
    const double width = numberOr(region, {0x0018, 0x601c}, 0) - numberOr(region, {0x0018, 0x6018}, 0);
    const double height = numberOr(region, {0x0018, 0x601e}, 0) - numberOr(region, {0x0018, 0x601a}, 0);
    return width > 0 && height > 0 ? width * height : 0;
}

bool isSameScale(const Vec3& one, const Vec3& other) {
    const auto close = [](double a, double b) { return std::abs(a - b) <= 0.01 * std::max(a, b); };
    return close(one[0], other[0]) && close(one[1], other[1]);
}

/// The scale of a region in mm; no value if it is no 2D picture, or if its units are no lengths.
std::optional<Vec3> scaleOfRegion(DcmItem& region) {
    const bool flat = dicomWholeNumber(region, {0x0018, 0x6012}).value_or(1) == 1;
    const bool centimetres =
        dicomWholeNumber(region, {0x0018, 0x6024}) == 3 && dicomWholeNumber(region, {0x0018, 0x6026}) == 3;
    const double x = 10 * std::abs(numberOr(region, {0x0018, 0x602c}, 0));
    const double y = 10 * std::abs(numberOr(region, {0x0018, 0x602e}, 0));
    if (!flat || !centimetres || !isScale(x) || !isScale(y)) return std::nullopt;
    return spacingFrom(x, y);
}

std::optional<PictureScale> scaleOfRegions(DcmItem& dataset) {
    std::optional<PictureScale> scale;
    std::optional<Vec3> other;  // the first scale that is not the largest region's
    double largest = -1;
    dicomVisitItems(dataset, regionsTag, [&](DcmItem& region) {
        const auto found = scaleOfRegion(region);
        if (!found) return true;
        if (scale && !isSameScale(*found, scale->spacing)) other = areaOf(region) > largest ? scale->spacing : *found;
        if (areaOf(region) > largest) {
            largest = areaOf(region);
            if (!scale) scale.emplace();
            scale->spacing = *found;
            scale->source.assign("(0018,602c), (0018,602e) of the largest 2D region");
        }
        return true;
    });
    if (!scale || !other || isSameScale(*other, scale->spacing)) return scale;
    scale->kind = PictureScale::Kind::severalScales;
    scale->warning = fmt::format(
        "The picture holds 2D regions of different scales ({:.4g} x {:.4g} mm and {:.4g} x {:.4g} mm a pixel), so that "
        "no size of its pixels is right everywhere; that of the largest region is assumed.",
        scale->spacing[0], scale->spacing[1], (*other)[0], (*other)[1]);
    return scale;
}

/// The shape of pixels that are no squares.
std::optional<PictureScale> shapeOfPixels(DcmItem& dataset) {
    const auto ratio = dicomNumbers(dataset, {0x0028, 0x0034}, 2);
    if (ratio.empty() || !(ratio[0] > 0) || !(ratio[1] > 0)) return std::nullopt;
    const double height = ratio[0] / ratio[1];
    if (!isScale(height) || height == 1) return std::nullopt;
    return PictureScale{
        PictureScale::Kind::shapeOnly, spacingFrom(1, height), "",
        fmt::format("(0028,0034) Pixel Aspect Ratio: pixels are taken to be {:.4g} times as high as wide.", height)};
}

}  // namespace

std::optional<std::array<double, 2>> dicomPixelSpacing(DcmItem& item) {
    const auto values = dicomNumbers(item, pixelSpacingTag, 2);
    if (values.empty() || !(values[0] > 0) || !(values[1] > 0)) return std::nullopt;
    return std::array<double, 2>{values[1], values[0]};  // the tag holds the distance between rows first
}

std::optional<PictureScale> pictureScaleOf(DcmItem& dataset) {
    if (const auto spacing = dicomPixelSpacing(dataset))
        return PictureScale{PictureScale::Kind::stated, spacingFrom((*spacing)[0], (*spacing)[1]), "(0028,0030)"};
    if (auto scale = scaleOfRegions(dataset)) return scale;
    return shapeOfPixels(dataset);
}

std::optional<double> statedSliceDistance(DcmItem& dataset) {
    const double distance = std::abs(numberOr(dataset, sliceDistanceTag, 0));
    return isScale(distance) ? std::optional(distance) : std::nullopt;
}

std::string distanceIsGuess(const std::string& source, double mm) {
    return fmt::format(
        "{} is {:.4g} mm; it is a guess that the frames are so far apart, because the file says that they follow each "
        "other in time.",
        source, mm);
}

SliceScale sliceScaleOf(DcmItem& dataset, std::optional<double> distance, const std::string& distanceSource) {
    const auto scale = pictureScaleOf(dataset);
    SliceScale found;
    std::string source = distanceSource;
    bool isDistanceKnown = true;
    if (!distance) {
        distance = statedSliceDistance(dataset);
        source = tagText(sliceDistanceTag);
        isDistanceKnown = distance && !framesFollowInTime(dataset);
        if (distance && !isDistanceKnown)
            found.warnings.push_back(distanceIsGuess(source + " Spacing Between Slices", *distance));
    }
    found.inPlaneKnown = scale && scale->kind == PictureScale::Kind::stated;
    found.spacingKnown = found.inPlaneKnown && isDistanceKnown;
    if (scale && !scale->warning.empty()) found.warnings.push_back(scale->warning);
    if (found.inPlaneKnown) found.source = isDistanceKnown ? scale->source + ", " + source : scale->source;
    if (scale) found.spacing = scale->spacing;
    if (distance && (!scale || scale->kind == PictureScale::Kind::shapeOnly)) {
        found.spacing *= *distance;
        found.warnings.push_back(pixelSizeUnknown(*distance));
    }
    if (distance) found.spacing[2] = *distance;
    return found;
}

std::string pixelSizeUnknown(double betweenSlices) {
    return fmt::format(
        "The size of the pixels is not stated: they are taken to be as long and wide as the slices are apart, {:.4g} "
        "mm, which is a guess.",
        betweenSlices);
}

}  // namespace echolucent
