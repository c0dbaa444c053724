// What the steps keep: documents that share what did not change, within a bound, the newest step in any case.
#include <QSignalSpy>
#include <QTest>
#include <random>

#include "io/document/document_file.h"
#include "tests/inputs.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/document/document_model.h"

using namespace echolucent;

namespace {

/// A surface of a MB.
CutSurface largeSurface(float depthMm) {
    constexpr int nodes = 500;
    return {.columns = nodes, .rows = nodes, .depthMm = std::vector<float>(nodes * nodes, depthMm)};
}

ScalpelStroke stroke(double at, std::size_t places = 3) {
    return {.places = std::vector<std::array<double, 2>>(places, {at, at})};
}

/// What a hand does of that which may be large, and of that which is small.
void change(Document& document, std::mt19937& random) {
    const double value = std::uniform_real_distribution<double>(0.0, 1.0)(random);
    switch (random() % 6) {
        case 0: document.scene.pose.magnification = 0.1 + value; break;
        case 1: document.scene.strokes.push_back(stroke(value, 3 + random() % 50)); break;
        case 2:
            document.scene.strokes.change([&](std::vector<ScalpelStroke>& strokes) {
                if (!strokes.empty())
                    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(random() % strokes.size()));
            });
            break;
        case 3:
            document.measurements.push_back(
                {.id = static_cast<int>(document.measurements.size()) + 1, .placesMm = {{0, 0, value}, {1, 0, 0}}});
            break;
        case 4:
            document.scene.front.surface = CutSurface{.columns = 2, .rows = 2};
            document.scene.front.surface->depthMm = std::vector<float>(4, static_cast<float>(value));
            break;
        default: document.scene.strokes.clear(); break;
    }
}

}  // namespace

class TestDocumentSteps : public QObject {
    Q_OBJECT

private slots:
    void whatIsUndoneAndDoneAgainIsTheSameAtEveryStepKept_data() {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<std::size_t>("mostBytes");
        for (unsigned seed = 1; seed <= 3; ++seed) {
            QTest::addRow("seed %u, all kept", seed) << seed << DocumentSteps::mostBytesKept;
            QTest::addRow("seed %u, some dropped", seed) << seed << 100 * sizeof(Document);
            QTest::addRow("seed %u, one kept", seed) << seed << std::size_t{1};
        }
    }
    void whatIsUndoneAndDoneAgainIsTheSameAtEveryStepKept() {
        QFETCH(unsigned, seed);
        QFETCH(std::size_t, mostBytes);
        std::mt19937 random(seed);
        DocumentModel model(nullptr, mostBytes);
        DocumentSteps& steps = model.steps();
        Document begun;
        for (int i = 0; i < 10; ++i) change(begun, random);
        model.begin(begun);
        std::vector<Document> states{begun};
        int gesture = 0;
        while (states.size() < 250) {
            Document next = model.document();
            change(next, random);
            switch (random() % 4) {
                case 0: model.edit(next, "one"); break;
                case 1:
                    model.edit(next, "held", ++gesture);
                    change(next, random);
                    model.edit(next, "held", gesture);
                    break;
                case 2:
                    model.preview(next, "drag");
                    change(next, random);
                    model.preview(next, "drag");
                    random() % 3 == 0 ? model.cancelPreview() : model.commitPreview();
                    break;
                default:
                    for (auto back = random() % 4; back > 0 && steps.canUndo(); --back) {
                        steps.undo();
                        states.pop_back();
                    }
                    break;
            }
            if (steps.index() + steps.dropped() == static_cast<int>(states.size())) states.push_back(model.document());
            QCOMPARE(steps.index() + steps.dropped(), static_cast<int>(states.size()) - 1);
            QVERIFY(model.document() == states.back());
            QVERIFY(steps.bytes() <= mostBytes || steps.count() <= 1);
        }
        QCOMPARE(steps.dropped() == 0, mostBytes == DocumentSteps::mostBytesKept);
        QVERIFY(mostBytes > 1 || steps.count() == 1);
        while (steps.canRedo()) steps.redo();
        const int last = steps.index();
        while (steps.canUndo()) {
            steps.undo();
            const Document& state = states[static_cast<std::size_t>(steps.index() + steps.dropped())];
            QVERIFY(model.document() == state);
            QCOMPARE(jsonOf(model.document()), jsonOf(state));
        }
        if (steps.dropped() == 0) QCOMPARE(jsonOf(model.document()), jsonOf(begun));
        while (steps.canRedo()) {
            steps.redo();
            QVERIFY(model.document() == states[static_cast<std::size_t>(steps.index() + steps.dropped())]);
        }
        QCOMPARE(steps.index(), last);
        QCOMPARE(jsonOf(model.document()), jsonOf(states.back()));
    }

