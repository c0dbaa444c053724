#include "processing/detection/detection_by_variance.h"

#include <span>

namespace echolucent {

DetectionByVariance::DetectionByVariance(const VarianceRule& rule, std::size_t tubes, int cellSize)
    : m_rule(rule), m_cellSize(cellSize), m_scaleSpace(rule), m_slabs(tubes), m_cells(tubes), m_trackers([this] {
          return Tracker(m_scaleSpace);
      }) {}

void DetectionByVariance::keep(TubeReader& reader, std::size_t place, std::size_t tube) {
    m_slabs[tube] = reader.slabsAt(place);
}

void DetectionByVariance::computeInterfaceFunction(StageRunner& run) {
    const auto nothing = [] { return 0; };
    run.forEach(m_cells.size(), nothing, [&](std::size_t tube, int) {
        cellsFrom(m_slabs[tube], m_cellSize, m_cells[tube]);
        m_slabs[tube] = {};
    });
}

const CellStatistics& DetectionByVariance::cellsOf(std::size_t tube, CellStatistics& /*scratch*/) const {
    return m_cells[tube];
}

std::vector<float> DetectionByVariance::interfaceFunctionOf(std::size_t /*tube*/, const CellStatistics& cells) const {
    return {cells.variances.begin(), cells.variances.end()};
}

std::vector<int> DetectionByVariance::track(const CellStatistics& cells, std::vector<TrackedScale>* trace) {
    if (cells.lastCell < cells.firstCell) return {};
    const auto function = std::span<const double>(cells.variances)
                              .subspan(static_cast<std::size_t>(cells.firstCell),
                                       static_cast<std::size_t>(cells.lastCell - cells.firstCell + 1));
    Tracker& tracker = m_trackers.local();
    return trackSurface(function, tracker.smoother, m_rule, tracker.scratch, trace);
}

std::vector<TrackedScale> DetectionByVariance::traceOf(const CellStatistics& cells) {
    std::vector<TrackedScale> trace;
    (void)track(cells, &trace);
    for (TrackedScale& scale : trace) {
        scale.searched.first += cells.firstCell;
        scale.searched.last += cells.firstCell;
        if (scale.cell) *scale.cell += cells.firstCell;
    }
    return trace;
}

std::optional<FoundSurface> DetectionByVariance::surfaceOf(std::size_t /*tube*/, const CellStatistics& cells,
                                                           std::vector<int>& tracked) {
    tracked = track(cells, nullptr);
    if (tracked.empty()) return std::nullopt;
    for (int& cell : tracked) cell += cells.firstCell;
    int surface = tracked.back();
    // A cell of too little data repeats the cell before it, so go back to the last complete cell.
    while (surface > cells.firstCell && cells.complete[static_cast<std::size_t>(surface)] == 0) --surface;
    return FoundSurface{surface, std::nullopt};
}

}  // namespace echolucent
