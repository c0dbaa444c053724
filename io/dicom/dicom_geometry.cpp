#include "io/dicom/dicom_geometry.h"

#include <cmath>

#include "io/study_assembly.h"

namespace echolucent {

namespace {

constexpr DicomTag positionPatient{0x0020, 0x0032};
constexpr DicomTag orientationPatient{0x0020, 0x0037};
constexpr DicomTag pixelSpacing{0x0028, 0x0030};

bool framesFollowInTime(DcmItem& dataset) {
    const std::string pointer = dicomText(dataset, {0x0028, 0x0009});
    return pointer.find("0018,1063") != std::string::npos || pointer.find("0018,1065") != std::string::npos;
}

}  // namespace

std::optional<Vec3> dicomPoint(DcmItem& item, DicomTag tag) {
    const auto values = dicomNumbers(item, tag, 3);
    if (values.empty()) return std::nullopt;
    return Vec3(values[0], values[1], values[2]);
}

std::optional<std::array<Vec3, 2>> dicomOrientation(DcmItem& item, DicomTag tag) {
    const auto values = dicomNumbers(item, tag, 6);
    if (values.empty()) return std::nullopt;
    const Vec3 alongRow(values[0], values[1], values[2]);
    const Vec3 alongColumn(values[3], values[4], values[5]);
    // The largest numbers have no length that a double could hold.
    const auto isDirection = [](const Vec3& vector) { return length(vector) >= 0.5 && std::isfinite(length(vector)); };
    if (!isDirection(alongRow) || !isDirection(alongColumn)) return std::nullopt;
    const Vec3 row = normalized(alongRow);
    const Vec3 column = normalized(alongColumn);
    if (!(std::abs(row.dot(column)) <= 0.01)) return std::nullopt;
    return std::array<Vec3, 2>{row, normalized(column - row * row.dot(column))};
}

std::optional<std::array<double, 2>> dicomPixelSpacing(DcmItem& item) {
    const auto values = dicomNumbers(item, pixelSpacing, 2);
    if (values.empty() || !(values[0] > 0) || !(values[1] > 0)) return std::nullopt;
    return std::array<double, 2>{values[1], values[0]};  // the tag holds the distance between rows first
}

std::optional<FramePlacement> topLevelPlacement(DcmItem& dataset) {
    FramePlacement placement;
    placement.position = dicomPoint(dataset, positionPatient);
    placement.positionTag = positionPatient;
    placement.orientation = dicomOrientation(dataset, orientationPatient);
    placement.orientationInPatient = true;
    placement.pixelSpacing = dicomPixelSpacing(dataset);
    if (!placement.position || !placement.orientation) return std::nullopt;
    return placement;
}

std::vector<FramePlacement> classicPlacements(DcmItem& dataset, std::size_t frames) {
    const auto spacing = dicomPixelSpacing(dataset);
    if (!spacing || framesFollowInTime(dataset)) return {};
    DicomTag offsetTag{0x3004, 0x000c};
    auto offsets = dicomNumbers(dataset, offsetTag, frames);
    if (offsets.empty()) {
        offsetTag = {0x0018, 0x0088};
        const auto between = dicomNumbers(dataset, offsetTag, 1);
        if (between.empty() || between[0] == 0.0) return {};
        offsets.resize(frames);
        for (std::size_t frame = 0; frame < frames; ++frame) offsets[frame] = static_cast<double>(frame) * between[0];
    }
    const auto stated = dicomOrientation(dataset, orientationPatient);
    const auto orientation = stated.value_or(std::array{Vec3(1, 0, 0), Vec3(0, 1, 0)});
    const Vec3 origin = dicomPoint(dataset, positionPatient).value_or(Vec3(0, 0, 0));
    const Vec3 normal = orientation[0].cross(orientation[1]);
    std::vector<FramePlacement> placements(frames);
    for (std::size_t frame = 0; frame < frames; ++frame) {
        placements[frame].position = origin + normal * offsets[frame];
        placements[frame].positionTag = isPosition(origin) ? offsetTag : positionPatient;
        placements[frame].orientation = orientation;
        placements[frame].orientationInPatient = stated.has_value();
        placements[frame].pixelSpacing = spacing;
    }
    return placements;
}

std::optional<std::array<double, 2>> pixelSpacingOf(DcmItem& dataset, std::string& source) {
    if (const auto spacing = dicomPixelSpacing(dataset)) {
        source = tagText(pixelSpacing);
        return spacing;
    }
    DcmItem* region = dicomFirstItem(dataset, {0x0018, 0x6011});
    if (region == nullptr) return std::nullopt;
    const auto x = dicomNumbers(*region, {0x0018, 0x602c}, 1);
    const auto y = dicomNumbers(*region, {0x0018, 0x602e}, 1);
    const bool centimetres =
        dicomWholeNumber(*region, {0x0018, 0x6024}) == 3 && dicomWholeNumber(*region, {0x0018, 0x6026}) == 3;
    if (!centimetres || x.empty() || y.empty() || x[0] == 0 || y[0] == 0) return std::nullopt;
    source = "(0018,602c), (0018,602e)";
    return std::array<double, 2>{std::abs(x[0]) * 10.0, std::abs(y[0]) * 10.0};
}

}  // namespace echolucent
