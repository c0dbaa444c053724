// The stages in which the ways of telling tissue from fluid differ: interface indicating function and surfaces.
#pragma once

#include <optional>
#include <vector>

#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/stage_runner.h"
#include "processing/tube_core/tube_reader.h"

namespace echolucent {

/// A surface on a tube core.
struct FoundSurface {
    int cell = 0;                    ///< s_t, index of the cell
    std::optional<double> contrast;  ///< with RatioRule: in standard deviations of the voxels of a slab
};

/// One rule at work on the tube cores of one view. The calls follow each other in this order: keep() for every tube,
/// computeInterfaceFunction() once, then the rest. Calls for different tubes may run side by side.
class Detection {
public:
    Detection() = default;
    Detection(const Detection&) = delete;
    Detection& operator=(const Detection&) = delete;
    virtual ~Detection() = default;

    /// Keeps what the rule needs of a tube. `place` is where the tube stands in the row that the reader read last.
    virtual void keep(TubeReader& reader, std::size_t place, std::size_t tube) = 0;
    /// Computes the interface indicating function of all tubes.
    virtual void computeInterfaceFunction(StageRunner& run) = 0;

    /// The tube's cells. They may stand in `scratch`, which then must stay as it is while they are used.
    [[nodiscard]] virtual const CellStatistics& cellsOf(std::size_t tube, CellStatistics& scratch) const = 0;
    /// The interface indicating function of each of the tube's cells.
    [[nodiscard]] virtual std::vector<float> interfaceFunctionOf(std::size_t tube,
                                                                 const CellStatistics& cells) const = 0;
    /// The tube's first surface, or nothing where it has none. A rule that follows the surface from coarse to fine
    /// fills `tracked` with the cell at each scale.
    [[nodiscard]] virtual std::optional<FoundSurface> surfaceOf(std::size_t tube, const CellStatistics& cells,
                                                                std::vector<int>& tracked) = 0;

    /// Standard deviation of voxels around a mean intensity (speckle), or nothing where the rule does not measure it.
    [[nodiscard]] virtual std::optional<double> spreadAt(double /*intensity*/) const { return std::nullopt; }
    /// The edge to noise below which a surface weighs nothing; 0 where the rule has an absolute test of its own.
    [[nodiscard]] virtual double leastEdgeToNoise() const { return 0.0; }
    /// The contrast from which a boundary counted, or nothing where the rule knows no contrast.
    [[nodiscard]] virtual std::optional<double> leastContrast() const { return std::nullopt; }
    /// Means below this intensity counted as fluid; nothing where no boundary tells.
    [[nodiscard]] virtual std::optional<double> fluidIntensity() const { return std::nullopt; }
};

}  // namespace echolucent
