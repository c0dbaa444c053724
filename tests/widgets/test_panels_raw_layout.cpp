// The dialog for headerless files: its arithmetic in 64 bits, and OK only where the layout fits the file.
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFocusEvent>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QPushButton>
#include <QSpinBox>
#include <QString>
#include <QStringList>
#include <QTest>
#include <QWidget>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/dialogs/raw_layout_dialog.h"

using namespace echolucent;

namespace {

void type(QAbstractSpinBox* spinBox, const QString& text) {
    spinBox->selectAll();
    QTest::keyClicks(spinBox, text);
    QFocusEvent left(QEvent::FocusOut, Qt::TabFocusReason);  // a dialog that is not shown moves no focus by itself
    QCoreApplication::sendEvent(spinBox, &left);
}

constexpr std::int64_t huge = std::int64_t{1} << 31;

}  // namespace

class TestPanelsRawLayout : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void bytesOfALayout_data() {
        QTest::addColumn<RawLayout>("layout");
        QTest::addColumn<qlonglong>("bytes");  // -1: none
        const auto row = [](const char* name, RawLayout layout, qlonglong bytes) {
            QTest::newRow(name) << layout << bytes;
        };
        row("bytes", {.size = {2, 3, 4}}, 24);
        row("int8", {.size = {2, 3, 4}, .type = "int8"}, 24);
        row("uint16 and header", {.size = {2, 3, 4}, .type = "uint16", .headerBytes = 10}, 58);
        row("int16", {.size = {2, 3, 4}, .type = "int16"}, 48);
        row("uint32", {.size = {2, 3, 4}, .type = "uint32"}, 96);
        row("int32", {.size = {2, 3, 4}, .type = "int32"}, 96);
        row("float32", {.size = {2, 3, 4}, .type = "float32"}, 96);
        row("float64", {.size = {2, 3, 4}, .type = "float64"}, 192);
        row("beyond 32 bits", {.size = {3000, 2000, 1000}, .type = "uint16"}, 12000000000);
        row("2^62", {.size = {huge, huge, 1}}, qlonglong{1} << 62);
        row("2^63", {.size = {huge, huge, 2}}, -1);
        row("2^62 times 2", {.size = {huge, huge, 1}, .type = "int16"}, -1);
        row("2^93", {.size = {huge, huge, huge}}, -1);
        row("wraps to 0 in 64 bits", {.size = {huge, huge, 4}}, -1);
        row("header too long", {.size = {huge, huge, 1}, .headerBytes = std::numeric_limits<std::int64_t>::max()}, -1);
        row("largest", {.size = {1, 1, 1}, .headerBytes = std::numeric_limits<std::int64_t>::max() - 1},
            std::numeric_limits<std::int64_t>::max());
        row("no voxels", {.size = {2, 0, 4}}, -1);
        row("negative", {.size = {-2, -3, 4}}, -1);
        row("negative header", {.size = {2, 3, 4}, .headerBytes = -1}, -1);
        row("unknown type", {.size = {2, 3, 4}, .type = "uint7"}, -1);
    }
    void bytesOfALayout() {
        QFETCH(RawLayout, layout);
        QFETCH(qlonglong, bytes);
        QCOMPARE(bytesNeeded(layout).value_or(-1), bytes);
    }

    void okOnlyWhereItFits() {
        RawLayoutDialog dialog("heart.raw", 58);
        auto* ok = child<QPushButton>(dialog, "rawLayout.ok");
        auto* fit = child<QLabel>(dialog, "rawLayout.fit");
        QVERIFY(!ok->isEnabled());  // no size yet
        type(child<QSpinBox>(dialog, "rawLayout.sizeX"), "2");
        type(child<QSpinBox>(dialog, "rawLayout.sizeY"), "3");
        type(child<QSpinBox>(dialog, "rawLayout.sizeZ"), "4");
        QVERIFY(fit->text().contains("34 are left over"));
        QVERIFY(ok->isEnabled());
        child<QComboBox>(dialog, "rawLayout.type")->setCurrentText("uint16");
        QVERIFY(fit->text().contains("10 are left over"));
        QTest::mouseClick(child<QPushButton>(dialog, "rawLayout.headerFit"), Qt::LeftButton);
        QVERIFY(ok->isEnabled());
        QVERIFY(!fit->text().contains("left over"));
        QVERIFY(!child<QPushButton>(dialog, "rawLayout.headerFit")->isEnabled());
        QCOMPARE(dialog.values().headerBytes, 10);
        type(child<QDoubleSpinBox>(dialog, "rawLayout.headerBytes"), "11");
        QVERIFY(fit->text().contains("1 are missing"));
        QVERIFY(!ok->isEnabled());
    }

    void noPieceOfATypedNumberIsTaken() {
        RawLayoutDialog dialog("heart.raw", 58);
        dialog.setValues({.size = {2, 3, 4}, .spacing = {0.3, 0.3, 0.3}, .spacingKnown = true});
        auto* ok = child<QPushButton>(dialog, "rawLayout.ok");
        type(child<QDoubleSpinBox>(dialog, "rawLayout.spacingX"), "1500");
        type(child<QDoubleSpinBox>(dialog, "rawLayout.linesFirst"), "20000");
        QCOMPARE(dialog.values().spacing[0], 0.3);
        QVERIFY(ok->isEnabled());
        type(child<QDoubleSpinBox>(dialog, "rawLayout.headerBytes"), "1,024");
        QCOMPARE(dialog.values().headerBytes, 1024);
        QVERIFY(!ok->isEnabled());
        QTest::keyClicks(child<QSpinBox>(dialog, "rawLayout.sizeX"), "3");
        QVERIFY(ok->isEnabled());  // to be pressed, which takes the number
        ok->click();
        QCOMPARE(dialog.result(), 0);
        QVERIFY(!ok->isEnabled());
    }

    void valuesComeBack() {
        RawLayoutDialog dialog("heart.raw", 1000);
        const RawLayout values{.size = {152, 156, 110},
                               .type = "float32",
                               .bigEndian = true,
                               .headerBytes = (std::int64_t{1} << 40) + 1,
                               .spacing = {0.3, 0.123456789, 2.5},
                               .spacingKnown = true};
        dialog.setValues(values);
        QCOMPARE(dialog.values(), values);
        QCOMPARE(child<QDoubleSpinBox>(dialog, "rawLayout.spacingX")->text(), "0.3");
    }

    void unknownSpacingIsOne() {
        RawLayoutDialog dialog("heart.raw", 1000);
        dialog.setValues({.size = {1, 1, 1}, .spacing = {0.3, 0.3, 0.3}, .spacingKnown = true});
        QTest::keyClick(child<QCheckBox>(dialog, "rawLayout.spacingUnknown"), Qt::Key_Space);
        QVERIFY(!child<QDoubleSpinBox>(dialog, "rawLayout.spacingX")->isEnabled());
        QCOMPARE(dialog.values(), (RawLayout{.size = {1, 1, 1}}));
    }

    void hugeSizesEndInASentence() {
        RawLayoutDialog dialog("heart.raw", 1000);
        constexpr std::int64_t largest = std::numeric_limits<int>::max();
        dialog.setValues({.size = {largest, largest, largest}, .type = "float64"});
        QVERIFY(child<QLabel>(dialog, "rawLayout.fit")->text().contains("more than 2⁶³ bytes"));
        QVERIFY(!dialog.fits());
        QVERIFY(!child<QPushButton>(dialog, "rawLayout.headerFit")->isEnabled());
    }

    void aPackedFileIsTakenAtItsWord() {
        RawLayoutDialog dialog("heart.raw.gz", -1);
        QVERIFY(!dialog.fits());
        dialog.setValues({.size = {100, 100, 100}});
        QVERIFY(dialog.fits());
        QVERIFY(child<QPushButton>(dialog, "rawLayout.ok")->isEnabled());
        QVERIFY(!child<QPushButton>(dialog, "rawLayout.headerFit")->isEnabled());
        const QString fit = child<QLabel>(dialog, "rawLayout.fit")->text();
        QVERIFY2(fit.contains("1,000,000 bytes") && !fit.contains("missing"), qPrintable(fit));
    }

    void beamsAreStatedByHand() {
        RawLayoutDialog dialog("heart.raw", 12 * 7 * 5);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto* grid = child<QComboBox>(dialog, "rawLayout.grid");
        auto* ok = child<QPushButton>(dialog, "rawLayout.ok");
        auto* fit = child<QLabel>(dialog, "rawLayout.fit");
        QVERIFY(!child<QWidget>(dialog, "rawLayout.polar")->isVisible());
        type(child<QSpinBox>(dialog, "rawLayout.sizeX"), "12");
        type(child<QSpinBox>(dialog, "rawLayout.sizeY"), "7");
        type(child<QSpinBox>(dialog, "rawLayout.sizeZ"), "5");
        QVERIFY(ok->isEnabled());
        grid->setFocus();
        for (int i = 0; i < 4; ++i) QTest::keyClick(grid, Qt::Key_Down);
        QCOMPARE(grid->currentText(), "Polar: wobbler");
        QVERIFY(child<QWidget>(dialog, "rawLayout.polar")->isVisible());
        QVERIFY(!child<QDoubleSpinBox>(dialog, "rawLayout.spacingX")->isVisible());
        QCOMPARE(child<QSpinBox>(dialog, "rawLayout.sizeY")->accessibleName(), "Lines of a plane");
        const auto set = [&](const char* name, const char* value) { type(child<QDoubleSpinBox>(dialog, name), value); };
        set("rawLayout.rangeStart", "2");
        set("rawLayout.rangeStep", "0.25");
        set("rawLayout.linesFirst", "-20");
        set("rawLayout.linesLast", "25");
        set("rawLayout.linesRadius", "38");
        set("rawLayout.planesFirst", "-15");
        set("rawLayout.planesLast", "15");
        set("rawLayout.planesRadius", "21.5");
        QVERIFY(ok->isEnabled());
        const RawLayout values = dialog.values();
        const PolarGeometry expected =
            polarGeometry({PolarKind::wobbler, 2, 0.25, {-20, 25}, {-15, 15}, 38, 21.5}, {12, 7, 5});
        QVERIFY(values.polar.has_value());
        QVERIFY(*values.polar == expected);
        QVERIFY(!values.spacingKnown);

        set("rawLayout.linesLast", "-20");
        QVERIFY(!ok->isEnabled());
        QVERIFY(fit->text().startsWith("The lines neither rise nor fall throughout"));
        set("rawLayout.linesLast", "190");
        QVERIFY(fit->text().contains("no angle between minus and plus half a turn"));
        set("rawLayout.linesLast", "25");
        set("rawLayout.rangeStep", "0");
        QVERIFY(fit->text().startsWith("The range has a step of 0 mm"));
        QVERIFY(!ok->isEnabled());

        QTest::keyClick(grid, Qt::Key_Home);
        QVERIFY(ok->isEnabled());
        QVERIFY(!dialog.values().polar);
    }

    void onlyTurnedBeamsHaveARadius_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<bool>("lines");
        QTest::addColumn<bool>("planes");
        QTest::newRow("linear") << 1 << false << false;
        QTest::newRow("convex") << 2 << true << false;
        QTest::newRow("linear wobbler") << 3 << false << true;
        QTest::newRow("wobbler") << 4 << true << true;
    }
    void onlyTurnedBeamsHaveARadius() {
        QFETCH(int, kind);
        QFETCH(bool, lines);
        QFETCH(bool, planes);
        RawLayoutDialog dialog("heart.raw", 1000);
        child<QComboBox>(dialog, "rawLayout.grid")->setCurrentIndex(kind);
        QCOMPARE(child<QDoubleSpinBox>(dialog, "rawLayout.linesRadius")->isEnabled(), lines);
        QCOMPARE(child<QDoubleSpinBox>(dialog, "rawLayout.planesRadius")->isEnabled(), planes);
    }

    void beamsThatAreNotEvenStayUntilTheirEndsAreChanged() {
        RawLayoutDialog dialog("heart.raw", 1000);
        RawLayout values{.size = {12, 7, 5}};
        values.polar = polarGeometry({PolarKind::convex, 0, 0.5, {-20, 20}, {-3, 3}, 40, 0}, values.size);
        values.polar->lines.values[3] += 0.01;
        dialog.setValues(values);
        QVERIFY(dialog.values() == values);
        type(child<QDoubleSpinBox>(dialog, "rawLayout.rangeStep"), "0.25");
        const RawLayout changed = dialog.values();
        QCOMPARE(changed.polar->rangeStepMm, 0.25);
        QVERIFY(changed.polar->lines == values.polar->lines);
        auto* fit = child<QLabel>(dialog, "rawLayout.fit");
        QVERIFY(!fit->text().contains("uneven"));
        type(child<QDoubleSpinBox>(dialog, "rawLayout.planesLast"), "4");
        QVERIFY(dialog.values().polar->lines == values.polar->lines);
        QVERIFY(!fit->text().contains("uneven"));
        type(child<QDoubleSpinBox>(dialog, "rawLayout.linesLast"), "21");
        QVERIFY(dialog.values().polar->lines ==
                polarGeometry({PolarKind::convex, 0, 0.25, {-20, 21}, {-3, 4}, 40, 0}, values.size).lines);
        QVERIFY2(fit->text().endsWith("Even spacing replaces the uneven lines."), qPrintable(fit->text()));
        type(child<QDoubleSpinBox>(dialog, "rawLayout.linesLast"), "20");
        QVERIFY(dialog.values().polar->lines == values.polar->lines);
        QVERIFY(!fit->text().contains("uneven"));
    }

    void everyFieldIsReachedByKeysAndFitsTheScreen() {
        RawLayoutDialog dialog("heart.raw", 1000);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        dialog.activateWindow();
        child<QComboBox>(dialog, "rawLayout.grid")->setCurrentIndex(4);
        QVERIFY(dialog.sizeHint().width() <= 1280);
        QVERIFY(dialog.sizeHint().height() <= 680);
        QStringList missing{"rangeStart",  "rangeStep",   "linesFirst", "linesLast",
                            "linesRadius", "planesFirst", "planesLast", "planesRadius"};
        child<QComboBox>(dialog, "rawLayout.grid")->setFocus();
        for (int i = 0; i < 30 && !missing.isEmpty(); ++i) {
            QTest::keyClick(dialog.focusWidget(), Qt::Key_Tab);
            missing.removeAll(dialog.focusWidget()->objectName().section('.', 1));
        }
        QCOMPARE(missing, QStringList());
    }

    void fileBeyondFourGigabytes() {
        RawLayoutDialog dialog("heart.raw", 12000000000);
        dialog.setValues({.size = {3000, 2000, 1000}, .type = "int16"});
        QVERIFY(dialog.fits());
        QVERIFY(child<QLabel>(dialog, "rawLayout.fit")->text().contains("12,000,000,000"));
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsRawLayout)
#include "test_panels_raw_layout.moc"
