// Measurements over pictures: where their lines, marks and words are painted.
#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/picture_labels/measurement_drawing.h"

using namespace echolucent;

namespace {

QImage painted(const std::vector<PlacedMeasurement>& measurements, const QSize& size, double scale) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(QColor(90, 90, 90));
    QPainter painter(&image);
    paintMeasurements(painter, measurements, size, scale);
    return image;
}

/// Pixels of nearly the measurements' colour in a rectangle.
int inColour(const QImage& image, const QRect& where) {
    int count = 0;
    for (int y = std::max(0, where.top()); y <= std::min(image.height() - 1, where.bottom()); ++y)
        for (int x = std::max(0, where.left()); x <= std::min(image.width() - 1, where.right()); ++x) {
            const QColor is = image.pixelColor(x, y);
            count += std::abs(is.red() - measurementColour.red()) < 40 &&
                     std::abs(is.green() - measurementColour.green()) < 40 &&
                     std::abs(is.blue() - measurementColour.blue()) < 40;
        }
    return count;
}

QRect around(const QPointF& at, int reach) {
    return {at.toPoint() - QPoint(reach, reach), QSize(2 * reach + 1, 2 * reach + 1)};
}

}  // namespace

class TestMeasurementDrawing : public QObject {
    Q_OBJECT

private slots:
    void marksLinesAndWordsStandWhereTheyAreSeen_data() {
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 2.0, 3.5}) QTest::addRow("%g", scale) << scale;
    }
    void marksLinesAndWordsStandWhereTheyAreSeen() {
        QFETCH(double, scale);
        const QSize size = QSize(400, 200) * scale;
        const QImage image =
            painted({{.id = 1, .places = {{-0.5, 0.25}, {0.25, -0.125}}, .text = "12.3 mm"}}, size, scale);
        const QPointF from = QPointF(100, 150) * scale, to = QPointF(250, 75) * scale;
        const int reach = qRound(3 * scale);
        for (const QPointF& at : {from, to}) QVERIFY(inColour(image, around(at, reach)) > 0.6 * M_PI * reach * reach);
        for (const double share : {0.2, 0.5, 0.8}) QVERIFY(inColour(image, around(from + (to - from) * share, 1)) >= 2);
        // The words stand to the right of the right place, and nowhere else.
        const QRect words(to.toPoint() + QPoint(qRound(8 * scale), -qRound(10 * scale)),
                          QSize(qRound(80 * scale), qRound(20 * scale)));
        QVERIFY(inColour(image, words) > 60 * scale);
        const int all = inColour(image, image.rect());
        const QRect beside(from.toPoint() - QPoint(qRound(100 * scale), qRound(10 * scale)),
                           QSize(qRound(90 * scale), qRound(20 * scale)));
        QCOMPARE(inColour(image, beside), 0);
        const QImage wordless = painted({{.id = 1, .places = {{-0.5, 0.25}, {0.25, -0.125}}}}, size, scale);
        QCOMPARE(inColour(wordless, words), 0);
        QVERIFY(all > inColour(wordless, wordless.rect()));
    }

    void aDashedLineHasGapsAndAWholeRim() {
        const QSize size(400, 200);
        PlacedMeasurement line{.places = {{-0.9, 0.5 / 200}, {0.9, 0.5 / 200}}};
        const QRect middle(100, 99, 120, 3);
        const auto columnsIn = [&](const QImage& image, auto&& isOne) {
            int count = 0;
            for (int x = middle.left(); x <= middle.right(); ++x) count += isOne(image, QRect(x, middle.top(), 1, 3));
            return count;
        };
        const auto bright = [](const QImage& image, const QRect& column) { return inColour(image, column) > 0; };
        const auto dark = [](const QImage& image, const QRect& column) {
            return qGray(image.pixel(column.center())) < 80 || inColour(image, column) > 0;
        };
        QCOMPARE(columnsIn(painted({line}, size, 1.0), bright), middle.width());
        line.dashed = true;
        const QImage image = painted({line}, size, 1.0);
        // Ten dashes and ten gaps.
        const int dashes = columnsIn(image, bright);
        QVERIFY2(dashes > 60 && dashes < 85, qPrintable(QString::number(dashes)));
        QVERIFY(columnsIn(image, dark) > 110);
    }

    void wordsAtTheEdgeStayInThePicture() {
        const QSize size(400, 200);
        const auto wordsOf = [&](const std::vector<PicturePlace>& places) {
            const QRect all({0, 0}, size);
            return inColour(painted({{.places = places, .text = "123.4 mm"}}, size, 1.0), all) -
                   inColour(painted({{.places = places}}, size, 1.0), all);
        };
        const int whole = wordsOf({{0, 0}, {0.2, 0}});
        QVERIFY(whole > 80);
        const std::vector<std::vector<PicturePlace>> atEdges{
            {{0, -0.495}, {0.2, -0.495}}, {{0, 0.495}, {0.2, 0.495}}, {{0.8, 0.1}, {0.98, 0.1}}};
        for (const std::vector<PicturePlace>& places : atEdges)
            QVERIFY2(std::abs(wordsOf(places) - whole) < 0.15 * whole, qPrintable(QString::number(wordsOf(places))));
    }

    void anAngleHasItsArcAndAnUnfinishedOneItsLines() {
        const QSize size(400, 400);
        constexpr double half = 0.5 / 400;  // a pixel's middle
        const PlacedMeasurement angle{.kind = MeasurementKind::angle,
                                      .places = {{0.4, half}, {half, half}, {half, -0.4}},
                                      .arc = {{0.1, 0.0}, {0.0707, -0.0707}, {0.0, -0.1}},
                                      .text = "90.0°"};
        QVERIFY(inColour(painted({angle}, size, 1.0), around({200 + 28, 200 - 28}, 2)) >= 2);
        PlacedMeasurement begun = angle;
        begun.places.pop_back();
        begun.arc.clear();
        begun.text.clear();
        const QImage image = painted({begun}, size, 1.0);
        QVERIFY(inColour(image, around({300, 200}, 1)) >= 2);
        QCOMPARE(inColour(image, QRect(150, 20, 100, 160)), 0);
    }
};

ECHOLUCENT_TEST_CLASS(TestMeasurementDrawing)
#include "test_measurement_drawing.moc"
