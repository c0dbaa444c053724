// Where tube cores and the surfaces they found lie in the volume: what planes and the 3D view draw of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/viewpoint/oriented_box.h"

namespace echolucent {

/// A tube core that was placed and met data. Places are in grid mm, on its axis.
struct TubeCoreMark {
    int number = 0;                   ///< row * columns + column of the grid
    Vec3 beginMm{}, endMm{};          ///< of its first and of its last sample
    std::optional<Vec3> surfaceMm{};  ///< the surface that it found
    double share = 0.0;               ///< its d as a share of the run's largest d, [0,1]; 0: it has no weight
    friend bool operator==(const TubeCoreMark&, const TubeCoreMark&) = default;
};

/// The tube cores of one run, and what their marks have in common.
struct TubeCoreMarks {
    std::vector<TubeCoreMark> marks{};  ///< by ascending number, without those that met no data
    ViewFrame axes{};                   ///< they run along axes.forward
    double halfWidthMm = 0.0;           ///< half the edge of a cell
    double halfSpacingMm = 0.0;         ///< half the larger of the distances between neighbours
    double unitMm = 1.0;                ///< a unit of length along a tube core
    int columns = 0, rows = 0;          ///< of the grid
    friend bool operator==(const TubeCoreMarks&, const TubeCoreMarks&) = default;

    /// Null if there is no mark of that number.
    [[nodiscard]] const TubeCoreMark* of(int number) const;
};

/// The marks of a run on a volume of this geometry.
[[nodiscard]] TubeCoreMarks marksOf(const AdaptiveOtf& otf, const VolumeGeometry& geometry);

/// The numbers of at most `most` tube cores that stand for all with a weight: of each square of neighbours the one with
/// the largest share. The squares are as small as `most` (at least 1) allows, so that all are given if they fit.
[[nodiscard]] std::vector<int> thinned(const TubeCoreMarks& marks, std::size_t most);

/// The column of cells of a tube core.
[[nodiscard]] OrientedBox columnOf(const TubeCoreMarks& marks, const TubeCoreMark& mark);

/// What a plane shows of a tube core.
struct TubeCoreInPlane {
    std::vector<Vec3> outlineMm{};    ///< a convex polygon, at least three corners
    std::optional<Vec3> surfaceMm{};  ///< the surface that it found; not set if it lies off the plane
};
/// What the plane through `pointMm` with the unit normal `normal` shows of a tube core. Its column counts as cut if its
/// axis lies within half a tube spacing of the plane: it is then moved onto the plane. Empty if it lies farther away.
[[nodiscard]] std::optional<TubeCoreInPlane> shownInPlane(const TubeCoreMarks& marks, const TubeCoreMark& mark,
                                                          const Vec3& pointMm, const Vec3& normal);

}  // namespace echolucent
