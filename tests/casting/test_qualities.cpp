// Which quality a picture gets, on made-up machines.
#include <QTest>
#include <cmath>

#include "tests/qt_program/test_classes.h"
#include "widgets/casting/preview_quality.h"

using namespace echolucent;

class QualitiesTest : public QObject {
    Q_OBJECT

private slots:
    void qualitiesGoFromFineToCoarse() {
        const RayCastSettings asked;
        const auto samplesAt = [&](std::size_t chosen) {
            const RayCastSettings settings = settingsAt(chosen, asked);
            return static_cast<double>(settings.width) * settings.height / settings.step;
        };
        for (std::size_t chosen = 1; chosen < qualities.size(); ++chosen)
            QVERIFY(samplesAt(chosen) < samplesAt(chosen - 1));
        QVERIFY(qualities[convergedQuality].atRest);
        const RayCastSettings converged = settingsAt(convergedQuality, asked);
        QCOMPARE(converged.width, asked.width);
        QVERIFY(converged.step <= asked.step / 2);
        // From every quality the way leads to the converged picture.
        for (std::size_t chosen = 1; chosen < qualities.size(); ++chosen) QVERIFY(nextAtRest(chosen) < chosen);
    }

    void qualityInMotionKeepsWithinItsBudget() {
        // Made-up machines, from one that needs no preview to one for which no preview is quick enough; cost in ms.
        for (const double costPerSample : {1e-6, 1e-5, 2e-5, 4e-4, 5e-2}) {
            PreviewQuality quality(40);
            RayCastSettings asked;
            asked.width = 1000;
            asked.height = 800;
            RayCastSettings shown;
            for (int frame = 0; frame < 8; ++frame) {
                shown = settingsAt(quality.qualityInMotion(asked), asked);
                quality.sampled(shown, costOf(shown, costPerSample));
            }
            const RayCastSettings converged = settingsAt(convergedQuality, asked);
            if (costOf(converged, costPerSample) <= 28) {
                QVERIFY(shown == converged);  // quick enough as it is
            } else if (costPerSample < 1e-2) {
                QVERIFY2(costOf(shown, costPerSample) <= 40, qPrintable(QString::number(costOf(shown, costPerSample))));
                QVERIFY2(costOf(shown, costPerSample) >= 5,  // not needlessly coarse
                         qPrintable(QString::number(costOf(shown, costPerSample))));
            } else {
                QCOMPARE(shown.width, 125);  // the coarsest there is
            }
            QVERIFY(std::abs(shown.width * 800.0 - shown.height * 1000.0) <= 1000.0);  // proportions
        }
    }

    void aViewAloneIsShownAsAtRestWhereThatIsQuick() {
        const RayCastSettings asked;
        const RayCastSettings atRest = settingsAt(convergedQuality + 1, asked);
        QVERIFY(qualities[convergedQuality + 1].atRest);
        QCOMPARE(PreviewQuality(33).qualityAlone(asked), firstQuality);  // nothing is known yet
        for (const double milliseconds : {35.0, 49.0, 51.0, 400.0}) {
            PreviewQuality quality(33);
            const double costPerSample = milliseconds / costOf(atRest, 1.0);
            quality.sampled(atRest, milliseconds);
            const std::size_t inMotion = quality.qualityInMotion(asked), alone = quality.qualityAlone(asked);
            QVERIFY(costOf(settingsAt(inMotion, asked), costPerSample) <= 33.0);
            QVERIFY(inMotion > convergedQuality + 1);
            QCOMPARE(alone, milliseconds <= PreviewQuality::aloneFrames * 33.0 ? convergedQuality + 1 : inMotion);
            QCOMPARE(quality.qualityInMotion(asked), inMotion);  // what moves is as it was
        }
        // Finer than that only where it keeps within a frame too.
        PreviewQuality quick(33);
        quick.sampled(atRest, 0.5);
        QCOMPARE(quick.qualityAlone(asked), convergedQuality);
    }

