#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "tests/volume_view/test_volumes.h"
#include "widgets/volume_view/progressive_caster.h"

using namespace echolucent;
using echolucent::testing::geometryOf;
using echolucent::testing::volumeOf;

namespace {

constexpr int patience = 20000;  // ms, a bound for broken programs

/// Stands in for castRays(): pictures of one grey, the curve's opacity at full intensity. Can be held up.
class CommandedCaster {
public:
    std::optional<Picture> operator()(const OpacityCurve& curve, const RayCastSettings& settings, const Progress& progress) {
        std::unique_lock lock(m_mutex);
        ++m_started;
        m_changed.notify_all();
        m_changed.wait(lock, [&] { return !m_held; });
        while (m_untilCancelled && settings.width == m_fineWidth && !progress.cancelled()) {
            lock.unlock();
            std::this_thread::yield();
            lock.lock();
        }
        if (progress.cancelled()) return std::nullopt;
        const auto level = static_cast<float>(opacityAt(curve, 1.0));
        return Picture{settings.width, settings.height,
                       std::vector<float>(static_cast<std::size_t>(4 * settings.width * settings.height), level)};
    }
    void hold() { set([this] { m_held = true; }); }
    void letGo() { set([this] { m_held = false; }); }
    /// Fine pictures end only when they are cancelled.
    void fineOnlyEndsCancelled(int fineWidth) {
        set([&] { m_untilCancelled = true, m_fineWidth = fineWidth; });
    }
    void fineEnds() { set([this] { m_untilCancelled = false; }); }
    int started() {
        const std::lock_guard lock(m_mutex);
        return m_started;
    }

private:
    template <typename Change>
    void set(const Change& change) {
        const std::lock_guard lock(m_mutex);
        change();
        m_changed.notify_all();
    }
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_held = false, m_untilCancelled = false;
    int m_fineWidth = 0, m_started = 0;
};

struct Setup {
    Setup() {
        QObject::connect(&caster, &ProgressiveCaster::delivered, [this](const std::shared_ptr<const CastPicture>& picture) {
            delivered.push_back(picture);
        });
    }
    PictureRequest request(double level, int width = 120) const {
        PictureRequest made{volume, ManualCurve{{{0.0, level}}}, {}};
        made.settings.width = width;
        made.settings.height = 90;
        return made;
    }
    CommandedCaster commands;
    std::shared_ptr<const Volume> volume = volumeOf(geometryOf(2, 2, 2), [](double, double, double) { return 9; });
    std::vector<std::shared_ptr<const CastPicture>> delivered;
    ProgressiveCaster caster{[this](const Volume&, const OpacityCurve& curve, const RayCastSettings& settings,
                                    const Progress& progress) { return commands(curve, settings, progress); },
                             PreviewQuality{0.0}};  // no budget: always a preview first
};

float levelOf(const CastPicture& picture) { return picture.picture->rgba.front(); }

}  // namespace

class ProgressiveCasterTest : public QObject {
    Q_OBJECT

private slots:
    void coarseThenFine() {
        Setup s;
        s.caster.request(s.request(0.5));
        QTRY_COMPARE_WITH_TIMEOUT(s.delivered.size(), std::size_t{2}, patience);
        QVERIFY(!s.delivered[0]->fine);
        QVERIFY(s.delivered[0]->picture->width < 120);
        QVERIFY(s.delivered[1]->fine);
        QCOMPARE(s.delivered[1]->picture->width, 120);
        QCOMPARE(s.delivered[1]->picture->height, 90);
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
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
        for (int part = 0; part < 11; ++part) QTest::addRow("%d", part) << part;
    }
    void everyPartOfARequestMatters() {
        QFETCH(int, part);
        Setup s;
        const PictureRequest a = s.request(0.5);
        PictureRequest b = a;
        switch (part) {
            case 0: b.volume = std::make_shared<const Volume>(*a.volume); break;
            case 1: b.curve = PowerCurve{}; break;
            case 2: b.settings.camera.focalPoint[1] += 1e-9; break;
            case 3: b.settings.camera.frame = frameOf({BeamAxis::plusZ, 1e-6, 0, 0, 0}); break;
            case 4: b.settings.camera.heightMm = 2; break;
            case 5: b.settings.nearPlaneDepthMm = 3; break;
            case 6: b.settings.shading = Shading{}; break;
            case 7: b.settings.colourMap = ColourMap::ice; break;
            case 8: b.settings.height = 91; break;
            case 9: b.settings.camera.projection = Projection::perspective; break;
            case 10: b.settings.interpolation = Interpolation::nearest; break;
            default: break;
        }
        QVERIFY(samePicture(a, a));
        QVERIFY(!samePicture(a, b));
    }

