// The document's one undo stack: what is a step, what belongs to one step, and that nothing is lost.
#include <QSignalSpy>
#include <QTest>
#include <functional>
#include <random>

#include "io/document/document_file.h"
#include "tests/inputs.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/document/document_model.h"

using namespace echolucent;

namespace {

/// The default document with a second pane.
Document twoPanes() {
    Document document;
    document.panes.push_back({.curve = CurveKind::linear});
    return document;
}

using Change = std::function<void(Document&, std::mt19937&)>;

double share(std::mt19937& random) { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }

/// Every kind of value that a person can set, each with a random value.
const std::vector<Change>& changes() {
    static const std::vector<Change> all{
        [](Document& d, auto& random) { d.scene.pose.direction.azimuth = 360 * share(random) - 180; },
        [](Document& d, auto& random) { d.scene.pose.offsetMm[1] = share(random); },
        [](Document& d, auto& random) { d.scene.pose.magnification = 0.1 + share(random); },
        [](Document& d, auto& random) { d.scene.front.depthMm = 30 * share(random); },
        [](Document& d, auto& random) {
            d.beam = {static_cast<BeamAxis>(random() % 6), BeamSource::person};
            d.scene.pose = Pose{};
        },
        [](Document& d, auto& random) { d.scene.look.mode = static_cast<RenderMode>(random() % 4); },
        [](Document& d, auto& random) { d.scene.look.colourMap = static_cast<ColourMap>(random() % 3); },
        [](Document& d, auto& random) { d.panes.at(random() % 2).curve = allCurveKinds[random() % 5]; },
        [](Document& d, auto& random) {
            d.curves.manual.nodes.push_back({1.0, share(random)});
        },
        [](Document& d, auto& random) { d.curves.linear.slope = share(random); },
        [](Document& d, auto& random) { d.curves.parabolic.scale = share(random); },
        [](Document& d, auto& random) { d.scene.look.light.azimuthDegrees = 360 * share(random) - 180; },
        [](Document& d, auto& random) { d.method.config.grid.columns = 1 + static_cast<int>(random() % 40); },
        [](Document& d, auto& random) { d.method.initialScale = share(random); },
        [](Document& d, auto& random) { d.method.initial = static_cast<InitialKind>(random() % 4); },
        [](Document& d, auto& random) { d.scene.side.elevation = share(random); },
        [](Document& d, auto& random) { d.motion.otf = allMotionOtfs[random() % allMotionOtfs.size()]; },
    };
    return all;
}

}  // namespace

class TestDocumentModel : public QObject {
    Q_OBJECT

private slots:
    void aDragThatIsTakenBackLeavesAMotionThatGoesOn() {
        DocumentModel model;
        model.showFrame(10, model.document().scene.phase);
        Document next = model.document();
        next.scene.look.light.azimuthDegrees = 12;
        model.preview(next, "move light");
        model.showFrame(11, model.document().scene.phase);
        model.cancelPreview();
        QCOMPARE(model.document().scene.motionAngle, 11.0);
        QVERIFY(model.document().scene.look.light == lookAtStart().light);

        next = model.document();
        next.scene.pose.direction.azimuth = 30;
        next.scene.motionAngle = 0;  // the hand on the camera ends the motion
        model.preview(next, "turn view");
        model.cancelPreview();
        QCOMPARE(model.document().scene.motionAngle, 11.0);
        QVERIFY(model.document().scene.pose == Pose{});
    }

