// What the plot paints, read back from its pixels.
#include <QTest>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/otf_editor/edited_document.h"
#include "widgets/controls/value_text.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/early_light_bars.h"

using namespace echolucent;

namespace {

double distance(const QColor& left, const QColor& right) {
    return std::hypot(left.red() - right.red(), left.green() - right.green(), left.blue() - right.blue());
}

}  // namespace

class TestOtfEditorPainting : public QObject {
    Q_OBJECT

private slots:
    /// Every function runs in each theme.
    void initTestCase_data();
    void init();
    void cleanup();
    void hiddenCurveIsNotPainted_data();
    void hiddenCurveIsNotPainted();
    void activeCurveIsHeavier();
    void histogramIsPaintedBehind();
    void earlyLightIsPaintedAtItsIntensities();
    void cursorIntensityIsMarked();
    void valuesOfAnyWindowAreNumbersThatMeanSomething();

private:
    [[nodiscard]] QPoint pixelOf(const CurveNode& value) const { return m_canvas->axes().positionOf(value).toPoint(); }
    [[nodiscard]] QImage picture() const { return m_canvas->grab().toImage(); }
    [[nodiscard]] double shareOfPathPainted(CurveKind kind) const;

    std::unique_ptr<EditedModel> m_model;
    std::unique_ptr<CurveCanvas> m_canvas;
};

void TestOtfEditorPainting::initTestCase_data() {
    QTest::addColumn<Theme>("theme");
    QTest::newRow("dark") << Theme::dark;
    QTest::newRow("light") << Theme::light;
}

void TestOtfEditorPainting::init() {
    m_model = std::make_unique<EditedModel>();
    OtfEditorState state;
    state.manual = threeNodes;
    state.active = CurveKind::manual;
    for (int i = 0; i < 256; ++i) state.adaptive.opacities.push_back(std::min(1.0, 0.9 * std::sqrt(i / 255.0)));
    m_model->setState(state);
    m_canvas = std::make_unique<CurveCanvas>(*m_model);
    QFETCH_GLOBAL(Theme, theme);
    m_canvas->setPalette(paletteOf(theme));
    m_canvas->resize(520, 340);
    m_canvas->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_canvas.get()));
}

void TestOtfEditorPainting::cleanup() {
    m_canvas.reset();
    m_model.reset();
}

/// Of the columns of pixels, the share in which the curve's own colour lies on its path.
double TestOtfEditorPainting::shareOfPathPainted(CurveKind kind) const {
    const QImage image = picture();
    const OpacityCurve curve = curveOf(m_model->state(), kind);
    int columns = 0;
    int painted = 0;
    for (int x = static_cast<int>(m_canvas->axes().rect.left()) + 5; x < m_canvas->axes().rect.right() - 5; ++x) {
        const double intensity = m_canvas->axes().valueAt({x + 0.5, 0.0}).intensity;
        const double opacity = opacityAt(curve, intensity);
        if (opacity < 0.05 || opacity > 0.97) continue;
        const double y = m_canvas->axes().positionOf({intensity, opacity}).y();
        ++columns;
        for (int row = static_cast<int>(y) - 2; row <= static_cast<int>(y) + 2; ++row)
            if (distance(image.pixelColor(x, row), curveColor(kind, themeOf(m_canvas->palette()))) < 60) {
                ++painted;
                break;
            }
    }
    return columns > 0 ? static_cast<double>(painted) / columns : 0.0;
}

void TestOtfEditorPainting::hiddenCurveIsNotPainted_data() {
    QTest::addColumn<CurveKind>("kind");
    QTest::addColumn<double>("leastShare");  // dashes leave gaps
    QTest::newRow("adaptive") << CurveKind::adaptive << 0.95;
    QTest::newRow("manual") << CurveKind::manual << 0.95;
    QTest::newRow("linear") << CurveKind::linear << 0.5;
    QTest::newRow("parabolic") << CurveKind::parabolic << 0.3;
    QTest::newRow("quartic") << CurveKind::quartic << 0.4;
}

void TestOtfEditorPainting::hiddenCurveIsNotPainted() {
    QFETCH(CurveKind, kind);
    QFETCH(double, leastShare);
    m_model->setActive(kind);
    const double shown = shareOfPathPainted(kind);
    QVERIFY2(shown > leastShare, qPrintable(QString::number(shown)));
    m_model->setVisible(kind, false);
    const double hidden = shareOfPathPainted(kind);
    QVERIFY2(hidden < 0.1, qPrintable(QString::number(hidden)));  // where another curve of like colour crosses
    m_model->setVisible(kind, true);
    QCOMPARE(shareOfPathPainted(kind), shown);
}

void TestOtfEditorPainting::activeCurveIsHeavier() {
    const auto pixelsLike = [&] {
        const QImage image = picture();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (distance(image.pixelColor(x, y), curveColor(CurveKind::quartic, themeOf(m_canvas->palette()))) < 40)
                    ++count;
        return count;
    };
    const int inactive = pixelsLike();
    m_model->setActive(CurveKind::quartic);
    QVERIFY(pixelsLike() > 1.4 * inactive);
}

