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
    /// Computes the tables. Throws std::invalid_argument where the geometry has a problem (problemOf()).
    ScanConversion(const PolarGeometry& polar, const ConversionGrid& grid);

    [[nodiscard]] const ConversionGrid& grid() const { return m_grid; }
    /// One byte a voxel of the grid, 1 where its centre lies in the insonified region, and 0 elsewhere: no data.
    [[nodiscard]] std::vector<std::uint8_t> mask() const;
    /// The voxels of the grid, of the same type; they are 0 outside the insonified region. Bytes and words are rounded
    /// to the nearest. A value that is not finite makes those that are interpolated from it not finite too. Any number
    /// of threads gives the same bits. Empty only where `progress` was cancelled, which is polled for each row of
    /// voxels. Throws std::invalid_argument where the number of voxels is not that of the geometry.
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
    void setRow(std::int64_t y, std::int64_t z);
    template <typename Value>
    void convertRow(const std::vector<Value>& polar, std::int64_t index, std::vector<Value>& out) const;
    template <typename Value>
    std::optional<Voxels> convertValues(const std::vector<Value>& polar, const Progress& progress) const;

    PolarGeometry m_polar;
    ConversionGrid m_grid;
    LineLookup m_lines;
    std::vector<Row> m_rows;  // y runs fastest, then z
};

}  // namespace echolucent
