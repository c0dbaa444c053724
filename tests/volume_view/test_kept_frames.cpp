// A motion that plays comes from memory from its second turn on, and nothing stale ever does.
#include <QTest>

#include "tests/volume_view/commanded_caster.h"

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

QTEST_GUILESS_MAIN(KeptFramesTest)
#include "test_kept_frames.moc"
