// Letters for people who sit far away: all of a panel gets them, what comes into it later too, and all is given back.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>

#include "tests/qt_program/test_classes.h"
#include "widgets/fitted_table.h"
#include "widgets/larger_letters.h"
#include "widgets/plots/plot_canvas.h"
#include "widgets/tube_cores/tube_core_list.h"

using namespace echolucent;

namespace {

double letters(const QWidget* widget) { return lettersOf(*widget); }

}  // namespace

class TestLargerLetters : public QObject {
    Q_OBJECT

private slots:
    /// Under a style sheet, as the program has one, no widget takes over the font of the one around it.
    void init() { qApp->setStyleSheet("QWidget { color: black; }"); }

    void cleanup() { qApp->setStyleSheet({}); }

    void allInThePlaceGetThemAndGiveThemBack() {
        QWidget place;
        auto* column = new QVBoxLayout(&place);
        auto* number = new QDoubleSpinBox;
        auto* bold = new QLabel("bold");
        QFont font = bold->font();
        font.setBold(true);
        bold->setFont(font);
        column->addWidget(number);
        column->addWidget(bold);
        place.show();
        const QFont before = number->font();
        const int narrow = number->sizeHint().width();

        LargerLetters larger;
        larger.set(&place, 2.0);
        QCOMPARE(letters(number), 2.0);
        QCOMPARE(letters(number->findChild<QWidget*>("qt_spinbox_lineedit")), 2.0);
        QCOMPARE(letters(bold), 2.0);
        QVERIFY(bold->font().bold());
        QVERIFY(number->sizeHint().width() > narrow);
        auto* late = new QLabel("late");
        column->addWidget(late);
        QTRY_COMPARE(letters(late), 2.0);
        larger.set(&place, 1.5);
        QCOMPARE(letters(bold), 1.5);
        QCOMPARE(letters(late), 1.5);
        font = late->font();
        font.setBold(true);
        late->setFont(font);

        larger.set(nullptr, 1.0);
        QCOMPARE(number->font(), before);
        QCOMPARE(number->font().resolveMask(), before.resolveMask());
        for (const QWidget* each : place.findChildren<QWidget*>())
            QVERIFY2(letters(each) == 1.0, each->metaObject()->className());
        QVERIFY(late->font().bold());  // it means something
        auto* later = new QLabel("later");
        column->addWidget(later);
        QTRY_VERIFY(later->isVisible());
        QCOMPARE(letters(later), 1.0);
    }

    void anotherPlaceTakesThemFromTheFirst() {
        QWidget first, second;
        LargerLetters larger;
        larger.set(&first, 2.0);
        larger.set(&second, 2.0);
        QCOMPARE(letters(&first), 1.0);
        QCOMPARE(letters(&second), 2.0);
    }

    void aPlotIsAsMuchHigherAsItsLettersAreLarger() {
        QWidget place;
        auto* plot = new PlotCanvas(&place, 120);
        plot->setPlot({.title = "Rise",
                       .xLabel = "place",
                       .yLabel = "value",
                       .series = {{.name = "rise", .x = {0, 1}, .y = {0, 1}}}});
        const int before = plot->heightForWidth(300);
        LargerLetters larger;
        larger.set(&place, 2.0);
        QVERIFY(plot->heightForWidth(600) > 1.9 * before);
        QVERIFY(plot->minimumSizeHint().height() > 1.9 * 120);
        larger.set(nullptr, 1.0);
        QCOMPARE(plot->heightForWidth(300), before);
    }

    void rowsOfTheListOfTubeCoresAreAsHighAsBefore() {
        QWidget place;
        auto* list = new TubeCoreList(&place);
        place.show();
        const int before = list->verticalHeader()->defaultSectionSize();
        LargerLetters larger;
        larger.set(&place, 2.0);
        QVERIFY(list->verticalHeader()->defaultSectionSize() > 1.5 * before);
        larger.set(nullptr, 1.0);
        QCOMPARE(list->verticalHeader()->defaultSectionSize(), before);
    }

    void aTableIsAsHighAsItsRowsInLettersOfAnySize() {
        QWidget place;
        auto* column = new QVBoxLayout(&place);
        auto* table = new FittedTable({"One\nline", "Two"});
        table->setRowCount(3);
        table->fit();
        column->addWidget(table);
        column->addStretch(1);
        place.resize(400, 600);
        place.show();
        const auto wordsFit = [&] {
            return table->verticalScrollBar()->maximum() == 0 && table->rowHeight(2) >= table->fontMetrics().height() &&
                   table->horizontalHeader()->height() >= 2 * table->horizontalHeader()->fontMetrics().height();
        };
        QTRY_VERIFY(wordsFit());
        const int before = table->height();
        LargerLetters larger;
        larger.set(&place, 2.5);
        QTRY_VERIFY(table->height() > 2 * before);
        QTRY_VERIFY(wordsFit());
        larger.set(nullptr, 1.0);
        QTRY_COMPARE(table->height(), before);
    }
};

ECHOLUCENT_TEST_CLASS(TestLargerLetters)
#include "test_larger_letters.moc"