    void hundredQuickRequestsEndWithTheLastFinePicture() {
        Setup s;
        s.commands.hold();
        for (int i = 1; i <= 100; ++i) s.caster.request(s.request(i / 100.0));
        s.commands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(s.delivered.back()->fine);
        QCOMPARE(levelOf(*s.delivered.back()), 1.0f);
        QVERIFY2(s.delivered.size() <= 3, "requests in between were cast");
    }

    void coarsePicturesAreShownUnderAStreamOfRequests() {
        Setup s;
        s.commands.fineOnlyEndsCancelled(120);
        int requests = 0;
        QObject::connect(&s.caster, &ProgressiveCaster::delivered, &s.caster, [&](const std::shared_ptr<const CastPicture>& p) {
            QVERIFY(!p->fine);  // no fine picture ends while newer requests come
            if (requests < 50) s.caster.request(s.request(++requests / 100.0));
        });
        s.caster.request(s.request(1.0));
        QTRY_COMPARE_WITH_TIMEOUT(s.delivered.size(), std::size_t{51}, patience);
        for (std::size_t i = 1; i < 51; ++i) QCOMPARE(levelOf(*s.delivered[i]), static_cast<float>(static_cast<double>(i) / 100.0));
        s.caster.clear();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{51});
    }

    void aFinePictureInTheMakingGivesWay() {
        Setup s;
        s.commands.fineOnlyEndsCancelled(120);
        s.caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 2, patience);  // the fine one runs
        s.caster.request(s.request(0.75, 121));
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{3});
        QCOMPARE(levelOf(*s.delivered[0]), 0.25f);
        QCOMPARE(levelOf(*s.delivered[1]), 0.75f);
        QVERIFY(s.delivered[2]->fine);
        QCOMPARE(levelOf(*s.delivered[2]), 0.75f);
    }

    void noPictureOfTheVolumeBefore() {
        Setup s;
        s.commands.hold();
        s.caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 1, patience);
        PictureRequest other = s.request(0.75);
        other.volume = std::make_shared<const Volume>(*s.volume);
        s.caster.request(other);
        s.commands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QCOMPARE(s.delivered.size(), std::size_t{2});
        for (const auto& picture : s.delivered) QVERIFY(picture->request.volume == other.volume);
    }

    void nothingAfterClear() {
        Setup s;
        s.commands.hold();
        s.caster.request(s.request(0.25));
        QTRY_COMPARE_WITH_TIMEOUT(s.commands.started(), 1, patience);
        s.caster.clear();
        s.commands.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(!s.caster.busy(), patience);
        QVERIFY(s.delivered.empty());
        // And the same request counts as new again.
        s.caster.request(s.request(0.25));
        QTRY_VERIFY_WITH_TIMEOUT(!s.delivered.empty() && s.delivered.back()->fine, patience);
    }

    void previewKeepsWithinItsBudget() {
        // Made-up machines, from one that needs no preview to one for which no preview is quick enough; cost in ms.
        for (const double costPerSample : {1e-6, 2e-5, 4e-4, 5e-2}) {
            PreviewQuality quality(40);
            RayCastSettings fine;
            fine.width = 1000;
            fine.height = 800;
            const auto costOf = [&](const RayCastSettings& settings) {
                return costPerSample * settings.width * settings.height / settings.step;
            };
            RayCastSettings coarse;
            for (int frame = 0; frame < 8; ++frame) {
                coarse = quality.coarse(fine);
                quality.measured(coarse, costOf(coarse));
            }
            if (costOf(fine) <= 28) {
                QCOMPARE(coarse.width, fine.width);  // quick enough as it is
                QCOMPARE(coarse.step, fine.step);
            } else if (costPerSample < 1e-2) {
                QVERIFY2(costOf(coarse) <= 40, qPrintable(QString::number(costOf(coarse))));
                QVERIFY2(costOf(coarse) >= 5, qPrintable(QString::number(costOf(coarse))));  // not needlessly coarse
            } else {
                QCOMPARE(coarse.width, 125);  // the coarsest there is
            }
            QVERIFY(std::abs(coarse.width * 800.0 - coarse.height * 1000.0) <= 1000.0);  // proportions
        }
    }
};

QTEST_GUILESS_MAIN(ProgressiveCasterTest)
#include "test_progressive_caster.moc"
