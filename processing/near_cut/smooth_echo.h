// A volume's echo in cells of a 64th of the data's extent, free of its resolution and most of its speckle.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Mean normalised intensity of the data in cubic cells along the grid's axes, smoothed. A cell is a 64th of the data's
/// extent, so that one anatomy gives the same cells at any resolution. The cells are larger if there would be more than
/// 160 along an edge of the volume.
class SmoothEcho {
public:
    /// The result is empty only if progress.cancel was raised. A volume without data gives no cells. The volume need
    /// not outlive the result.
    [[nodiscard]] static std::optional<SmoothEcho> of(const Volume& volume, const Progress& progress);

    /// Edge of the cube that is as large as all voxels with data, mm; 0 if there are none.
    [[nodiscard]] double dataExtentMm() const { return m_extentMm; }
    /// Edge of a cell, mm.
    [[nodiscard]] double cellMm() const { return m_cellMm; }
    /// Middle of the data, grid mm.
    [[nodiscard]] const Vec3& dataCentreMm() const { return m_centreMm; }
    /// The smoothed intensity at a place in grid mm, trilinear between cells; empty outside the cells, or if less than
    /// half is data there.
    [[nodiscard]] std::optional<float> at(const Vec3& gridMm) const;
    /// The smoothed intensities of all cells of which at least half is data.
    [[nodiscard]] std::vector<float> intensities() const;

private:
    SmoothEcho() = default;
    [[nodiscard]] std::size_t offset(int x, int y, int z) const;
    void placeCells(const Volume& volume, double dataVoxels);
    [[nodiscard]] bool gather(const Volume& volume, const Progress& progress);
    void smooth();
    void findCentre();

    double m_extentMm = 0.0, m_cellMm = 1.0;
    Vec3 m_firstMm{0, 0, 0}, m_centreMm{0, 0, 0};  ///< centre of cell (0,0,0); middle of the data
    std::array<int, 3> m_size{0, 0, 0};
    std::vector<float> m_echo;   ///< of each cell: smoothed sum of intensity times share, smoothed share of data
    std::vector<float> m_share;  ///< of each cell: share of data in the cell itself
};

}  // namespace echolucent
