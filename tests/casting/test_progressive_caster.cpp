#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "processing/ray_caster/ray_caster.h"
#include "tests/casting/commanded_caster.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

float levelOf(const CastPicture& picture) { return picture.panes.front().picture->rgba.front(); }

}  // namespace

class ProgressiveCasterTest : public QObject {
    Q_OBJECT

private slots:
    void betterAndBetterUntilConverged() {
        Setup s;
        s.caster.request(s.request(0.5));
        QTRY_COMPARE_WITH_TIMEOUT(s.delivered.size(), std::size_t{3}, patience);
        QVERIFY(s.delivered[0]->panes.front().picture->width < 120);
        QVERIFY(s.delivered[0]->followsHand && !s.delivered[0]->converged());
        // In visible steps, each of full size and a finer step.
        QCOMPARE(s.delivered[1]->panes.front().picture->width, 120);
        QCOMPARE(s.delivered[1]->panes.front().picture->height, 90);
        QVERIFY(!s.delivered[1]->followsHand && !s.delivered[1]->converged());
        QVERIFY(s.delivered[2]->settings.step < s.delivered[1]->settings.step);
        QCOMPARE(s.delivered[2]->panes.front().picture->width, 120);
        QCOMPARE(s.delivered[2]->panes.front().picture->height, 90);
        QVERIFY(!s.delivered[2]->followsHand && s.delivered[2]->converged());
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        // No quality is cast twice.
        QCOMPARE(s.commands.started(), 3);
    }

    void forACardItIsPreparedInMotionAndAtRest() {
        Setup s;
        s.caster.request(s.request(0.5), true);
        QTRY_COMPARE_WITH_TIMEOUT(s.delivered.size(), std::size_t{2}, patience);
        QCOMPARE(s.commands.started(), 0);  // nothing is cast
        const std::vector<RayCastSettings> made = s.cardCommands.startedSettings();
        QCOMPARE(made.size(), std::size_t{2});
        QCOMPARE(made[0].width, 120);
        QCOMPARE(made[0].step, qualities[qualityForCard].step);
        QCOMPARE(made[0].lightCoarseness, 2 * made[1].lightCoarseness);
        QVERIFY(s.delivered[0]->byCard && s.delivered[0]->followsHand && !s.delivered[0]->converged());
        QVERIFY(s.delivered[1]->byCard && s.delivered[1]->converged());
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        s.caster.request(s.request(0.5), true);
        QVERIFY(!s.caster.busy());
        // The other renderer makes the same picture, and what was made for the card is let go.
        s.caster.request(s.request(0.5), false);
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(!s.delivered.back()->byCard && s.delivered.back()->converged());
        QCOMPARE(s.cardCommands.lettingGo(), 1);
        QCOMPARE(s.commands.lettingGo(), 1);  // when the card began
        QCOMPARE(s.cardCommands.started(), 2);
    }

