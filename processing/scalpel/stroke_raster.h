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
    /// Around a place in cells, whether many cells are alike.
    struct Stretch {
        Cell cell;
        int cells;  ///< on both axes up to so many cells away all are `cell`; where it is 0, the cell itself may not be
    };
    [[nodiscard]] Stretch around(double right, double down) const {
        const auto block = [](double cells) {
            return static_cast<std::size_t>(cells > 0.0 ? (cells < edge - 1 ? cells : edge - 1) : 0.0) / blockEdge;
        };
        const std::size_t at = block(down) * blocks + block(right);
        return {m_blockCells[at], m_alike[at]};
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
    void findAlike();
    [[nodiscard]] double centreOf(int cell, int axis) const;
    [[nodiscard]] std::size_t bandOf(const PicturePlace& place) const;

    const ScalpelStroke& m_stroke;
    ToCells m_toCells;
    std::vector<Cell> m_cells;
    static constexpr int blockEdge = 8, blocks = edge / blockEdge;
    std::vector<Cell> m_blockCells;  ///< of squares of cells: what all of one are, or mixed
    std::vector<int> m_alike;        ///< of squares of cells: Stretch::cells
    /// Pieces of the line, by the index of their last place, that matter to a place: of an outline by rows of cells, of
    /// an eraser by squares of cells.
    std::vector<std::vector<std::uint32_t>> m_bands;
};

}  // namespace echolucent::scalpel
