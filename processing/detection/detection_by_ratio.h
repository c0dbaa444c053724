// Detection by the ratio of means before and behind a boundary (docs/method.md, "Detection by ratio").
#pragma once

#include <span>

#include "processing/detection/detection.h"
#include "processing/detection/ratio_surface.h"

namespace echolucent {

/// The cells whose interface function is the contrast of a boundary, that at the cell's middle. The other cells of a
/// tube core lie too near to its ends.
[[nodiscard]] IndexRange contrastCellsOf(const CellStatistics& cells, const RatioRule& rule, int cellSize);

/// The interface indicating function is the contrast on the speckle's own scale. All tubes are read before any is
/// judged: only together they tell how strong speckle is and where fluid ends.
class DetectionByRatio final : public Detection {
public:
    DetectionByRatio(const RatioRule& rule, std::span<const TubeSamples> samples, int cellSize);

    void keep(TubeReader& reader, std::size_t place, std::size_t tube) override;
    void computeInterfaceFunction(StageRunner& run) override;
    [[nodiscard]] const CellStatistics& cellsOf(std::size_t tube, CellStatistics& scratch) const override;
    [[nodiscard]] std::vector<float> interfaceFunctionOf(std::size_t tube, const CellStatistics& cells) const override;
    [[nodiscard]] std::optional<FoundSurface> surfaceOf(std::size_t tube, const CellStatistics& cells,
                                                        std::vector<int>& tracked) override;
    [[nodiscard]] std::optional<double> spreadAt(double intensity) const override;
    [[nodiscard]] std::optional<double> leastContrast() const override { return m_thresholds.contrast; }
    [[nodiscard]] std::optional<double> fluidIntensity() const override;

private:
    RatioRule m_rule;
    int m_cellSize;
    TubeProfiles m_profiles;
    // Set by computeInterfaceFunction().
    std::optional<SpeckleScale> m_scale;
    std::optional<TubeContrasts> m_contrasts;
    RatioThresholds m_thresholds;
};

}  // namespace echolucent
