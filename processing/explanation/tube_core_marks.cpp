#include "processing/explanation/tube_core_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "processing/adaptive/halved_lengths.h"
#include "processing/viewpoint/box_section.h"

namespace echolucent {

const TubeCoreMark* TubeCoreMarks::of(int number) const {
    const auto found = std::ranges::lower_bound(marks, number, {}, &TubeCoreMark::number);
    return found != marks.end() && found->number == number ? &*found : nullptr;
}

TubeCoreMarks marksOf(const AdaptiveOtf& otf, const VolumeGeometry& geometry) {
    const AdaptiveOtfConfig used = configUsed(otf);
    TubeCoreMarks marks;
    marks.axes = frameOf(otf.view);
    marks.unitMm = otf.tubeLengthUnit;
    marks.halfWidthMm = used.cells.size / 2.0 * otf.tubeLengthUnit;
    marks.halfSpacingMm = std::max(otf.tubeSpacingUnits[0], otf.tubeSpacingUnits[1]) / 2.0 * otf.tubeLengthUnit;
    marks.columns = used.grid.columns;
    marks.rows = used.grid.rows;
    double largest = 0.0;
    for (const TubeCore& tube : otf.tubes) largest = std::max(largest, tube.d);
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
        const TubeCore& tube = otf.tubes[t];
        if (tube.status == TubeStatus::outside) continue;
        const Vec3 first = geometry.gridMmFromVoxel(tube.firstSampleVoxel);
        const auto sampleAt = [&](double sample) { return first + marks.axes.forward * (sample * otf.tubeLengthUnit); };
        TubeCoreMark mark{.number = static_cast<int>(t),
                          .beginMm = sampleAt(tube.firstCell),
                          .endMm = sampleAt(static_cast<double>(tube.cellMeans.size()) + used.cells.size - 2)};
        if (tube.surfaceVoxel) mark.surfaceMm = geometry.gridMmFromVoxel(*tube.surfaceVoxel);
        if (largest > 0.0) mark.share = tube.d / largest;
        marks.marks.push_back(mark);
    }
    return marks;
}

std::vector<int> thinned(const TubeCoreMarks& marks, std::size_t most) {
    const int widest = std::max({marks.columns, marks.rows, 1});
    for (int square = 1; square <= widest; ++square) {
        std::map<std::pair<int, int>, const TubeCoreMark*> heaviest;
        for (const TubeCoreMark& mark : marks.marks) {
            if (!(mark.share > 0.0)) continue;
            const TubeCoreMark*& kept =
                heaviest[{mark.number / marks.columns / square, mark.number % marks.columns / square}];
            if (kept == nullptr || mark.share > kept->share) kept = &mark;
        }
        if (heaviest.size() > most && square < widest) continue;
        std::vector<int> numbers;
        for (const auto& [place, mark] : heaviest) numbers.push_back(mark->number);
        std::ranges::sort(numbers);
        return numbers;
    }
    return {};
}

OrientedBox columnOf(const TubeCoreMarks& marks, const TubeCoreMark& mark) {
    const double width = 2.0 * marks.halfWidthMm;
    return {(mark.beginMm + mark.endMm) * 0.5, marks.axes,
            Vec3(width, width, marks.axes.forward.dot(mark.endMm - mark.beginMm) + marks.unitMm)};
}

std::optional<TubeCoreInPlane> shownInPlane(const TubeCoreMarks& marks, const TubeCoreMark& mark, const Vec3& pointMm,
                                            const Vec3& normal) {
    const double begin = normal.dot(mark.beginMm - pointMm), end = normal.dot(mark.endMm - pointMm);
    // The axis crosses the plane, or one of its ends is the nearest place.
    const double apart = begin * end <= 0.0 ? 0.0 : std::abs(begin) < std::abs(end) ? begin : end;
    if (std::abs(apart) > marks.halfSpacingMm) return std::nullopt;
    OrientedBox column = columnOf(marks, mark);
    column.centreMm -= normal * apart;
    TubeCoreInPlane shown{sectionOf(column, pointMm, normal).corners, std::nullopt};
    if (shown.outlineMm.size() < 3) return std::nullopt;
    if (mark.surfaceMm && std::abs(normal.dot(*mark.surfaceMm - pointMm) - apart) <= marks.halfWidthMm)
        shown.surfaceMm = *mark.surfaceMm - normal * apart;
    return shown;
}

}  // namespace echolucent
