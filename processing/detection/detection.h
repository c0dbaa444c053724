// The stages of the method in which the detection rules differ: interface indicating function and surfaces.
#pragma once

#include <optional>
#include <vector>

#include "processing/detection/tracked_scale.h"
#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/stage_runner.h"
#include "processing/tube_core/tube_reader.h"

namespace echolucent {

/// A surface on a tube core.
struct FoundSurface {
    int cell = 0;                    ///< s_t, index of the cell
    std::optional<double> contrast;  ///< with RatioRule: in standard deviations of the voxels of a slab
};

/// One rule at work on the tube cores of one view. Call keep() for every tube, then computeInterfaceFunction() once,
/// then the rest. Calls for different tubes may run side by side.
class Detection {
public:
    Detection() = default;
    Detection(const Detection&) = delete;
    Detection& operator=(const Detection&) = delete;
    virtual ~Detection() = default;

    /// Keeps what the rule needs of a tube. `place` is the tube's place in the row that the reader read last.
    virtual void keep(TubeReader& reader, std::size_t place, std::size_t tube) = 0;
    /// Computes the interface indicating function of all tubes.
    virtual void computeInterfaceFunction(StageRunner& run) = 0;

    /// The tube's cells. They may lie in `scratch`, which must stay unchanged while they are used.
    [[nodiscard]] virtual const CellStatistics& cellsOf(std::size_t tube, CellStatistics& scratch) const = 0;
    [[nodiscard]] virtual std::vector<float> interfaceFunctionOf(std::size_t tube,
                                                                 const CellStatistics& cells) const = 0;
    /// The tube's first surface; empty if it has none. A rule that tracks the surface from coarse to fine fills
    /// `tracked` with the cell at each scale.
    [[nodiscard]] virtual std::optional<FoundSurface> surfaceOf(std::size_t tube, const CellStatistics& cells,
                                                                std::vector<int>& tracked) = 0;

    /// What surfaceOf() does at each scale, coarsest first, the unsmoothed function last; indices are those of cells,
    /// but element i of a function belongs to cell firstCell + i. Empty if the rule tracks nothing, or the tube has no
    /// cell.
    [[nodiscard]] virtual std::vector<TrackedScale> traceOf(const CellStatistics& /*cells*/) { return {}; }

    /// Standard deviation of voxels around a mean intensity (speckle); empty if the rule does not measure it.
    [[nodiscard]] virtual std::optional<double> spreadAt(double /*intensity*/) const { return std::nullopt; }
    /// The edge to noise below which a surface weighs nothing; 0 if the rule has an absolute test of its own.
    [[nodiscard]] virtual double leastEdgeToNoise() const { return 0.0; }
    /// The least contrast of a boundary that counts; empty if the rule knows no contrast.
    [[nodiscard]] virtual std::optional<double> leastContrast() const { return std::nullopt; }
    /// Means below this intensity count as fluid; empty if the rule does not tell, or the view shows no boundary of
    /// fluid.
    [[nodiscard]] virtual std::optional<double> fluidIntensity() const { return std::nullopt; }
};

}  // namespace echolucent
