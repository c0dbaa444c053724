#include "io/headers/frame_spacing.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/headers/stated_times.h"

namespace echolucent {

namespace {

std::optional<Vec3> spacingIn(const std::string& text) {
    const auto points = withDecimalPoints(text);
    const auto numbers = realNumbers(points ? *points : text);
    if (!numbers || numbers->size() != 3) return std::nullopt;
    for (const double number : *numbers)
        if (!std::isfinite(number) || number <= 0) return std::nullopt;
    return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

bool areSame(const Vec3& one, const Vec3& other) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(std::abs(one[axis]) - other[axis]) > 1e-4 * other[axis]) return false;
    return true;
}

std::string inWords(const Vec3& spacing) {
    return fmt::format("{:.6g} x {:.6g} x {:.6g} mm", spacing[0], spacing[1], spacing[2]);
}

}  // namespace

void takeFrameSpacing(const std::map<std::string, std::string>& keys, StoredVolume& stored) {
    std::string first;
    std::optional<Vec3> common;
    VolumeGeometry& geometry = stored.geometry;
    for (const auto& [key, text] : keys) {
        if (!frameOfKey(key, "_ElementSpacing")) continue;
        const auto spacing = spacingIn(text);
        if (spacing && (!common || areSame(*spacing, *common))) {
            if (!common) first = quotedText(key);
            common = spacing;
            continue;
        }
        geometry.spacingKnown = false;
        stored.warnings.push_back(
            spacing ? fmt::format("{} differs from {}: which spacing counts is unknown.", quotedText(key), first)
                    : fmt::format("{} is {}, which is no spacing: the spacing is unknown.", quotedText(key),
                                  quotedText(text)));
        return;
    }
    const bool isStated = !stored.spacingSource.empty();
    if (!common || (isStated && areSame(geometry.spacing, *common))) return;
    stored.warnings.push_back(isStated ? fmt::format("{} and the others give {}, where {} gives {}; the frames count.",
                                                     first, inWords(*common), stored.spacingSource,
                                                     inWords(geometry.spacing))
                                       : fmt::format("The spacing of the voxels is that of {} and the others.", first));
    // Axes that were turned round have spacings above 0 by now.
    geometry.spacing = *common;
    if (!isStated) geometry.spacingKnown = true;
    stored.spacingSource = first + " and the others";
}

}  // namespace echolucent
