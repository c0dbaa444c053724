// Volumes after cuts by the scalpel's strokes.
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

/// Cuts volumes of one grid, such as the phases of a study, by lists of strokes. A stroke cuts a voxel if it cuts its
/// centre (cutsAway()). The object keeps the first stroke that cuts each voxel, and the parts of rows that each stroke
/// cuts. So only strokes that are new, or follow one that changed, are carried through the volume. A stroke that is
/// undone or redone changes the mask only in the kept parts of rows. Memory: a byte a voxel, and 8 bytes a row of
/// voxels for each stroke (2 MiB in a volume of 512 x 512 x 512). If a call throws because memory ran out, make a new
/// object. Only one thread at a time may use it.
class ScalpelCuts {
public:
    explicit ScalpelCuts(const VolumeGeometry& geometry);

    [[nodiscard]] const VolumeGeometry& geometry() const { return m_geometry; }
    /// The scan with these strokes cut, whatever strokes were cut before. Voxels outside the scan stay no data, and the
    /// data box stays the scan's. Empty only if the caller set progress.cancel (polled in every slice of a new stroke).
    /// The result has the same bits for any number of threads and any earlier cuts. Scans with equal masks
    /// (Volume::scannedMask()), cut one after another by the same strokes, share one mask. Throws std::invalid_argument
    /// for a volume of another size and for a stroke with a problem (problemOf()).
    [[nodiscard]] std::optional<Volume> cut(const Volume& scan, std::span<const ScalpelStroke> strokes,
                                            const Progress& progress = {});

    /// How many strokes cut() has begun to carry through the volume so far.
    [[nodiscard]] int passes() const { return m_passes; }

private:
    [[nodiscard]] bool follow(std::span<const ScalpelStroke> strokes, const Progress& progress);
    void forgetFrom(std::size_t kept);
    [[nodiscard]] bool add(const ScalpelStroke& stroke, const Progress& progress);
    [[nodiscard]] Volume::SharedMask maskFor(const Volume& scan, std::size_t strokes) const;

    /// A stroke, and the parts of rows in which it is the first to cut a voxel.
    struct Carried {
        ScalpelStroke stroke;
        RowMarks rows;
    };
    /// The newest result.
    struct Made {
        Volume left;
        std::size_t strokes;  ///< how many of m_carried it contains
        RowMarks others;      ///< parts of rows with cuts of strokes that m_carried has lost since
    };

    VolumeGeometry m_geometry;
    std::vector<Carried> m_carried;  ///< the strokes in m_firstCut
    /// For each voxel the first stroke that cuts it, counted from 1; 0 if none does. The strokes from the 255th on
    /// share the number 255.
    std::vector<std::uint8_t> m_firstCut;
    std::optional<Made> m_made;
    int m_passes = 0;
};

}  // namespace echolucent
