#include "io/dicom/pixels/dicom_window.h"

#include <cmath>

#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/frames/functional_groups.h"
#include "io/files/header_text.h"

namespace echolucent {

namespace {

constexpr DicomTag centreTag{0x0028, 0x1050};
constexpr DicomTag widthTag{0x0028, 0x1051};
constexpr DicomTag functionTag{0x0028, 0x1056};
constexpr DicomTag lutTag{0x0028, 0x3010};
constexpr DicomTag frameLutTag{0x0028, 0x9132};

struct WindowPlace {
    DcmItem* window = nullptr;
    std::string words;  ///< after the tag in the import report: ", frame 1"
};

/// The groups of one frame; null if it has none.
DcmItem* groupsOf(DcmItem& dataset, std::size_t frame) {
    DcmItem* found = nullptr;
    std::size_t index = 0;
    dicomVisitItems(dataset, perFrameGroupsTag, [&](DcmItem& groups) {
        if (index == frame) found = &groups;
        return index++ < frame;
    });
    return found;
}

WindowPlace placeOf(DcmItem& dataset, std::size_t frame) {
    if (dicomHas(dataset, centreTag)) return {&dataset, ""};
    DcmItem* const shared = dicomFirstItem(dataset, sharedGroupsTag);
    if (DcmItem* window = shared != nullptr ? dicomFirstItem(*shared, frameLutTag) : nullptr)
        return {window, ", all frames"};
    DcmItem* const own = groupsOf(dataset, frame);
    if (DcmItem* window = own != nullptr ? dicomFirstItem(*own, frameLutTag) : nullptr)
        return {window, fmt::format(", frame {}", frame + 1)};
    return {};
}

std::string firstValueOf(DcmItem& item, DicomTag tag) {
    const std::string text = dicomText(item, tag);
    return trimmed(text.substr(0, text.find('\\')));
}

/// The first value of the attribute; NaN if it is missing or no number.
double numberIn(DcmItem& item, DicomTag tag) { return decimalNumber(firstValueOf(item, tag)).value_or(NAN); }

}  // namespace

DicomWindow readWindow(DcmItem& dataset, const DicomPixelFormat& format, std::size_t frame, const Rescale& rescale) {
    DicomWindow window;
    const bool grey = format.model == ColourModel::monochrome1 || format.model == ColourModel::monochrome2;
    if (!grey || format.bitsStored <= 8) return window;
    const WindowPlace place = placeOf(dataset, frame);
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
    const double shownBlack = centre - (dark ? -width : width) / 2.0;
    window.white = DisplayWindow{dark ? ends - shownWhite : shownWhite, dark ? ends - shownBlack : shownBlack,
                                 fmt::format("centre {:.6g}, width {:.6g}", centre, width),
                                 tagText(centreTag) + " Window Center, " + tagText(widthTag) + " Width" + place.words};
    return window;
}

}  // namespace echolucent
