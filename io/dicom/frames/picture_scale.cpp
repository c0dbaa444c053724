#include "io/dicom/frames/picture_scale.h"

#include <cmath>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/frames/dicom_geometry.h"

namespace echolucent {

namespace {

constexpr DicomTag regionsTag{0x0018, 0x6011};

bool isScale(double mm) { return std::isfinite(mm) && mm >= 1e-4 && mm <= 1e4; }

/// Takes the mean of x and y along z, which is a guess.
Vec3 spacingFrom(double x, double y) { return {x, y, (x + y) / 2}; }

double numberOr(DcmItem& item, DicomTag tag, double missing) {
    const auto values = dicomNumbers(item, tag, 1);
    return values.empty() ? missing : values[0];
}

/// The number of pixels in a region; 0 if its corners are missing or make no sense.
double areaOf(DcmItem& region) {
    const double width = numberOr(region, {0x0018, 0x601c}, 0) - numberOr(region, {0x0018, 0x6018}, 0);
    const double height = numberOr(region, {0x0018, 0x601e}, 0) - numberOr(region, {0x0018, 0x601a}, 0);
    return width > 0 && height > 0 ? width * height : 0;
}

}  // namespace

std::optional<PictureScale> pictureScaleOf(DcmItem& dataset) {
    if (const auto spacing = dicomPixelSpacing(dataset))
        return PictureScale{spacingFrom((*spacing)[0], (*spacing)[1]), "(0028,0030)"};
    std::optional<PictureScale> scale;
    double largest = -1;
    dicomVisitItems(dataset, regionsTag, [&](DcmItem& region) {
        const bool flat = dicomWholeNumber(region, {0x0018, 0x6012}).value_or(1) == 1;
        const bool centimetres =
            dicomWholeNumber(region, {0x0018, 0x6024}) == 3 && dicomWholeNumber(region, {0x0018, 0x6026}) == 3;
        const double x = 10 * std::abs(numberOr(region, {0x0018, 0x602c}, 0));
        const double y = 10 * std::abs(numberOr(region, {0x0018, 0x602e}, 0));
        if (flat && centimetres && isScale(x) && isScale(y) && areaOf(region) > largest) {
            largest = areaOf(region);
            if (!scale) scale.emplace();
            scale->spacing = spacingFrom(x, y);
            scale->source.assign("(0018,602c), (0018,602e) of the largest 2D region");
        }
        return true;
    });
    return scale;
}

}  // namespace echolucent
