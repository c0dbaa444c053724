#include "io/dicom/pixels/pixel_padding.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/files/header_text.h"

namespace echolucent {

namespace {

constexpr DicomTag paddingTag{0x0028, 0x0120};
constexpr DicomTag limitTag{0x0028, 0x0121};
constexpr const char* paddingName = "(0028,0120) Pixel Padding Value";
constexpr const char* limitName = "(0028,0121) Pixel Padding Range Limit";

/// The attribute as a value that the allocated bits can hold; no value if it is none.
std::optional<int> sampleIn(DcmItem& dataset, DicomTag tag, const GreySamples& samples) {
    const auto stated = dicomWholeNumber(dataset, tag);
    if (!stated || *stated < -0x8000 || *stated > 0xffff) return std::nullopt;
    auto value = static_cast<int>(*stated);
    // The attribute has 16 bits, with or without a sign. Programs, and implicit VR, mistake one for the other.
    for (const int bits : {16, samples.bitsAllocated}) {
        const int all = 1 << bits, half = all / 2;
        if (value < -half || value >= all) return std::nullopt;
        if (samples.isSigned && value >= half) value -= all;
        if (!samples.isSigned && value < 0 && bits == samples.bitsAllocated) value += all;
    }
    return value;
}

}  // namespace

std::optional<PixelPadding> readPadding(DcmItem& dataset, const GreySamples& samples, std::vector<std::string>& notes) {
    const std::string stated = dicomText(dataset, paddingTag), statedLimit = dicomText(dataset, limitTag);
    if (stated.empty()) return std::nullopt;
    const auto value = sampleIn(dataset, paddingTag, samples);
    if (!value) {
        notes.push_back(
            fmt::format("{} is {}, which no pixel can hold; it was left out.", paddingName, quotedText(stated)));
        return std::nullopt;
    }
    auto limit = statedLimit.empty() ? value : sampleIn(dataset, limitTag, samples);
    if (!limit) {
        notes.push_back(
            fmt::format("{} is {}, which no pixel can hold; it was left out.", limitName, quotedText(statedLimit)));
        limit = value;
    }
    PixelPadding padding{std::min(*value, *limit), std::max(*value, *limit), fmt::format("{} {}", paddingName, *value)};
    if (*value != *limit) padding.words += fmt::format(" to {} {}", limitName, *limit);
    if (!samples.dark && !samples.isSigned && padding.high == 0) return std::nullopt;
    if (padding.low <= samples.smallest && padding.high >= samples.largest) {
        notes.push_back(padding.words + " would leave no value for the picture; it was left out.");
        return std::nullopt;
    }
    return padding;
}

}  // namespace echolucent
