// Looks up whether a place of the picture lies in a stroke.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/picture/picture_place.h"
#include "processing/scalpel/scalpel_stroke.h"

namespace echolucent::scalpel {

/// A raster over a stroke's outline or line. Most of its cells lie whole within the stroke or whole outside it. Only
/// places in the other cells need an exact test.
class StrokeRaster {
public:
    /// A cell's place relative to the stroke. The side decides whether the inside or the outside is cut.
    enum Cell : std::uint8_t { outside, inside, mixed };

    /// The stroke must outlive the raster and have no problem (problemOf()).
    explicit StrokeRaster(const ScalpelStroke& stroke);

    /// Conversion to cells of a place right and down of the picture's centre, in picture heights.
    struct ToCells {
        PicturePlace first;                     ///< place of the raster's corner
        std::array<double, 2> perHeight{1, 1};  ///< cells in a picture height
    };
    [[nodiscard]] const ToCells& toCells() const { return m_toCells; }
    /// The cell at a place in cells. Places beyond the raster are outside. The answer also holds for all places up to
    /// half a cell away.
    [[nodiscard]] Cell at(double right, double down) const {
        const auto inRaster = [](double cells) { return cells > 0.0 ? (cells < edge - 1 ? cells : edge - 1) : 0.0; };
        return m_cells[static_cast<std::size_t>(inRaster(down)) * edge + static_cast<std::size_t>(inRaster(right))];
    }
    /// Whether many cells around a place are alike.
    struct Stretch {
        Cell cell;
        int cells;  ///< on both axes, all cells up to this many away are `cell`; if 0, the cell itself may differ
    };
    [[nodiscard]] Stretch around(double right, double down) const {
        const auto block = [](double cells) {
            return static_cast<std::size_t>(cells > 0.0 ? (cells < edge - 1 ? cells : edge - 1) : 0.0) / blockEdge;
        };
        const std::size_t at = block(down) * blocks + block(right);
        return {m_blockCells[at], m_alike[at]};
    }
    /// All cells, row by row, `edge` to a row and `edge` rows.
    [[nodiscard]] const Cell* cells() const { return m_cells.data(); }
    /// Whether the outline or line holds a place, whatever the stroke's side: cutsAway()'s test to the bit, but faster.
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
    std::vector<Cell> m_blockCells;  ///< by squares of cells: the value of all their cells, or mixed
    std::vector<int> m_alike;        ///< by squares of cells: Stretch::cells
    /// The pieces of the line near a place, by the index of their last place. For an outline they are listed by rows of
    /// cells, for an eraser by squares of cells.
    std::vector<std::vector<std::uint32_t>> m_bands;
};

}  // namespace echolucent::scalpel
