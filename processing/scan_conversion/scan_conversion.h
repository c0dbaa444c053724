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

/// The conversion of volumes of one geometry to one grid. What follows from the geometry alone is computed once, for
/// all phases. It may be used by several threads at once.
class ScanConversion {
public:
    /// Computes the tables. Throws std::invalid_argument where the geometry has a problem (problemOf()). `progress` is
    /// polled for each row of voxels; where it was cancelled the tables are not complete, and nothing may be converted.
    ScanConversion(const PolarGeometry& polar, const ConversionGrid& grid, const Progress& progress = {});

    [[nodiscard]] const ConversionGrid& grid() const { return m_grid; }
    /// One byte a voxel of the grid, 1 where its centre lies in the insonified region, and 0 elsewhere: no data.
    /// Empty only where `progress` was cancelled, which is polled for each row of voxels.
    [[nodiscard]] std::vector<std::uint8_t> mask(const Progress& progress = {}) const;
    /// The voxels of the grid, of the same type; they are 0 outside the insonified region. Bytes and words are rounded
    /// to the nearest. Rows of a linear probe whose voxels are samples are copied, bit for bit. A value that is not
    /// finite makes those that are interpolated from it not finite too. Any number of threads gives the same bits.
    /// Empty only where `progress` was cancelled, which is polled for each row of voxels. Throws std::invalid_argument
    /// where the number of voxels is not that of the geometry.
    [[nodiscard]] std::optional<Voxels> convert(const Voxels& polar, const Progress& progress = {}) const;

private:
    /// The voxels of one row (along x) that are insonified: [first, end), once or twice.
    struct Run {
        std::int32_t first = 0, end = 0;
    };
    /// What all voxels of a row share.
    struct Row {
        float along = 0;       ///< mm within the plane, from the axis of the lines, or from the face without one
        float planeShare = 0;  ///< [0,1] between `plane` and the next
        std::int32_t plane = 0;
        Run runs[2];
    };
    static_assert(sizeof(Row) == conversionRowBytes);
    /// Which sample of a linear probe stands at each index of the grid, by axis: lines along x, planes along y, samples
    /// along z; notThere where none does. All are empty for other probes.
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
