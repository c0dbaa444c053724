// From a polar volume to a Cartesian one: trilinear in polar coordinates (docs/scan-conversion.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/scan_conversion/conversion_grid.h"
#include "processing/scan_conversion/line_lookup.h"
#include "processing/scan_conversion/polar_geometry.h"
#include "processing/volume/voxels.h"

namespace echolucent {

/// The conversion of volumes of one geometry to one grid. Its tables depend on the geometry alone and serve all phases.
/// Several threads may use it at once.
class ScanConversion {
public:
    /// Computes the tables. Throws std::invalid_argument if the geometry has a problem (problemOf()). Polls `progress`
    /// for each row of voxels. If it is cancelled, the tables are not complete and must not be used.
    ScanConversion(const PolarGeometry& polar, const ConversionGrid& grid, const Progress& progress = {});

    [[nodiscard]] const ConversionGrid& grid() const { return m_grid; }
    /// One byte a voxel of the grid: 1 if its centre lies in the insonified region, else 0 (no data). Empty only if
    /// cancelled (polled for each row of voxels).
    [[nodiscard]] std::vector<std::uint8_t> mask(const Progress& progress = {}) const;
    /// The voxels of the grid, of the type of `polar`, 0 outside the insonified region. Bytes and words are rounded to
    /// the nearest. Rows of a linear probe are copied bit for bit if all their voxels lie on samples. Voxels
    /// interpolated from a value that is not finite are not finite either. Any number of threads gives the same bits.
    /// Empty only if cancelled (polled for each row of voxels). Throws std::invalid_argument if the number of voxels is
    /// not the geometry's.
    [[nodiscard]] std::optional<Voxels> convert(const Voxels& polar, const Progress& progress = {}) const;

private:
    /// Insonified voxels of one row (along x): [first, end). A row has at most two runs.
    struct Run {
        std::int32_t first = 0, end = 0;
    };
    /// The common values of a row's voxels.
    struct Row {
        float along = 0;       ///< ConversionRow::alongMm
        float planeShare = 0;  ///< [0,1] between `plane` and the next
        std::int32_t plane = 0;
        Run runs[2];
    };
    static_assert(sizeof(Row) == conversionRowBytes);
    /// The sample of a linear probe at each index of the grid, by axis: lines along x, planes along y, samples along z.
    /// notThere if there is none. All are empty for other probes.
    struct Lattice {
        std::vector<std::int32_t> lines, planes, samples;
        bool allLines = false;  ///< whether a line stands at every index along x
    };
    static constexpr std::int32_t notThere = -1;
    void setLattice();
    void setRow(std::int64_t y, std::int64_t z);
    template <typename Value>
    bool copyRow(const VoxelArray<Value>& polar, std::int64_t index, std::vector<Value>& out) const;
    template <typename Value>
    void convertRow(const VoxelArray<Value>& polar, std::int64_t index, std::vector<Value>& out) const;
    template <typename Value>
    std::optional<Voxels> convertValues(const VoxelArray<Value>& polar, const Progress& progress) const;

    PolarGeometry m_polar;
    ConversionGrid m_grid;
    LineLookup m_lines;
    Lattice m_lattice;
    std::vector<Row> m_rows;  // y runs fastest, then z
};

}  // namespace echolucent
