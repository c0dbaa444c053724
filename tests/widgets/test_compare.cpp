// The widgets of the comparison by themselves: difference, panes, grid, table.
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/compare_rows.h"
#include "widgets/compare/difference_image.h"

using namespace echolucent;

namespace {

QImage plain(const QColor& colour, const QSize& size = {30, 20}) {
    QImage image(size, QImage::Format_RGB888);
    image.fill(colour);
    return image;
}

}  // namespace

class TestCompare : public QObject {
    Q_OBJECT

private slots:
    void aDifferenceIsSignedAndAmplifiedAroundGrey() {
        const QImage one = plain({100, 50, 7});
        DifferenceImage same = differenceOf(one, one, 32);
        QCOMPARE(same.rmse, 0.0);
        QVERIFY(same.image.pixelColor(3, 3) == QColor(128, 128, 128));
        const DifferenceImage other = differenceOf(one, plain({90, 56, 7}), 4);
        QVERIFY(other.image.pixelColor(3, 3) == QColor(168, 104, 128));
        QVERIFY(std::abs(other.rmse - std::sqrt((100.0 + 36.0) / 3)) < 1e-12);
        QVERIFY(differenceOf(plain(Qt::white), plain(Qt::black), 32).image.pixelColor(0, 0) == QColor(255, 255, 255));
        QVERIFY(differenceOf(one, plain(Qt::black, {3, 3}), 4).image.isNull());
        QVERIFY(differenceOf({}, {}, 4).image.isNull());
    }

    void panesHaveOneSizeAndAllTheRoom_data() {
        QTest::addColumn<int>("panes");
        for (const int panes : {2, 3, 4}) QTest::addRow("%d", panes) << panes;
    }
    void panesHaveOneSizeAndAllTheRoom() {
        QFETCH(int, panes);
        CompareGrid grid;
        grid.resize(900, 560);
        grid.arrange(ComparisonLayout::sideBySide, static_cast<std::size_t>(panes));
        grid.show();
        QCOMPARE(grid.shownPanes().size(), static_cast<std::size_t>(panes));
        for (std::size_t i = 0; i < mostPanes; ++i) {
            QCOMPARE(grid.pane(i).isVisible(), static_cast<int>(i) < panes);
            if (!grid.pane(i).isVisible()) continue;
            QCOMPARE(grid.pane(i).size(), grid.pane(0).size());
            QVERIFY(grid.rect().contains(grid.pane(i).geometry()));
            for (std::size_t k = 0; k < i; ++k) QVERIFY(!grid.pane(i).geometry().intersects(grid.pane(k).geometry()));
        }
        QCOMPARE(grid.pictureSize(), grid.pane(1).pictureSize());
        grid.arrange(ComparisonLayout::wipe, static_cast<std::size_t>(panes));
        QVERIFY(grid.pair().isVisible() && !grid.pane(0).isVisible());
        QCOMPARE(grid.pair().size(), grid.size());
    }

    void theWipeShowsOnePictureLeftAndTheOtherRight() {
        ComparePane pane("pane");
        pane.resize(300, 260);
        pane.setImage(plain(Qt::red));
        pane.setWipe(plain(Qt::blue), 0.25);
        pane.show();
        const QRect picture = pane.pictureRect();
        const auto colourAt = [&](double share) {
            const QImage shot = pane.grab().toImage();
            return shot.pixelColor(picture.x() + static_cast<int>(share * picture.width()), picture.y() + 10);
        };
        QVERIFY(colourAt(0.1) == QColor(Qt::red));
        QVERIFY(colourAt(0.5) == QColor(Qt::blue));
        QSignalSpy wiped(&pane, &ComparePane::wipeMoved), turned(&pane, &ComparePane::orbited);
        const QPoint line(picture.x() + picture.width() / 4, picture.y() + 20);
        QTest::mousePress(&pane, Qt::LeftButton, {}, line);
        const QPoint to(picture.x() + picture.width() / 2, line.y());
        QMouseEvent move(QEvent::MouseMove, to, pane.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&pane, &move);
        QCOMPARE(turned.count(), 0);
        QVERIFY(std::abs(wiped.last().first().toDouble() - 0.5) < 0.01);
        QSignalSpy cancelled(&pane, &ComparePane::dragCancelled);
        QTest::keyClick(&pane, Qt::Key_Escape);
        QCOMPARE(cancelled.count(), 1);
        QVERIFY(!pane.dragging());
    }

