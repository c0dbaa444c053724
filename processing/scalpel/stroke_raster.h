// Where a place of the picture lies for a stroke, looked up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/picture/picture_place.h"
#include "processing/scalpel/scalpel_stroke.h"

namespace echolucent::scalpel {

/// A raster over a stroke's outline or line. Most of its cells lie whole within the stroke or whole outside it; only in
/// the others a place must be asked for exactly.
class StrokeRaster {
public:
    /// Of what lies within the stroke: whether that is cut, or all else, is the side's matter.
    enum Cell : std::uint8_t { outside, inside, mixed };

    /// The stroke must outlive the raster and have no problem (problemOf()).
    explicit StrokeRaster(const ScalpelStroke& stroke);

    /// How a place, right and down of the picture's centre in picture heights, is written in cells.
    struct ToCells {
        PicturePlace first;                     ///< the place of the raster's corner
        std::array<double, 2> perHeight{1, 1};  ///< cells in a picture height
    };
    [[nodiscard]] const ToCells& toCells() const { return m_toCells; }
    /// The cell at a place in cells. Places beyond the raster are outside. The answer also holds for all places up to
    /// half a cell away.
    [[nodiscard]] Cell at(double right, double down) const {
        const auto inRaster = [](double cells) { return cells > 0.0 ? (cells < edge - 1 ? cells : edge - 1) : 0.0; };
        return m_cells[static_cast<std::size_t>(inRaster(down)) * edge + static_cast<std::size_t>(inRaster(right))];
    }
    /// All cells, row by row: edge of them a row, edge rows.
    [[nodiscard]] const Cell* cells() const { return m_cells.data(); }
    /// Whether the stroke holds a place: what cutsAway() asks, to the bit, sooner.
    [[nodiscard]] bool holds(const PicturePlace& place) const;

    static constexpr int edge = 512;  ///< cells along a side

private:
    void place();
    void fillOutline();
    void markLine(const PicturePlace& a, const PicturePlace& b);
    void fillEraser();
    void fillBuckets();
    [[nodiscard]] double centreOf(int cell, int axis) const;
    [[nodiscard]] std::size_t bandOf(const PicturePlace& place) const;

    const ScalpelStroke& m_stroke;
    ToCells m_toCells;
    std::vector<Cell> m_cells;
    /// Pieces of the line, by the index of their last place, that matter to a place: of an outline by rows of cells, of
    /// an eraser by squares of cells.
    std::vector<std::vector<std::uint32_t>> m_bands;
};

}  // namespace echolucent::scalpel
