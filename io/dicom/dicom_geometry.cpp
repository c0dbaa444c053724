#include "io/dicom/dicom_geometry.h"

#include <cmath>

#include "io/study_assembly.h"

namespace echolucent {

namespace {

constexpr DicomTag positionPatient{0x0020, 0x0032};
constexpr DicomTag orientationPatient{0x0020, 0x0037};
constexpr DicomTag pixelSpacingTag{0x0028, 0x0030};

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
    const auto values = dicomNumbers(item, pixelSpacingTag, 2);
    if (values.empty() || !(values[0] > 0) || !(values[1] > 0)) return std::nullopt;
    return std::array<double, 2>{values[1], values[0]};  // the tag holds the distance between rows first
}

std::optional<FramePlacement> topLevelPlacement(DcmItem& dataset) {
    FramePlacement placement;
    placement.position = dicomPoint(dataset, positionPatient);
    placement.orientation = dicomOrientation(dataset, orientationPatient);
    placement.orientationInPatient = true;
    placement.pixelSpacing = dicomPixelSpacing(dataset);
    if (!placement.position || !placement.orientation) return std::nullopt;
    return placement;
}

std::optional<ClassicPlaces> classicPlaces(DcmItem& dataset, std::size_t frames) {
    const auto spacing = dicomPixelSpacing(dataset);
    if (!spacing || framesFollowInTime(dataset)) return std::nullopt;
    ClassicPlaces places;
    places.name = "(3004,000c) Grid Frame Offset Vector";
    places.offsets = dicomNumbers(dataset, {0x3004, 0x000c}, frames);
    if (places.offsets.empty()) {
        places.name = "(0018,0088) Spacing Between Slices";
        const auto between = dicomNumbers(dataset, {0x0018, 0x0088}, 1);
        if (between.empty() || between[0] == 0.0) return std::nullopt;
        places.between = between[0];
    }
    const auto stated = dicomOrientation(dataset, orientationPatient);
    const auto orientation = stated.value_or(std::array{Vec3(1, 0, 0), Vec3(0, 1, 0)});
    places.start = {dicomPoint(dataset, positionPatient).value_or(Vec3(0, 0, 0)), orientation[0], orientation[1]};
    if (!isPosition(places.start.position)) places.name = tagText(positionPatient) + " Image Position";
    places.orientationInPatient = stated.has_value();
    places.pixelSpacing = *spacing;
    return places;
}

}  // namespace echolucent
