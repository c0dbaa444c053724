// The widgets of the comparison by themselves: difference, panes, grid, table.
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/compare/compare_grid.h"
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
        const std::vector<CompareRow> rows{{.name = "x², \"mine\"", .contrast = -1.234, .nearSurfaces = 0.456},
                                           {.name = "Levoy", .designMilliseconds = 12.34, .pictureMilliseconds = 56.7}};
        QCOMPARE(cellsOf(rows[0]), (QStringList{"x², \"mine\"", "−1.23", "46", "–", "–", "–"}));
        QCOMPARE(numbersOf(rows[1]), QString("OTF 12.3 ms · picture 57 ms"));
        QCOMPARE(compareCsv(rows), QString("pane,cnr_s,light_near_surfaces,flicker,otf_ms,picture_ms\n"
                                           "\"x², \"\"mine\"\"\",-1.234,0.456,,,\n\"Levoy\",,,,12.34,56.7\n"));
        QCOMPARE(compareText(rows).count('\n'), 3);
    }
};

ECHOLUCENT_TEST_CLASS(TestCompare)
#include "test_compare.moc"