    void keysOfAPaneOrbitPanAndZoom() {
        ComparePane pane("pane");
        pane.show();
        QSignalSpy orbits(&pane, &ComparePane::orbited), pans(&pane, &ComparePane::panned);
        QSignalSpy zooms(&pane, &ComparePane::zoomed), wipes(&pane, &ComparePane::wipeMoved);
        QTest::keyClick(&pane, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(orbits.last().first().toDouble(), 1.0 / 180);
        QTest::keyClick(&pane, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(pans.count(), 1);
        QTest::keyClick(&pane, Qt::Key_Plus);
        QCOMPARE(zooms.count(), 1);
        QTest::keyClick(&pane, Qt::Key_Left);
        QCOMPARE(wipes.count(), 0);  // the window's own key, where nothing is wiped
        pane.setWipe(plain(Qt::blue), 0.5);
        QTest::keyClick(&pane, Qt::Key_Left);
        QCOMPARE(wipes.last().first().toDouble(), 0.48);
    }

    void theTableSaysWhatIsKnown() {
        const std::vector<CompareRow> rows{
            {.name = "x², \"mine\"",
             .surfaces = SurfacesFrom::truth,
             .depth = ShownDepth{.right = 5, .early = 2, .late = 1, .never = 0},
             .contrast = -1.234,
             .nearSurfaces = 0.456},
            {.name = "Levoy", .flicker = 0.5, .designMilliseconds = 127.4, .pictureMilliseconds = 56.7}};
        QCOMPARE(cellsOf(rows[0]), (QStringList{"x², \"mine\"", "63", "25", "13", "0", "−1.23", "46", "–", "–", "–"}));
        QCOMPARE(cellsOf(rows[1]), (QStringList{"Levoy", "–", "–", "–", "–", "–", "–", "127.50", "130", "57"}));
        QCOMPARE(numbersOf(rows[0]), QString("right 63 % · early 25 % · CNR_S −1.23"));
        QCOMPARE(numbersOf(rows[1]), QString("flicker 127.50 levels"));
        QCOMPARE(compareCsv(rows), QString("pane,surfaces,right_percent,early_percent,late_percent,never_percent,cnr_s,"
                                           "light_near_surfaces,flicker_levels,otf_ms,picture_ms\n"
                                           "\"x², \"\"mine\"\"\",truth,62.5,25,12.5,0,-1.234,0.456,,,\n"
                                           "\"Levoy\",,,,,,,,127.5,127.4,56.7\n"));
        const QString text = compareText(rows);
        QVERIFY(text.endsWith("Surfaces are the true ones of the simulated scan.\n"));
        QCOMPARE(text.count('\n'), 4);
        QVERIFY(surfacesSentence({rows[1]}).isEmpty());
        QCOMPARE(compareTips().size(), compareColumns().size());
    }

    void aTimeHasTheDigitsThatItIsWorth() {
        const auto timeOf = [](double milliseconds) {
            const QStringList cells = cellsOf({.name = "", .designMilliseconds = milliseconds});
            return cells[compareColumns().indexOf("OTF ms")];
        };
        QCOMPARE(timeOf(0.04), QString("0.0"));
        QCOMPARE(timeOf(1.649), QString("1.6"));
        QCOMPARE(timeOf(12.34), QString("12"));
        QCOMPARE(timeOf(99.4), QString("99"));
        QCOMPARE(timeOf(1234.5), QString("1200"));
    }

    void theTableOfANarrowPanelHidesNothing() {
        ComparePanel panel;
        panel.setPanes({{}, {.curve = CurveKind::linear}}, {"one", "two"});
        panel.setRows({{.name = "one",
                        .surfaces = SurfacesFrom::tubeCores,
                        .depth = ShownDepth{.right = 1},
                        .contrast = -12.34,
                        .nearSurfaces = 1.0,
                        .flicker = 0.1,
                        .designMilliseconds = 1200,
                        .pictureMilliseconds = 1200},
                       {.name = "two"}});
        panel.resize(329, 900);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto* table = panel.findChild<QTableWidget*>("compare.table");
        for (int column = 0; column < table->columnCount(); ++column) {
            const QString heading = table->horizontalHeaderItem(column)->text();
            QVERIFY2(table->columnWidth(column) >= table->horizontalHeader()->sectionSizeHint(column),
                     qPrintable(heading));
            const QString cell = table->item(0, column)->text();
            QVERIFY2(table->columnWidth(column) > table->fontMetrics().horizontalAdvance(cell), qPrintable(heading));
            QVERIFY2(!table->horizontalHeaderItem(column)->toolTip().isEmpty(), qPrintable(heading));
        }
        // What does not fit is reached by scrolling sideways; rows are never cut.
        QVERIFY(table->columnViewportPosition(3) + table->columnWidth(3) <= table->viewport()->width());
        QVERIFY(table->horizontalScrollBar()->maximum() > 0);
        QCOMPARE(table->verticalScrollBar()->maximum(), 0);
        QVERIFY(panel.findChild<QLabel*>("compare.note")->text().contains("tube cores find in this view"));
    }
};

ECHOLUCENT_TEST_CLASS(TestCompare)
#include "test_compare.moc"