    void randomActionsUndoneOneByOneGiveTheFirstDocument_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= (takesSomeInputs ? 5 : 20); ++seed) QTest::addRow("seed %u", seed) << seed;
    }

    void randomActionsUndoneOneByOneGiveTheFirstDocument() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        DocumentModel model;
        model.begin(twoPanes());
        std::vector<std::string> history{jsonOf(model.document())};
        int gesture = 0;
        for (int action = 0; action < 200; ++action) {
            Document next = model.document();
            changes()[random() % changes().size()](next, random);
            const int count = model.steps().count();
            switch (random() % 3) {
                case 0:  // a typed value
                    model.edit(next, "value");
                    break;
                case 1:  // a burst: only what it ends with can be undone
                    ++gesture;
                    for (int i = 0; i < 3; ++i) {
                        next.scene.pose.magnification = 0.1 + share(random);
                        model.edit(next, "zoom", gesture);
                    }
                    break;
                case 2:  // a drag, sometimes taken back
                    for (int i = 0; i < 3; ++i) {
                        next.scene.front.depthMm = share(random);
                        model.preview(next, "cut");
                    }
                    random() % 4 == 0 ? model.cancelPreview() : model.commitPreview();
                    break;
            }
            QVERIFY(model.steps().count() - count <= 1);
            if (model.steps().count() > count) history.push_back(jsonOf(model.document()));
            QCOMPARE(jsonOf(model.document()), history.back());
        }
        QVERIFY(history.size() > 100);
        QCOMPARE(model.steps().count(), static_cast<int>(history.size()) - 1);
        for (std::size_t i = history.size() - 1; i-- > 0;) {
            model.steps().undo();
            QCOMPARE(jsonOf(model.document()), history[i]);
        }
        QVERIFY(!model.steps().canUndo());
        QVERIFY(model.document() == twoPanes());
        while (model.steps().canRedo()) model.steps().redo();
        QCOMPARE(jsonOf(model.document()), history.back());
    }

    void whatPlaysIsNoStepAndStaysThroughUndo() {
        DocumentModel model;
        Document next = model.document();
        next.curves.linear.slope = 0.25;
        model.edit(next, "slope");
        QSignalSpy phases(&model, &DocumentModel::phaseChanged);
        QSignalSpy frames(&model, &DocumentModel::motionAngleChanged);
        model.showPhase(3);
        model.showFrame(12, model.document().scene.phase);
        QCOMPARE(phases.count(), 1);
        QCOMPARE(frames.count(), 1);
        QCOMPARE(model.steps().count(), 1);
        model.steps().undo();
        QCOMPARE(model.document().curves.linear.slope, 0.5);
        QCOMPARE(phaseOf(model.document(), firstPane), 3);
        QCOMPARE(model.document().scene.motionAngle, 12.0);
        QCOMPARE(phases.count() + frames.count(), 2);
    }

    void aStepMayEndTheMotionInItsFrame() {
        DocumentModel model;
        model.showFrame(20, model.document().scene.phase);
        Document next = model.document();
        next.scene.pose = shownPose(next);
        next.scene.motionAngle = 0;
        model.edit(next, "turn");
        QCOMPARE(model.document().scene.pose.direction.azimuth, 20.0);
        QCOMPARE(model.document().scene.motionAngle, 0.0);
        model.steps().undo();
        QCOMPARE(model.document().scene.pose.direction.azimuth, 0.0);
        QCOMPARE(model.document().scene.motionAngle, 0.0);
    }

    /// Whatever is done while panes are looked at, steps and the document's own value are those of a model where nobody
    /// looks, unless a pane itself is changed.
    void panesThatAreLookedAtAreNoPartOfSteps() {
        DocumentModel looking, plain;
        const std::vector<Pane> added{{.curve = CurveKind::linear}, {.curve = CurveKind::quartic}};
        const auto both = [&](const auto& act) {
            act(looking);
            act(plain);
        };
        both([](DocumentModel& model) {
            model.change("zoom", [](Document& next) { next.scene.pose.magnification = 2; });
        });
        looking.lookAtPanes(added);
        QCOMPARE(looking.document().panes.size(), std::size_t{3});
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, looking.lookAtPanes(added));
        both([](DocumentModel& model) {
            model.change("turn", [](Document& next) { next.scene.pose.direction.azimuth = 30; });
        });
        both([](DocumentModel& model) { model.steps().setIndex(0); });
        QCOMPARE(looking.document().panes.size(), std::size_t{3});
        both([](DocumentModel& model) { model.steps().setIndex(2); });
        QVERIFY(looking.ownDocument() == plain.document());
        QCOMPARE(looking.steps().count(), plain.steps().count());
        looking.endLookAtPanes();
        QVERIFY(looking.document() == plain.document());

        looking.lookAtPanes(added);
        looking.change("OTF of pane 2", [](Document& next) { next.panes[1].curve = CurveKind::manual; });
        QCOMPARE(looking.steps().count(), plain.steps().count() + 1);
        QCOMPARE(looking.ownDocument().panes.size(), std::size_t{3});
        looking.steps().undo();
        QVERIFY(looking.ownDocument() == plain.document());
        looking.steps().redo();
        looking.endLookAtPanes();
        QCOMPARE(looking.document().panes.size(), std::size_t{3});
        QCOMPARE(looking.document().panes[1].curve, CurveKind::manual);

        // A document that begins is looked at in the same way; one with panes of its own is not.
        looking.begin(Document{});
        QCOMPARE(looking.document().panes.size(), std::size_t{1});
        looking.lookAtPanes(added);
        looking.begin(plain.document());
        QVERIFY(looking.ownDocument() == plain.document());
        QCOMPARE(looking.document().panes.size(), std::size_t{3});
        Document several;
        several.panes.insert(several.panes.end(), added.begin(), added.end());
        looking.begin(several);
        QVERIFY(looking.ownDocument() == several);
    }

    /// The panes of a state, and those of a snapshot, are their own, even if somebody looks at the same ones meanwhile.
    void panesOfAStateAreItsOwnWhoeverLooks() {
        DocumentModel model;
        const std::vector<Pane> added{{.curve = CurveKind::linear}, {.curve = CurveKind::quartic}};
        Document several;
        several.panes.insert(several.panes.end(), added.begin(), added.end());
        model.edit(several, "panes");
        model.steps().undo();
        model.lookAtPanes(added);
        QVERIFY(model.ownDocument() == Document{});
        QSignalSpy changed(&model, &DocumentModel::changed);
        model.steps().redo();
        QVERIFY(model.ownDocument() == several);
        QCOMPARE(changed.count(), 1);  // the room asks whose panes it shows
        model.endLookAtPanes();
        QVERIFY(model.document() == several);
        model.steps().undo();
        QVERIFY(model.document() == Document{});
        model.lookAtPanes(added);
        model.editWithFrame(several, "snapshot");
        QVERIFY(model.ownDocument() == several);
        QCOMPARE(model.steps().count(), 1);
        model.steps().undo();
        QVERIFY(model.ownDocument() == Document{});
    }

    void eachPartHasItsSignal() {
        DocumentModel model;
        model.begin(twoPanes());
        QSignalSpy poses(&model, &DocumentModel::poseChanged), cuts(&model, &DocumentModel::frontChanged),
            looks(&model, &DocumentModel::lookChanged), curves(&model, &DocumentModel::curvesChanged),
            method(&model, &DocumentModel::methodChanged), motion(&model, &DocumentModel::motionChanged),
            panes(&model, &DocumentModel::panesChanged), beam(&model, &DocumentModel::beamChanged),
            study(&model, &DocumentModel::studyChanged), all(&model, &DocumentModel::changed);
        const std::vector<QSignalSpy*> parts{&poses, &cuts, &looks, &curves, &method, &motion, &panes, &beam, &study};
        const std::vector<std::function<void(Document&)>> edits{
            [](Document& d) { d.scene.pose.magnification = 2; },
            [](Document& d) { d.scene.front.depthMm = 2; },
            [](Document& d) { d.scene.look.mode = RenderMode::mean; },
            [](Document& d) { d.curves.quartic.scale = 2; },
            [](Document& d) { d.method.initialScale = 2; },
            [](Document& d) { d.motion.pingPong = false; },
            [](Document& d) { d.panes.at(1).curve = CurveKind::quartic; },
            [](Document& d) { d.beam.source = BeamSource::person; },
            [](Document& d) { d.study = SimulatedScan{}; }};
        for (std::size_t edited = 0; edited < edits.size(); ++edited) {
            Document next = model.document();
            edits[edited](next);
            model.edit(next, "edit");
            for (std::size_t part = 0; part < parts.size(); ++part)
                QCOMPARE(parts[part]->count(), part <= edited ? 1 : 0);
            QCOMPARE(all.count(), static_cast<int>(edited) + 1);
        }
        model.edit(model.document(), "nothing");
        QCOMPARE(all.count(), static_cast<int>(edits.size()));
        QCOMPARE(model.steps().count(), static_cast<int>(edits.size()));
    }

    void whatIsKnownOfTheStudysBytesIsNoStepAndStays() {
        DocumentModel model;
        StudyFile file{.path = "/data/scan.mha", .options = {}, .checksum = {}};
        Document begun;
        begun.study = file;
        model.begin(begun);
        Document next = model.document();
        next.scene.pose.magnification = 2;
        model.edit(next, "zoom");
        next.scene.pose.magnification = 3;
        model.preview(next, "zoom");
        QSignalSpy study(&model, &DocumentModel::studyChanged), changed(&model, &DocumentModel::changed);
        file.checksum = "xxh3-128:00";
        file.bytes = 12;
        file.files = 1;
        model.noteChecksum(file);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(model.steps().count(), 1);
        const auto known = [&] { return model.document().study == StudyReference(file); };
        QVERIFY(known());
        model.commitPreview();
        QCOMPARE(model.steps().count(), 2);
        QVERIFY(known());
        model.steps().undo();
        model.steps().undo();
        QVERIFY(known());
        model.steps().redo();
        model.edit(next, "zoom");  // of before it was known
        QVERIFY(known());
        QCOMPARE(study.count(), 0);
        file.path = "/data/other.mha";
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, model.noteChecksum(file));
    }

    void aGestureThatEndsWhereItBeganIsNoStep() {
        DocumentModel model;
        const Document before = model.document();
        Document next = before;
        next.scene.front.depthMm = 5;
        model.edit(next, "cut", 1);
        QCOMPARE(model.steps().count(), 1);
        model.edit(before, "cut", 1);
        QCOMPARE(model.steps().count(), 0);
        model.edit(next, "cut", 2);
        next.curves.linear.slope = 0.1;
        model.edit(next, "slope", 2);  // another value, though the same gesture
        QCOMPARE(model.steps().count(), 2);
        model.preview(before, "all");
        model.preview(next, "all");
        model.commitPreview();
        QCOMPARE(model.steps().count(), 2);
    }

    void aStepThatSetsTheFrameBringsItBack() {
        DocumentModel model;
        Document next = model.document();
        next.curves.linear.slope = 0.25;
        model.edit(next, "slope");
        model.showFrame(12, 2);
        const Document before = model.document();
        next = before;
        next.curves.quartic.scale = 3;
        next.scene.motionAngle = 30;
        model.editWithFrame(next, "figure");
        model.showFrame(-5, 1);
        model.steps().undo();
        QVERIFY(model.document() == before);
        model.showFrame(1, 0);
        model.steps().redo();
        QVERIFY(model.document() == next);
        model.showFrame(2, 0);
        model.steps().setIndex(0);  // over the figure and the slope, which alone would keep the frame
        QVERIFY(model.document() == withShown(Document{}, before));
        model.showFrame(3, 0);
        model.steps().redo();
        QCOMPARE(model.document().scene.motionAngle, 3.0);
        next = model.document();
        next.scene.motionAngle = 30;
        const int steps = model.steps().count();
        model.editWithFrame(next, "figure");  // nothing but another frame
        QCOMPARE(model.document().scene.motionAngle, 30.0);
        QCOMPARE(model.steps().count(), steps);
    }

    void undoDuringADragTakesTheDragBackToo() {
        DocumentModel model;
        Document next = model.document();
        next.curves.linear.slope = 0.25;
        model.edit(next, "slope");
        next.scene.front.depthMm = 5;
        model.preview(next, "cut");
        QVERIFY(model.previewing());
        model.steps().undo();
        QVERIFY(!model.previewing());
        QVERIFY(model.document() == Document{});
        model.commitPreview();
        QVERIFY(model.steps().canRedo());
    }

    void aSlotThatEditsFindsEveryPartChanged() {
        DocumentModel model;
        double seen = -1;
        connect(&model, &DocumentModel::frontChanged, this, [&] {
            seen = model.document().curves.linear.slope;
            Document next = model.document();
            next.curves.quartic.scale = 3;
            model.edit(next, "follows");
        });
        QSignalSpy curves(&model, &DocumentModel::curvesChanged);
        Document next = model.document();
        next.scene.front.depthMm = 1;
        next.curves.linear.slope = 0.125;
        model.edit(next, "both");
        QCOMPARE(seen, 0.125);
        QVERIFY(curves.count() >= 1);
        QCOMPARE(model.document().curves.quartic.scale, 3.0);
        QCOMPARE(model.document().curves.linear.slope, 0.125);
    }
};

ECHOLUCENT_TEST_CLASS(TestDocumentModel)
#include "test_document_model.moc"
