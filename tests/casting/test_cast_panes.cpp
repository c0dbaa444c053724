// Several panes of one caster: together, the newest request, cancellation, pictures of the ray caster itself.
#include <QSignalSpy>
#include <QTest>

#include "processing/phantom/phantom.h"
#include "processing/picture/converged.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/casting/progressive_caster.h"
#include "widgets/casting/ray_casters.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> shapes(std::uint64_t seed) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {48, 44, 46};
    config.seed = seed;
    return std::make_shared<const Volume>(*makePhantom(config));
}

}  // namespace

class TestCastPanes : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void initTestCase() {
        m_volume = shapes(1);
        m_other = shapes(2);
    }
    void init() {
        m_caster = std::make_unique<ProgressiveCaster>(m_works);
        m_frames.clear();
        connect(m_caster.get(), &ProgressiveCaster::delivered, this,
                [this](const std::shared_ptr<const CastPicture>& frame) { m_frames.push_back(frame); });
    }
    void cleanup() { m_caster.reset(); }

    void theFinestFrameIsWhatTheRayCasterMakes() {
        const PictureRequest asked = request(10);
        m_caster->request(asked);
        QVERIFY(m_caster->busy());
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        const CastPicture& last = *m_frames.back();
        QVERIFY(last.converged());
        QVERIFY(samePicture(last.request, asked));
        for (std::size_t i = 0; i < asked.panes.size(); ++i) {
            const auto picture = castRays(*asked.panes[i].volume, asked.panes[i].classification, last.settings);
            QVERIFY(!last.panes[i].picture);
            QVERIFY2(last.panes[i].screen->rgba == screenPicture(*picture).rgba, qPrintable(QString::number(i)));
        }
        for (const auto& frame : m_frames) {
            QCOMPARE(frame->panes.size(), asked.panes.size());
            for (const CastPane& pane : frame->panes) QCOMPARE(pane.screen->width, frame->panes[0].screen->width);
        }
    }

    void theNewestRequestWins() {
        for (int degrees = 0; degrees < 30; ++degrees) m_caster->request(request(degrees));
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        QVERIFY(samePicture(m_frames.back()->request, request(29)));
        QVERIFY(m_frames.back()->converged());
        // A request is replaced before it begins, so that few of them were cast.
        int frames = 0;
        for (const auto& frame : m_frames) frames += samePicture(frame->request, request(29)) ? 0 : 1;
        QVERIFY(frames <= 3);
        m_frames.clear();
        m_caster->request(request(29));
        QVERIFY(!m_caster->busy());
    }

    void whatIsClearedIsNotDelivered() {
        m_caster->request(request(3));
        m_caster->clear();
        QVERIFY(!m_caster->busy());
        m_caster->request(request(5));
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        for (const auto& frame : m_frames) QVERIFY(samePicture(frame->request, request(5)));
    }

    void onlyThePaneThatChangedIsCastAgain() {
        const Cast cast = castThroughRayCasters();
        PictureRequest asked = request(10);
        const CastResult before = cast(asked, {});
        QVERIFY(before.samples == SampleUse::taken);
        asked.panes[1].classification = PowerCurve{4, 0.7};
        const CastResult after = cast(asked, {});
        QVERIFY(after.panes[1].screen->rgba != before.panes[1].screen->rgba);
        QVERIFY(after.panes[0].screen == before.panes[0].screen);
        QVERIFY(after.panes[2].screen == before.panes[2].screen);
        QVERIFY(!after.samples);  // what one pane took does not say what a frame costs
        asked.settings.step = 0.5;
        const CastResult finer = cast(asked, {});
        for (std::size_t i = 0; i < 3; ++i) QVERIFY(finer.panes[i].screen != after.panes[i].screen);
    }

private:
    [[nodiscard]] PictureRequest request(double degrees) const {
        Viewpoint view;
        view.azimuthDegrees = degrees;
        PictureRequest request;
        request.panes = {
            {m_volume, PowerCurve{2, 1.0}, 0}, {m_volume, LinearCurve{}, 1}, {m_other, PowerCurve{4, 1.0}, 2}};
        request.settings.width = 90;
        request.settings.height = 80;
        request.settings.camera = defaultCamera(m_volume->dataBox(), view, 90.0 / 80);
        return request;
    }

    std::shared_ptr<const Volume> m_volume, m_other;
    std::unique_ptr<ProgressiveCaster> m_caster;
    std::vector<std::shared_ptr<const CastPicture>> m_frames;
};

ECHOLUCENT_TEST_CLASS(TestCastPanes)
#include "test_cast_panes.moc"