void TestOtfEditorPainting::histogramIsPaintedBehind() {
    IntensityHistogram histogram;
    histogram.counts.fill(10);
    histogram.counts[200] = 100'000;
    m_canvas->setHistogram(histogram);
    for (const CurveKind kind : allCurveKinds) m_model->setVisible(kind, false);
    // Between two grid lines, at a height that log(11) / log(100001) = 0.21 reaches and 10 / 100000 does not.
    const QPoint inside = pixelOf({0.3, 0.1});
    const QPoint above = pixelOf({0.3, 0.5});
    const QImage logarithmic = picture();
    QVERIFY(logarithmic.pixelColor(inside) != logarithmic.pixelColor(above));
    m_canvas->setHistogramScale(HistogramScale::linear);
    const QImage linear = picture();
    QCOMPARE(linear.pixelColor(inside), linear.pixelColor(above));
    QCOMPARE(linear.pixelColor(above), logarithmic.pixelColor(above));
    const QPoint peak = pixelOf({200.5 / 256.0, 0.5});
    QVERIFY(linear.pixelColor(peak) != linear.pixelColor(above));
}

void TestOtfEditorPainting::earlyLightIsPaintedAtItsIntensities() {
    for (const CurveKind kind : allCurveKinds) m_model->setVisible(kind, false);
    const QImage without = picture();
    EarlyLight light;
    light.rays = light.early = 10;
    light.held[20] = 0.04;  // from 0.3125 on, four tenths of the plot high
    light.held[40] = 0.06;
    m_canvas->setEarlyLight(light);
    QImage with = picture();
    const auto painted = [&](const CurveNode& value) {
        return with.pixelColor(pixelOf(value)) != without.pixelColor(pixelOf(value));
    };
    QVERIFY(painted({20.5 / 64, 0.1}) && painted({20.5 / 64, 0.35}));
    QVERIFY(!painted({20.5 / 64, 0.45}));
    QVERIFY(!painted({19.4 / 64, 0.1}) && !painted({21.6 / 64, 0.1}));
    QVERIFY(painted({40.5 / 64, 0.55}) && !painted({40.5 / 64, 0.65}));
    QVERIFY(m_canvas->accessibleDescription().contains("10 % of the light, height: 10 %"));
    // A higher bar is not cut: the plot stands for more.
    light.held[40] = 0.16;
    m_canvas->setEarlyLight(light);
    with = picture();
    QVERIFY(painted({20.5 / 64, 0.15}) && !painted({20.5 / 64, 0.25}));
    QVERIFY(painted({40.5 / 64, 0.75}) && !painted({40.5 / 64, 0.85}));
    QVERIFY(m_canvas->accessibleDescription().contains("20 % of the light, height: 20 %"));
    for (const auto& [held, full] :
         {std::pair{0.1, 0.1}, std::pair{0.11, 0.2}, std::pair{0.21, 0.5}, std::pair{0.51, 1.0}}) {
        light.held[40] = held;
        QCOMPARE(earlyLightOfFullHeight(light), full);
        QCOMPARE(earlyLightHeights(light)[40], held / full);
    }
    light.held[40] = 0.06;
    m_canvas->setEarlyLight(light);
    // The opacity axis may be zoomed: bars have a measure of their own.
    m_canvas->setOpacityRange({0.0, 0.5});
    QVERIFY(picture().pixelColor(pixelOf({20.5 / 64, 0.05})) != without.pixelColor(pixelOf({20.5 / 64, 0.05})));
    m_canvas->resetZoom();
    m_canvas->setEarlyLight({});
    QVERIFY(picture() == without);
}

void TestOtfEditorPainting::cursorIntensityIsMarked() {
    const QImage without = picture();
    m_canvas->setCursorIntensity(0.66);
    const QImage with = picture();
    const int x = pixelOf({0.66, 0.0}).x();
    int changed = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int column = 0; column < with.width(); ++column)
            if (with.pixelColor(column, y) != without.pixelColor(column, y)) {
                QVERIFY(std::abs(column - x) <= 6);
                ++changed;
            }
    QVERIFY(changed > m_canvas->axes().rect.height() / 2);
    m_canvas->setCursorIntensity(std::nullopt);
    QCOMPARE(picture(), without);
}

/// A whole number could not hold the largest float: 9223372036854775807 stood there.
void TestOtfEditorPainting::valuesOfAnyWindowAreNumbersThatMeanSomething() {
    const double largest = std::numeric_limits<float>::max();
    QCOMPARE(valueText(largest, {0.0, largest}), QStringLiteral("3.4e+38"));
    QCOMPARE(valueText(-largest, {0.0, largest}), QStringLiteral("-3.4e+38"));
    QCOMPARE(valueText(0.5e38, {0.0, 1e38}), QStringLiteral("5e+37"));
    QCOMPARE(valueText(1e-40, {0.0, 1e-40}), QStringLiteral("1e-40"));
    QCOMPARE(valueText(1e300, {0.0, 1e300}), QStringLiteral("1e+300"));
    QCOMPARE(valueText(127.6, {0.0, 255.0}), QStringLiteral("128"));
    QCOMPARE(valueText(4294967295.0, {0.0, 4294967295.0}), QStringLiteral("4.29e+09"));
    QCOMPARE(valueText(0.5, {0.0, 1.5}), QStringLiteral("0.5"));
    QCOMPARE(valueText(-12.64, {-60.0, 0.0}), QStringLiteral("-12.6"));
    QCOMPARE(valueText(-900.4, {-1018.0, -794.0}), QStringLiteral("-900"));
    QCOMPARE(valueText(1000000.42, {1e6, 1e6 + 1}), QStringLiteral("1000000.42"));
    QCOMPARE(valueBeside(0.5, {-1e308, 1e308}), QStringLiteral(" (0)"));
    QCOMPARE(valueBeside(0.42, {0.0, 1.0}), QString());
}

ECHOLUCENT_TEST_CLASS(TestOtfEditorPainting)
#include "test_otf_editor_painting.moc"
