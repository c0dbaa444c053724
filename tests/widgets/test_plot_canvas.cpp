// The canvas of a plot: its lines stand where their values are, and the pointer reads the values.
#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/plots/plot_canvas.h"
#include "widgets/plots/plot_painting.h"

using namespace echolucent;

namespace {

Plot steps() {
    return {
        .title = "Steps",
        .xLabel = "place",
        .yLabel = "value",
        .series = {{.name = "low", .x = {0, 1, 2}, .y = {0, 0, 0}}, {.name = "high", .x = {0, 1, 2}, .y = {1, 1, 1}}}};
}

}  // namespace

class TestPlotCanvas : public QObject {
    Q_OBJECT

private slots:
    void thePointerReadsTheNearestValueOfTheNearestLine() {
        PlotCanvas canvas;
        canvas.setPlot(steps());
        canvas.resize(300, canvas.heightForWidth(300));
        const QString above = canvas.wordsAt({canvas.width() / 2.0, 40.0});
        QVERIFY2(above.startsWith("high\nplace: 1\nvalue: 1"), qPrintable(above));
        QCOMPARE(canvas.wordsAt({canvas.width() / 2.0, canvas.height() - 2.0}), QString());
        QCOMPARE(canvas.accessibleName(), QStringLiteral("Steps"));
        QCOMPARE(canvas.accessibleDescription(), QStringLiteral("value over place: low, high."));
    }

    void aLegendThatDoesNotFitTakesMoreHeight() {
        PlotCanvas canvas;
        Plot plot = steps();
        canvas.setPlot(plot);
        const int few = canvas.heightForWidth(300);
        for (int i = 0; i < 8; ++i) plot.series.push_back({.name = "another line of the plot", .x = {0}, .y = {0}});
        canvas.setPlot(plot);
        QVERIFY(canvas.heightForWidth(300) > few);
        QVERIFY(canvas.heightForWidth(3000) < canvas.heightForWidth(300));
    }

    void theHeavyLineIsPaintedOverTheOthers() {
        Plot plot = steps();
        plot.series[0].y = {1, 1, 1};
        plot.series[0].weight = PlotWeight::heavy;
        plot.rangeY = PlotRange{0, 2};
        QImage image(300, 200, QImage::Format_RGB32);
        image.fill(Qt::black);
        QPainter painter(&image);
        const PlotPainting painting(plot, QRectF(image.rect()), painter);
        painting.paint(painter, {.ground = Qt::black,
                                 .text = Qt::white,
                                 .secondary = Qt::white,
                                 .grid = Qt::black,
                                 .frame = Qt::black,
                                 .band = Qt::black,
                                 .dark = true});
        painter.end();
        const QPoint on = painting.positionOf(0.5, 1).toPoint();
        QCOMPARE(image.pixelColor(on), QColor("#4fb3bf"));  // the first free colour, which the first series has
    }
};

ECHOLUCENT_TEST_CLASS(TestPlotCanvas)
#include "test_plot_canvas.moc"
