#include "processing/theory/two_intensities.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> contrastNames{"difference", "michelson", "weber"};

bool isShare(double value) { return value >= 0.0 && value <= 1.0; }
bool isThickness(std::int64_t units) { return units >= 0 && units <= TwoIntensities::mostUnits; }

/// ln of what one unit of fluid lets through.
double logThroughUnit(const OpacityCurve& curve, double intensity) { return std::log1p(-opacityAt(curve, intensity)); }

}  // namespace

std::string problemOf(const TwoIntensities& model) {
    if (!isShare(model.tissue)) return "c1 must be from 0 to 1";
    if (!isShare(model.fluid)) return "c2 must be from 0 to 1";
    if (!isShare(model.background)) return "the background must be from 0 to 1";
    if (!isThickness(model.fluidUnits)) return "the fluid must be from 0 to 1000000 units thick";
    if (!isThickness(model.tissueUnits)) return "the tissue must be from 0 to 1000000 units thick";
    return {};
}

std::array<RayLayer, 2> layersOf(const TwoIntensities& model, const OpacityCurve& curve, ModelRay ray) {
    if (const std::string problem = problemOf(model); !problem.empty())
        throw std::invalid_argument("layersOf: " + problem);
    const double behind = ray == ModelRay::intoTissue ? model.tissue : model.fluid;
    return {RayLayer{model.fluid, opacityAt(curve, model.fluid), model.fluidUnits},
            RayLayer{behind, opacityAt(curve, behind), model.tissueUnits}};
}

double byEquation2(std::span<const RayLayer> layers, double background) {
    long double colour = background;
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
        for (std::int64_t k = 0; k < layer->units; ++k)
            colour = colour * (1.0L - layer->opacity) + static_cast<long double>(layer->intensity) * layer->opacity;
    return static_cast<double>(colour);
}

double byEquation3(std::span<const RayLayer> layers, double background) {
    long double sum = 0.0, product = 1.0;  // of 1 - alpha over all samples before this one
    for (const RayLayer& layer : layers)
        for (std::int64_t k = 0; k < layer.units; ++k) {
            sum += layer.intensity * layer.opacity * product;
            product *= 1.0L - layer.opacity;
        }
    return static_cast<double>(sum + background * product);
}

double inClosedForm(std::span<const RayLayer> layers, double background) {
    double sum = 0.0, product = 1.0;
    for (const RayLayer& layer : layers) {
        const double opacity = opacityForStep(layer.opacity, static_cast<double>(layer.units));
        sum += layer.intensity * opacity * product;
        product *= 1.0 - opacity;
    }
    return sum + background * product;
}

ModelPixels pixelsOf(const TwoIntensities& model, const OpacityCurve& curve) {
    return {inClosedForm(layersOf(model, curve, ModelRay::throughFluid), model.background),
            inClosedForm(layersOf(model, curve, ModelRay::intoTissue), model.background)};
}

std::string_view nameOf(ContrastKind kind) { return nameIn(contrastNames, kind); }

std::optional<double> contrastOf(const ModelPixels& pixels, ContrastKind kind) {
    const double difference = pixels.tissue - pixels.fluid;
    if (kind == ContrastKind::difference) return difference;
    const double divisor = kind == ContrastKind::weber ? pixels.fluid : pixels.tissue + pixels.fluid;
    return divisor > 0.0 ? std::optional(difference / divisor) : std::nullopt;
}

std::optional<double> unitsToBeat(const TwoIntensities& model, const OpacityCurve& better, const OpacityCurve& other) {
    TwoIntensities atOnce = model;
    atOnce.fluidUnits = 0;
    const auto difference = [&](const OpacityCurve& curve) {
        return contrastOf(pixelsOf(atOnce, curve), ContrastKind::difference).value();
    };
    const double ofBetter = difference(better), ofOther = difference(other);
    const double perUnit = logThroughUnit(better, model.fluid) - logThroughUnit(other, model.fluid);
    if (!(ofBetter > 0.0) || !(ofOther > 0.0) || !(perUnit > 0.0)) return std::nullopt;
    return std::max(0.0, std::log(ofOther / ofBetter) / perUnit);
}

}  // namespace echolucent
