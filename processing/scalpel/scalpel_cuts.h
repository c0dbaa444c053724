// What strokes of the scalpel leave of volumes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "processing/progress.h"
#include "processing/scalpel/scalpel_stroke.h"
#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Cuts volumes of one grid, such as the phases of a study, by lists of strokes. A voxel is cut where a stroke cuts its
/// centre (cutsAway()). For each voxel the first stroke that cuts it is kept, one byte each, and for each stroke the
/// parts of rows that it cuts: a stroke more is carried through what it reaches, a stroke less, or one of them again,
/// changes these parts of the mask alone. Kept are a byte a voxel, and 8 bytes a row of voxels for each stroke (2 MiB
/// in a volume of 512 x 512 x 512). Where a call throws for want of memory, the object is to be made anew. Only one
/// thread at a time may use it.
class ScalpelCuts {
public:
    explicit ScalpelCuts(const VolumeGeometry& geometry);

    [[nodiscard]] const VolumeGeometry& geometry() const { return m_geometry; }
    /// The scan, of which other strokes may have been cut before, with these strokes cut. Voxels that the scan does not
    /// hold stay no data, and the data box stays the scan's. The result is empty only where progress.cancel was raised
    /// (it is polled in every slice of a new stroke), and has the same bits for any number of threads and whatever was
    /// cut before. Scans that hold the same voxels share one mask of the same strokes, where they are cut one after
    /// another. Throws std::invalid_argument for a volume of another size and for a stroke that has a problem
    /// (problemOf()).
    [[nodiscard]] std::optional<Volume> cut(const Volume& scan, std::span<const ScalpelStroke> strokes,
                                            const Progress& progress = {});

    /// How many strokes cut() has carried through the volume.
    [[nodiscard]] int passes() const { return m_passes; }

private:
    [[nodiscard]] bool follow(std::span<const ScalpelStroke> strokes, const Progress& progress);
    void forgetFrom(std::size_t kept);
    [[nodiscard]] bool add(const ScalpelStroke& stroke, const Progress& progress);
    [[nodiscard]] Volume::SharedMask maskFor(const Volume& scan, std::size_t strokes) const;

    /// A stroke, and the rows in which it is the first to cut a voxel.
    struct Carried {
        ScalpelStroke stroke;
        RowMarks rows;
    };
    /// The newest result that was cut.
    struct Made {
        Volume left;
        std::size_t strokes;  ///< how many of m_carried it knows
        RowMarks others;      ///< rows in which it knows other strokes
    };

    VolumeGeometry m_geometry;
    std::vector<Carried> m_carried;  ///< the strokes that m_firstCut knows
    /// By voxel: 0 where no stroke cuts it, else the first that does, counted from 1. The strokes from the 255th on
    /// share that number.
    std::vector<std::uint8_t> m_firstCut;
    std::optional<Made> m_made;
    int m_passes = 0;
};

}  // namespace echolucent
