// Number fields under the languages of several desktops: the same text is the same number, and shown alike.
#include <QAbstractSpinBox>
#include <QDialog>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTest>
#include <QToolTip>
#include <QVBoxLayout>

#include "tests/qt_program/test_classes.h"
#include "widgets/controls/number_box.h"
#include "widgets/controls/short_spin_box.h"
#include "widgets/controls/tool_tips.h"

using namespace echolucent;

namespace {

void typeInto(QAbstractSpinBox& box, const QString& text) {
    box.findChild<QLineEdit*>()->selectAll();
    for (const QChar letter : text)  // keyClicks() knows ASCII only
        QTest::sendKeyEvent(QTest::Click, &box, Qt::Key_unknown, QString(letter), Qt::NoModifier);
    QTest::keyClick(&box, Qt::Key_Return);
}

}  // namespace

class TestNumberBox : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void aTypedNumberIsTheSameWhateverTheDesktop_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"C", "en_US", "de_DE", "de_CH", "fr_FR", "tr_TR", "ar_EG", "fa_IR", "hi_IN"})
            QTest::newRow(language) << QString(language);
    }
    void aTypedNumberIsTheSameWhateverTheDesktop() {
        QFETCH(QString, language);
        QLocale::setDefault(QLocale(language));
        NumberBox box;
        box.setRange(0, 1000);
        box.setDecimals(1);
        box.setSuffix(" mm");
        for (const auto& [text, value, shown] : {std::tuple{QString("1,5"), 1.5, "1.5 mm"},
                                                 {QString("2.5"), 2.5, "2.5 mm"},
                                                 {QString("15"), 15.0, "15.0 mm"},
                                                 {QString::fromUtf8("١٫٥"), 1.5, "1.5 mm"},
                                                 {QString::fromUtf8("۲۵"), 25.0, "25.0 mm"},
                                                 {QString("0,125"), 0.1, "0.1 mm"}}) {
            box.setValue(7);
            typeInto(box, text);
            QCOMPARE(box.value(), value);
            QCOMPARE(box.text(), QString(shown));
        }
        ShortSpinBox spacing;
        spacing.setDecimals(9);
        spacing.setRange(1e-9, 1000);
        typeInto(spacing, "1,234");  // 1234 is more than a spacing may be
        QCOMPARE(spacing.value(), 1.234);
        QCOMPARE(spacing.text(), QString("1.234"));
        WholeNumberBox whole;
        whole.setRange(0, 4096);
        whole.setValue(1024);
        QCOMPARE(whole.text(), QString("1024"));
    }

    void whatHasTwoMeaningsIsNotTakenAndSaid() {
        NumberBox box;
        box.setRange(0, 10000);
        box.setDecimals(3);
        box.setValue(7);
        box.show();
        typeInto(box, "1,234");
        QCOMPARE(box.value(), 7.0);
        QCOMPARE(box.text(), QString("7.000"));
        QCOMPARE(QToolTip::text().replace('\n', ' '), QString("\"1,234\" has two meanings. Write 1.234 or 1234."));
        QToolTip::hideText();
        typeInto(box, "1.234,5");
        QCOMPARE(box.value(), 1234.5);
    }

    void noKeyIsLostOnTheWayToATenfoldNumber() {
        WholeNumberBox whole;
        whole.setRange(1, 400);
        whole.setValue(20);
        for (const char* text : {"1,5", "1.5", "4000", "-3", "1,000"}) {
            typeInto(whole, text);
            QCOMPARE(whole.value(), 20);
            QCOMPARE(whole.text(), QString("20"));
        }
        typeInto(whole, "1a5");  // letters are no part of any number
        QCOMPARE(whole.value(), 15);
        NumberBox box;
        box.setRange(0, 20);
        box.setValue(3);
        typeInto(box, "25");  // more than there may be, and not 2
        QCOMPARE(box.value(), 3.0);
        NumberBox bytes;
        bytes.takeWholeNumbersOnly();
        bytes.setRange(0, 1e12);
        typeInto(bytes, "1,024");
        QCOMPARE(bytes.value(), 1024.0);
        typeInto(bytes, "1.5");
        QCOMPARE(bytes.value(), 1024.0);
    }

    void aDialogIsAcceptedWithWhatWasTypedOrNotAtAll() {
        QDialog dialog;
        QVBoxLayout column(&dialog);
        WholeNumberBox width;
        width.setRange(16, 4096);
        width.setValue(1280);
        width.setSuffix(" px");
        QPushButton save("Save");
        save.setDefault(true);
        column.addWidget(&width);
        column.addWidget(&save);
        int looks = 0;
        followTyping(dialog, save, [&] {
            ++looks;
            save.setEnabled(true);
        });
        connect(&save, &QPushButton::clicked, &dialog, &QDialog::accept);
        dialog.show();
        width.setFocus();
        typeInto(width, "5000");
        QCOMPARE(width.value(), 1280);
        QCOMPARE(dialog.result(), 0);
        const QString why("\"5000\" is not taken. Write a whole number from 16 to 4096.");
        QCOMPARE(QToolTip::text(), linesOfToolTip(why, QToolTip::font()));
        QVERIFY(QToolTip::text() != why);  // it is wider than a tip
        QToolTip::hideText();
        QVERIFY(looks > 0 && save.isEnabled());
        width.selectAll();
        QTest::keyClicks(&width, "5000");
        QVERIFY(!save.isEnabled());  // nobody saves 1280 by a click
        QTest::keyClick(&width, Qt::Key_Backspace);
        QVERIFY(save.isEnabled());
        QCOMPARE(width.value(), 1280);
        QTest::mouseClick(&save, Qt::LeftButton);
        QCOMPARE(width.value(), 500);
        QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
        dialog.show();
        dialog.setResult(0);
        typeInto(width, "600");
        QCOMPARE(width.value(), 600);
        QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
    }

    void prefixAndSpecialValueAreKept() {
        NumberBox box;
        box.setPrefix(QString::fromUtf8("× "));
        box.setDecimals(1);
        typeInto(box, "2,5");
        QCOMPARE(box.value(), 2.5);
        QCOMPARE(box.text(), QString::fromUtf8("× 2.5"));
        WholeNumberBox phase;
        phase.setRange(0, 9);
        phase.setSpecialValueText("as pane 1");
        phase.setValue(3);
        typeInto(phase, "0");
        QCOMPARE(phase.value(), 0);
        QCOMPARE(phase.text(), QString("as pane 1"));
        QTest::keyClick(&phase, Qt::Key_Return);
        QCOMPARE(phase.value(), 0);
        QTest::keyClick(&phase, Qt::Key_Up);
        QCOMPARE(phase.value(), 1);
    }
};

ECHOLUCENT_TEST_CLASS(TestNumberBox)
#include "test_number_box.moc"
