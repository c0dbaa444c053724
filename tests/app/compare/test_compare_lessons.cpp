// What a lesson shows in the comparison: the OTFs of a motion side by side, figures of the paper, the page that is
// kept.
#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <thread>

#include "app/compare/paper_figures.h"
#include "app/otf/pane_otfs.h"
#include "app/picture/panes_saving.h"
#include "app/sessions/session_keeping.h"
#include "io/document/document_file.h"
#include "io/document/session_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/designers/choice/designer.h"
#include "processing/motion/otf_smoothing.h"
#include "tests/app/compare/compare_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/casting/picture_image.h"
#include "widgets/motion/otf_curves_canvas.h"
#include "widgets/panels/history_panel.h"

using namespace echolucent;

class TestCompareLessons : public QObject, private CompareFixture {
    Q_OBJECT

private slots:
    void initTestCase() { makeFiles(); }
    void init() { begin(); }
    void cleanup() { close(); }

    void panesShowTheOtfsOfAMotion() {
        waitUntilRest();
        child<QAction>("compare.motions")->trigger();
        QCOMPARE(document().panes.size(), std::size_t{3});
        QCOMPARE(document().panes.at(1).motionOtf, std::optional(MotionOtf::eachView));
        waitUntilRest();
        QVERIFY(child<QComboBox>("compare.motion2")->isVisible());
        const auto curves = [this] {
            std::vector<Classification> made;
            for (const PaneRequest& pane : window().compareRoom().views().frame()->request.panes)
                made.push_back(pane.classification);
            return made;
        };
        QVERIFY(curves()[0] == curves()[1] && curves()[1] == curves()[2]);  // all begin in one view
        const Classification begun = curves()[0];
        std::vector<SampledCurve> own;
        OtfHistory history(OtfSmoothing::leastFlicker);
        (void)history.add(0, std::get<SampledCurve>(begun.curve()));
        for (int angle = 1; angle <= 3; ++angle) {
            child<QSlider>("motion.angle")->setValue(angle);
            waitUntilRest();
            const auto made = curves();
            QVERIFY(made[0] == begun);
            const Design design = *echolucent::design(AdaptiveConfig{}, {*window().openStudy().volume(),
                                                                         *window().openStudy().newestVoxels(),
                                                                         {},
                                                                         viewpointOf(document()),
                                                                         configOf(document())});
            QVERIFY(made[1] == design.classification);
            QVERIFY(made[2] == Classification(history.add(angle, std::get<SampledCurve>(made[1].curve()))));
        }
        click("compare.measureFlicker");
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows()[2].flicker.has_value(), 60000);
        QCOMPARE(*panel().rows()[0].flicker, 0.0);
        QVERIFY(*panel().rows()[2].flicker < *panel().rows()[1].flicker);
    }

    void figuresOfThePaperAreOneClick() {
        child<QAction>("compare.figure9.fetus")->trigger();
        QVERIFY(child<MessageBar>("message")->text().contains("simulated fetus"));
        QVERIFY(!window().openStudy().loading());  // it asks first
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(document().scene.motionAngle, 30.0, 60000);
        QVERIFY(window().openStudy().isSimulatedScan());
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && window().compareRoom().views().settled(), 60000);
        const auto nine = window().compareRoom().views().frame();
        QCOMPARE(nine->panes.size(), std::size_t{2});
        QCOMPARE(grid().pane(0).face().name, QString("1  Adaptive curve, one OTF"));
        QCOMPARE(grid().pane(1).face().name, QString("2  Adaptive curve, each view's OTF"));
        QVERIFY(nine->request.panes[0].classification != nine->request.panes[1].classification);
        // The truth of the simulated scan is known, also in the turned view.
        QVERIFY(panel().rows()[1].surfaces == SurfacesFrom::truth);
        QVERIFY(panel().rows()[1].depth->rays() > 1000);
        QVERIFY(panel().rows()[0].depth->rays() == panel().rows()[1].depth->rays());
        QVERIFY(child<QLabel>("compare.note")->text().contains("true ones of the simulated scan"));
        child<QAction>("compare.figure1.fetus")->trigger();  // it is open: nothing to ask
        waitUntilRest();
        QCOMPARE(document().scene.motionAngle, 0.0);
        const auto one = window().compareRoom().views().frame();
        QCOMPARE(one->panes.size(), std::size_t{3});
        QVERIFY(opacityAt(one->request.panes[0].classification, 0.5, 0.0) == 0.5);
        const auto names = [this] {
            QStringList all;
            for (std::size_t place = 0; place < 3; ++place) all << grid().pane(place).face().name;
            return all;
        };
        QCOMPARE(names(), QStringList({"1  (a) Linear OTF", "2  (b) Manually designed piecewise linear OTF",
                                       "3  (c) Adaptively designed OTF"}));
        QCOMPARE(panel().rows()[1].name, QString("(b) Manually designed piecewise linear OTF"));
        QCOMPARE(child<QComboBox>("compare.first")->itemText(2), QString("3: (c) Adaptively designed OTF"));
        // Another slope is another curve than the paper's. The editor edits the pane's own, and resets it to eq. 1.
        const CurveSet drawn = document().curves;
        window().otfEditor().model().setLinear({0.0, 0.6, 1.0});
        QCOMPARE(document().panes[0].linear->slope, 0.6);
        QCOMPARE(names(), QStringList({"1  Piecewise linear curve of its own", "2  Piecewise linear curve (eq. 1)",
                                       "3  Adaptive curve"}));
        QCOMPARE(child<QComboBox>("compare.first")->itemText(1), QString("2: Piecewise linear curve (eq. 1)"));
        window().otfEditor().resetAction()->trigger();
        QVERIFY(document().panes[0].linear == LinearCurve{});
        QVERIFY(document().curves == drawn);
    }

    /// Each figure from an odd state: one step, which undo, redo, a snapshot and a session bring back byte for byte.
    void aFigureIsOneStepFromAKnownState() {
        window().compareRoom().setShown(false);
        Document odd = document();
        odd.scene.look = Look{};
        odd.scene.look.brightness = 1.5;
        odd.scene.pose.direction.azimuth = 12;
        odd.scene.front.depthMm = 5;
        odd.curves.manual = ManualCurve{{{0.1, 0.2}, {0.8, 0.9}}};
        odd.curves.linear.slope = 2;
        odd.curves.adjustment.threshold = 0.1;
        odd.method.config = configOf(MethodReading::settled);
        odd.motion.otf = MotionOtf::leastFlicker;
        odd.motion.axis = MotionAxis::screenHorizontal;
        odd = withDesigner(odd, firstPane, OtsuConfig{});
        window().document().edit(odd, "odd");
        window().motionPlayer().setAngle(7);
        waitUntilRest();
        const Document before = document();
        const std::string text = jsonOf(before);
        const int steps = window().document().steps().count();
        const auto shows = [this](const QString& dock) { return !child<QDockWidget>(dock)->visibleRegion().isEmpty(); };
        for (const PaperFigure& figure : paperFigures()) {
            const QByteArray name = "figure " + QByteArray::number(figure.number);
            child<QAction>(QStringLiteral("compare.figure%1").arg(figure.number))->trigger();
            waitUntilRest();
            const Document set = withFigure(before, figure.number);
            const std::string after = jsonOf(set);
            QVERIFY2(jsonOf(document()) == after, name);
            QCOMPARE(window().document().steps().count(), steps + 1);
            QCOMPARE(window().compareRoom().shown(), set.panes.size() > 1);
            QCOMPARE(window().motionPlayer().angle(), set.scene.motionAngle);
            QVERIFY(document().scene.look == lookAtStart() && document().scene.pose == before.scene.pose);
            QVERIFY(document().curves.manual == odd.curves.manual && document().curves.linear == odd.curves.linear);
            if (figure.number == 6) QVERIFY(shows("dock.otfEditor"));
            if (figure.number == 5) QVERIFY(shows("dock.tubeCores"));
            if (figure.number >= 10) QVERIFY(shows("dock.motionMap"));
            if (figure.number == 10)
                QCOMPARE(child<OtfCurvesCanvas>("motion.map.curves")->shownRows(), (std::vector<int>{0, 45, 90, 45}));
            QVERIFY(window().sessionKeeping().snapshots().keep(QString::fromUtf8(name), document()).isEmpty());
            window().document().steps().undo();
            QVERIFY2(jsonOf(document()) == text, name);
            QVERIFY(!window().compareRoom().shown());
            QCOMPARE(window().motionPlayer().angle(), 7.0);
            window().document().steps().redo();
            QVERIFY2(jsonOf(document()) == after, name);
            QCOMPARE(window().compareRoom().shown(), set.panes.size() > 1);
            window().document().steps().undo();
            const SavedSession session{.document = set, .snapshots = {{"of the figure", set}}};
            QVERIFY2(jsonOf(sessionFromJson(jsonOf(session)).value()) == jsonOf(session), name);
        }
        for (std::size_t i = 0; i < paperFigures().size(); ++i) {
            const Document set = withFigure(before, paperFigures()[i].number);
            emit window().findChild<HistoryPanel*>()->chosen(static_cast<int>(i));
            QVERIFY(jsonOf(document()) == jsonOf(set));
            QCOMPARE(window().compareRoom().shown(), set.panes.size() > 1);
            window().document().steps().undo();
            QVERIFY(jsonOf(document()) == text);
        }
        // It is shown also if the panes of another one were there, and the comparison was left.
        emit window().findChild<HistoryPanel*>()->chosen(0);
        window().compareRoom().setShown(false);
        emit window().findChild<HistoryPanel*>()->chosen(3);
        QVERIFY(window().compareRoom().shown());
    }

    /// Saved, opened by another start of the program and saved there: the same bytes, and the same room. Nothing waits
    /// for the pictures.
    void aSessionOfAFigureIsTheSameInAnotherWindow() {
        MainWindow other(temporaryFolder().filePath("other.ini"));
        other.show();
        const QString first = temporaryFolder().filePath("first.session.json"),
                      second = temporaryFolder().filePath("second.session.json");
        const auto save = [](MainWindow& from, const QString& path) {
            from.sessionKeeping().saveAs(path);
            QTRY_VERIFY(!from.sessionKeeping().saving());
        };
        const auto bytes = [](const QString& path) {
            QFile in(path);
            return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
        };
        for (const PaperFigure& figure : paperFigures()) {
            // Panes with curves of their own, and the motion.
            if (!isLongRun() && figure.number != 1 && figure.number != 11) continue;
            child<QAction>(QStringLiteral("compare.figure%1").arg(figure.number))->trigger();
            const QByteArray name = "figure " + QByteArray::number(figure.number);
            QVERIFY(window().sessionKeeping().snapshots().keep(QString::fromUtf8(name), document()).isEmpty());
            const Document saved = document();
            save(window(), first);
            QVERIFY(!bytes(first).isEmpty());
            QSignalSpy opened(&other.openStudy(), &OpenStudy::studyOpened);
            other.open(first);
            QTRY_VERIFY(!opened.isEmpty());
            QVERIFY2(jsonOf(other.document().document()) == jsonOf(saved), name);
            QCOMPARE(other.compareRoom().shown(), isCompared(saved));
            QCOMPARE(other.motionPlayer().angle(), saved.scene.motionAngle);
            save(other, second);
            QVERIFY2(bytes(second) == bytes(first), name);
        }
    }

    /// Smoothed, the pane shows the mean of the five newest; the other shows its own view's.
    void figure11HasThePastThatItSmooths() {
        window().compareRoom().setShown(false);
        child<QAction>("compare.figure11")->trigger();
        waitUntilRest();
        const auto& panes = window().compareRoom().views().frame()->request.panes;
        std::vector<double> mean;
        for (int angle = 16; angle <= 20; ++angle) {
            Document frame = document();
            frame.scene.motionAngle = angle;
            const auto otf = adaptOpacity(*window().openStudy().volume(), viewpointOf(frame), configOf(frame), {},
                                          {window().openStudy().newestVoxels().get(), frame.scene.look.reduction});
            mean.resize(otf->curve.opacities.size());
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += otf->curve.opacities[i] / 5;
            if (angle == 20) QVERIFY(panes[1].classification == Classification(otf->curve));
        }
        const auto& shown = std::get<SampledCurve>(panes[0].classification.curve()).opacities;
        for (std::size_t i = 0; i < mean.size(); ++i) QVERIFY(std::abs(shown[i] - mean[i]) < 1e-12);
        // What is saved anew is what is seen.
        const QString path = temporaryFolder().filePath("figure11.png");
        window().panesSaving().save(path, {.allPanes = true, .width = grid().width()});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), patience);
        waitUntilRest();
        const QImage saved(path);
        for (std::size_t place = 0; place < 2; ++place) {
            const ComparePane& pane = grid().pane(place);
            const auto made = rgbBytesOf(saved.copy(pane.pictureRect().translated(pane.pos())));
            const auto seen = rgbBytesOf(images()[place]);
            QCOMPARE(made.size(), seen.size());
            int farthest = 0;
            for (std::size_t i = 0; i < made.size(); ++i)
                farthest = std::max(farthest, std::abs(static_cast<int>(made[i]) - static_cast<int>(seen[i])));
            QVERIFY2(farthest <= 1, qPrintable(QString::number(farthest)));
        }
    }

    void onePaneReadsAsPublished() {
        choose(child<QComboBox>("compare.otf2"), 0);
        choose(child<QComboBox>("compare.method2"), 1);
        waitUntilRest();
        QVERIFY(document().panes[1].method == configOf(MethodReading::asPublished));
        QCOMPARE(grid().pane(1).face().name, QString("2  Adaptive curve, as published"));
        const auto& panes = window().compareRoom().views().frame()->request.panes;
        const Volume& voxels = *window().openStudy().volume();
        QVERIFY(panes[0].classification ==
                Classification(adaptOpacity(voxels, otfViewpointOf(document(), 0), configOf(document()))->curve));
        QVERIFY(panes[1].classification ==
                Classification(
                    adaptOpacity(voxels, otfViewpointOf(document(), 1), configOf(MethodReading::asPublished))->curve));
        choose(child<QComboBox>("compare.method2"), 0);
        QVERIFY(!document().panes[1].method);
    }

    void aDesignerOfAPaneIsSetInItsRow() {
        QVERIFY(child("compare.pane4.tissueOpacity")->isHidden() || !child("compare.pane4.tissueOpacity")->isVisible());
        click("compare.parameters4");
        QVERIFY(child("compare.pane4.tissueOpacity")->isVisible());
        auto* opacity = child<QDoubleSpinBox>("compare.pane4.tissueOpacity");
        const LevoyConfig before = std::get<LevoyConfig>(*document().panes[3].designer);
        opacity->setValue(opacity->value() / 2);
        LevoyConfig after = before;
        after.tissueOpacity /= 2;
        QVERIFY(document().panes[3].designer == DesignerConfig(after));
    }

    void thePageOpensWithoutANetwork() {
        waitUntilRest();
        const QString path = temporaryFolder().filePath("comparison.html");
        window().compareRoom().savePage(path);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), patience);
        waitUntilRest();
        QFile page(path);
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray text = page.readAll();
        QCOMPARE(text.count("data:image/png"), 4);
        QVERIFY(text.contains("not for diagnosis") && text.contains("<svg"));
        QVERIFY(!text.contains("href=\"http") && !text.contains("src=\"http"));
        // What is seen, by which parameters, and by which program.
        QVERIFY(text.contains("looked at along its +z axis"));
        QVERIFY(text.contains("Parameters of 1. Reading: default. "));
        QVERIFY(text.contains("(eqs. 8 and 9)") && text.contains("(eqs. 2 and 3)"));
        QVERIFY(text.contains(QApplication::applicationVersion().toUtf8()));
        // The curves have the colours of the window on light ground: adaptive, x², eq. 1.
        for (const auto& [name, colour] : {std::pair("1: Adaptive curve", "#1c7f8c"),
                                           {"2: x²", "#905a8a"},
                                           {"3: Piecewise linear curve", "#66717d"}}) {
            const qsizetype legend = text.indexOf(name, text.indexOf("<svg"));
            QVERIFY2(legend > 0, name);
            QVERIFY2(text.mid(legend - 400, 800).contains(colour), name);
        }
    }

    void thePaneInFocusIsExplained() {
        waitUntilRest();
        grid().pane(1).setFocus();
        QVERIFY(window().explanationOfPane().startsWith("Pane 2: x² (parabolic curve)."));
        QVERIFY(window().explanationOfPane().contains("α(x) = x²"));
        grid().pane(0).setFocus();
        QVERIFY(window().explanationOfPane().contains("f_t") || window().explanationOfPane().contains("eq. 4"));
        QVERIFY(!window().explanation().startsWith("Pane"));  // that of the 3D view, which the case report prints
        window().compareRoom().setShown(false);
        QCOMPARE(window().explanationOfPane(), window().explanation());
    }

    void savingAndCopyingTakeAllPanes() {
        waitUntilRest();
        const QString path = temporaryFolder().filePath("panes.png");
        QVERIFY(window().savePicture(path));
        const QImage saved(path);
        QCOMPARE(saved.size(), grid().size() * grid().devicePixelRatioF());
        for (std::size_t place = 0; place < 4; ++place) {
            const ComparePane& pane = grid().pane(place);
            const QRect picture = pane.pictureRect().translated(pane.pos());
            QCOMPARE(picture.size(), images()[place].size());
            QCOMPARE(rgbBytesOf(saved.copy(picture)), rgbBytesOf(images()[place]));
        }
        child<QAction>("edit.copyPicture")->trigger();
        QCOMPARE(rgbBytesOf(QApplication::clipboard()->image()), rgbBytesOf(saved));
        const QString large = temporaryFolder().filePath("large.png");
        QVERIFY(child<QAction>("file.savePanes")->isEnabled());
        const std::optional<QColor> frame = grid().pane(0).face().frame;
        window().document().change("colours", [](Document& next) { next.comparison.colours = true; });
        QVERIFY(grid().pane(0).face().coloured);
        window().panesSaving().save(large, {.allPanes = true, .width = grid().width() * 3 / 2});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(large), patience);
        waitUntilRest();
        const QImage inLarge(large);
        const QImage twice = inLarge.scaled(saved.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        const auto mean = [](const QImage& image, const QRect& rect) {
            return qGray(image.copy(rect).scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).pixel(0, 0));
        };
        // Its pictures are not coloured, so frames have the colours of the curves.
        bool framed = false;
        for (int x = 0; x < inLarge.width() && !framed; ++x) framed = inLarge.pixelColor(x, 1) == *frame;
        QVERIFY(framed);
        for (std::size_t place = 0; place < 4; ++place) {
            const QRect rect = grid().pane(place).geometry();
            QVERIFY(std::abs(mean(twice, rect) - mean(saved, rect)) <= 3);
        }
    }

    void aPageIsGivenUpWhereAPaneWillNotCome() {
        waitUntilRest();
        window().otfs().setRun([](const DesignerConfig&, const DesignerInput&, const Progress& progress) {
            while (!progress.cancelled()) std::this_thread::yield();
            return std::optional<Design>();
        });
        window().document().edit(withPane(document(), 1, {.designer = OtsuConfig{}}), "designer");
        QTRY_VERIFY(window().otfs().busy());
        const QString path = temporaryFolder().filePath("given-up.html");
        window().compareRoom().savePage(path);
        QVERIFY(!window().idle());
        window().otfs().cancel();
        waitUntilRest();
        QVERIFY(!QFile::exists(path));
        QVERIFY(!child<QAbstractButton>("designer.compute")->isHidden());
        QVERIFY(!panel().rows()[1].contrast);
    }
};

ECHOLUCENT_TEST_CLASS(TestCompareLessons, "aSessionOfAFigureIsTheSameInAnotherWindow")

#include "test_compare_lessons.moc"
