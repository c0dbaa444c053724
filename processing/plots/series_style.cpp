#include "processing/plots/series_style.h"

namespace echolucent {

std::vector<std::size_t> coloursOf(const std::vector<PlotSeries>& series) {
    std::array<bool, seriesColours.size()> used{};
    std::vector<std::size_t> colours(series.size(), seriesColours.size());
    for (std::size_t i = 0; i < series.size(); ++i)
        if (const auto& own = series[i].colour) {
            colours[i] = *own % seriesColours.size();
            used[colours[i]] = true;
        }
    for (std::size_t i = 0; i < series.size(); ++i)
        for (std::size_t c = 0; c < seriesColours.size() && !series[i].colour && series[i].weight != PlotWeight::faint;
             ++c) {
            const std::string_view curve = seriesColours[c].curve;
            if (curve.empty() || used[c] || !series[i].name.starts_with(curve)) continue;
            used[c] = true;
            colours[i] = c;
            break;
        }
    std::size_t next = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (colours[i] < seriesColours.size() || series[i].weight == PlotWeight::faint) continue;
        while (next < seriesColours.size() && used[next]) ++next;
        if (next == seriesColours.size()) {
            used.fill(false);
            next = 0;
        }
        used[next] = true;
        colours[i] = next;
    }
    return colours;
}

}  // namespace echolucent
