#include "processing/comparison/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>

#include "processing/parallel.h"
#include "processing/picture/picture_place.h"

namespace echolucent {

namespace {

/// A linear function of a pixel's column and row.
struct OfPixel {
    double atFirst = 0.0, aColumn = 0.0, aRow = 0.0;
    [[nodiscard]] double at(int column, int row) const { return atFirst + column * aColumn + row * aRow; }
};

/// A rectangle as the picture sees it: the pixels around it, and how far each lies from its centre, in sides.
struct SeenRectangle {
    int firstColumn = 0, lastColumn = -1, firstRow = 0, lastRow = -1;
    OfPixel right, down;
};

class Projecting {
public:
    Projecting(const Camera& camera, int width, int height, const SurfaceRectangles& rectangles)
        : m_camera(camera), m_width(width), m_height(height), m_rectangles(rectangles) {}

    [[nodiscard]] SeenRectangle seen(const SurfaceRay& ray) const {
        const ViewFrame& frame = m_rectangles.frame;
        const auto [wide, high] = m_rectangles.sidesMm;
        const Vec3 centre = ray.pointMm + frame.forward * (ray.surfaceDepthMm - frame.forward.dot(ray.pointMm));
        SeenRectangle seen;
        double least[2] = {infinite, infinite}, most[2] = {-infinite, -infinite};
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) {
                const auto place =
                    placeInPicture(m_camera, centre + frame.right * (x * wide) + frame.down * (y * high));
                if (!place) return seen;
                for (const std::size_t axis : {0u, 1u}) {
                    least[axis] = std::min(least[axis], (*place)[axis]);
                    most[axis] = std::max(most[axis], (*place)[axis]);
                }
            }
        // Column c has its centre at ((c + 0.5) - width / 2) / height. A pixel more on each side costs little.
        const auto pixel = [&](double place, int count) {
            return static_cast<int>(std::clamp(place * m_height + 0.5 * count, -2.0, count + 2.0));
        };
        seen.firstColumn = std::max(0, pixel(least[0], m_width) - 1);
        seen.lastColumn = std::min(m_width - 1, pixel(most[0], m_width) + 1);
        seen.firstRow = std::max(0, pixel(least[1], m_height) - 1);
        seen.lastRow = std::min(m_height - 1, pixel(most[1], m_height) + 1);
        const double depth = m_camera.frame.forward.dot(centre);
        const Vec3 first = atPixel(0, 0, depth), aColumn = atPixel(1, 0, depth) - first,
                   aRow = atPixel(0, 1, depth) - first;
        const auto along = [&](const Vec3& axis, double side) {
            return OfPixel{axis.dot(first - centre) / side, axis.dot(aColumn) / side, axis.dot(aRow) / side};
        };
        seen.right = along(frame.right, wide);
        seen.down = along(frame.down, high);
        return seen;
    }

private:
    [[nodiscard]] Vec3 atPixel(int column, int row, double depth) const {
        return gridPlaceAt(m_camera,
                           {(column + 0.5 - 0.5 * m_width) / m_height, (row + 0.5 - 0.5 * m_height) / m_height}, depth);
    }

    static constexpr double infinite = std::numeric_limits<double>::infinity();
    const Camera& m_camera;
    int m_width, m_height;
    const SurfaceRectangles& m_rectangles;
};

}  // namespace

std::vector<std::int32_t> raysInPicture(const Camera& camera, int width, int height,
                                        const SurfaceRectangles& rectangles) {
    std::vector<std::int32_t> shown(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), noRay);
    const std::vector<SurfaceRay>& rays = rectangles.rays;
    // The nearest last: it is seen.
    std::vector<std::int32_t> order(rays.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::int32_t ray) { return rays[static_cast<std::size_t>(ray)].surfaceDepthMm; });
    std::vector<SeenRectangle> seen(rays.size());
    const Projecting projecting(camera, width, height, rectangles);
    parallelFor(std::size_t{0}, rays.size(),
                [&](std::size_t i) { seen[i] = projecting.seen(rays[static_cast<std::size_t>(order[i])]); });
    // Neighbours share an edge: no pixel on it may fall between them.
    constexpr double half = 0.5 + 1e-9;
    constexpr int rowsOfPart = 16;
    parallelFor(0, (height + rowsOfPart - 1) / rowsOfPart, [&](int part) {
        const int firstRow = part * rowsOfPart, lastRow = std::min(height, firstRow + rowsOfPart) - 1;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const SeenRectangle& one = seen[i];
            for (int row = std::max(firstRow, one.firstRow); row <= std::min(lastRow, one.lastRow); ++row)
                for (int column = one.firstColumn; column <= one.lastColumn; ++column)
                    if (std::abs(one.right.at(column, row)) <= half && std::abs(one.down.at(column, row)) <= half)
                        shown[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(column)] = order[i];
        }
    });
    return shown;
}

}  // namespace echolucent