    void aSlowCardDrawsFewerPixelsInMotion() {
        Setup s;
        s.caster.request(s.request(0.5), true);
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        for (int i = 0; i < 5; ++i) s.caster.drawnByCard(s.delivered.front()->settings, 500.0);
        s.caster.request(s.request(0.6), true);
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        const std::vector<RayCastSettings> made = s.cardCommands.startedSettings();
        QCOMPARE(made.size(), std::size_t{4});
        QVERIFY(made[2].width < 60);
        QCOMPARE(made[3].width, 120);
        // However quick it is, light in motion stays coarse.
        for (int i = 0; i < 20; ++i) s.caster.drawnByCard(s.delivered.front()->settings, 1e-3);
        s.caster.request(s.request(0.7), true);
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.cardCommands.startedSettings()[4].step, qualities[qualityForCard].step);
    }

    void whatACardWasToDrawIsNotShownAfterASwitch() {
        Setup s;
        s.cardCommands.hold();
        s.caster.request(s.request(0.5), true);
        QTRY_COMPARE_WITH_TIMEOUT(s.cardCommands.started(), 1, patience);
        s.caster.request(s.request(0.5), false);
        s.cardCommands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(!s.delivered.empty());
        for (const auto& picture : s.delivered) QVERIFY(!picture->byCard);
        QCOMPARE(s.cardCommands.lettingGo(), 1);  // even if the card's job ran when the other came
    }

    void theStepOfTheLookCounts() {
        Setup s;
        PictureRequest fine = s.request(0.5);
        fine.settings.step = 0.25;
        s.caster.request(fine);
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.delivered.back()->settings.step, 0.25 * convergedStep);
        QCOMPARE(s.delivered.back()->request.settings.step, 0.25);
    }

    void aRequestEqualToTheNewestDoesNothing() {
        Setup s;
        s.caster.request(s.request(0.5));
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        const int before = s.commands.started();
        for (int i = 0; i < 10; ++i) s.caster.request(s.request(0.5));
        QVERIFY(!s.caster.busy());
        QCOMPARE(s.commands.started(), before);
    }

    void everyPartOfARequestMatters_data() {
        QTest::addColumn<int>("part");
        for (int part = 0; part < 16; ++part) QTest::addRow("%d", part) << part;
    }
    void everyPartOfARequestMatters() {
        QFETCH(int, part);
        Setup s;
        const PictureRequest a = s.request(0.5);
        PictureRequest b = a;
        switch (part) {
            case 0: b.panes[0].volume = std::make_shared<const Volume>(*a.panes[0].volume); break;
            case 1: b.panes[0].classification = PowerCurve{}; break;
            case 2: b.settings.camera.focalPoint[1] += 1e-9; break;
            case 3: b.settings.camera.frame = frameOf({BeamAxis::plusZ, 1e-6, 0, 0}); break;
            case 4: b.settings.camera.heightMm = 2; break;
            case 5: b.settings.front = CuttingFace{b.settings.camera.frame.forward, 3}; break;
            case 6: b.settings.shading = Shading{}; break;
            case 7: b.settings.colourMap = ColourMap::ice; break;
            case 8: b.settings.height = 91; break;
            case 9: b.settings.camera.projection = Projection::perspective; break;
            case 10: b.settings.interpolation = Interpolation::nearest; break;
            case 11: b.settings.mode = RenderMode::mean; break;
            case 12: b.settings.depthColouring = DepthColouring{}; break;
            case 13: b.settings.step = 0.75; break;
            case 14: b.panes[0].pane = 1; break;
            case 15: b.panes.push_back(a.panes[0]); break;
            default: break;
        }
        QVERIFY(samePicture(a, a));
        QVERIFY(!samePicture(a, b));
    }

    void theCurveMattersInDirectModeOnly() {
        Setup s;
        PictureRequest a = s.request(0.5), b = s.request(0.75);
        QVERIFY(!samePicture(a, b));
        a.settings.mode = b.settings.mode = RenderMode::maximum;
        QVERIFY(samePicture(a, b));
    }

    void hundredQuickRequestsEndWithTheLastConvergedPicture() {
        Setup s;
        s.commands.hold();
        for (int i = 1; i <= 100; ++i) s.caster.request(s.request(i / 100.0));
        s.commands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(s.delivered.back()->converged());
        QCOMPARE(levelOf(*s.delivered.back()), 1.0f);
        QVERIFY2(s.delivered.size() <= 4, "requests in between were cast");
    }

    void quickPicturesAreShownUnderAStreamOfRequests() {
        Setup s;
        s.commands.convergedOnlyEndsCancelled(120);
        std::size_t requests = 1;
        QObject::connect(&s.caster, &ProgressiveCaster::delivered, &s.caster, [&] {
            if (requests <= 50) {
                s.caster.request(s.turned(static_cast<double>(requests++) / 100.0));
            } else {
                s.caster.clear();  // at once: the hand rests from here on, and better pictures would follow
            }
        });
        s.caster.request(s.request(1.0));
        QTRY_VERIFY_WITH_TIMEOUT(s.delivered.size() >= 51 && !s.caster.busy(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{51});
        for (std::size_t i = 0; i < 51; ++i) {
            QVERIFY(s.delivered[i]->followsHand);  // nothing is refined while newer requests come
            if (i > 0) QCOMPARE(levelOf(*s.delivered[i]), static_cast<float>(static_cast<double>(i) / 100.0));
        }
    }

    void aPictureThatRefinesGivesWay() {
        Setup s;
        s.commands.convergedOnlyEndsCancelled(120);
        s.caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 3, patience);  // the converged one runs
        s.caster.request(s.request(0.75, 121));
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{5});
        for (std::size_t i = 0; i < 5; ++i) QCOMPARE(levelOf(*s.delivered[i]), i < 2 ? 0.25f : 0.75f);
        QVERIFY(s.delivered.back()->converged());
    }

    void theNextPictureIsCastWhileThisOneIsShown() {
        Setup s;
        bool second = false;
        QObject::connect(&s.caster, &ProgressiveCaster::delivered, &s.caster, [&] {
            if (std::exchange(second, true)) return;
            // As long as this thread shows the first picture, nothing is delivered; the second is begun all the same.
            while (s.commands.started() < 2) std::this_thread::yield();
        });
        s.commands.hold();
        s.caster.request(s.turned(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 1, patience);
        s.caster.request(s.turned(0.5));
        s.commands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(levelOf(*s.delivered[0]), 0.25f);
        QCOMPARE(levelOf(*s.delivered[1]), 0.5f);
    }

    void editsKeepOneViewsSamples() {
        // Under one camera every quick picture has the settings of the one before, which the ray caster needs.
        Setup s;
        int requests = 0;
        QObject::connect(&s.caster, &ProgressiveCaster::delivered, &s.caster, [&] {
            if (requests < 20) s.caster.request(s.request(++requests / 100.0));
        });
        s.caster.request(s.request(1.0));
        QTRY_VERIFY_WITH_TIMEOUT(requests == 20 && !s.caster.busy(), patience);
        const std::vector<RayCastSettings> started = s.commands.startedSettings();
        for (std::size_t i = 3; i <= 20; ++i) QVERIFY(started[i] == started[2]);
        QVERIFY(s.delivered.back()->converged());
        QCOMPARE(levelOf(*s.delivered.back()), 0.2f);
    }

    void noPictureOfTheVolumeBefore() {
        Setup s;
        s.commands.hold();
        s.caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 1, patience);
        PictureRequest other = s.request(0.75);
        other.panes[0].volume = std::make_shared<const Volume>(*s.volume);
        s.caster.request(other);
        s.commands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{3});
        for (const auto& picture : s.delivered) QVERIFY(sameVolumes(picture->request, other));
    }

    void nothingAfterClear() {
        Setup s;
        s.commands.hold();
        s.caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 1, patience);
        s.caster.clear();
        QVERIFY(!s.caster.busy());
        s.commands.letGo();
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.lettingGo(), 1, patience);  // after what ran
        QVERIFY(s.delivered.empty());
        // And the same request counts as new again.
        s.caster.request(s.request(0.25));
        QTRY_VERIFY_WITH_TIMEOUT(!s.delivered.empty() && s.delivered.back()->converged(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{3});
    }

    void tooLittleMemoryIsToldAndAnotherRequestIsTried() {
        Setup s;
        std::atomic<bool> enough = false;
        Works works;
        ProgressiveCaster caster{works, PreviewQuality{0.0},
                                 [&](const PictureRequest& request, const Progress& progress) {
                                     if (!request.panes.empty() && !enough) throw std::bad_alloc();
                                     return s.commands(request, progress);
                                 }};
        std::vector<std::shared_ptr<const CastPicture>> delivered;
        QObject::connect(&caster, &ProgressiveCaster::delivered, &caster,
                         [&](const std::shared_ptr<const CastPicture>& picture) { delivered.push_back(picture); });
        QSignalSpy failed(&caster, &ProgressiveCaster::failed);
        caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, patience);
        QTRY_VERIFY_WITH_TIMEOUT(!caster.busy(), patience);
        QCOMPARE(s.commands.lettingGo(), 1);  // nothing of what was begun is kept
        QVERIFY(delivered.empty());
        enough = true;
        caster.request(s.request(0.75));
        QTRY_VERIFY_WITH_TIMEOUT(!delivered.empty() && delivered.back()->converged(), patience);
        QCOMPARE(levelOf(*delivered.back()), 0.75f);
        QCOMPARE(failed.size(), 1);
    }

    void clearLetsGoOfTheVolume() {
        auto volume = volumeOf(geometryOf(8, 8, 8), [](double x, double, double) { return static_cast<int>(9 * x); });
        const std::weak_ptr<const Volume> watched = volume;
        Works works;
        ProgressiveCaster caster(works);
        int delivered = 0;
        QObject::connect(&caster, &ProgressiveCaster::delivered, &caster, [&] { ++delivered; });
        PictureRequest request{{{std::move(volume), PowerCurve{}}}, {}};
        request.settings.width = request.settings.height = 16;
        request.settings.camera = defaultCamera(request.panes[0].volume->geometry(), {}, 1.0);
        caster.request(request);
        QTRY_VERIFY_WITH_TIMEOUT(delivered > 0 && !caster.busy(), patience);
        request.panes.clear();
        QVERIFY(!watched.expired());
        caster.clear();
        QTRY_VERIFY_WITH_TIMEOUT(watched.expired(), patience);
    }

    void oneRayCasterGivesTheRayCastersPictures() {
        const auto a =
            volumeOf(geometryOf(9, 8, 7), [](double x, double y, double) { return static_cast<int>(20 * x + y); });
        const auto b =
            volumeOf(geometryOf(9, 8, 7), [](double x, double, double z) { return static_cast<int>(9 * z + x); });
        const Cast cast = castThroughRayCasters();
        PictureRequest request{{{a, PowerCurve{}}}, {}};
        request.settings.width = request.settings.height = 24;
        request.settings.camera = defaultCamera(a->geometry(), {}, 1.0);
        const auto check = [&](SampleUse expected, int line) {
            const CastResult result = cast(request, {});
            const auto alone = castRays(*request.panes[0].volume, request.panes[0].classification, request.settings);
            QVERIFY2(!result.panes.empty() &&
                         largestDifference(*result.panes[0].picture, *alone) <= (expected == SampleUse::kept ? 0.5 : 0),
                     qPrintable(QString::number(line)));
            QVERIFY2(result.samples == expected, qPrintable(QString::number(line)));
        };
        check(SampleUse::taken, __LINE__);
        request.panes[0].classification = PowerCurve{2, 0.5};
        check(SampleUse::taken, __LINE__);
        request.settings.colourMap = ColourMap::ice;
        check(SampleUse::kept, __LINE__);
        request.settings.step = 0.5;  // a finer picture of the same view has samples of its own
        check(SampleUse::taken, __LINE__);
        request.settings.step = 1;
        request.panes[0].classification = PowerCurve{2, 0.25};
        check(SampleUse::kept, __LINE__);
        request.settings.camera.heightMm *= 1.1;
        check(SampleUse::taken, __LINE__);
        check(SampleUse::taken, __LINE__);
        check(SampleUse::kept, __LINE__);
        request.panes[0].volume = b;
        check(SampleUse::taken, __LINE__);
        QVERIFY(cast({}, {}).panes.empty());
    }

private:
    /// In 8-bit levels. Kept samples are rounded to 16 bits.
    static double largestDifference(const Picture& a, const Picture& b) {
        double largest = a.rgba.size() == b.rgba.size() ? 0 : 255;
        for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i)
            largest = std::max(largest, 255.0 * std::abs(a.rgba[i] - b.rgba[i]));
        return largest;
    }
};

ECHOLUCENT_TEST_CLASS(ProgressiveCasterTest)
#include "test_progressive_caster.moc"
