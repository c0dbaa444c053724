#include "processing/viewpoint/cut_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace echolucent {

namespace {

/// The bilinear patch of nodes around a place.
struct Patch {
    std::size_t node;          ///< the node of least column and row
    double acrossNode, below;  ///< share of the way to the next column and row, [0,1]
};

Patch patchAt(const CutSurface& surface, const Vec3& gridMm) {
    const auto placed = [&](double mm, double first, int count) {
        const double place = std::clamp((mm - first) / surface.spacingMm, 0.0, count - 1.0);
        const double low = std::min(std::floor(place), count - 2.0);
        return std::array{low, place - low};
    };
    const auto [column, across] = placed(surface.frame.right.dot(gridMm), surface.firstRightMm, surface.columns);
    const auto [row, below] = placed(surface.frame.down.dot(gridMm), surface.firstDownMm, surface.rows);
    return {
        static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.columns) + static_cast<std::size_t>(column),
        across, below};
}

/// The next place behind `from` at which a line crosses from one patch of nodes to another, or `to` if it crosses none
/// before `to`. All places are mm from `pointMm` along the line.
double nextCrossing(const CutSurface& surface, const Vec3& pointMm, const Vec3& direction, double from, double to) {
    double next = to;
    const auto crossing = [&](const Vec3& axis, double first, int count) {
        const double towards = axis.dot(direction) / surface.spacingMm;  // nodes per mm
        if (towards == 0.0) return;
        const double start = (axis.dot(pointMm) - first) / surface.spacingMm;
        constexpr double rounding = 1e-9;
        const double at = start + towards * from;
        double node = towards > 0.0 ? std::floor(at + rounding) + 1.0 : std::ceil(at - rounding) - 1.0;
        if (towards > 0.0) node = std::max(node, 0.0);
        if (towards < 0.0) node = std::min(node, count - 1.0);
        if (node < 0.0 || node > count - 1.0) return;
        // Rounding must not bring a line to a halt.
        if (const double mm = (node - start) / towards; mm > from) next = std::min(next, mm);
    };
    crossing(surface.frame.right, surface.firstRightMm, surface.columns);
    crossing(surface.frame.down, surface.firstDownMm, surface.rows);
    return next;
}

/// The first place in [0,1] at which a parabola through (0, first), (1/2, middle), (1, last) is at least 0, if any.
std::optional<double> firstRoot(double first, double middle, double last) {
    if (first >= 0.0) return 0.0;
    const double square = 2.0 * (first - 2.0 * middle + last), linear = last - first - square;
    const double discriminant = linear * linear - 4.0 * square * first;
    if (discriminant < 0.0) return std::nullopt;
    const double q = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
    std::optional<double> nearest;
    for (const double root : {square != 0.0 ? q / square : -1.0, q != 0.0 ? first / q : -1.0})
        if (root >= 0.0 && root <= 1.0) nearest = std::min(nearest.value_or(root), root);
    if (!nearest && last >= 0.0) return 1.0;
    return nearest;
}

}  // namespace

double CutSurface::depthAt(const Vec3& gridMm) const {
    const Patch patch = patchAt(*this, gridMm);
    const auto row = static_cast<std::size_t>(columns);
    const auto node = [&](std::size_t place) { return static_cast<double>(depthMm[place]); };
    const auto between = [](double a, double b, double share) { return a + share * (b - a); };
    return between(between(node(patch.node), node(patch.node + 1), patch.acrossNode),
                   between(node(patch.node + row), node(patch.node + row + 1), patch.acrossNode), patch.below);
}

std::optional<CutSurface::Stretch> CutSurface::firstLeft(const Vec3& pointMm, const Vec3& direction,
                                                         const Stretch& within) const {
    const auto behind = [&](double mm) {
        const Vec3 place = pointMm + direction * mm;
        return frame.forward.dot(place) - depthAt(place);
    };
    std::optional<double> begin;
    for (double from = within.begin; from < within.end;) {
        const double to = nextCrossing(*this, pointMm, direction, from, within.end);
        // Between two crossings the distance behind the surface is a polynomial of degree 2.
        const double first = behind(from), middle = behind((from + to) / 2.0), last = behind(to);
        double entered = 0.0;
        if (!begin) {
            const auto share = firstRoot(first, middle, last);
            if (share) begin = from + *share * (to - from);
            entered = share.value_or(1.0);
        }
        if (begin && last < 0.0) {
            // Search from the last place back: the first root from there is the last one.
            const double left = 1.0 - firstRoot(last, middle, first).value_or(1.0 - entered);
            return Stretch{*begin, from + std::max(entered, left) * (to - from)};
        }
        from = to;
    }
    if (!begin) return std::nullopt;
    return Stretch{*begin, within.end};
}

std::string problemOf(const CutSurface& surface) {
    constexpr int mostNodes = 4096;  // along one side: limits the memory a file asks for
    if (const std::string frame = problemOf(surface.frame); !frame.empty()) return frame;
    if (!std::isfinite(surface.firstRightMm) || !std::isfinite(surface.firstDownMm))
        return "has a first node whose place is not finite";
    if (!std::isfinite(surface.spacingMm) || !(surface.spacingMm > 0.0)) return "has a spacing that is not above 0";
    if (surface.columns < 2) return "has fewer than 2 columns";
    if (surface.rows < 2) return "has fewer than 2 rows";
    if (surface.columns > mostNodes || surface.rows > mostNodes) return "has more than 4096 columns or rows";
    if (surface.depthMm.size() != static_cast<std::size_t>(surface.columns) * static_cast<std::size_t>(surface.rows))
        return "does not have one depth for each node";
    if (!std::all_of(surface.depthMm.begin(), surface.depthMm.end(), [](float mm) { return std::isfinite(mm); }))
        return "has a depth that is not finite";
    return {};
}

}  // namespace echolucent
