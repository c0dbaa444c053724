// How pixels and contrast of the two-intensity model change along one of its values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/theory/theory_curves.h"
#include "processing/theory/two_intensities.h"

namespace echolucent {

/// What runs along the x axis of a course.
enum class CourseAxis {
    depth,  ///< the thickness of the fluid, units: where the surface lies
    ratio,  ///< c2 / c1; c1 stays
};
inline constexpr std::array<CourseAxis, 2> allCourseAxes{CourseAxis::depth, CourseAxis::ratio};
/// "depth", "ratio".
[[nodiscard]] std::string_view nameOf(CourseAxis axis);

/// What a page or a panel shows of section 4.
struct TheorySetting {
    static constexpr double largestScale = 4.0;
    TwoIntensities model;
    GivenCurves given;
    double scale = 1.0;  ///< a, [0, largestScale]
    OpacityScaling scaling = OpacityScaling::sameScale;
    ContrastKind contrast = ContrastKind::difference;
    friend bool operator==(const TheorySetting&, const TheorySetting&) = default;
};
/// What is out of range. Empty if nothing is.
[[nodiscard]] std::string problemOf(const TheorySetting& setting);

/// The curves of a setting, scaled. Throws std::invalid_argument if problemOf() is not empty.
[[nodiscard]] std::vector<TheoryCurve> curvesOf(const TheorySetting& setting);

/// What one curve makes of a model.
struct CurveContrast {
    std::string name;                  ///< of the curve
    double atFluid = 0.0;              ///< opacity per unit at c2
    double atTissue = 0.0;             ///< opacity per unit at c1
    ModelPixels pixels{};              ///< shares of white
    std::optional<double> contrast{};  ///< of the setting's kind
};
/// What each curve makes of the setting's model, in the order of the curves. Throws as curvesOf() does.
[[nodiscard]] std::vector<CurveContrast> contrastsOf(const TheorySetting& setting);
/// The curves whose pixels differ most, tissue less fluid, whatever contrast the setting asks for: relative contrasts
/// rise as the fluid turns black, however dark the tissue is. Indices, ascending. They are several if their differences
/// lie less than 0.0005 of white apart. Empty if no difference is above that.
[[nodiscard]] std::vector<std::size_t> winnersOf(const std::vector<CurveContrast>& contrasts);

/// contrastsOf() at each place of an axis.
struct ContrastCourse {
    std::vector<double> places;                         ///< units of fluid, or c2 / c1
    std::vector<std::vector<CurveContrast>> contrasts;  ///< [place][curve]
};
/// Along `depth`: 101 depths from 0 to 100 units, to 200 if the model's fluid is thicker than 100, and so on in powers
/// of 2. Along `ratio`: 101 ratios from 0 to 1. Throws as curvesOf() does.
[[nodiscard]] ContrastCourse courseOf(const TheorySetting& setting, CourseAxis axis);

}  // namespace echolucent
