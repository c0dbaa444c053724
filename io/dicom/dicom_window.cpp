#include "io/dicom/dicom_window.h"

#include <cmath>

#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/headers/header_text.h"

namespace echolucent {

namespace {

constexpr DicomTag centreTag{0x0028, 0x1050};
constexpr DicomTag widthTag{0x0028, 0x1051};
constexpr DicomTag functionTag{0x0028, 0x1056};
constexpr DicomTag lutTag{0x0028, 0x3010};
constexpr DicomTag sharedGroupsTag{0x5200, 0x9229};
constexpr DicomTag perFrameGroupsTag{0x5200, 0x9230};
constexpr DicomTag frameLutTag{0x0028, 0x9132};

/// Where a window stands.
struct WindowPlace {
    DcmItem* window = nullptr;
    std::string words;  ///< after the tag in the import report: ", first frame"
};

WindowPlace placeOf(DcmItem& dataset) {
    if (dicomHas(dataset, centreTag)) return {&dataset, ""};
    for (const auto& [tag, words] :
         {std::pair{sharedGroupsTag, ", all frames"}, std::pair{perFrameGroupsTag, ", first frame"}}) {
        DcmItem* groups = dicomFirstItem(dataset, tag);
        if (groups == nullptr) continue;
        if (DcmItem* window = dicomFirstItem(*groups, frameLutTag)) return {window, words};
    }
    return {};
}

std::string firstValueOf(DcmItem& item, DicomTag tag) {
    const std::string text = dicomText(item, tag);
    return trimmed(text.substr(0, text.find('\\')));
}

/// The first value of the attribute; NaN where it is missing or no number.
double numberIn(DcmItem& item, DicomTag tag) { return realNumber(firstValueOf(item, tag)).value_or(NAN); }

}  // namespace

DicomWindow readWindow(DcmItem& dataset, const DicomPixelFormat& format, const LinearRescale& rescale) {
    DicomWindow window;
    const bool grey = format.model == ColourModel::monochrome1 || format.model == ColourModel::monochrome2;
    if (!grey || format.bitsStored <= 8) return window;
    const WindowPlace place = placeOf(dataset);
    DcmItem& holder = place.window != nullptr ? *place.window : dataset;
    const std::string function = dicomText(holder, functionTag);
    if (dicomHas(holder, lutTag) || (!function.empty() && function != "LINEAR" && function != "LINEAR_EXACT"))
        window.warnings.emplace_back("The VOI LUT of the file is not applied: grey values are shown linearly.");
    if (place.window == nullptr || !dicomHas(holder, centreTag)) return window;

    const double centre = numberIn(holder, centreTag), width = numberIn(holder, widthTag);
    const bool dark = format.model == ColourModel::monochrome1;
    const double shownWhite = centre + (dark ? -width : width) / 2.0;
    const double ends = rescale.of(format.smallestValue()) + rescale.of(format.largestValue());
    if (!std::isfinite(shownWhite) || !(width > 0.0)) {
        window.warnings.push_back(
            fmt::format("The window of the file (centre {}, width {}) is not taken: its numbers are no window.",
                        quotedText(firstValueOf(holder, centreTag)), quotedText(firstValueOf(holder, widthTag))));
        return window;
    }
    window.white =
        WindowWhite{dark ? ends - shownWhite : shownWhite, fmt::format("centre {:.6g}, width {:.6g}", centre, width),
                    tagText(centreTag) + " Window Center, " + tagText(widthTag) + " Width" + place.words};
    return window;
}

}  // namespace echolucent
