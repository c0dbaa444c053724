// The caster of a comparison: all panes together, the newest request, cancellation, pictures of the ray caster itself.
#include <QSignalSpy>
#include <QTest>

#include "app/compare/compare_caster.h"
#include "app/picture/picture_image.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/converged.h"
#include "processing/ray_caster.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> shapes(std::uint64_t seed) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {48, 44, 46};
    config.seed = seed;
    return std::make_shared<const Volume>(*makePhantom(config));
}

}  // namespace

class TestCompareCaster : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_volume = shapes(1);
        m_other = shapes(2);
    }
    void init() {
        m_caster = std::make_unique<CompareCaster>();
        m_frames.clear();
        connect(m_caster.get(), &CompareCaster::delivered, this,
                [this](const std::shared_ptr<const CompareFrame>& frame) { m_frames.push_back(frame); });
    }
    void cleanup() { m_caster.reset(); }

    void theFinestFrameIsWhatTheRayCasterMakes() {
        const CompareRequest asked = request(10);
        m_caster->request(asked);
        QVERIFY(m_caster->busy());
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        const CompareFrame& last = *m_frames.back();
        QVERIFY(last.converged());
        QVERIFY(last.request == asked);
        for (std::size_t i = 0; i < asked.panes.size(); ++i) {
            const auto picture = castRays(*asked.panes[i].volume, asked.panes[i].classification, last.settings);
            QVERIFY2(last.panes[i].image == imageOf(*picture), qPrintable(QString::number(i)));
        }
        for (const auto& frame : m_frames) {
            QCOMPARE(frame->panes.size(), asked.panes.size());
            for (const PanePicture& pane : frame->panes) QCOMPARE(pane.image.size(), frame->panes[0].image.size());
        }
    }

    void theNewestRequestWins() {
        for (int degrees = 0; degrees < 30; ++degrees) m_caster->request(request(degrees));
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        QVERIFY(m_frames.back()->request == request(29));
        QVERIFY(m_frames.back()->converged());
        // A request is replaced before it begins, so that few of them were cast.
        int frames = 0;
        for (const auto& frame : m_frames) frames += frame->request == request(29) ? 0 : 1;
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
        for (const auto& frame : m_frames) QVERIFY(frame->request == request(5));
    }

    void onlyThePaneThatChangedIsCastAgain() {
        m_caster->request(request(10));
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        const auto before = m_frames.back();
        CompareRequest edited = request(10);
        edited.panes[1].classification = PowerCurve{4, 0.7};
        m_caster->request(edited);
        QTRY_VERIFY_WITH_TIMEOUT(!m_caster->busy(), patience);
        const auto after = m_frames.back();
        QVERIFY(after->panes[1].image != before->panes[1].image);
        QVERIFY(after->panes[0].image == before->panes[0].image);
        QVERIFY(after->panes[2].image == before->panes[2].image);
    }

private:
    [[nodiscard]] CompareRequest request(double degrees) const {
        Viewpoint view;
        view.azimuthDegrees = degrees;
        CompareRequest request;
        request.panes = {{m_volume, PowerCurve{2, 1.0}}, {m_volume, LinearCurve{}}, {m_other, PowerCurve{4, 1.0}}};
        request.settings.width = 90;
        request.settings.height = 80;
        request.settings.camera = defaultCamera(m_volume->dataBox(), view, 90.0 / 80);
        request.places = {0, 1, 2};
        return request;
    }

    std::shared_ptr<const Volume> m_volume, m_other;
    std::unique_ptr<CompareCaster> m_caster;
    std::vector<std::shared_ptr<const CompareFrame>> m_frames;
};

ECHOLUCENT_TEST_CLASS(TestCompareCaster)
#include "test_compare_caster.moc"