    void drawingTakesItsShareOfTheFrame() {
        PreviewQuality quality(33);
        quality.drawn(500);  // prepares OpenGL
        QCOMPARE(quality.budgetMilliseconds(), 33.0);
        for (int i = 0; i < 20; ++i) quality.drawn(10);
        QVERIFY(std::abs(quality.budgetMilliseconds() - 23) < 0.1);
        const RayCastSettings asked;
        const double cost = 25.0 / (512 * 512);  // of full size at step 1: 25 ms
        const auto inMotion = [&](PreviewQuality& chooser) {
            for (int i = 0; i < 8; ++i) {
                const RayCastSettings shown = settingsAt(chooser.qualityInMotion(asked), asked);
                chooser.sampled(shown, costOf(shown, cost));
            }
            return costOf(settingsAt(chooser.qualityInMotion(asked), asked), cost);
        };
        QVERIFY(inMotion(quality) <= 23);
        for (int i = 0; i < 20; ++i) quality.drawn(1000);
        QVERIFY(quality.budgetMilliseconds() > 5);  // some picture there must be
        QVERIFY(inMotion(quality) <= quality.budgetMilliseconds());
    }

    void editsAreShownFinerThanNewViews() {
        // 60 ms for full size at step 1, a fifth of it from kept samples.
        const RayCastSettings asked;
        const double sampling = 60.0 / (512 * 512), reclassifying = sampling / 5;
        PreviewQuality quality(33);
        for (int i = 0; i < 8; ++i) {
            const RayCastSettings moving = settingsAt(quality.qualityInMotion(asked), asked);
            quality.sampled(moving, costOf(moving, sampling));
        }
        std::size_t chosen = 0;
        for (int i = 0; i < 8; ++i) {
            chosen = quality.qualityForEdits(asked, false);
            quality.reclassified(settingsAt(chosen, asked), costOf(settingsAt(chosen, asked), reclassifying));
        }
        QVERIFY(costOf(settingsAt(chosen, asked), reclassifying) <= 33);
        QVERIFY(chosen < quality.qualityInMotion(asked));
        QCOMPARE(settingsAt(chosen, asked).width, 512);
        // Where its samples cannot be kept, the chosen quality costs what a new view costs.
        quality.couldNotKeep(settingsAt(chosen, asked));
        const std::size_t smaller = quality.qualityForEdits(asked, false);
        QVERIFY(smaller > chosen);
        QVERIFY(smaller <= quality.qualityInMotion(asked));
    }

    void lightIsLearntApart() {
        RayCastSettings unlit, lit;
        lit.shading = Shading{};
        PreviewQuality quality(33);
        const auto learn = [&](const RayCastSettings& asked, double cost) {
            RayCastSettings shown;
            for (int i = 0; i < 8; ++i) {
                shown = settingsAt(quality.qualityInMotion(asked), asked);
                quality.sampled(shown, costOf(shown, cost));
            }
            return shown.width / shown.step;
        };
        const double unlitCost = 30.0 / (512 * 512);
        const double fine = learn(unlit, unlitCost);
        // Even the first lit picture is no shock, and back without light the first picture is fine at once.
        QVERIFY(costOf(settingsAt(quality.qualityInMotion(lit), lit), 4 * unlitCost) <= 33);
        QVERIFY(learn(lit, 8 * unlitCost) < fine);
        const RayCastSettings back = settingsAt(quality.qualityInMotion(unlit), unlit);
        QVERIFY(costOf(back, unlitCost) <= 33 && back.width / back.step >= 0.9 * fine);
    }

    void pixelsThatAreInterpolatedCostNothing() {
        RayCastSettings asked;
        asked.width = 1600;
        asked.height = 1000;
        const double costPerSample = 33.0 / (1600 * 1000);
        const auto shownWith = [&](double share) {
            PreviewQuality quality(33);
            std::size_t chosen = firstQuality;
            for (int frame = 0; frame < 8; ++frame) {
                chosen = quality.qualityInMotion(asked);
                const RayCastSettings shown = settingsAt(chosen, asked);
                const double cast = shown.pixelTolerance > 0.0 ? share : 1.0;
                quality.sampled(shown, costOf(shown, costPerSample) * cast, cast);
            }
            return chosen;
        };
        // If a third of the rays is cast, high quality keeps within the frame, but not the converged picture, which
        // needs all rays.
        QVERIFY(shownWith(1.0) > highQuality);
        QCOMPARE(shownWith(0.33), highQuality);
    }

