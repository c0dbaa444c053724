#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/pages/html_page.h"
#include "app/pages/html_text.h"
#include "processing/plots/plot_axis.h"
#include "processing/plots/series_style.h"

namespace echolucent {

namespace {

constexpr double plotWidth = 760, plotLeft = 78, plotRight = 736, plotTop = 40, plotBottom = 384;
constexpr double characterWidth = 6.6;  // of the type of legend and labels, a little generous
constexpr double legendRow = 20, legendSample = 34;

struct Box {
    double x, y, width, height;
    [[nodiscard]] bool meets(const Box& other) const {
        return x < other.x + other.width && other.x < x + width && y < other.y + other.height && other.y < y + height;
    }
};

/// Counts characters and not bytes: UTF-8's continuation bytes add no width.
double textWidth(const std::string& text) {
    return characterWidth *
           static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<double> valuesOf(const Plot& plot, bool ofX) {
    std::vector<double> values;
    for (const PlotSeries& series : plot.series) {
        const auto& own = ofX ? series.x : series.y;
        values.insert(values.end(), own.begin(), own.end());
    }
    return values;
}

struct Place {
    double x, y;
};

/// Distance of a place from the line through `first` and `last`. If these are one place, the distance from that place.
double distanceFromLine(const Place& place, const Place& first, const Place& last) {
    const double dx = last.x - first.x, dy = last.y - first.y, length = std::hypot(dx, dy);
    if (length == 0.0) return std::hypot(place.x - first.x, place.y - first.y);
    return std::abs(dx * (place.y - first.y) - dy * (place.x - first.x)) / length;
}

/// Appends the places after the first that a line needs, so that no other place lies farther than a fifth of a pixel
/// from it (Douglas and Peucker 1973). So a report's page stays small.
void appendNeeded(const std::vector<Place>& line, std::size_t first, std::size_t last, std::vector<Place>& needed) {
    constexpr double tolerance = 0.2;
    std::size_t farthest = first;
    double distance = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
        if (const double own = distanceFromLine(line[i], line[first], line[last]); own > distance) {
            distance = own;
            farthest = i;
        }
    if (farthest == first) {
        needed.push_back(line[last]);
        return;
    }
    appendNeeded(line, first, farthest, needed);
    appendNeeded(line, farthest, last, needed);
}

class PlotDrawing {
public:
    explicit PlotDrawing(const Plot& plot)
        : m_plot(plot),
          m_x(valuesOf(plot, true), plot.logX, plot.rangeX),
          m_y(valuesOf(plot, false), plot.logY, plot.rangeY),
          m_colours(coloursOf(plot.series)) {}

    std::string text() {
        drawBands();
        drawGrid();
        drawTitles();
        drawMarks();
        for (const PlotWeight weight : {PlotWeight::faint, PlotWeight::ordinary, PlotWeight::heavy})
            for (std::size_t i = 0; i < m_plot.series.size(); ++i)
                if (m_plot.series[i].weight == weight) drawLine(i);
        for (std::size_t i = 0; i < m_plot.series.size(); ++i) drawMarkers(i);
        for (std::size_t i = 0; i < m_plot.series.size(); ++i) drawLabels(i);
        const double height = drawLegend();
        return fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
            "role=\"img\" font-family=\"sans-serif\" font-size=\"12\">\n<title>{2}</title>\n{3}</svg>\n",
            plotWidth, height, escaped(m_plot.title), m_body);
    }

private:
    [[nodiscard]] double pixelX(double value) const { return plotLeft + (plotRight - plotLeft) * m_x.placeOf(value); }
    [[nodiscard]] double pixelY(double value) const { return plotBottom - (plotBottom - plotTop) * m_y.placeOf(value); }
    [[nodiscard]] bool shows(const PlotSeries& series, std::size_t i) const {
        return m_x.shows(series.x[i]) && m_y.shows(series.y[i]);
    }
    [[nodiscard]] static std::size_t countOf(const PlotSeries& series) {
        return std::min(series.x.size(), series.y.size());
    }
    [[nodiscard]] const SeriesColour& colour(std::size_t i) const { return colourAt(m_colours[i]); }
    [[nodiscard]] double strokeWidth(std::size_t i) const;

    void drawBands();
    void drawGrid();
    void drawTitles();
    void drawMarks();
    void drawLine(std::size_t index);
    void drawMarkers(std::size_t index);
    void drawLabels(std::size_t index);
    void drawMarker(std::size_t index, double x, double y, const std::string& says);
    double drawLegend();

    const Plot& m_plot;
    PlotAxis m_x, m_y;
    std::vector<std::size_t> m_colours;
    std::vector<Box> m_taken;  ///< where markers and labels stand
    std::string m_body;
};

double PlotDrawing::strokeWidth(std::size_t i) const {
    switch (m_plot.series[i].weight) {
        case PlotWeight::ordinary: break;
        case PlotWeight::heavy: return 3.5;
        case PlotWeight::faint: return 1.0;
    }
    return 2.0;
}

void PlotDrawing::drawBands() {
    for (const PlotBand& band : m_plot.bands) {
        if (!m_x.shows(band.from) || !m_x.shows(band.to)) continue;
        const double from = std::clamp(pixelX(band.from), plotLeft, plotRight);
        const double to = std::clamp(pixelX(band.to), plotLeft, plotRight);
        if (!(from < to)) continue;
        m_body += fmt::format(
            "<rect class=\"band\" fill=\"#e6ebf0\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" "
            "height=\"{}\"><title>{}</title>"
            "</rect>\n",
            from, plotTop, to - from, plotBottom - plotTop, escaped(band.label));
    }
}

void PlotDrawing::drawMarks() {
    const auto add = [this](const std::string& path, double x, double y, const std::string& label) {
        m_body += fmt::format(
            "<path class=\"mark\" stroke=\"#555\" stroke-dasharray=\"4 3\" d=\"{}\"/>\n"
            "<text class=\"ink\" fill=\"#333\" font-size=\"11\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
            path, x, y, escaped(label));
        m_taken.push_back({x, y - 10, textWidth(label), 12});
    };
    // Names of upright lines that stand close together go on lines of text of their own.
    constexpr double line = 13, mostLines = 4;
    std::vector<double> ends;
    for (const PlotMark& mark : m_plot.marksX) {
        if (!m_x.shows(mark.value)) continue;
        const double x = pixelX(mark.value), wide = textWidth(mark.label);
        if (x < plotLeft || x > plotRight) continue;
        const double begin = x + 4 + wide > plotRight ? x - 4 - wide : x + 4;
        std::size_t row = 0;
        while (row < ends.size() && begin < ends[row] && row + 1 < mostLines) ++row;
        if (row == ends.size()) ends.push_back(0);
        ends[row] = begin + wide + 4;
        add(fmt::format("M{0:.1f} {1}V{2}", x, plotTop, plotBottom), begin,
            plotTop + 13 + line * static_cast<double>(row), mark.label);
    }
    for (const PlotMark& mark : m_plot.marksY) {
        if (!m_y.shows(mark.value)) continue;
        const double y = pixelY(mark.value);
        if (y < plotTop || y > plotBottom) continue;
        add(fmt::format("M{0} {1:.1f}H{2}", plotLeft, y, plotRight), plotRight - 4 - textWidth(mark.label), y - 4,
            mark.label);
    }
}

void PlotDrawing::drawGrid() {
    for (const PlotTick& tick : m_x.ticks()) {
        const double x = pixelX(tick.value);
        m_body +=
            fmt::format("<path class=\"grid\" stroke=\"#d5d9de\" d=\"M{0:.1f} {1}V{2}\"/>\n", x, plotTop, plotBottom);
        if (!tick.label.empty())
            m_body += fmt::format(
                "<text class=\"ink\" fill=\"#333\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x,
                plotBottom + 18, escaped(tick.label));
    }
    for (const PlotTick& tick : m_y.ticks()) {
        const double y = pixelY(tick.value);
        m_body +=
            fmt::format("<path class=\"grid\" stroke=\"#d5d9de\" d=\"M{1} {0:.1f}H{2}\"/>\n", y, plotLeft, plotRight);
        if (!tick.label.empty())
            m_body +=
                fmt::format("<text class=\"ink\" fill=\"#333\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                            plotLeft - 8, y + 4, escaped(tick.label));
    }
    m_body += fmt::format(
        "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666\"/>\n",
        plotLeft, plotTop, plotRight - plotLeft, plotBottom - plotTop);
}

void PlotDrawing::drawTitles() {
    constexpr double middleY = (plotTop + plotBottom) / 2;
    m_body += fmt::format(
        "<text class=\"ink\" fill=\"#333\" x=\"{}\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{}</text>\n",
        plotLeft, escaped(m_plot.title));
    m_body += fmt::format("<text class=\"ink\" fill=\"#333\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                          (plotLeft + plotRight) / 2, plotBottom + 38, escaped(m_plot.xLabel));
    m_body += fmt::format(
        "<text class=\"ink\" fill=\"#333\" x=\"18\" y=\"{0}\" text-anchor=\"middle\" transform=\"rotate(-90 18 "
        "{0})\">{1}"
        "</text>\n",
        middleY, escaped(m_plot.yLabel));
}

void PlotDrawing::drawLine(std::size_t index) {
    const PlotSeries& series = m_plot.series[index];
    if (!series.line) return;
    std::string path;
    const std::size_t count = countOf(series);
    std::vector<Place> piece;  // the line between two gaps
    for (std::size_t i = 0; i <= count; ++i) {
        if (i < count && shows(series, i)) {
            piece.push_back({pixelX(series.x[i]), pixelY(series.y[i])});
            continue;
        }
        if (piece.empty()) continue;
        std::vector<Place> needed{piece.front()};
        if (piece.size() > 1) appendNeeded(piece, 0, piece.size() - 1, needed);
        for (std::size_t k = 0; k < needed.size(); ++k)
            path += fmt::format("{}{:.1f} {:.1f}", k == 0 ? 'M' : 'L', needed[k].x, needed[k].y);
        // A point between two gaps has no line. A line of length 0 with a round cap shows it.
        if (needed.size() == 1) path += "h0";
        piece.clear();
    }
    if (path.empty()) return;
    m_body += fmt::format(
        "<path class=\"line c{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\"{} d=\"{}\"/>\n",
        m_colours[index], colour(index).onLight, strokeWidth(index),
        colour(index).dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", colour(index).dashes), path);
}

void PlotDrawing::drawMarker(std::size_t index, double x, double y, const std::string& says) {
    static constexpr std::array<std::string_view, 5> shapes{"M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z",
                                                            "M-3.6 -3.6h7.2v7.2h-7.2z", "M0 -5L5 0L0 5L-5 0z",
                                                            "M0 -4.8L4.6 3.6H-4.6z", "M0 4.8L4.6 -3.6H-4.6z"};
    m_body += fmt::format("<path class=\"marker c{}\" fill=\"{}\" transform=\"translate({:.1f} {:.1f})\" d=\"{}\">",
                          m_colours[index], colour(index).onLight, x, y, shapes[index % shapes.size()]);
    if (!says.empty()) m_body += "<title>" + escaped(says) + "</title>";
    m_body += "</path>\n";
}

void PlotDrawing::drawMarkers(std::size_t index) {
    const PlotSeries& series = m_plot.series[index];
    if (!series.markers) return;
    for (std::size_t i = 0; i < countOf(series); ++i) {
        if (!shows(series, i)) continue;
        const double x = pixelX(series.x[i]), y = pixelY(series.y[i]);
        const auto& names = series.names.empty() ? series.labels : series.names;
        const std::string label = i < names.size() ? names[i] + ": " : std::string();
        drawMarker(index, x, y, fmt::format("{}{}, {}", label, shortNumber(series.x[i]), shortNumber(series.y[i])));
        m_taken.push_back({x - 4, y - 4, 8, 8});
    }
}

void PlotDrawing::drawLabels(std::size_t index) {
    constexpr double height = 12, gap = 7;
    const PlotSeries& series = m_plot.series[index];
    for (std::size_t i = 0; i < std::min(countOf(series), series.labels.size()); ++i) {
        if (!shows(series, i) || series.labels[i].empty()) continue;
        const double x = pixelX(series.x[i]), y = pixelY(series.y[i]), wide = textWidth(series.labels[i]);
        const std::array<Box, 5> places{
            Box{x + 4, y - 3 - height, wide, height}, Box{x + gap, y - height / 2, wide, height},
            Box{x - wide / 2, y - gap - height, wide, height}, Box{x - gap - wide, y - height / 2, wide, height},
            Box{x - wide / 2, y + gap, wide, height}};
        // If no side is free, only the marker's tooltip shows the label: two labels on top of each other tell nothing.
        const auto free = std::find_if(places.begin(), places.end(), [&](const Box& place) {
            return place.x >= plotLeft && place.x + wide <= plotRight && place.y >= plotTop &&
                   place.y + height <= plotBottom &&
                   std::none_of(m_taken.begin(), m_taken.end(), [&](const Box& box) { return box.meets(place); });
        });
        if (free == places.end()) continue;
        m_taken.push_back(*free);
        m_body +=
            fmt::format("<text class=\"ink\" fill=\"#333\" font-size=\"11\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                        free->x, free->y + height - 2, escaped(series.labels[i]));
    }
}

double PlotDrawing::drawLegend() {
    double x = plotLeft, y = plotBottom + 62;
    const auto place = [&](const std::string& name) {
        const double wide = legendSample + textWidth(name) + 22;
        if (x > plotLeft && x + wide > plotRight) {
            x = plotLeft;
            y += legendRow;
        }
        m_body += fmt::format("<text class=\"ink\" fill=\"#333\" x=\"{}\" y=\"{}\">{}</text>\n", x + legendSample, y,
                              escaped(name));
        return wide;
    };
    for (std::size_t i = 0; i < m_plot.series.size(); ++i) {
        const PlotSeries& series = m_plot.series[i];
        if (series.name.empty()) continue;
        const double wide = place(series.name);
        if (series.line)
            m_body += fmt::format(
                "<path class=\"c{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{} d=\"M{} {}h26\"/>\n",
                m_colours[i], colour(i).onLight, strokeWidth(i),
                colour(i).dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", colour(i).dashes), x, y - 4);
        if (series.markers) drawMarker(i, x + 13, y - 4, {});
        x += wide;
    }
    std::string named;
    for (const PlotBand& band : m_plot.bands) {
        if (band.label.empty() || band.label == named) continue;
        named = band.label;
        const double wide = place(band.label);
        m_body += fmt::format("<rect class=\"band\" fill=\"#e6ebf0\" x=\"{}\" y=\"{}\" width=\"26\" height=\"12\"/>\n",
                              x, y - 10);
        x += wide;
    }
    return y + (m_plot.series.empty() && named.empty() ? -8 : 12);
}

}  // namespace

std::string svgOf(const Plot& plot) { return PlotDrawing(plot).text(); }

}  // namespace echolucent
