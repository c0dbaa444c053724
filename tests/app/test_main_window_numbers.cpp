// The real window on desktops of other languages: numbers are typed and shown as everywhere.
#include <QAbstractSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <clocale>

#include "app/window/start_of_program.h"
#include "tests/app/window_fixture.h"
#include "widgets/controls/number_box.h"

using namespace echolucent;

class TestMainWindowNumbers : public QObject, private WindowFixture {
    Q_OBJECT

    void type(const QString& name, const QString& text) {
        auto* box = child<QAbstractSpinBox>(name);
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }
    double cut() { return window().document().document().scene.front.depthMm; }

private slots:
    void initTestCase() {
        lookAlongAssumedBeam();
        lookAtNoPicture();
        m_file = file("heart.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void cleanup() {
        close();
        QLocale::setDefault(QLocale::c());
    }

    void areTypedAndShownAlikeWhateverTheDesktop_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"de_DE", "ar_EG"}) QTest::newRow(language) << QString(language);
    }
    void areTypedAndShownAlikeWhateverTheDesktop() {
        QFETCH(QString, language);
        QLocale::setDefault(QLocale(language));
        show();
        if (language == QLatin1String("de_DE")) {
            open(m_file);
            for (const auto& [text, mm] : {std::pair{"1,5", 1.5}, {"2.5", 2.5}}) {
                type("view.nearCut.value", text);
                QCOMPARE(cut(), mm);
                QCOMPARE(child<QAbstractSpinBox>("view.nearCut.value")->text(), QString("%1 mm").arg(mm));
            }
            waitUntilIdle();
        }
        QCOMPARE(window().layoutDirection(), Qt::LeftToRight);
        for (QAbstractSpinBox* box : window().findChildren<QAbstractSpinBox*>()) {
            QVERIFY2(dynamic_cast<NumberBox*>(box) || dynamic_cast<WholeNumberBox*>(box),
                     qPrintable(box->objectName()));
            look(box->text(), box->objectName());
        }
        for (QLabel* label : window().findChildren<QLabel*>()) look(label->text(), label->objectName());
    }

    void theProgramWritesThemAlike() {
        const std::string before = std::setlocale(LC_NUMERIC, nullptr);
        QLocale::setDefault(QLocale("de_DE"));
        writeNumbersAlike();
        QCOMPARE(QLocale().toString(1.5), QString("1.5"));
        QCOMPARE(std::string(std::setlocale(LC_NUMERIC, nullptr)), std::string("C"));
        std::setlocale(LC_NUMERIC, before.c_str());
    }

private:
    static void look(const QString& text, const QString& where) {
        static const QRegularExpression comma("[0-9],[0-9]");
        for (const QChar letter : text)
            QVERIFY2(
                letter.digitValue() < 0 || letter.unicode() < 0x80 || letter.category() != QChar::Number_DecimalDigit,
                qPrintable(where + ": " + text));
        QVERIFY2(!comma.match(text).hasMatch(), qPrintable(where + ": " + text));
    }
    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowNumbers)
#include "test_main_window_numbers.moc"
