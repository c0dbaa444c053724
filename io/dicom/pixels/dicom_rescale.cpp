#include "io/dicom/pixels/dicom_rescale.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/frames/functional_groups.h"
#include "io/files/header_text.h"

namespace echolucent {

namespace {

constexpr DicomTag interceptTag{0x0028, 0x1052};
constexpr DicomTag slopeTag{0x0028, 0x1053};
constexpr DicomTag transformationTag{0x0028, 0x9145};

using Read = tl::expected<Rescale, PixelFormatProblem>;

tl::unexpected<PixelFormatProblem> problemAt(DicomTag tag, const char* name, std::string text) {
    return tl::unexpected(PixelFormatProblem{tagText(tag) + " " + name, std::move(text)});
}

/// Takes the attribute into `value`, which stays if the attribute is missing or empty. False if it is no finite number.
bool takeFactor(DcmItem& item, DicomTag tag, double& value) {
    const std::string text = dicomText(item, tag);
    if (text.empty()) return true;
    const auto number = decimalNumber(text);
    if (!number || !std::isfinite(*number)) return false;
    value = *number;
    return true;
}

Read rescaleOf(DcmItem& item, const DicomPixelFormat& format) {
    Rescale rescale;
    if (!takeFactor(item, slopeTag, rescale.slope))
        return problemAt(slopeTag, "Rescale Slope", "is no number: " + quotedText(dicomText(item, slopeTag)));
    if (!takeFactor(item, interceptTag, rescale.intercept))
        return problemAt(interceptTag, "Rescale Intercept",
                         "is no number: " + quotedText(dicomText(item, interceptTag)));
    if (rescale.slope == 0.0) return problemAt(slopeTag, "Rescale Slope", "is 0, which makes all values one");
    if (auto problem = problemOf(rescale, format.smallestValue(), format.largestValue()))
        return problemAt(slopeTag, "Rescale Slope", *std::move(problem));
    return rescale;
}

DcmItem* transformationIn(DcmItem* groups) {
    return groups != nullptr ? dicomFirstItem(*groups, transformationTag) : nullptr;
}

template <typename T>
void writeFloats(const Rescale& rescale, std::span<const std::uint8_t> grey, std::span<std::uint8_t> out) {
    for (std::size_t i = 0; i * sizeof(T) < grey.size(); ++i) {
        T stored{};
        std::memcpy(&stored, grey.data() + i * sizeof(T), sizeof(T));
        const auto value = static_cast<float>(rescale.of(stored));
        std::memcpy(out.data() + i * sizeof(float), &value, sizeof(float));
    }
}

}  // namespace

tl::expected<FrameRescales, PixelFormatProblem> readRescales(DcmItem& dataset, const DicomPixelFormat& format) {
    const bool grey = format.model == ColourModel::monochrome1 || format.model == ColourModel::monochrome2;
    if (!grey) return FrameRescales{};
    DcmItem* shared = transformationIn(dicomFirstItem(dataset, sharedGroupsTag));
    const Read all = rescaleOf(shared != nullptr ? *shared : dataset, format);
    if (!all) return tl::unexpected(all.error());
    FrameRescales rescales{*all, {}};
    std::optional<PixelFormatProblem> problem;
    bool perFrame = false;
    dicomVisitItems(dataset, perFrameGroupsTag, [&](DcmItem& groups) {
        DcmItem* own = transformationIn(&groups);
        const Read read = own != nullptr ? rescaleOf(*own, format) : all;
        if (!read) problem = read.error();
        perFrame = perFrame || own != nullptr;
        rescales.single.push_back(read.value_or(Rescale{}));
        return read && rescales.single.size() < static_cast<std::size_t>(format.frames);
    });
    if (problem) return tl::unexpected(*problem);
    if (!perFrame) rescales.single.clear();
    return rescales;
}

void applyRescale(const Rescale& rescale, std::span<const std::uint8_t> grey, StoredType type,
                  std::span<std::uint8_t> out) {
    switch (type) {
        case StoredType::uint8: return writeFloats<std::uint8_t>(rescale, grey, out);
        case StoredType::int8: return writeFloats<std::int8_t>(rescale, grey, out);
        case StoredType::int16: return writeFloats<std::int16_t>(rescale, grey, out);
        default: return writeFloats<std::uint16_t>(rescale, grey, out);
    }
}

}  // namespace echolucent
