#include "io/dicom/frames/dicom_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/dicom/frames/frame_times.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

constexpr DicomTag positionPatient{0x0020, 0x0032};
constexpr DicomTag orientationPatient{0x0020, 0x0037};
constexpr DicomTag locationsTag{0x0018, 0x2005};

/// What Slice Location Vector says, if Frame Increment Pointer names it.
struct SliceLocations {
    std::vector<double> offsets;  ///< mm from the first frame; empty if they say no places
    bool isWrong = false;         ///< whether they are not one number for each frame
};

SliceLocations sliceLocations(DcmItem& dataset, std::size_t frames) {
    if (!namesAsIncrement(dataset, locationsTag) || dicomText(dataset, locationsTag).empty()) return {};
    SliceLocations locations{dicomNumbers(dataset, locationsTag, frames)};
    if (locations.offsets.empty()) return {{}, true};
    const double first = locations.offsets.front();
    for (double& offset : locations.offsets) offset -= first;
    // Frames of one plane, whatever it is that changes from frame to frame.
    if (std::ranges::all_of(locations.offsets, [](double offset) { return offset == 0.0; })) return {};
    return locations;
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
    // A cosine rounded to one digit is off by 0.05. Numbers so large that the length overflows are refused too.
    const auto isDirection = [](const Vec3& vector) { return std::abs(length(vector) - 1.0) <= 0.05; };
    if (!isDirection(alongRow) || !isDirection(alongColumn)) return std::nullopt;
    const Vec3 row = normalized(alongRow);
    const Vec3 column = normalized(alongColumn);
    if (!(std::abs(row.dot(column)) <= 0.01)) return std::nullopt;
    return std::array<Vec3, 2>{row, normalized(column - row * row.dot(column))};
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

Result<std::optional<ClassicPlaces>> classicPlaces(DcmItem& dataset, const std::string& path, std::size_t frames) {
    constexpr DicomTag offsetsTag{0x3004, 0x000c};
    const auto refuse = [&](const std::string& element, const std::string& problem) {
        auto refused = fail(FailureKind::unreadable, path, element, problem,
                            "Export it again, or add --frames-as-slices to take its pictures as slices; their distance "
                            "stays unknown unless the file states it.");
        refused.value().framesCouldBeSlices = true;
        return refused;
    };
    const auto isStatedIn = [](DcmItem& item, DicomTag tag) { return !dicomText(item, tag).empty(); };
    const auto isStated = [&](DicomTag tag) { return isStatedIn(dataset, tag); };
    const bool byOffsets = isStated(offsetsTag);
    auto scale = pictureScaleOf(dataset);
    const bool isScaled = scale && scale->kind != PictureScale::Kind::shapeOnly;
    SliceLocations locations = byOffsets ? SliceLocations() : sliceLocations(dataset, frames);
    const bool byLocations = !locations.offsets.empty() || (locations.isWrong && !isStated(sliceDistanceTag));
    if (framesFollowInTime(dataset) || !(byOffsets || byLocations || isStated(sliceDistanceTag)) ||
        !(isScaled || isStated(pixelSpacingTag)))
        return std::optional<ClassicPlaces>();
    ClassicPlaces places;
    const auto between = dicomNumber(dataset, sliceDistanceTag);
    const std::string locationsName = tagText(locationsTag) + " Slice Location Vector";
    if (byOffsets) {
        places.name = tagText(offsetsTag) + " Grid Frame Offset Vector";
        places.offsets = dicomNumbers(dataset, offsetsTag, frames);
        if (places.offsets.empty())
            return refuse(places.name, "is not one number for each of " + std::to_string(frames) + " frames");
    } else if (byLocations) {
        places.name = locationsName;
        if (locations.isWrong)
            return refuse(places.name, "is not one number for each of " + std::to_string(frames) + " frames");
        places.offsets = std::move(locations.offsets);
    } else {
        if (locations.isWrong)
            places.warnings.push_back(
                fmt::format("{} is not one number for each of {} frames; it was left out.", locationsName, frames));
        places.name = tagText(sliceDistanceTag) + " Spacing Between Slices";
        if (!between) return refuse(places.name, "is no number");
        if (*between == 0.0) return std::optional<ClassicPlaces>();
        places.between = between;
        // Cines of scanners have regions and times, and often no pointer that names the times.
        places.isBetweenGuess = !isStated(pixelSpacingTag) && statesFrameTime(dataset);
        if (places.isBetweenGuess) places.warnings.push_back(distanceIsGuess(places.name, std::abs(*between)));
    }
    if (isStated(pixelSpacingTag) && !dicomPixelSpacing(dataset))
        return refuse(tagText(pixelSpacingTag) + " Pixel Spacing", "is not two numbers above 0");
    // Nuclear medicine states the place of a volume in the description of its detector.
    constexpr DicomTag detectorSequence{0x0054, 0x0022};
    DcmItem* const detector =
        isStated(positionPatient) || isStated(orientationPatient) ? nullptr : dicomFirstItem(dataset, detectorSequence);
    DcmItem& holder = detector != nullptr ? *detector : dataset;
    // Pictures that are not placed by their detector are often written with zeros for its directions.
    const auto leaveOut = [&](const std::string& element, const std::string& problem) {
        places.warnings.push_back(fmt::format("{} in {} Detector Information {}; it was left out.", element,
                                              tagText(detectorSequence), problem));
    };
    const auto orientation = dicomOrientation(holder, orientationPatient);
    if (!orientation && isStatedIn(holder, orientationPatient)) {
        const std::string element = tagText(orientationPatient) + " Image Orientation (Patient)";
        const std::string problem = "is no pair of perpendicular directions";
        if (detector == nullptr) return refuse(element, problem);
        leaveOut(element, problem);
    }
    auto position = dicomPoint(holder, positionPatient);
    if (detector != nullptr && position && !isPosition(*position)) position.reset();
    if (!position && isStatedIn(holder, positionPatient)) {
        const std::string element = tagText(positionPatient) + " Image Position (Patient)";
        const std::string problem = "is no position: three numbers that are finite";
        if (detector == nullptr) return refuse(element, problem);
        leaveOut(element, problem);
    }
    const auto directions = orientation.value_or(std::array{Vec3(1, 0, 0), Vec3(0, 1, 0)});
    places.start = {position.value_or(Vec3(0, 0, 0)), directions[0], directions[1]};
    if (!isPosition(places.start.position)) places.name = tagText(positionPatient) + " Image Position";
    if (!places.between) places.otherBetween = between;
    places.orientationInPatient = orientation.has_value();
    places.scale = *std::move(scale);
    return std::optional(std::move(places));
}

}  // namespace echolucent
