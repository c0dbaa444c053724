// The command line's `render FILE` and `otf FILE` beside the real window, which has opened the same file with fresh
// settings.
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <cmath>

#include "processing/picture/picture.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/app/walled_sector.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestRenderedByCommand : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void init() { show(lookAtStart()); }
    void cleanup() { close(); }

    void aSimulatedScanIsRenderedAsInTheWindow_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<bool>("front");
        QTest::newRow("beam and front are found") << file("sector.mha", {walledSector()}) << true;
        QTest::newRow("4D, nothing is found") << file("moving.mha", {smallPhantom(PhantomScene::fetus, 3, 0.0),
                                                                     smallPhantom(PhantomScene::fetus, 3, 0.5)})
                                              << false;
    }
    void aSimulatedScanIsRenderedAsInTheWindow() {
        QFETCH(QString, path);
        QFETCH(bool, front);
        expectTheWindowsPicture(path);
        QCOMPARE(window().document().document().scene.front.source == FrontSource::found, front);
    }

    void aRealVolumeIsRenderedAsInTheWindow_data() {
        QTest::addColumn<QString>("path");
        const QDir volumes(ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes");
        QStringList names = volumes.entryList(QDir::Files);
        if (!isLongRun()) names = names.filter("prostate");
        for (const QString& name : names) QTest::newRow(qPrintable(name)) << volumes.filePath(name);
        if (names.isEmpty()) QTest::newRow("none") << QString();
    }
    void aRealVolumeIsRenderedAsInTheWindow() {
        QFETCH(QString, path);
        if (path.isEmpty()) QSKIP("the shared volumes are not here");
        expectTheWindowsPicture(path);
    }

private:
    QByteArray run(const QStringList& arguments) {
        QProcess program;
        program.start(ECHOLUCENT_CLI, arguments);
        if (!program.waitForFinished(120000) || program.exitCode() != 0)
            qWarning("%s", program.readAllStandardError().constData());
        return program.readAllStandardOutput();
    }

    /// RMSE 0 between the command's picture and the one that the window's view asks of the processor to save it; and
    /// the command's curve is the window's, number by number.
    void expectTheWindowsPicture(const QString& path) {
        open(path);
        const VolumeViewWidget& view = window().volumeView();
        const auto settings = view.settings();
        const auto picture = castRays(*view.volume(), view.classification(), settings);
        const std::vector<std::uint8_t> ofWindow = overBackground(*picture, {0, 0, 0});
        const QString rendered = temporaryFolder().filePath("rendered.png"),
                      saved = temporaryFolder().filePath("saved.png");
        run({"render", path, "--size", QString("%1x%2").arg(settings.width).arg(settings.height), "-o", rendered});
        QVERIFY(window().savePicture(saved));
        const QImage ofCommand = QImage(rendered).convertToFormat(QImage::Format_RGB888),
                     withLabels = QImage(saved).convertToFormat(QImage::Format_RGB888);
        QCOMPARE(ofCommand.size(), QSize(settings.width, settings.height));
        QCOMPARE(withLabels.size(), ofCommand.size());
        double squares = 0;
        qint64 labelled = 0, lit = 0;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x) {
                const auto at = static_cast<std::size_t>(3 * (y * settings.width + x));
                bool asSaved = true;
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const int command = ofCommand.constScanLine(y)[3 * x + static_cast<int>(channel)];
                    squares += std::pow(command - ofWindow[at + channel], 2);
                    asSaved &= command == withLabels.constScanLine(y)[3 * x + static_cast<int>(channel)];
                    lit += command > 30;
                }
                labelled += !asSaved;
            }
        const double rmse = std::sqrt(squares / (3.0 * settings.width * settings.height));
        qInfo("%s, %d x %d: RMSE %g; %.1f %% of the saved picture are labels", qPrintable(QFileInfo(path).fileName()),
              settings.width, settings.height, rmse, 100.0 * labelled / (settings.width * settings.height));
        QCOMPARE(rmse, 0.0);
        QVERIFY2(labelled < settings.width * settings.height / 10, "the saved picture is the same but for its labels");
        QVERIFY2(lit > 1000, "there is something to compare");

        const auto otf = QJsonDocument::fromJson(run({"otf", path, "--json", "-"})).object();
        const QJsonArray opacities = otf["otf"].toObject()["opacity"].toArray();
        const SampledCurve& curve = window().otfs().adaptive()->curve;
        QCOMPARE(static_cast<std::size_t>(opacities.size()), curve.opacities.size());
        for (std::size_t i = 0; i < curve.opacities.size(); ++i)
            QCOMPARE(opacities[static_cast<int>(i)].toDouble(), curve.opacities[i]);
        QCOMPARE(otf["made_of"].toObject()["study"].toObject()["file"].toString(), QFileInfo(path).fileName());
    }
};

ECHOLUCENT_TEST_CLASS(TestRenderedByCommand, "aRealVolumeIsRenderedAsInTheWindow")

#include "test_rendered_by_command.moc"
