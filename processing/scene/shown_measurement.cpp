#include "processing/scene/shown_measurement.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "processing/one_line.h"
#include "processing/viewpoint/box_section.h"

namespace echolucent {

namespace {

/// With a decimal point in every locale.
std::string fixedNumber(double value, int decimals) {
    std::array<char, 400> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
    return {digits.data(), end.ptr};
}

/// An arc about the vertex of an angle, from one side to the other. Its radius is a share of the shorter side.
std::vector<Vec3> arcOf(const std::vector<Vec3>& places) {
    constexpr double shareOfSide = 0.3;
    constexpr int pieces = 16;
    const Vec3 first = places[0] - places[1], second = places[2] - places[1];
    const double radius = shareOfSide * std::min(length(first), length(second));
    const Vec3 from = normalized(first) * radius, across = first.cross(second);
    const double angle = std::atan2(length(across), first.dot(second)) * 180.0 / std::numbers::pi;
    // Sides on one straight line have no plane of their own, and so no arc.
    if (!(length(across) > 1e-9 * length(first) * length(second))) return {};
    const Vec3 axis = normalized(across);
    std::vector<Vec3> arc;
    for (int i = 0; i <= pieces; ++i) arc.push_back(places[1] + rotatedAbout(axis, angle * i / pieces, from));
    return arc;
}

template <typename See>
std::vector<PlacedMeasurement> placed(const std::vector<ShownMeasurement>& shown, const See& see) {
    std::vector<PlacedMeasurement> all;
    for (const ShownMeasurement& each : shown) {
        PlacedMeasurement next{.id = each.id, .kind = each.kind, .text = each.text, .dashed = each.dashed};
        bool seen = !each.placesMm.empty();
        const auto add = [&](const std::vector<Vec3>& places, std::vector<PicturePlace>& to) {
            for (const Vec3& place : places) {
                const std::optional<PicturePlace> at = see(place);
                seen = seen && at.has_value();
                if (at) to.push_back(*at);
            }
        };
        add(each.placesMm, next.places);
        add(each.arcMm, next.arc);
        if (seen) all.push_back(std::move(next));
    }
    return all;
}

/// The place of words, in heights of the picture from its centre, to the right and down.
struct TextBox {
    double left, right, top, bottom;
};

/// Boxes that touch do not overlap. Rounding does not count.
bool overlap(const TextBox& one, const TextBox& other) {
    constexpr double least = 1e-9;
    return one.left < other.right - least && other.left < one.right - least && one.top < other.bottom - least &&
           other.top < one.bottom - least;
}

/// The label right of the rightmost place, or left of the leftmost. If neither has room for it, it ends at the
/// picture's right edge, below or above the rightmost place. If the place lies in the picture, the label stays within
/// the picture's upper and lower edge, which would cut the text.
MeasurementLabel besideItsPlaces(const MeasurementWords& words, double aspect) {
    const auto [left, right] =
        std::ranges::minmax_element(words.places, {}, [](const PicturePlace& place) { return place[0]; });
    const bool fits = (*right)[0] + words.width <= aspect / 2.0;
    const double lowest = std::max(0.0, 0.5 - words.height / 2.0);
    const auto isSeen = [&](const PicturePlace& place) {
        return std::abs(place[0]) <= aspect / 2.0 && std::abs(place[1]) <= 0.5;
    };
    if (!fits && (*left)[0] - words.width < -aspect / 2.0 && isSeen(*right) && words.width <= aspect) {
        const double below = (*right)[1] + words.height;
        return {{aspect / 2.0 - words.width, below <= lowest ? below : (*right)[1] - words.height}, true};
    }
    PicturePlace at = fits ? *right : *left;
    if (std::abs(at[1]) <= 0.5) at[1] = std::clamp(at[1], -lowest, lowest);
    return {at, fits};
}

}  // namespace

Result<MeasurementNumber> measurementNumber(const Measurement& measurement, const VolumeGeometry& geometry) {
    const Result<double> value = measuredValue(measurement, geometry);
    if (!value) return tl::unexpected(value.error());
    if (measurement.kind == MeasurementKind::angle) return MeasurementNumber{fixedNumber(*value, 1), "°"};
    return MeasurementNumber{fixedNumber(*value, *value >= 1.0 ? 1 : *value >= 0.1 ? 2 : 3), "mm"};
}

Result<std::string> measurementText(const Measurement& measurement, const VolumeGeometry& geometry) {
    const Result<MeasurementNumber> number = measurementNumber(measurement, geometry);
    if (!number) return tl::unexpected(number.error());
    const char* const gap = measurement.kind == MeasurementKind::angle ? "" : " ";
    return number->digits + gap + std::string(number->unit);
}

Result<std::string> measurementLabel(const Measurement& measurement, const VolumeGeometry& geometry) {
    Result<std::string> text = measurementText(measurement, geometry);
    if (!text || measurement.name.empty()) return text;
    if (letterCount(measurement.name) <= longestShownName) return measurement.name + " " + *text;
    return std::string(firstLetters(measurement.name, longestShownName - 1)) + "… " + *text;
}

std::string_view groundWords(MeasurementGround ground) {
    return ground == MeasurementGround::plane ? "in a plane" : "on a surface";
}

std::optional<ShownMeasurement> shownMeasurement(const Measurement& measurement, const VolumeGeometry& geometry) {
    ShownMeasurement shown{.id = measurement.id, .kind = measurement.kind, .placesMm = measurement.placesMm};
    if (measurement.placesMm.size() < placesNeeded(measurement.kind)) return shown;
    const Result<std::string> text = measurementLabel(measurement, geometry);
    if (!text) return std::nullopt;
    shown.text = *text;
    if (measurement.kind == MeasurementKind::angle) shown.arcMm = arcOf(measurement.placesMm);
    return shown;
}

std::vector<ShownMeasurement> shownMeasurements(const std::vector<Measurement>& measurements, int phase,
                                                const VolumeGeometry& geometry) {
    std::vector<ShownMeasurement> shown;
    for (const Measurement& measurement : measurements) {
        if (measurement.phase != phase) continue;
        if (auto next = shownMeasurement(measurement, geometry)) shown.push_back(std::move(*next));
    }
    return shown;
}

std::vector<ShownMeasurement> shownMeasurementsIn3d(const std::vector<Measurement>& measurements, int phase,
                                                    const Volume& volume, const Planes& planes, BeamAxis beam) {
    std::vector<ShownMeasurement> shown = shownMeasurements(measurements, phase, volume.geometry());
    const double reach = planeReachUnits * volume.geometry().unit();
    const Vec3 reference = referencePointOf(planes, volume.dataBox());
    for (ShownMeasurement& each : shown) {
        if (std::ranges::find(measurements, each.id, &Measurement::id)->ground != MeasurementGround::plane) continue;
        std::string where(groundWords(MeasurementGround::plane));
        for (const PlaneName plane : allPlaneNames)
            if (liesInPlane(each.placesMm, {.centreMm = reference, .frame = frameOf(plane, planes, beam)}, reach)) {
                where = "in plane " + std::string(nameOf(plane));
                break;
            }
        each.text += " (" + where + ")";
        each.dashed = true;
    }
    return shown;
}

bool liesInPlane(const std::vector<Vec3>& placesMm, const PlaneView& view, double reachMm) {
    return std::ranges::all_of(placesMm, [&](const Vec3& place) {
        return std::abs(view.frame.forward.dot(place - view.centreMm)) <= reachMm;
    });
}

std::vector<PlacedMeasurement> placedInPlane(const std::vector<ShownMeasurement>& shown, const PlaneView& view,
                                             double unitMm) {
    std::vector<ShownMeasurement> inPlane;
    for (const ShownMeasurement& each : shown)
        if (liesInPlane(each.placesMm, view, planeReachUnits * unitMm)) inPlane.push_back(each);
    return placed(inPlane, [&](const Vec3& place) -> std::optional<PicturePlace> {
        const Vec3 from = (place - view.centreMm) * (1.0 / view.heightMm);
        return PicturePlace{view.frame.right.dot(from), view.frame.down.dot(from)};
    });
}

std::vector<PlacedMeasurement> placedInPicture(const std::vector<ShownMeasurement>& shown, const Camera& camera) {
    return placed(shown, [&](const Vec3& place) { return placeInPicture(camera, place); });
}

std::vector<MeasurementLabel> labelsOf(const std::vector<MeasurementWords>& words, double aspect) {
    std::vector<MeasurementLabel> labels;
    std::vector<TextBox> taken;
    for (const MeasurementWords& each : words) {
        MeasurementLabel label = besideItsPlaces(each, aspect);
        const double wanted = label.at[1];
        const auto boxAt = [&](double down) {
            const double left = label.toTheRight ? label.at[0] : label.at[0] - each.width;
            return TextBox{left, left + each.width, down - each.height / 2.0, down + each.height / 2.0};
        };
        // The text keeps its place if that is free. Else it touches one of those in its way.
        std::vector<double> free{wanted};
        for (const TextBox& box : taken)
            for (const double down : {box.bottom + each.height / 2.0, box.top - each.height / 2.0})
                if (std::abs(down) + each.height / 2.0 <= 0.5) free.push_back(down);
        std::erase_if(free, [&](double down) {
            return std::ranges::any_of(taken, [&](const TextBox& box) { return overlap(box, boxAt(down)); });
        });
        if (!free.empty())
            label.at[1] = *std::ranges::min_element(free, {}, [&](double down) { return std::abs(down - wanted); });
        taken.push_back(boxAt(label.at[1]));
        labels.push_back(label);
    }
    return labels;
}

}  // namespace echolucent
