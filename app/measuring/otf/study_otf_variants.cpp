#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/otf/study_otf.h"
#include "processing/tube_core/tube_grid.h"

namespace echolucent::cli {

namespace {

constexpr double referenceSpacing = 4.0;  // units between tube cores

/// How many units the automatic grid covers along the view's right and down axes.
std::array<double, 2> coveredUnits(const VolumeGeometry& geometry, const Viewpoint& view) {
    AdaptiveOtfConfig one;
    one.tubeColumns = one.tubeRows = 1;
    one.tubeSpacing = 0;
    return tubeSpacingUnits(geometry, view, one);
}

class VariantList {
public:
    VariantList(const VolumeGeometry& geometry, const Viewpoint& view, InterfaceFunction function)
        : m_covered(coveredUnits(geometry, view)) {
        m_base.interfaceFunction = function;
    }

    void add(const std::string& parameter, const std::string& value, const AdaptiveOtfConfig& config,
             bool isReference = false) {
        variants.push_back({m_base.interfaceFunction, parameter, value, config, isReference});
    }
    /// The base with one field set.
    template <typename Field, typename Value>
    void vary(const std::string& parameter, const std::string& name, Field field, Value value) {
        AdaptiveOtfConfig config = m_base;
        config.*field = value;
        add(parameter, name, config);
    }
    [[nodiscard]] AdaptiveOtfConfig ofSpacing(double spacing) const {
        AdaptiveOtfConfig config = m_base;
        config.tubeSpacing = spacing;
        config.tubeColumns = std::max(1, static_cast<int>(m_covered[0] / spacing));
        config.tubeRows = std::max(1, static_cast<int>(m_covered[1] / spacing));
        return config;
    }
    void addGrids();
    void addCells();
    void addSmoothing();
    void addArithmetic();

    std::vector<OtfVariant> variants;

private:
    AdaptiveOtfConfig m_base;
    std::array<double, 2> m_covered;
};

void VariantList::addGrids() {
    add("unchanged", "", m_base);
    AdaptiveOtfConfig reference = ofSpacing(referenceSpacing);
    reference.precision = Precision::double64;
    add("reference", "", reference, true);
    for (const int spacing : {40, 26, 20, 10, 8, 6, 4})
        add("tube spacing", std::to_string(spacing), ofSpacing(spacing));
    for (const int count : {5, 10}) {
        // The middle of the picture only, at the spacing the whole grid has.
        AdaptiveOtfConfig fewer = m_base;
        const double across = std::max(m_covered[0] / m_base.tubeColumns, 1.0 * m_base.cellSize);
        fewer.tubeSpacing = static_cast<int>(across);
        fewer.tubeColumns = fewer.tubeRows = count;
        add("tube count", fmt::format("{0}x{0}", count), fewer);
    }
}

void VariantList::addCells() {
    for (const int size : {3, 4, 7, 9}) vary("cell size", std::to_string(size), &AdaptiveOtfConfig::cellSize, size);
    for (const int stride : {2, 3, 5}) vary("stride", std::to_string(stride), &AdaptiveOtfConfig::cellStride, stride);
}

void VariantList::addSmoothing() {
    // The ratio knows no scale space.
    if (m_base.interfaceFunction != InterfaceFunction::variance) return;
    for (const auto& [coarsest, finest] : {std::pair{6, 3}, {5, 3}, {4, 3}, {7, 5}, {7, 2}}) {
        AdaptiveOtfConfig config = m_base;
        config.coarsestScale = coarsest;
        config.finestScale = finest;
        add("scales", fmt::format("{} to {}", coarsest, finest), config);
    }
    vary("smoothing", "direct", &AdaptiveOtfConfig::smoothing, SmoothingRoute::direct);
    vary("smoothing", "Fourier", &AdaptiveOtfConfig::smoothing, SmoothingRoute::fourier);
    vary("smoothing", "recursive", &AdaptiveOtfConfig::smoothing, SmoothingRoute::recursive);
}

void VariantList::addArithmetic() {
    vary("sampling", "nearest", &AdaptiveOtfConfig::sampling, TubeSampling::nearest);
    vary("precision", "double", &AdaptiveOtfConfig::precision, Precision::double64);
    AdaptiveOtfConfig both = m_base;
    both.sampling = TubeSampling::nearest;
    both.cellStride = 2;
    add("nearest and stride", "2", both);
}

}  // namespace

std::string nameOf(InterfaceFunction function) {
    return function == InterfaceFunction::variance ? "variance" : "ratio";
}

std::vector<OtfVariant> otfVariants(const VolumeGeometry& geometry, const Viewpoint& view) {
    std::vector<OtfVariant> all;
    for (const InterfaceFunction function : {InterfaceFunction::variance, InterfaceFunction::ratio}) {
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
