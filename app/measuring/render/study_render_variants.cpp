#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/measuring/render/study_render.h"

namespace echolucent::cli {

namespace {

std::string shareText(double share) { return share > 0.0 ? fmt::format("1/{:g}", 1.0 / share) : std::string("never"); }

class VariantList {
public:
    explicit VariantList(const RayCastSettings& reference) : m_reference(reference) {
        m_variants.push_back({"reference", "step 1", reference});
    }

    template <typename Change>
    void add(const std::string& axis, const std::string& value, Change change) {
        RenderVariant variant{axis, value, m_reference};
        change(variant);
        variant.settings = reduced(variant.settings, variant.reduction);
        const bool known = std::any_of(m_variants.begin(), m_variants.end(), [&](const RenderVariant& other) {
            return other.settings == variant.settings && other.plain == variant.plain;
        });
        if (!known) m_variants.push_back(std::move(variant));
    }

    [[nodiscard]] std::vector<RenderVariant> take() { return std::move(m_variants); }

private:
    RayCastSettings m_reference;
    std::vector<RenderVariant> m_variants;
};

void addSampling(VariantList& list) {
    for (const double step : {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0})
        list.add("step", fmt::format("{:g}", step), [&](RenderVariant& v) { v.settings.step = step; });
    list.add("interpolation", "nearest", [](RenderVariant& v) { v.settings.interpolation = Interpolation::nearest; });
}

void addOmissions(VariantList& list) {
    for (const double share :
         {0.0, 1.0 / 4096, 1.0 / 2048, 1.0 / 1024, 1.0 / 512, 1.0 / 256, 1.0 / 128, 1.0 / 64, 1.0 / 32})
        list.add("termination", shareText(share),
                 [&](RenderVariant& v) { v.settings.terminationTransmittance = share; });
    list.add("skipping", "off", [](RenderVariant& v) { v.settings.skipEmptySpace = false; });
    for (const double reduction : {1.5, 2.0, 3.0, 4.0})
        list.add("resolution", fmt::format("1/{:g}", reduction), [&](RenderVariant& v) { v.reduction = reduction; });
}

/// The kernel has one precision only (float within a run of samples, double over runs), so the plain route tells the
/// cost of each precision.
void addPrecisions(VariantList& list) {
    for (const double step : {1.0, 0.25})
        for (const auto precision : {CompositingPrecision::twofold, CompositingPrecision::single,
                                     CompositingPrecision::half, CompositingPrecision::eightBit})
            list.add("precision", fmt::format("{}, step {:g}", nameOf(precision), step), [&](RenderVariant& v) {
                v.settings.step = step;
                v.plain = asTheKernel(step, precision);
                v.precision = precision;
            });
}

/// The cost of counting whole steps only.
void addEnds(VariantList& list) {
    for (const double step : {2.0, 1.0, 0.25})
        list.add("ends", fmt::format("double, step {:g}, whole steps only", step), [&](RenderVariant& v) {
            v.settings.step = step;
            v.plain = asTheKernel(step);
            v.plain->wholeSteps = true;
            v.precision = CompositingPrecision::twofold;
        });
}

/// Settings for a controller with a frame budget: rays end at 1/128, and the number of rays and the step vary.
void addCombinations(VariantList& list) {
    for (const double reduction : {1.0, 1.5, 2.0, 3.0, 4.0})
        for (const double step : {0.5, 0.75, 1.0, 1.5, 2.0, 3.0})
            if (step >= 1.0 || reduction == 1.0) {
                const std::string value = fmt::format(
                    "{}step {:g}, ends at 1/128", reduction > 1.0 ? fmt::format("1/{:g} size, ", reduction) : "", step);
                list.add("combination", value, [&](RenderVariant& v) {
                    v.reduction = reduction;
                    v.settings.step = step;
                    v.settings.terminationTransmittance = 1.0 / 128;
                });
            }
}

}  // namespace

PlainCasting asTheKernel(double step, CompositingPrecision precision) {
    return {.rounded = roundingOf(precision), .leastLitOpacity = std::min(1.0, step) / 128, .wholeSteps = false};
}

RayCastSettings reduced(RayCastSettings settings, double reduction) {
    settings.width = std::max(1, static_cast<int>(std::lround(settings.width / reduction)));
    settings.height = std::max(1, static_cast<int>(std::lround(settings.height / reduction)));
    return settings;
}

std::vector<RenderVariant> renderVariants(const RayCastSettings& reference) {
    VariantList list(reference);
    addSampling(list);
    addOmissions(list);
    addCombinations(list);
    addPrecisions(list);
    addEnds(list);
    return list.take();
}

}  // namespace echolucent::cli
