// The table of the comparison's measures, as cells, CSV and words, and in a narrow panel.
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/compare_rows.h"

using namespace echolucent;

class TestCompareTable : public QObject {
    Q_OBJECT

private slots:
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
        QCOMPARE(numbersOf(rows[0]), QString("right 63 % · early 25 % · late 13 %"));
        QVERIFY(numbersOf(rows[1]).isEmpty());
        QCOMPARE(numbersOf({.name = "", .depth = ShownDepth{.right = 0, .early = 1, .late = 920, .never = 79}}),
                 QString("right 0 % · late 92 % · never 8 %"));
        for (const double contrast : {-0.004, 0.004})
            QCOMPARE(cellsOf({.name = "", .contrast = contrast})[5], QString("0.00"));
        QCOMPARE(cellsOf({.name = "", .contrast = -0.006})[5], QString("−0.01"));
        QCOMPARE(compareColumns()[flickerColumn], QString("Flicker levels"));
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

    void theFlickerThatWasAskedForIsScrolledTo() {
        ComparePanel panel;
        panel.setPanes({{}, {.curve = CurveKind::linear}}, {"one", "two"});
        std::vector<CompareRow> rows{{.name = "one", .contrast = -12.34, .pictureMilliseconds = 1200}, {.name = "two"}};
        panel.setRows(rows);
        panel.resize(329, 900);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto* table = panel.findChild<QTableWidget*>("compare.table");
        const auto isSeen = [table] {
            const int left = table->columnViewportPosition(flickerColumn - 1);
            return left >= 0 && left + table->columnWidth(flickerColumn - 1) <= table->viewport()->width();
        };
        rows[0].flicker = 0.1;
        panel.setRows(rows);
        QVERIFY2(!isSeen(), "nobody asked for it");
        rows[0].flicker.reset();
        panel.setRows(rows);
        auto* button = panel.findChild<QPushButton*>("compare.measureFlicker");
        QTest::mouseClick(button, Qt::LeftButton);
        panel.setMeasuringFlicker(true);
        QVERIFY(!isSeen());
        panel.setMeasuringFlicker(false);
        rows[0].flicker = 0.1;
        panel.setRows(rows);
        QVERIFY(isSeen());
        // The same numbers again.
        table->horizontalScrollBar()->setValue(0);
        rows[0].contrast = -12.35;
        panel.setRows(rows);
        QVERIFY2(!isSeen(), "it was seen before");
        QTest::mouseClick(button, Qt::LeftButton);
        panel.setMeasuringFlicker(true);
        panel.setMeasuringFlicker(false);
        QVERIFY(isSeen());
    }
};

ECHOLUCENT_TEST_CLASS(TestCompareTable)
#include "test_compare_table.moc"
