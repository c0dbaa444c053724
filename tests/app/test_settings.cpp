// What is remembered survives in its file; recent files are few, unique and there.
#include <QByteArray>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QIODevice>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include "app/settings/settings.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestSettings : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void startsWithDefaults() {
        const Settings settings(store());
        QVERIFY(settings.recentFiles().isEmpty());
        QVERIFY(settings.lastFolder().isEmpty());
        QVERIFY(settings.windowGeometry().isEmpty());
        QVERIFY(settings.windowState().isEmpty());
        QVERIFY(settings.histogramLogarithmic() && !settings.earlyLightShown() && settings.motion().pingPong);
        QCOMPARE(settings.look(), lookAtStart());
        QCOMPARE(settings.look().lighting, Lighting::depth);
        QCOMPARE(settings.renderer(), RendererChoice::automatic);
        QCOMPARE(settings.theme(), Theme::dark);
        QCOMPARE(settings.face(), Face::review);
    }

    void everythingComesBackFromTheFile() {
        const QByteArray bytes = QByteArray("\x00\xff\x01;,=\"\n", 8);
        const QString file = fileNamed("größe, 1.mha");
        const Look chosen{.mode = RenderMode::mean,
                          .lighting = Lighting::flat,
                          .light = {71, -12.5},
                          .reaching = {},
                          .depthColoured = true,
                          .colourMap = ColourMap::ice,
                          .projection = Projection::perspective,
                          .interpolation = Interpolation::nearest};
        const MotionChoice motion{.axis = MotionAxis::screenHorizontal,
                                  .otf = MotionOtf::leastFlicker,
                                  .pingPong = false,
                                  .phasesPingPong = true,
                                  .speed = 0.5};
        MethodChoice method;
        method.initial = InitialKind::quartic;
        method.initialScale = 0.75;
        method.config.detection = VarianceRule{};
        method.config.curve = ProductRule{};
        method.config.grid.columns = 11;
        {
            Settings settings(store());
            settings.addRecentFile(file);
            settings.setLastFolder("/some/where");
            settings.setWindowGeometry(bytes);
            settings.setWindowState(bytes + bytes);
            settings.setLook(chosen);
            settings.setRenderer(RendererChoice::graphicsCard);
            settings.setTheme(Theme::light);
            settings.setHistogramLogarithmic(false);
            settings.setEarlyLightShown(true);
            settings.setMotion(motion);
            settings.setActiveCurve(CurveKind::quartic);
            settings.setMethod(method);
            settings.setLastSaveFolder("/else/where");
            QVERIFY(settings.save());
        }
        const Settings settings(store());
        QCOMPARE(settings.recentFiles(), QStringList{file});
        QCOMPARE(settings.lastFolder(), "/some/where");
        QCOMPARE(settings.windowGeometry(), bytes);
        QCOMPARE(settings.windowState(), bytes + bytes);
        QVERIFY(!settings.histogramLogarithmic());
        QVERIFY(settings.earlyLightShown());
        QCOMPARE(settings.lastSaveFolder(), "/else/where");
        QVERIFY(settings.motion() == motion);
        QCOMPARE(settings.activeCurve(), CurveKind::quartic);
        QVERIFY(settings.method() == method);
        QCOMPARE(settings.look(), chosen);
        QCOMPARE(settings.renderer(), RendererChoice::graphicsCard);
        QCOMPARE(settings.theme(), Theme::light);
    }

    void whatIsNotUnderstoodGivesTheDefault() {
        {
            QFile file(store());
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(
                "[picture]\ncolourMap=mauve\ninterpolation=17\nprojection=\nlighting=perhaps\n"
                "mode=5\nlightAzimuth=nan\nlightElevation=91\ndepthColouring=2\nrenderer=abacus\n"
                "[motion]\nspeed=fast\nphasesPingPong=2\n[window]\ntheme=mauve\n");
        }
        const Settings settings(store());
        QVERIFY(settings.motion() == MotionChoice{});
        QCOMPARE(settings.theme(), Theme::dark);
        QCOMPARE(settings.look(), lookAtStart());
        QCOMPARE(settings.renderer(), RendererChoice::automatic);
    }

    void theLookOfAnOlderFileIsRead() {
        {
            QFile file(store());
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(
                "[picture]\ncolourMap=ice\ninterpolation=nearest\nprojection=perspective\nlighting=flat\n"
                "mode=mean\nlightAzimuth=71\nlightElevation=-12.5\ndepthColouring=true\n");
        }
        const Look expected{.mode = RenderMode::mean,
                            .reduction = lookAtStart().reduction,
                            .lighting = Lighting::flat,
                            .light = {71, -12.5},
                            .reaching = {},
                            .depthColoured = true,
                            .colourMap = ColourMap::ice,
                            .projection = Projection::perspective,
                            .interpolation = Interpolation::nearest};
        QCOMPARE(Settings(store()).look(), expected);
    }

    void theMotionAndTheMethodOfAnOlderFileAreRead() {
        {
            QFile file(store());
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(
                "[motion]\naxis=x\notf=least_flicker\npingPong=false\nphasesPingPong=true\nspeed=0.5\n"
                "[method]\ninitial=quartic\ninitialScale=0.75\nform=product\ninterfaceFunction=variance\n"
                "tubeColumns=11\nstrength=3.5\ncoarsestScale=6\nsignificance=9\n");
        }
        Settings settings(store());
        QVERIFY(settings.motion() == (MotionChoice{.axis = MotionAxis::screenHorizontal,
                                                   .otf = MotionOtf::leastFlicker,
                                                   .pingPong = false,
                                                   .phasesPingPong = true,
                                                   .speed = 0.5}));
        MethodChoice method;
        method.initial = InitialKind::quartic;
        method.initialScale = 0.75;
        method.config.detection = VarianceRule{.coarsestScale = 6};
        method.config.curve = ProductRule{3.5};
        method.config.grid.columns = 11;
        QVERIFY(settings.method() == method);
        // From here on each stands in one key.
        settings.setMotion(settings.motion());
        settings.setMethod(method);
        settings.setLook(settings.look());
        QVERIFY(settings.save());
        QFile file(store());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(!text.contains("pingPong=") && !text.contains("tubeColumns="));
        QCOMPARE(text.count("choice="), 2);
        QCOMPARE(text.count("look="), 1);
        QVERIFY(Settings(store()).method() == method);
    }

    void aKeyThatIsNoJsonGivesTheDefault() {
        {
            QFile file(store());
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("[picture]\nlook=mauve\ncolourMap=ice\n[motion]\nchoice={\n[method]\nchoice=\n");
        }
        const Settings settings(store());
        QCOMPARE(settings.look(), lookAtStart());
        QVERIFY(settings.motion() == MotionChoice{});
        QVERIFY(settings.method() == MethodChoice{});
    }

    void aWrongValueLeavesItsNeighboursAlone() {
        QSettings written(store(), QSettings::IniFormat);
        written.setValue("picture/look", R"({"mode": "mean", "colour_map": "mauve", "brightness": 2})");
        written.setValue("motion/choice", R"({"axis": "x", "otf": 7, "ping_pong": false, "speed": 99})");
        written.setValue("method/choice", R"({"initial": "cubic", "initial_scale": 0.5, "parameters":
            {"tube_columns": 11, "cell_size": 99, "interface_function": "variance", "significance": 0.3}})");
        written.sync();
        const Settings settings(store());
        Look look = lookAtStart();
        look.mode = RenderMode::mean;
        look.brightness = 2;
        QCOMPARE(settings.look(), look);
        QVERIFY(settings.motion() == (MotionChoice{.axis = MotionAxis::screenHorizontal, .pingPong = false}));
        MethodChoice method;
        method.initialScale = 0.5;
        method.config.grid.columns = 11;
        method.config.detection = VarianceRule{.significance = 0.3};
        std::get<RampRule>(method.config.curve).aim = 0.0;  // written before there was an aim
        QVERIFY(settings.method() == method);
    }

    void aMethodFromBeforeTheAimKeepsItsCurve() {
        MethodChoice method;
        std::get<RampRule>(method.config.curve) = {.opacity = 0.5, .aim = 0.0};
        {
            QFile file(store());
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("[method]\nform=ramp\nrampOpacity=0.5\n");
        }
        QVERIFY(Settings(store()).method() == method);
        QSettings written(store(), QSettings::IniFormat);
        written.clear();
        written.setValue("method/choice", R"({"parameters": {"form": "ramp", "ramp_opacity": 0.5}})");
        written.sync();
        QVERIFY(Settings(store()).method() == method);
        QVERIFY(QFile::remove(store()));
        QVERIFY(Settings(store()).method() == MethodChoice{});
    }

    void recentFilesAreNewestFirstWithoutDoubles() {
        Settings settings(store());
        const QString a = fileNamed("a.mha");
        const QString b = fileNamed("b.mha");
        settings.addRecentFile(a);
        settings.addRecentFile(b);
        settings.addRecentFile(m_folder->filePath("x/../a.mha"));
        settings.addRecentFile({});
        QCOMPARE(settings.recentFiles(), (QStringList{a, b}));
        settings.clearRecentFiles();
        QVERIFY(settings.recentFiles().isEmpty());
    }

    void relativePathsBecomeAbsolute() {
        Settings settings(store());
        const QString a = fileNamed("a.mha");
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_folder->path()));
        settings.addRecentFile("a.mha");
        QVERIFY(QDir::setCurrent(before));
        QCOMPARE(settings.recentFiles(), QStringList{QFileInfo(a).canonicalFilePath()});
    }

    void atMostTenFilesAreKept() {
        Settings settings(store());
        QStringList expected;
        for (int i = 0; i < 13; ++i) {
            const QString file = fileNamed(QString("%1.mha").arg(i));
            settings.addRecentFile(file);
            expected.prepend(file);
        }
        QCOMPARE(settings.recentFiles(), QStringList(expected.mid(0, 10)));
    }

    void missingFilesAreLeftOutUntilTheyComeBack() {
        Settings settings(store());
        const QString a = fileNamed("a.mha");
        const QString b = fileNamed("b.mha");
        settings.addRecentFile(a);
        settings.addRecentFile(b);
        QVERIFY(QFile::remove(a));
        QCOMPARE(settings.recentFiles(), QStringList{b});
        fileNamed("a.mha");
        QCOMPARE(settings.recentFiles(), (QStringList{b, a}));
    }

    void aFolderThatCannotBeWrittenIsSaid() {
        fileNamed("plain");
        Settings settings(m_folder->filePath("plain/settings.ini"));
        settings.setMotion({.pingPong = false});
        QVERIFY(!settings.save());
    }

    void changesAreWrittenWithoutWaitingForThem() {
        Settings settings(store());
        settings.setLastFolder("/first");
        settings.setLastSaveFolder("/saved");
        QVERIFY2(!QFile::exists(store()), "the disc was waited for");
        QCOMPARE(settings.lastFolder(), "/first");
        const auto inFile = [&](const char* key) {
            QFile file(store());
            return file.open(QIODevice::ReadOnly) && file.readAll().contains(key);
        };
        QTRY_VERIFY(inFile("folder=/first"));
        QVERIFY(inFile("saveFolder=/saved"));
        // What changes while the thread writes is written after it.
        settings.setLastFolder("/second");
        QCoreApplication::processEvents();
        settings.setLastFolder("/third");
        QTRY_VERIFY(inFile("folder=/third"));
        settings.clearRecentFiles();
        QVERIFY(settings.save());
        QVERIFY(inFile("folder=/third") && inFile("saveFolder=/saved"));
    }

    void whatAnotherWindowWroteStaysAndIsSeen() {
        Settings one(store()), other(store());
        one.setLastFolder("/of/one");
        QVERIFY(one.save());
        other.setLastSaveFolder("/of/other");
        QVERIFY(other.save());
        QCOMPARE(other.lastFolder(), "/of/one");
        QCOMPARE(Settings(store()).lastFolder(), "/of/one");
        QCOMPARE(Settings(store()).lastSaveFolder(), "/of/other");
    }

    void whatCouldNotBeWrittenIsTriedAgain() {
        const QString file = m_folder->filePath("plain/settings.ini");
        fileNamed("plain");
        Settings settings(file);
        settings.setLastFolder("/kept");
        QVERIFY(!settings.save());
        QVERIFY(QFile::remove(m_folder->filePath("plain")));
        settings.setLastSaveFolder("/saved");
        QVERIFY(settings.save());
        QCOMPARE(Settings(file).lastFolder(), "/kept");
    }

private:
    QString store() const { return m_folder->filePath("settings.ini"); }

    /// Creates an empty file; returns its path.
    QString fileNamed(const QString& name) const {
        QFile file(m_folder->filePath(name));
        if (!file.open(QIODevice::WriteOnly)) qFatal("cannot create a file");
        return file.fileName();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

ECHOLUCENT_TEST_CLASS(TestSettings)
#include "test_settings.moc"
