#include "io/dicom/dicom_window.h"

#include <cmath>

#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/headers/header_text.h"

namespace echolucent {

namespace {

constexpr DicomTag centreTag{0x0028, 0x1050};
constexpr DicomTag widthTag{0x0028, 0x1051};
constexpr DicomTag interceptTag{0x0028, 0x1052};
constexpr DicomTag slopeTag{0x0028, 0x1053};
constexpr DicomTag functionTag{0x0028, 0x1056};
constexpr DicomTag lutTag{0x0028, 0x3010};
constexpr DicomTag sharedGroupsTag{0x5200, 0x9229};
constexpr DicomTag perFrameGroupsTag{0x5200, 0x9230};
constexpr DicomTag frameLutTag{0x0028, 0x9132};
constexpr DicomTag transformationTag{0x0028, 0x9145};

/// Where a window stands, and where its rescaling.
struct WindowPlace {
    DcmItem* window = nullptr;
    DcmItem* rescale = nullptr;
    std::string words;  ///< after the tag in the import report: ", first frame"
};

WindowPlace placeOf(DcmItem& dataset) {
    if (dicomHas(dataset, centreTag)) return {&dataset, &dataset, ""};
    WindowPlace place;
    for (const auto& [tag, words] :
         {std::pair{sharedGroupsTag, ", all frames"}, std::pair{perFrameGroupsTag, ", first frame"}}) {
        DcmItem* groups = dicomFirstItem(dataset, tag);
        if (groups == nullptr) continue;
        if (place.rescale == nullptr) place.rescale = dicomFirstItem(*groups, transformationTag);
        if (place.window != nullptr) continue;
        place.window = dicomFirstItem(*groups, frameLutTag);
        place.words = words;
    }
    if (place.rescale == nullptr) place.rescale = &dataset;
    return place;
}

std::string firstValueOf(DcmItem& item, DicomTag tag) {
    const std::string text = dicomText(item, tag);
    return trimmed(text.substr(0, text.find('\\')));
}

/// The first value of the attribute, `missing` where it is missing; NaN where it is no number.
double numberOr(DcmItem& item, DicomTag tag, double missing) {
    if (!dicomHas(item, tag)) return missing;
    return realNumber(firstValueOf(item, tag)).value_or(NAN);
}

double inverted(const DicomPixelFormat& format, double value) {
    const int values = 1 << format.bitsStored;
    return (format.isSigned ? -1 : values - 1) - value;
}

}  // namespace

DicomWindow readWindow(DcmItem& dataset, const DicomPixelFormat& format) {
    DicomWindow window;
    const bool grey = format.model == ColourModel::monochrome1 || format.model == ColourModel::monochrome2;
    if (!grey || format.bitsStored <= 8) return window;
    const WindowPlace place = placeOf(dataset);
    DcmItem& holder = place.window != nullptr ? *place.window : dataset;
    const std::string function = dicomText(holder, functionTag);
    if (dicomHas(holder, lutTag) || (!function.empty() && function != "LINEAR" && function != "LINEAR_EXACT"))
        window.warnings.push_back("The VOI LUT of the file is not applied: grey values are shown linearly.");
    if (place.window == nullptr || !dicomHas(holder, centreTag)) return window;

    const double centre = numberOr(holder, centreTag, NAN), width = numberOr(holder, widthTag, NAN);
    const double slope = numberOr(*place.rescale, slopeTag, 1.0);
    const double intercept = numberOr(*place.rescale, interceptTag, 0.0);
    const bool dark = format.model == ColourModel::monochrome1;
    const double stored = (centre + (dark ? -width : width) / 2.0 - intercept) / slope;
    if (!std::isfinite(stored) || !(width > 0.0) || !(slope > 0.0)) {
        window.warnings.push_back(fmt::format(
            "The window of the file (centre {}, width {}) is not taken: it and its rescaling are no window.",
            quotedText(firstValueOf(holder, centreTag)), quotedText(firstValueOf(holder, widthTag))));
        return window;
    }
    window.white =
        WindowWhite{dark ? inverted(format, stored) : stored, fmt::format("centre {:.6g}, width {:.6g}", centre, width),
                    tagText(centreTag) + " Window Center, " + tagText(widthTag) + " Width" + place.words};
    return window;
}

}  // namespace echolucent
