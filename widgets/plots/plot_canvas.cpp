#include "widgets/plots/plot_canvas.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPixmap>
#include <QStringList>
#include <QToolTip>
#include <cmath>

#include "widgets/larger_letters.h"
#include "widgets/otf_editor/plot_colours.h"
#include "widgets/plots/plot_painting.h"

namespace echolucent {

namespace {

constexpr double rim = 4.0;

QString describe(const Plot& plot) {
    QStringList names;
    for (const PlotSeries& series : plot.series)
        if (!series.name.empty()) names << QString::fromStdString(series.name);
    return PlotCanvas::tr("%1 over %2: %3.")
        .arg(QString::fromStdString(plot.yLabel), QString::fromStdString(plot.xLabel),
             names.join(QStringLiteral(", ")));
}

}  // namespace

PlotCanvas::PlotCanvas(QWidget* parent, int areaHeight) : QWidget(parent), m_areaHeight(areaHeight) {
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void PlotCanvas::setPlot(const Plot& plot) {
    if (plot == m_plot) return;
    const int before = heightForWidth(width());
    m_plot = plot;
    setAccessibleName(QString::fromStdString(plot.title));
    setAccessibleDescription(describe(plot));
    if (heightForWidth(width()) != before) updateGeometry();
    update();
}

int PlotCanvas::heightForWidth(int width) const {
    const double letters = lettersOf(*this);
    return static_cast<int>(
        std::ceil(PlotPainting::heightFor(m_plot, width - 2 * rim, letters * m_areaHeight, font(), letters) + 2 * rim));
}

QSize PlotCanvas::minimumSizeHint() const { return inLettersOf(*this, QSize(200, m_areaHeight + 40)); }

QRectF PlotCanvas::place() const { return QRectF(rect()).adjusted(rim, rim, -rim, -rim); }

QString PlotCanvas::wordsAt(QPointF position) const {
    QPixmap measure(1, 1);  // the font's metrics need a device
    QPainter painter(&measure);
    painter.setFont(font());
    const PlotPainting painting(m_plot, place(), painter, lettersOf(*this));
    const auto point = painting.pointAt(position);
    if (!point) return {};
    const PlotSeries& series = m_plot.series[point->series];
    const auto words = [](const std::string& text) { return QString::fromStdString(text); };
    const auto& names = series.names.empty() ? series.labels : series.names;
    const QString name = point->index < names.size() ? words(names[point->index]) : words(series.name);
    return tr("%1\n%2: %3\n%4: %5")
        .arg(name, words(m_plot.xLabel), words(shortNumber(series.x[point->index])), words(m_plot.yLabel),
             words(shortNumber(series.y[point->index])))
        .trimmed();
}

bool PlotCanvas::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString words = wordsAt(help->pos());
    if (words.isEmpty()) {
        // Beside the lines the canvas says what the plot is.
        return QWidget::event(event);
    }
    QToolTip::showText(help->globalPos(), words, this);
    return true;
}

void PlotCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) updateGeometry();
    QWidget::changeEvent(event);
}

void PlotCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = themeOf(palette());
    const PlotColours colours = plotColours(theme);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    const PlotPaint paint{.ground = colours.background,
                          .text = colours.text,
                          .secondary = colours.secondary,
                          .grid = colours.grid,
                          .frame = colours.frame,
                          .band = colours.histogram,
                          .dark = theme == Theme::dark};
    PlotPainting(m_plot, place(), painter, lettersOf(*this)).paint(painter, paint);
}

}  // namespace echolucent
