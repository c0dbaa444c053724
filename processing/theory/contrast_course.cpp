#include "processing/theory/contrast_course.h"

#include <algorithm>
#include <stdexcept>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> axisNames{"depth", "ratio"};
constexpr std::int64_t coursePlaces = 100;  // and the one at 0
constexpr double toldApart = 0.0005;        // of differences, shares of white

double differenceOf(const CurveContrast& one) { return one.pixels.tissue - one.pixels.fluid; }

std::int64_t unitsPerPlace(std::int64_t fluidUnits) {
    std::int64_t units = 1;
    while (units * coursePlaces < fluidUnits) units *= 2;
    return units;
}

}  // namespace

std::string_view nameOf(CourseAxis axis) { return nameIn(axisNames, axis); }

std::string problemOf(const TheorySetting& setting) {
    if (!(setting.scale >= 0.0 && setting.scale <= TheorySetting::largestScale)) return "a must be from 0 to 4";
    return problemOf(setting.model);
}

std::vector<TheoryCurve> curvesOf(const TheorySetting& setting) {
    if (const std::string problem = problemOf(setting); !problem.empty())
        throw std::invalid_argument("curvesOf: " + problem);
    return scaledCurves(theoryCurves(setting.given, setting.model), setting.scaling, setting.scale,
                        setting.model.tissue);
}

std::vector<CurveContrast> contrastsOf(const TheorySetting& setting) {
    std::vector<CurveContrast> contrasts;
    for (const TheoryCurve& named : curvesOf(setting)) {
        const ModelPixels pixels = pixelsOf(setting.model, named.curve);
        contrasts.push_back({named.name, opacityAt(named.curve, setting.model.fluid),
                             opacityAt(named.curve, setting.model.tissue), pixels,
                             contrastOf(pixels, setting.contrast)});
    }
    return contrasts;
}

std::vector<std::size_t> winnersOf(const std::vector<CurveContrast>& contrasts) {
    double most = 0.0;
    for (const CurveContrast& one : contrasts) most = std::max(most, differenceOf(one));
    std::vector<std::size_t> winners;
    if (!(most > toldApart)) return winners;
    for (std::size_t i = 0; i < contrasts.size(); ++i)
        if (differenceOf(contrasts[i]) > most - toldApart) winners.push_back(i);
    return winners;
}

ContrastCourse courseOf(const TheorySetting& setting, CourseAxis axis) {
    TheorySetting at = setting;
    const std::int64_t perPlace = unitsPerPlace(setting.model.fluidUnits);
    ContrastCourse course;
    for (std::int64_t i = 0; i <= coursePlaces; ++i) {
        double place = static_cast<double>(i) / static_cast<double>(coursePlaces);
        if (axis == CourseAxis::depth) {
            at.model.fluidUnits = i * perPlace;
            place = static_cast<double>(at.model.fluidUnits);
        } else {
            at.model.fluid = place * setting.model.tissue;
        }
        course.places.push_back(place);
        course.contrasts.push_back(contrastsOf(at));
    }
    return course;
}

}  // namespace echolucent
