#include "io/study/slice_stack.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

constexpr double refusedUnevenness = 0.10;
constexpr double mentionedUnevenness = 0.01;

std::string sidewaysWarning(const std::vector<SlicePlane>& planes, const SliceStack& stack, const Vec3& normal) {
    double sideways = 0.0;
    for (const std::size_t index : stack.order) {
        const Vec3 offset = planes[index].position - stack.origin;
        sideways = std::max(sideways, length(offset - normal * offset.dot(normal)));
    }
    if (sideways < 0.1 * stack.spacing) return {};
    return fmt::format("The slices are shifted sideways by up to {:.3g} mm; they are stacked as if they were not.",
                       sideways);
}

}  // namespace

double turnBetween(const SlicePlane& a, const SlicePlane& b) {
    return std::max(length(a.alongRow - b.alongRow), length(a.alongColumn - b.alongColumn));
}

bool areParallel(const SlicePlane& a, const SlicePlane& b) {
    constexpr double parallelTurn = 1e-3;
    // std::max() may pass over a number that is none.
    return length(a.alongRow - b.alongRow) < parallelTurn && length(a.alongColumn - b.alongColumn) < parallelTurn;
}

Result<SliceStack> stackSlices(const std::string& file, const std::string& positionTag,
                               const std::vector<SlicePlane>& planes) {
    const SlicePlane& first = planes.front();
    const auto refuse = [&](const SlicePlane& plane, const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, plane.file.empty() ? file : plane.file, positionTag, problem, remedy);
    };
    for (const SlicePlane& plane : planes)
        if (!isPosition(plane.position))
            return refuse(plane,
                          fmt::format("puts a slice at ({:.4g}, {:.4g}, {:.4g}) mm, where no scanner can be",
                                      plane.position[0], plane.position[1], plane.position[2]),
                          "Export the series again.");
    const auto turned = std::find_if_not(planes.begin(), planes.end(),
                                         [&](const SlicePlane& plane) { return areParallel(plane, first); });
    if (turned != planes.end())
        return refuse(*turned, "belongs to slices that are not parallel: a rotated or freehand sweep is no volume yet",
                      "Have it resampled to a volume by the scanner or its software.");
    const Vec3 normal = first.alongRow.cross(first.alongColumn);
    std::vector<double> depth(planes.size());
    for (std::size_t i = 0; i < planes.size(); ++i) depth[i] = planes[i].position.dot(normal);

    SliceStack stack;
    stack.order.resize(planes.size());
    std::iota(stack.order.begin(), stack.order.end(), std::size_t{0});
    std::stable_sort(stack.order.begin(), stack.order.end(),
                     [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
    stack.spacing = (depth[stack.order.back()] - depth[stack.order.front()]) / static_cast<double>(planes.size() - 1);
    double least = stack.spacing;
    double most = stack.spacing;
    const SlicePlane* afterLeast = &first;
    const SlicePlane* afterMost = &first;
    for (std::size_t i = 1; i < planes.size(); ++i) {
        const double distance = depth[stack.order[i]] - depth[stack.order[i - 1]];
        const SlicePlane& plane = planes[stack.order[i]];
        if (distance < least) afterLeast = &plane;
        if (distance > most) afterMost = &plane;
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    if (!(least >= samePositionMm))
        return refuse(*afterLeast, "is the same for two slices",
                      "Keep the slices of one volume at one time in the folder.");
    if (!(most - stack.spacing <= refusedUnevenness * stack.spacing &&
          stack.spacing - least <= refusedUnevenness * stack.spacing))
        return refuse(
            most - stack.spacing >= stack.spacing - least ? *afterMost : *afterLeast,
            fmt::format("puts slices between {:.4g} and {:.4g} mm apart; slices are missing or uneven", least, most),
            "Export the whole series again, with equal distances.");
    if (most - least > mentionedUnevenness * stack.spacing)
        stack.warnings.push_back(
            fmt::format("The slices lie between {:.4g} and {:.4g} mm apart; {:.4g} mm is used throughout.", least, most,
                        stack.spacing));
    stack.origin = planes[stack.order.front()].position;
    for (int row = 0; row < 3; ++row) {
        stack.direction(row, 0) = first.alongRow[row];
        stack.direction(row, 1) = first.alongColumn[row];
        stack.direction(row, 2) = normal[row];
    }
    if (auto warning = sidewaysWarning(planes, stack, normal); !warning.empty())
        stack.warnings.push_back(std::move(warning));
    return stack;
}

}  // namespace echolucent
