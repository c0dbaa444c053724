#include "processing/scene/measurement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/choice_names.h"
#include "processing/one_line.h"
#include "processing/sampling/sampler.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> kindNames{"distance", "angle"};
constexpr ChoiceNames<2> groundNames{"plane", "surface"};

/// The text with each of its lines as oneLine().
std::string withPlainLines(std::string_view text) {
    std::string lines;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find('\n', begin);
        lines += oneLine(text.substr(begin, end == std::string_view::npos ? end : end - begin));
        if (end == std::string_view::npos) return lines;
        lines += '\n';
        begin = end + 1;
    }
}

std::string problemOfTexts(const Measurement& measurement) {
    const auto tooLong = [](const std::string& text, std::size_t longest) { return letterCount(text) > longest; };
    if (oneLine(measurement.name) != measurement.name)
        return "name must be one line of UTF-8 without control characters";
    if (tooLong(measurement.name, longestMeasurementName))
        return "name must have at most " + std::to_string(longestMeasurementName) + " letters";
    if (withPlainLines(measurement.comment) != measurement.comment)
        return "comment must be UTF-8 without control characters other than the ends of lines";
    if (tooLong(measurement.comment, longestMeasurementComment))
        return "comment must have at most " + std::to_string(longestMeasurementComment) + " letters";
    return {};
}

}  // namespace

std::string_view nameOf(MeasurementKind kind) { return nameIn(kindNames, kind); }

std::optional<MeasurementKind> measurementKindFromName(std::string_view name) {
    return choiceNamed<MeasurementKind>(kindNames, name);
}

std::size_t placesNeeded(MeasurementKind kind) { return kind == MeasurementKind::angle ? 3 : 2; }

std::string_view nameOf(MeasurementGround ground) { return nameIn(groundNames, ground); }

std::optional<MeasurementGround> measurementGroundFromName(std::string_view name) {
    return choiceNamed<MeasurementGround>(groundNames, name);
}

Result<double> measuredValue(const Measurement& measurement, const VolumeGeometry& geometry) {
    if (!geometry.spacingKnown)
        return fail(FailureKind::wrongUsage, {}, {},
                    "the spacing of this volume is not known, so that nothing can be measured in it",
                    "Open a file that states its spacing, or say it where raw data are opened.");
    const std::vector<Vec3>& places = measurement.placesMm;
    // Only the difference of two places counts, so origin and voxel counts drop out.
    const auto way = [&](const Vec3& from, const Vec3& to) { return geometry.direction * (to - from); };
    if (measurement.kind == MeasurementKind::distance) {
        const double distance = cv::norm(way(places[0], places[1]));
        if (distance == 0.0)
            return fail(FailureKind::wrongUsage, {}, {}, "a distance needs two places that lie apart",
                        "Mark another place.");
        return distance;
    }
    const Vec3 first = way(places[1], places[0]), second = way(places[1], places[2]);
    if (cv::norm(first) == 0.0 || cv::norm(second) == 0.0)
        return fail(FailureKind::wrongUsage, {}, {}, "an angle needs a vertex that lies apart from its other places",
                    "Mark three places that lie apart.");
    // Unlike the arc cosine of the scalar product, this is accurate near 0 and 180 degrees too.
    return std::atan2(cv::norm(first.cross(second)), first.dot(second)) * 180.0 / std::numbers::pi;
}

std::string measurementNameOf(std::string_view typed) {
    const auto trimmed = [](std::string_view text) {
        const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
        return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
    };
    const std::string line = oneLine(typed);
    return std::string(trimmed(firstLetters(trimmed(line), longestMeasurementName)));
}

std::string measurementCommentOf(std::string_view typed) {
    return std::string(firstLetters(withPlainLines(typed), longestMeasurementComment));
}

bool holdsData(const Volume& volume, const Vec3& gridMm) {
    const Vec3 voxel = volume.geometry().voxelFromGridMm(gridMm);
    return inBox(volume.geometry(), voxel) && VolumeSampler(volume).intensityAt(voxel).has_value();
}

std::string problemOf(const Measurement& measurement) {
    if (measurement.id < 1) return "id must be at least 1";
    if (measurement.phase < 0) return "phase must not be negative";
    if (measurement.placesMm.size() != placesNeeded(measurement.kind))
        return "places_mm must hold " + std::to_string(placesNeeded(measurement.kind)) + " places";
    const auto finite = [](const Vec3& place) {
        return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
    };
    if (!std::ranges::all_of(measurement.placesMm, finite)) return "places_mm must hold finite numbers";
    return problemOfTexts(measurement);
}

}  // namespace echolucent
