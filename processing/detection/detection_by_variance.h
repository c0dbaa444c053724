// Detection by the variance of cells, tracked from coarse to fine scales (Petersch 2005, section 4.1 and Fig. 4).
#pragma once

#include "processing/detection/detection.h"
#include "processing/detection/scale_space.h"
#include "processing/detection/variance_surface.h"
#include "processing/per_thread.h"

namespace echolucent {

/// The interface indicating function is the variance of normalised intensity in each cell.
class DetectionByVariance final : public Detection {
public:
    DetectionByVariance(const VarianceRule& rule, std::size_t tubes, int cellSize);

    void keep(TubeReader& reader, std::size_t place, std::size_t tube) override;
    void computeInterfaceFunction(StageRunner& run) override;
    [[nodiscard]] const CellStatistics& cellsOf(std::size_t tube, CellStatistics& scratch) const override;
    [[nodiscard]] std::vector<float> interfaceFunctionOf(std::size_t tube, const CellStatistics& cells) const override;
    [[nodiscard]] std::optional<FoundSurface> surfaceOf(std::size_t tube, const CellStatistics& cells,
                                                        std::vector<int>& tracked) override;
    [[nodiscard]] std::vector<TrackedScale> traceOf(const CellStatistics& cells) override;
    [[nodiscard]] double leastEdgeToNoise() const override { return m_rule.leastEdgeToNoise; }

private:
    /// What smoothing and tracking keep between the tubes of one thread.
    struct Tracker {
        explicit Tracker(const ScaleSpace& space) : smoother(space) {}
        ScaleSmoother smoother;
        DetectionScratch scratch;
    };

    /// The tracked indices into the function of the cells from firstCell to lastCell.
    std::vector<int> track(const CellStatistics& cells, std::vector<TrackedScale>* trace);

    VarianceRule m_rule;
    int m_cellSize;
    ScaleSpace m_scaleSpace;
    std::vector<TubeSlabs> m_slabs;       ///< of each tube, until its cells are made
    std::vector<CellStatistics> m_cells;  ///< of each tube
    PerThread<Tracker> m_trackers;
};

}  // namespace echolucent