    void theShareOfALargePictureSaysLittleOfASmallOne() {
        RayCastSettings asked;
        asked.width = 1600;
        asked.height = 1000;
        PreviewQuality quality(33);
        const RayCastSettings large = settingsAt(highQuality, asked);
        // With all its rays cast, high quality would take nine frames.
        const double costPerSample = 300.0 / costOf(large, 1.0);
        quality.sampled(large, 0.3 * 300.0, 0.3);
        const RayCastSettings chosen = settingsAt(quality.qualityInMotion(asked), asked);
        QVERIFY(chosen.width < large.width);
        // Fewer pixels than those that were cast may all have to be cast.
        QVERIFY(chosen.width * chosen.height < 0.3 * large.width * large.height);
        QVERIFY(costOf(chosen, costPerSample) <= 33.0);
    }

    void withinASeriesOfEditsTheQualityStays() {
        const RayCastSettings asked;
        PreviewQuality quality(30);
        quality.sampled(asked, 60);
        QVERIFY(quality.qualityInMotion(asked) > 0);
        quality.reclassified(asked, 20);
        const std::size_t chosen = quality.qualityForEdits(asked, false);
        const RayCastSettings shown = settingsAt(chosen, asked);
        for (const double milliseconds : {40.0, 12.0, 40.0, 12.0}) {
            quality.reclassified(shown, milliseconds);
            QCOMPARE(quality.qualityForEdits(asked, true), chosen);
        }
        for (int i = 0; i < 8; ++i) quality.reclassified(shown, 100);
        QVERIFY(quality.qualityForEdits(asked, true) > chosen);
    }

    void aLitEditMayBeOneCoarserThanAViewInMotion() {
        // 90 ms for full size at step 1, and four times as long from kept samples: every edit would rather be coarser.
        // The light of another curve takes most of a frame.
        RayCastSettings asked;
        const double sampling = 90.0 / (512 * 512), reclassifying = 4.0 * sampling;
        const auto coarserBy = [&](bool lit) {
            if (lit) asked.shading = Shading{.reaching = {}};
            PreviewQuality quality(33);
            for (int i = 0; i < 8; ++i) {
                const RayCastSettings moving = settingsAt(quality.qualityInMotion(asked), asked);
                quality.sampled(moving, costOf(moving, sampling));
                quality.lit(moving, 5);
            }
            const std::size_t inMotion = quality.qualityInMotion(asked);
            for (int i = 0; i < 8; ++i) {
                const RayCastSettings shown = settingsAt(quality.qualityForEdits(asked, true), asked);
                quality.reclassified(shown, costOf(shown, reclassifying));
                quality.lit(shown, 25);
            }
            return static_cast<int>(quality.qualityForEdits(asked, true)) - static_cast<int>(inMotion);
        };
        QCOMPARE(coarserBy(false), 0);
        QCOMPARE(coarserBy(true), 1);
    }

    void raysOfALitEditKeepHalfOfTheBudget() {
        // The light takes the whole frame. An edit's rays take 14 ms at the first quality.
        RayCastSettings asked;
        asked.shading = Shading{.reaching = {}};
        const RayCastSettings first = settingsAt(firstQuality, asked);
        const auto ofEdit = [&](double drawing) {
            PreviewQuality quality(33);
            for (int i = 0; i < 8; ++i) {
                quality.sampled(first, 10);
                quality.reclassified(first, 14);
                quality.lit(first, 33);
                quality.drawn(drawing);
            }
            (void)quality.qualityInMotion(asked);
            return quality.qualityForEdits(asked, false);
        };
        QCOMPARE(ofEdit(0), firstQuality);
        QCOMPARE(ofEdit(25), firstQuality + 1);  // 11 ms are left, and a third of a frame is kept for the rays
    }

    void noEditBeginsWithALongWait() {
        // Five seconds for full size: from kept samples it might be quick, but not the two pictures before.
        const RayCastSettings asked;
        const double sampling = 5000.0 / (512 * 512);
        PreviewQuality quality(33);
        const auto learn = [&] {
            const RayCastSettings moving = settingsAt(quality.qualityInMotion(asked), asked);
            quality.sampled(moving, costOf(moving, sampling));
        };
        for (int i = 0; i < 8; ++i) learn();
        quality.reclassified(asked, 1e-3);
        QVERIFY(costOf(settingsAt(quality.qualityForEdits(asked, false), asked), sampling) <=
                PreviewQuality::warmUpFrames * 33);
    }

private:
    static double costOf(const RayCastSettings& settings, double costPerSample) {
        return costPerSample * settings.width * settings.height / settings.step;
    }
};

ECHOLUCENT_TEST_CLASS(QualitiesTest)
#include "test_qualities.moc"
