// What strokes of the scalpel leave of volumes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "processing/progress.h"
#include "processing/scalpel/scalpel_stroke.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Cuts volumes of one grid, such as the phases of a study, by lists of strokes. A voxel is cut where a stroke cuts its
/// centre (cutsAway()). For each voxel the first stroke that cuts it is kept, one byte each: a stroke more costs one
/// pass, a stroke less, or one of them again, costs none. Only one thread at a time may use it.
class ScalpelCuts {
public:
    explicit ScalpelCuts(const VolumeGeometry& geometry);

    [[nodiscard]] const VolumeGeometry& geometry() const { return m_geometry; }
    /// The scan, of which other strokes may have been cut before, with these strokes cut. Voxels that the scan does not
    /// hold stay no data, and the data box stays the scan's. The result is empty only where progress.cancel was raised
    /// (it is polled in every slice), and has the same bits for any number of threads and whatever was cut before.
    /// Throws std::invalid_argument for a volume of another size and for a stroke that has a problem (problemOf()).
    [[nodiscard]] std::optional<Volume> cut(const Volume& scan, std::span<const ScalpelStroke> strokes,
                                            const Progress& progress = {});

    /// How many passes over the volume cut() has made for strokes.
    [[nodiscard]] int passes() const { return m_passes; }

private:
    [[nodiscard]] bool follow(std::span<const ScalpelStroke> strokes, const Progress& progress);
    void forgetFrom(std::size_t kept);
    [[nodiscard]] bool add(const ScalpelStroke& stroke, const Progress& progress);

    VolumeGeometry m_geometry;
    std::vector<ScalpelStroke> m_strokes;  ///< those that m_firstCut knows
    /// By voxel: 0 where no stroke cuts it, else the first that does, counted from 1. The strokes from the 255th on
    /// share that number.
    std::vector<std::uint8_t> m_firstCut;
    int m_passes = 0;
};

}  // namespace echolucent