    /// The list of strokes itself grows with each step, their places and the surface are kept once.
    void manyStrokesBesideALargeSurfaceStayWithinTheBound() {
        const int strokes = takesSomeInputs ? 2'500 : 10'000;
        DocumentModel model;
        Document begun;
        begun.scene.front.surface = largeSurface(1);
        model.begin(begun);
        std::size_t most = 0;
        for (int i = 0; i < strokes; ++i) {
            Document next = model.document();
            next.scene.strokes.push_back(stroke(i, 100));
            model.edit(next, "cut");
            most = std::max(most, model.steps().bytes());
        }
        QVERIFY2(most <= DocumentSteps::mostBytesKept, qPrintable(QString::number(most)));
        QVERIFY(model.steps().dropped() > 0);
        QCOMPARE(model.steps().count() + model.steps().dropped(), strokes);
        QVERIFY2(model.steps().count() >= 20, qPrintable(QString::number(model.steps().count())));
        model.steps().undo();
        QCOMPARE(model.document().scene.strokes.size(), static_cast<std::size_t>(strokes - 1));
        QVERIFY(model.document().scene.front.surface->depthMm.sharesWith(begun.scene.front.surface->depthMm));
    }

    void aThousandPosesBesideALargeSurfaceKeepItOnce() {
        DocumentModel model;
        Document next;
        next.scene.front.surface = largeSurface(1);
        model.begin(next);
        const std::size_t begun = model.steps().bytes();
        for (int i = 1; i <= 1'000; ++i) {
            next.scene.pose.direction.azimuth = i * 0.1;
            next.scene.front.surface = largeSurface(1);  // equal, and not the one that is kept
            model.edit(next, "turn");
        }
        QCOMPARE(model.steps().dropped(), 0);
        QVERIFY2(model.steps().bytes() < begun + 1'000 * 2 * sizeof(Document),
                 qPrintable(QString::number(model.steps().bytes())));
    }

    void aStepAboveTheBoundIsUndoneAllTheSame() {
        DocumentModel model(nullptr, 500'000);
        const Document begun = model.document();
        Document next = begun;
        for (const float depth : {1.0F, 2.0F}) {
            next.scene.front.surface = largeSurface(depth);
            model.edit(next, "bow");
        }
        QCOMPARE(model.steps().count(), 1);
        QCOMPARE(model.steps().dropped(), 1);
        QVERIFY(model.steps().bytes() > model.steps().mostBytes());
        model.steps().undo();
        QCOMPARE(model.document().scene.front.surface->depthMm[0], 1.0F);
        QVERIFY(!model.steps().canUndo());
        next = begun;
        next.scene.pose.magnification = 2;
        model.edit(next, "zoom");  // the large surface is behind the step that is kept
        QCOMPARE(model.steps().count(), 1);
        next.scene.pose.magnification = 3;
        model.edit(next, "zoom");
        QVERIFY(model.steps().bytes() <= 3 * 2 * sizeof(Document));
        model.begin(begun);
        QCOMPARE(model.steps().dropped(), 0);
    }

    void aPreviewCopiesNothingLarge() {
        DocumentModel model;
        Document begun;
        begun.scene.front.surface = largeSurface(1);
        begun.scene.strokes = {stroke(0.1, 1'000), stroke(0.2, 1'000)};
        begun.measurements = {{.id = 1, .placesMm = {{0, 0, 0}, {1, 0, 0}}}};
        model.begin(begun);
        const auto sharesAll = [&] {
            const Document& document = model.document();
            return document.scene.front.surface->depthMm.sharesWith(begun.scene.front.surface->depthMm) &&
                   document.scene.strokes.sharesWith(begun.scene.strokes) &&
                   document.measurements.sharesWith(begun.measurements);
        };
        for (int i = 1; i <= 3; ++i) {
            Document next = model.document();
            next.scene.pose.direction.azimuth = i;
            model.preview(next, "turn");
            QVERIFY(sharesAll());
        }
        model.cancelPreview();
        QVERIFY(sharesAll());
        Document next = begun;
        next.scene.strokes.push_back(stroke(0.3));
        model.preview(next, "cut");
        model.preview(begun, "cut");
        QVERIFY(sharesAll());
        model.preview(next, "cut");
        model.commitPreview();
        for (std::size_t i = 0; i < begun.scene.strokes.size(); ++i)
            QVERIFY(model.document().scene.strokes[i].places.sharesWith(begun.scene.strokes[i].places));
        model.steps().undo();
        QVERIFY(sharesAll());
    }

    void stepsAreToldOnceTheirDocumentIsShown() {
        DocumentModel model;
        Document next = model.document();
        std::vector<double> seen;
        connect(&model.steps(), &DocumentSteps::changed, this,
                [&] { seen.push_back(model.document().scene.pose.magnification); });
        for (const double magnification : {2.0, 3.0}) {
            next.scene.pose.magnification = magnification;
            model.edit(next, QString("zoom %1").arg(magnification));
        }
        QCOMPARE(model.steps().undoText(), "zoom 3");
        QCOMPARE(model.steps().redoText(), "");
        model.steps().undo();
        QCOMPARE(model.steps().undoText(), "zoom 2");
        QCOMPARE(model.steps().redoText(), "zoom 3");
        model.steps().setIndex(-5);
        QCOMPARE(model.steps().undoText(), "");
        model.steps().undo();  // nothing is left
        model.steps().setIndex(7);
        QCOMPARE(seen, (std::vector<double>{2, 3, 2, 1, 3}));
        QCOMPARE(model.steps().text(0), "zoom 2");
        QCOMPARE(model.steps().text(2), "");
    }
};

ECHOLUCENT_TEST_CLASS(TestDocumentSteps)
#include "test_document_steps.moc"
