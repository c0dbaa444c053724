#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/measuring/otf/study_otf.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent::cli {

namespace {

constexpr double referenceSpacing = 4.0;  // units between tube cores

/// The units that the automatic grid covers along the view's right and down axes.
std::array<double, 2> coveredUnits(const VolumeGeometry& geometry, const Viewpoint& view) {
    return tubeSpacingUnits(geometry, view, {.columns = 1, .rows = 1, .spacing = 0}, CellRule{}.size);
}

class VariantList {
public:
    VariantList(const VolumeGeometry& geometry, const Viewpoint& view, std::string function)
        : m_function(std::move(function)), m_covered(coveredUnits(geometry, view)) {
        if (m_function == "variance") m_base.detection = VarianceRule{};
    }

    void add(const std::string& parameter, const std::string& value, const AdaptiveOtfConfig& config,
             bool isReference = false) {
        variants.push_back({m_function, parameter, value, config, isReference});
    }
    /// Adds the base with one field changed.
    template <typename Change>
    void vary(const std::string& parameter, const std::string& name, const Change& change) {
        AdaptiveOtfConfig config = m_base;
        change(config);
        add(parameter, name, config);
    }
    [[nodiscard]] AdaptiveOtfConfig ofSpacing(double spacing) const {
        AdaptiveOtfConfig config = m_base;
        config.grid.spacing = spacing;
        config.grid.columns = std::max(1, static_cast<int>(m_covered[0] / spacing));
        config.grid.rows = std::max(1, static_cast<int>(m_covered[1] / spacing));
        return config;
    }
    void addGrids();
    void addCells();
    void addSmoothing();
    void addArithmetic();

    std::vector<OtfVariant> variants;

private:
    std::string m_function;
    AdaptiveOtfConfig m_base;
    std::array<double, 2> m_covered;
};

void VariantList::addGrids() {
    add("unchanged", "", m_base);
    AdaptiveOtfConfig reference = ofSpacing(referenceSpacing);
    reference.cells.precision = Precision::double64;
    add("reference", "", reference, true);
    for (const int spacing : {40, 26, 20, 10, 8, 6, 4})
        add("tube spacing", std::to_string(spacing), ofSpacing(spacing));
    for (const int count : {5, 10}) {
        // These grids cover only the middle of the picture, at the spacing of the whole grid.
        AdaptiveOtfConfig fewer = m_base;
        const double across = std::max(m_covered[0] / m_base.grid.columns, 1.0 * m_base.cells.size);
        fewer.grid.spacing = static_cast<int>(across);
        fewer.grid.columns = fewer.grid.rows = count;
        add("tube count", fmt::format("{0}x{0}", count), fewer);
    }
}

void VariantList::addCells() {
    for (const int size : {3, 4, 7, 9})
        vary("cell size", std::to_string(size), [size](AdaptiveOtfConfig& config) { config.cells.size = size; });
}

void VariantList::addSmoothing() {
    // The ratio rule has no scale space.
    const auto* base = std::get_if<VarianceRule>(&m_base.detection);
    if (base == nullptr) return;
    const auto varyRule = [&](const std::string& parameter, const std::string& name, const VarianceRule& rule) {
        vary(parameter, name, [&](AdaptiveOtfConfig& config) { config.detection = rule; });
    };
    for (const auto& [coarsest, finest] : {std::pair{6, 3}, {5, 3}, {4, 3}, {7, 5}, {7, 2}}) {
        VarianceRule rule = *base;
        rule.coarsestScale = coarsest;
        rule.finestScale = finest;
        varyRule("scales", fmt::format("{} to {}", coarsest, finest), rule);
    }
    VarianceRule rule = *base;
    rule.smoothing = SmoothingRoute::direct;
    varyRule("smoothing", "direct", rule);
    rule.smoothing = SmoothingRoute::fourier;
    varyRule("smoothing", "Fourier", rule);
}

void VariantList::addArithmetic() {
    vary("sampling", "nearest", [](AdaptiveOtfConfig& config) { config.cells.sampling = Interpolation::nearest; });
    vary("precision", "double", [](AdaptiveOtfConfig& config) { config.cells.precision = Precision::double64; });
}

}  // namespace

std::vector<OtfVariant> otfVariants(const VolumeGeometry& geometry, const Viewpoint& view) {
    std::vector<OtfVariant> all;
    for (const std::string& function : interfaceFunctions) {
        VariantList list(geometry, view, function);
        list.addGrids();
        list.addCells();
        list.addSmoothing();
        list.addArithmetic();
        all.insert(all.end(), list.variants.begin(), list.variants.end());
    }
    return all;
}

}  // namespace echolucent::cli
