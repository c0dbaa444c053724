// Numbers of the panel *Tube cores* beside those that the command line tells of the same document.
#include <QDockWidget>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QTableWidget>
#include <QTextDocumentFragment>
#include <cstdint>
#include <random>

#include "app/explain/tube_core_choice.h"
#include "app/explain/tube_core_explaining.h"
#include "io/document/document_file.h"
#include "processing/adaptive/method_reading.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/tube_cores/tube_core_list.h"
#include "widgets/tube_cores/tube_core_map.h"

using namespace echolucent;

class TestTubeCoreNumbers : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        teach();
        lookAtNoPicture();
        show(lookAtStart());  // quiet voxels too
        open(file("fetus.mha", {smallPhantom(PhantomScene::fetus, 5)}));
        child<QDockWidget>("dock.tubeCores")->raise();
        QTRY_VERIFY(child("tubeCores")->isVisible());
    }
    void cleanupTestCase() { close(); }

    void areThoseOfTheCommandLine_data() {
        QTest::addColumn<int>("reading");
        QTest::newRow("as published") << static_cast<int>(MethodReading::asPublished);
        QTest::newRow("default") << static_cast<int>(MethodReading::standard);
    }
    /// Ranks, facts, tool tips, the row of the list, and the curve without the tube core to the bit.
    void areThoseOfTheCommandLine() {
        QFETCH(int, reading);
        window().document().change(
            "reading", [&](Document& next) { next.method.config = configOf(static_cast<MethodReading>(reading)); });
        waitUntilIdle();
        m_document = temporaryFolder().filePath("document.json");
        QVERIFY(writeDocument(m_document.toStdString(), window().document().document()));
        std::mt19937 random(50);
        int weighing = 0;
        for (int i = 0; i < (isLongRun() ? 50 : 2); ++i) {
            const int number = static_cast<int>(random() % 225);
            QTest::mouseClick(child("tubeCores.map"), Qt::LeftButton, {},
                              child<TubeCoreMap>("tubeCores.map")->cellOf(number).center().toPoint());
            QTRY_VERIFY(window().tubeCoreExplaining().explanation() &&
                        window().tubeCoreExplaining().explanation()->explanation->number == number &&
                        window().tubeCoreExplaining().explanation()->run == window().otfs().adaptive());
            const QJsonObject report = otfOfCommand(number);
            expectTheSame(number, report);
            if (QTest::currentTestFailed()) return;
            weighing += report["explanation"]["factors"].toArray().isEmpty() ? 0 : 1;
        }
        QVERIFY(weighing > 0);
    }

private:
    QJsonObject otfOfCommand(int number) {
        QProcess program;
        program.start(ECHOLUCENT_CLI,
                      {"otf", "--document", m_document, "--json", "-", "--explain", QString::number(number)});
        if (!program.waitForFinished(120000) || program.exitCode() != 0)
            qWarning("%s", program.readAllStandardError().constData());
        return QJsonDocument::fromJson(program.readAllStandardOutput()).object();
    }

    void expectTheSame(int number, const QJsonObject& report) {
        const QJsonObject explained = report["explanation"].toObject();
        QCOMPARE(explained["number"].toInt(-1), number);
        QCOMPARE(child<QLabel>("tubeCores.sentence")->text(), explained["sentence"].toString());
        const auto* table = child<QTableWidget>("tubeCores.facts");
        const QJsonArray facts = explained["facts"].toArray();
        QVERIFY(facts.size() > 10);
        QCOMPARE(table->rowCount(), facts.size());
        for (int row = 0; row < table->rowCount(); ++row) {
            const QJsonObject fact = facts[row].toObject();
            const QString value = fact["value"].toString(), unit = fact["unit"].toString();
            QCOMPARE(table->item(row, 0)->text(), fact["symbol"].toString());
            QCOMPARE(table->item(row, 1)->text(), unit.isEmpty() ? value : value + ' ' + unit);
            const QString raw = table->item(row, 0)->toolTip();
            const QString tip =
                Qt::mightBeRichText(raw) ? QTextDocumentFragment::fromHtml(raw).toPlainText() : raw.simplified();
            for (const char* said : {"equation", "place"})
                QVERIFY2(tip.contains(fact[said].toString().simplified()), qPrintable(tip));
        }
        expectTheRow(report["tubes"][number].toObject());
        const auto shown = window().tubeCoreExplaining().explanation();
        expectTheCurve(shown->explanation->full.curve, explained["curves"]["full"].toObject());
        expectTheCurve(shown->explanation->without.curve, explained["curves"]["without"].toObject());
        expectTheCurve(shown->explanation->alone.curve, explained["curves"]["alone"].toObject());
    }

    void expectTheRow(const QJsonObject& tube) {
        const QModelIndex at = child<TubeCoreList>("tubeCores.list")->currentIndex();
        QVERIFY(at.isValid());
        const auto text = [&](TubeCoreListModel::Column column) {
            return at.siblingAtColumn(column).data().toString();
        };
        QCOMPARE(text(TubeCoreListModel::column), QString::number(tube["u"].toInt(-1)));
        QCOMPARE(text(TubeCoreListModel::row), QString::number(tube["v"].toInt(-1)));
        const auto rounded = [](const QJsonValue& value, int digits) {
            return value.isDouble() ? QString::number(value.toDouble(), 'f', digits) : QString();
        };
        QCOMPARE(text(TubeCoreListModel::low), rounded(tube["i_low"], 3));
        QCOMPARE(text(TubeCoreListModel::high), rounded(tube["i_high"], 3));
        QCOMPARE(text(TubeCoreListModel::weight), tube["d"].toDouble() > 0.0 ? rounded(tube["d"], 4) : QString());
    }

    static void expectTheCurve(const SampledCurve& shown, const QJsonObject& told) {
        const QJsonArray opacities = told["opacity"].toArray();
        QCOMPARE(static_cast<std::size_t>(opacities.size()), shown.opacities.size());
        for (std::size_t i = 0; i < shown.opacities.size(); ++i)
            QVERIFY(shown.opacities[i] == opacities[static_cast<qsizetype>(i)].toDouble(-1.0));
    }

    QString m_document;
};

ECHOLUCENT_TEST_CLASS(TestTubeCoreNumbers, "areThoseOfTheCommandLine")
#include "test_tube_core_numbers.moc"
