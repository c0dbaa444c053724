// A motion that plays comes from memory from its second turn on, and nothing stale ever does.
#include <QTest>
#include <atomic>
#include <thread>

#include "tests/casting/commanded_caster.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class KeptFramesTest : public QObject {
    Q_OBJECT

private slots:
    void aMotionComesFromMemoryInItsSecondTurn() {
        Setup s;
        s.caster.setPlaying(true);
        const std::vector<double> frames{0.1, 0.2, 0.3};
        for (std::size_t i = 0; i < frames.size(); ++i) {
            s.caster.request(s.turned(frames[i]));
            QTRY_COMPARE_WITH_TIMEOUT(s.caster.keptFrames(), static_cast<int>(i) + 1, patience);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        const int cast = s.commands.started();
        for (int turn = 0; turn < 2; ++turn)
            for (const double frame : frames) {
                s.delivered.clear();
                s.caster.request(s.turned(frame));
                QTRY_VERIFY_WITH_TIMEOUT(!s.delivered.empty(), patience);
                QCOMPARE(s.delivered.front()->quality, highQuality);
                QVERIFY(samePicture(s.delivered.front()->request, s.turned(frame)));
            }
        // Nothing but the frame that stayed was cast again.
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(s.commands.started() <= cast + 1);
        // Another picture that is none of the motion's drops them.
        s.caster.setPlaying(false);
        s.caster.request(s.turned(0.9));
        QCOMPARE(s.caster.keptFrames(), 0);
    }

    void aCoarseFrameIsFollowedByAFineOneThatIsKept() {
        Setup s;
        s.caster.setPlaying(true);
        s.caster.request(s.turned(0.1));
        QTRY_COMPARE_WITH_TIMEOUT(s.caster.keptFrames(), 1, patience);
        QVERIFY(s.delivered.front()->quality > highQuality);  // something is seen at once
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(s.delivered.back()->converged());  // the frame that stays becomes as fine as at rest
    }

    void aFrameThatIsCastIsKeptAlthoughAnotherVolumeIsWanted() {
        std::atomic<bool> begun = false, go = false;
        Setup s;
        ProgressiveCaster caster(s.works, PreviewQuality{0.0},
                                 [&](const PictureRequest& request, const Progress& progress) -> CastResult {
                                     const bool fine = request.settings.step == qualities[highQuality].step;
                                     begun = begun || fine;
                                     while (fine && !go && !progress.cancelled()) std::this_thread::yield();
                                     return s.commands(request, progress);
                                 });
        caster.setPlaying(true);
        caster.request(s.turned(0.1));
        QTRY_VERIFY_WITH_TIMEOUT(begun, patience);
        // As a view does it when the next phase is to be shown.
        PictureRequest next = s.turned(0.2);
        next.panes[0].volume = volumeOf(geometryOf(3, 3, 3), [](double, double, double) { return 5; });
        caster.clear();
        caster.request(next);
        go = true;
        QTRY_COMPARE_WITH_TIMEOUT(caster.keptFrames(), 2, patience);
    }

    void aConvergedFrameFromMemoryIsRefinedNoFurther() {
        Setup s;
        // Where time is plenty, a frame is converged at once, and kept so.
        Works works;
        ProgressiveCaster caster{
            works, PreviewQuality{1e9},
            [&](const PictureRequest& request, const Progress& progress) { return s.commands(request, progress); }};
        std::vector<std::shared_ptr<const CastPicture>> delivered;
        connect(&caster, &ProgressiveCaster::delivered,
                [&](const std::shared_ptr<const CastPicture>& picture) { delivered.push_back(picture); });
        caster.setPlaying(true);
        for (const double frame : {0.1, 0.2, 0.3}) {
            delivered.clear();
            caster.request(s.turned(frame));
            QTRY_VERIFY_WITH_TIMEOUT(!delivered.empty() && !caster.busy(), patience);
        }
        QVERIFY(delivered.front()->converged());
        caster.request(s.turned(0.4));
        QTRY_VERIFY_WITH_TIMEOUT(!caster.busy(), patience);
        const int cast = s.commands.started();
        delivered.clear();
        caster.request(s.turned(0.3));
        QTRY_VERIFY_WITH_TIMEOUT(!delivered.empty(), patience);
        QVERIFY(delivered.front()->converged());
        QTRY_VERIFY_WITH_TIMEOUT(!caster.busy(), patience);
        caster.setPlaying(false);
        QTRY_VERIFY_WITH_TIMEOUT(!caster.busy(), patience);
        QCOMPARE(s.commands.started(), cast);
    }

    void anotherLookIsNoFrameOfTheMotion() {
        Setup s;
        s.caster.setPlaying(true);
        s.caster.request(s.turned(0.1));
        QTRY_COMPARE_WITH_TIMEOUT(s.caster.keptFrames(), 1, patience);
        PictureRequest other = s.turned(0.1);
        other.settings.colourMap = ColourMap::ice;
        const int cast = s.commands.started();
        s.caster.request(other);
        QTRY_VERIFY_WITH_TIMEOUT(s.commands.started() > cast, patience);
        QTRY_COMPARE_WITH_TIMEOUT(s.caster.keptFrames(), 2, patience);
    }
};

ECHOLUCENT_TEST_CLASS(KeptFramesTest)
#include "test_kept_frames.moc"
