#include "processing/detection/detection_by_ratio.h"

#include <algorithm>
#include <vector>

namespace echolucent {

namespace {

std::vector<int> slabsOf(std::span<const TubeSamples> samples) {
    std::vector<int> slabs(samples.size());
    std::ranges::transform(samples, slabs.begin(), &TubeSamples::slabs);
    return slabs;
}

/// The cell of contrast 0, counted from the first cell; may be below 0. Contrast 0 belongs to the boundary behind the
/// first leastFluid slabs. A cell has the contrast at its middle.
int firstContrastCell(const RatioRule& rule, int cellSize) { return rule.leastFluid - cellSize / 2; }

}  // namespace

IndexRange contrastCellsOf(const CellStatistics& cells, const RatioRule& rule, int cellSize) {
    const int size = static_cast<int>(cells.means.size());
    if (cells.lastCell < cells.firstCell) return {};
    // The first contrasts may lie before the middle of the first cell: no cell has them.
    const int ofFirst = cells.firstCell + firstContrastCell(rule, cellSize);
    const auto slabs = static_cast<std::size_t>(cells.lastCell - cells.firstCell + cellSize);
    return {std::max(cells.firstCell, ofFirst),
            std::min(size, ofFirst + static_cast<int>(contrastCount(slabs, rule))) - 1};
}

DetectionByRatio::DetectionByRatio(const RatioRule& rule, std::span<const TubeSamples> samples, int cellSize)
    : m_rule(rule), m_cellSize(cellSize), m_profiles(slabsOf(samples)) {}

void DetectionByRatio::keep(TubeReader& reader, std::size_t place, std::size_t tube) {
    reader.profile(place, m_profiles, tube);
}

void DetectionByRatio::computeInterfaceFunction(StageRunner& /*run*/) {
    m_scale.emplace(m_profiles);
    m_contrasts.emplace(m_profiles, *m_scale, m_rule);
    m_thresholds = ratioThresholds(*m_contrasts, *m_scale, m_rule);
}

const CellStatistics& DetectionByRatio::cellsOf(std::size_t tube, CellStatistics& scratch) const {
    const auto means = m_profiles.means(tube);
    if (means.empty()) {
        scratch = {};
        scratch.anyData = m_profiles.anyData(tube);
        return scratch;
    }
    cellsFrom(means, m_profiles.firstSlab(tube), m_cellSize, scratch);
    return scratch;
}

std::vector<float> DetectionByRatio::interfaceFunctionOf(std::size_t tube, const CellStatistics& cells) const {
    std::vector<float> ofCells(cells.means.size(), 0.0f);
    const auto contrasts = m_contrasts->contrasts(tube);
    const IndexRange ofBoundaries = contrastCellsOf(cells, m_rule, m_cellSize);
    const int ofFirst = cells.firstCell + firstContrastCell(m_rule, m_cellSize);
    for (int cell = ofBoundaries.first; cell <= ofBoundaries.last; ++cell)
        ofCells[static_cast<std::size_t>(cell)] = contrasts[static_cast<std::size_t>(cell - ofFirst)];
    return ofCells;
}

std::optional<FoundSurface> DetectionByRatio::surfaceOf(std::size_t tube, const CellStatistics& cells,
                                                        std::vector<int>& /*tracked*/) {
    const auto surface = firstFluidToTissue(m_profiles.means(tube), m_contrasts->scaled(tube),
                                            m_contrasts->contrasts(tube), m_thresholds, m_rule, m_cellSize);
    if (!surface) return std::nullopt;
    return FoundSurface{surface->cell + cells.firstCell, surface->contrast};
}

std::optional<double> DetectionByRatio::spreadAt(double intensity) const { return m_scale->spreadAt(intensity); }

std::optional<double> DetectionByRatio::fluidIntensity() const {
    if (!m_thresholds.mayHoldSurfaces) return std::nullopt;
    return m_scale->intensityAt(m_thresholds.fluidLevel);
}

}  // namespace echolucent
