// The widgets of the comparison by themselves: difference, panes, grid.
#include <QAbstractItemView>
#include <QFontInfo>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "processing/comparison/surface_picture.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/contrast.h"
#include "widgets/compare/coloured_surfaces.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/compare_rows.h"
#include "widgets/compare/difference_image.h"
#include "widgets/compare/pane_face.h"
#include "widgets/compare/surface_legend.h"
#include "widgets/controls/narrow_combo.h"
#include "widgets/surface_colours.h"
#include "widgets/theme_colours.h"

using namespace echolucent;

namespace {

QImage plain(const QColor& colour, const QSize& size = {30, 20}) {
    QImage image(size, QImage::Format_RGB888);
    image.fill(colour);
    return image;
}

using Primaries = std::array<double, 3>;

/// Linear red, green and blue.
Primaries linear(const QColor& colour) {
    const auto one = [](double value) {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return {one(colour.redF()), one(colour.greenF()), one(colour.blueF())};
}

/// CIE L*a*b* of the white point D65.
Primaries labOf(const Primaries& rgb) {
    const auto f = [](double value) { return value > 0.008856 ? std::cbrt(value) : 7.787 * value + 16.0 / 116; };
    const double x = f((0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505),
                 y = f(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]),
                 z = f((0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The linear colours that an eye without one kind of cone sees as an eye with all sees them (Machado, Oliveira and
/// Fernandes 2009, severity 1): without red, green, blue cones.
constexpr std::array<std::array<Primaries, 3>, 3> missingCones{
    {{{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};

double apartWithout(const std::array<Primaries, 3>& cone, const QColor& one, const QColor& other) {
    const auto seen = [&cone](const QColor& colour) {
        const Primaries rgb = linear(colour);
        Primaries made{};
        for (std::size_t i = 0; i < 3; ++i)
            made[i] = std::max(0.0, cone[i][0] * rgb[0] + cone[i][1] * rgb[1] + cone[i][2] * rgb[2]);
        return labOf(made);
    };
    const Primaries a = seen(one), b = seen(other);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The numbers of a pane that take the most room.
QString longest() {
    CompareRow row;
    row.depth = ShownDepth{100, 100, 100, 100};
    return numbersOf(row).replace("25", "100");
}

/// The smallest rectangle around everything that is not black.
QRect inkOf(const QImage& image) {
    QRect ink;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qGray(image.pixel(x, y)) > 8) ink |= QRect(x, y, 1, 1);
    return ink;
}

/// Whether the pattern of a shown depth has a line at a pixel.
bool isDarker(ShownSurface shown, int column, int row) {
    return QColor(surfaceShade(shown, 255, column, row)).value() < surfaceColour(shown).value();
}

}  // namespace

class TestCompare : public QObject {
    Q_OBJECT

private slots:
    void aDifferenceIsSignedAndAmplifiedAroundGrey() {
        const QImage one = plain({100, 50, 7});
        DifferenceImage same = differenceOf(one, one, 32);
        QCOMPARE(same.rmse, 0.0);
        QVERIFY(same.image.pixelColor(3, 3) == QColor(128, 128, 128));
        const DifferenceImage other = differenceOf(one, plain({90, 56, 7}), 4);
        QVERIFY(other.image.pixelColor(3, 3) == QColor(168, 104, 128));
        QVERIFY(std::abs(other.rmse - std::sqrt((100.0 + 36.0) / 3)) < 1e-12);
        QVERIFY(differenceOf(plain(Qt::white), plain(Qt::black), 32).image.pixelColor(0, 0) == QColor(255, 255, 255));
        QVERIFY(differenceOf(one, plain(Qt::black, {3, 3}), 4).image.isNull());
        QVERIFY(differenceOf({}, {}, 4).image.isNull());
    }

    void surfacesAreColouredOverTheGreyPicture() {
        QImage picture = plain({200, 120, 80}, {4, 2});
        picture.setPixelColor(3, 0, Qt::black);
        const std::vector<std::int32_t> rays{noRay, 0, 0, 1, 2, 3, 3, noRay};
        const std::vector<ShownSurface> shown(allShownSurfaces.begin(), allShownSurfaces.end());
        const QImage coloured = colouredSurfaces(picture, rays, shown);
        const int grey = qGray(picture.pixel(0, 0));
        QCOMPARE(coloured.pixel(0, 0), qRgb(grey, grey, grey));
        QCOMPARE(coloured.pixel(1, 0), surfaceShade(ShownSurface::right, grey, 1, 0));
        QCOMPARE(coloured.pixel(2, 0), surfaceShade(ShownSurface::right, grey, 2, 0));
        QCOMPARE(coloured.pixel(3, 0), surfaceShade(ShownSurface::early, 0, 3, 0));
        QCOMPARE(coloured.pixel(0, 1), surfaceShade(ShownSurface::late, grey, 0, 1));
        QCOMPARE(coloured.pixel(2, 1), surfaceShade(ShownSurface::never, grey, 2, 1));
        QCOMPARE(coloured.pixel(3, 1), qRgb(grey, grey, grey));
        QVERIFY_THROWS_EXCEPTION(std::invalid_argument, (void)colouredSurfaces(plain(Qt::red), rays, shown));
        // The patterns go on without a seam over a wide picture.
        const QImage wide = plain(Qt::white, {64, 40});
        const std::vector<std::int32_t> all(64 * 40, 1);
        const QImage early = colouredSurfaces(wide, all, shown);
        for (int row = 0; row < 40; ++row)
            for (int column = 0; column < 64; ++column)
                QCOMPARE(early.pixel(column, row), surfaceShade(ShownSurface::early, 255, column, row));
    }

    void theFourColoursAndPatternsDiffer() {
        for (const ShownSurface one : allShownSurfaces) {
            QVERIFY(contrast(surfaceColour(one), Qt::black) >= 3.0);
            for (const ShownSurface other : allShownSurfaces) {
                if (one == other) continue;
                int alike = 0;  // pixels where both patterns have a line, or both have none
                for (int row = 0; row < 12; ++row)
                    for (int column = 0; column < 12; ++column)
                        alike += isDarker(one, column, row) == isDarker(other, column, row) ? 1 : 0;
                QVERIFY(alike < 130);
                constexpr double plainlyApart = 20.0;  // of L*a*b*; 2.3 is just seen
                for (const auto& cone : missingCones)
                    QVERIFY(apartWithout(cone, surfaceColour(one), surfaceColour(other)) > plainlyApart);
            }
        }
        QCOMPARE(wordOf(ShownSurface::never), QString("never"));
    }

    void theLegendSaysAllFourInOneLine() {
        const SurfaceLegend legend = surfaceLegend(ShownDepth{.right = 5, .early = 3, .late = 0, .never = 0});
        const SurfaceLegend expected{
            {ShownSurface::right, 63}, {ShownSurface::early, 38}, {ShownSurface::late, 0}, {ShownSurface::never, 0}};
        QVERIFY(legend == expected);
        const SurfaceLegend withoutShares{
            {ShownSurface::right}, {ShownSurface::early}, {ShownSurface::late}, {ShownSurface::never}};
        QVERIFY(surfaceLegend({}) == withoutShares);
        const QImage picture = plain(Qt::white, {400, 50});
        const QImage saved = withSurfaceLegend(picture, legend);
        QCOMPARE(saved.copy(picture.rect()), picture.convertToFormat(saved.format()));
        QVERIFY(saved.height() > picture.height() + 8);
        for (const ShownSurface shown : allShownSurfaces) {
            int found = 0;
            for (int row = 50; row < saved.height(); ++row)
                for (int column = 0; column < saved.width(); ++column)
                    found += saved.pixelColor(column, row) == surfaceColour(shown) ? 1 : 0;
            QVERIFY2(found > 10, qPrintable(wordOf(shown)));
        }
        // A pane shows it in the place of its numbers.
        ComparePane pane(QStringLiteral("pane"));
        pane.resize(460, 300);
        pane.setFace({.name = "one", .numbers = "right 63 %"});
        const QImage without = pane.grab().toImage();
        pane.setFace({.name = "one", .numbers = "right 63 %", .legend = legend});
        QVERIFY(pane.grab().toImage() != without);
        QCOMPARE(pane.accessibleDescription(), QString("right 63 %"));
    }

    void panesHaveOneSizeAndAllTheRoom_data() {
        QTest::addColumn<int>("panes");
        for (const int panes : {2, 3, 4}) QTest::addRow("%d", panes) << panes;
    }
    void panesHaveOneSizeAndAllTheRoom() {
        QFETCH(int, panes);
        CompareGrid grid;
        grid.resize(900, 560);
        grid.arrange(ComparisonLayout::sideBySide, static_cast<std::size_t>(panes));
        grid.show();
        QCOMPARE(grid.shownPanes().size(), static_cast<std::size_t>(panes));
        for (std::size_t i = 0; i < mostPanes; ++i) {
            QCOMPARE(grid.pane(i).isVisible(), static_cast<int>(i) < panes);
            if (!grid.pane(i).isVisible()) continue;
            QCOMPARE(grid.pane(i).size(), grid.pane(0).size());
            QVERIFY(grid.rect().contains(grid.pane(i).geometry()));
            for (std::size_t k = 0; k < i; ++k) QVERIFY(!grid.pane(i).geometry().intersects(grid.pane(k).geometry()));
        }
        QCOMPARE(grid.pictureSize(), grid.pane(1).pictureSize());
        grid.arrange(ComparisonLayout::wipe, static_cast<std::size_t>(panes));
        QVERIFY(grid.pair().isVisible() && !grid.pane(0).isVisible());
        QCOMPARE(grid.pair().size(), grid.size());
    }

    void textsBelowPanesAreWholeAtEverySize_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("panes");
        for (const QSize size : {QSize(1024, 768), QSize(1280, 720), QSize(1920, 1080)})
            for (int panes = 2; panes <= 4; ++panes)
                QTest::addRow("%d x %d, %d panes", size.width(), size.height(), panes) << size << panes;
    }
    void textsBelowPanesAreWholeAtEverySize() {
        QFETCH(QSize, size);
        QFETCH(int, panes);
        CompareGrid grid;
        grid.resize(size);
        // A hidden grid places its panes anew only for another number of them.
        grid.arrange(ComparisonLayout::sideBySide, static_cast<std::size_t>(panes % 3 + 2));
        grid.arrange(ComparisonLayout::sideBySide, static_cast<std::size_t>(panes));
        const QString name("2  (b) Manually designed piecewise linear OTF");
        grid.setNames({"1  (a) Linear OTF", name});
        const int plain = grid.pane(0).pictureRect().height();
        grid.setLarge(true);
        const CaptionLayout& caption = grid.caption();
        QVERIFY(QFontInfo(caption.font).pixelSize() >= size.height() / 40);
        const QRect pane = grid.pane(0).rect();
        const QRect picture = grid.pane(0).pictureRect();
        QVERIFY(picture.height() <= plain && 2 * picture.height() > pane.height());
        // The texts, each on its own, within the pane and below the picture: what is painted outside would be cut.
        for (const PaneFace& face : {PaneFace{.name = name}, PaneFace{.name = "x", .numbers = longest()},
                                     PaneFace{.name = name, .legend = surfaceLegend(ShownDepth{1, 1, 1, 1})}}) {
            const QSize room = pane.size() + QSize(400, 400);  // more than the pane
            QImage image(room, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            painter.translate(200, 200);
            paintFace(painter, pane, face, caption);
            painter.end();
            const QRect inked = inkOf(image).translated(-200, -200);
            QVERIFY(inked.height() > QFontInfo(caption.font).pixelSize() / 2);
            QVERIFY2(pane.contains(inked) && inked.top() > picture.bottom(),
                     qPrintable(QStringLiteral("%1 %2").arg(inked.left()).arg(inked.right())));
        }
    }

    void aPaneShowsItsOtfInACorner() {
        const QRect pane(0, 0, 400, 440);
        const CaptionLayout caption = captionLayout({"x²"}, pane.width(), QFont());
        const QColor colour("#b48ead");
        PaneFace face{.name = "x²", .frame = colour};
        const auto painted = [&] {
            QImage image(pane.size(), QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            paintFace(painter, pane, face, caption);
            painter.end();
            return image.copy(pictureIn(pane, caption).adjusted(4, 4, -4, -4));
        };
        QVERIFY(inkOf(painted()).isEmpty());
        face.otf = ManualCurve{{{0.5, 0.0}, {1.0, 1.0}}};  // clear up to half the intensity, then a rise to the full
        const QImage with = painted();
        const QRect box = inkOf(with);
        QVERIFY(box.right() < with.width() / 2 && box.top() > with.height() / 2);
        const auto isColour = [&](int x, int y) { return QColor(with.pixel(x, y)).hsvSaturation() > 30; };
        const auto rows = [&](int from, int to) {
            int most = 0;
            for (int x = from; x < to; ++x)
                for (int y = box.top() + 2; y < box.bottom() - 2; ++y)
                    if (isColour(x, y)) most = std::max(most, box.bottom() - y);
            return most;
        };
        QVERIFY(rows(box.left() + 2, box.center().x()) < box.height() / 4);
        QVERIFY(rows(box.center().x(), box.right() - 1) > 3 * box.height() / 4);
    }

    void theWipeShowsOnePictureLeftAndTheOtherRight() {
        ComparePane pane("pane");
        pane.resize(300, 260);
        pane.setImage(plain(Qt::red));
        pane.setWipe(plain(Qt::blue), 0.25);
        pane.show();
        const QRect picture = pane.pictureRect();
        const auto colourAt = [&](double share) {
            const QImage shot = pane.grab().toImage();
            return shot.pixelColor(picture.x() + static_cast<int>(share * picture.width()), picture.y() + 10);
        };
        QVERIFY(colourAt(0.1) == QColor(Qt::red));
        QVERIFY(colourAt(0.5) == QColor(Qt::blue));
        QSignalSpy wiped(&pane, &ComparePane::wipeMoved), turned(&pane, &ComparePane::orbited);
        const QPoint line(picture.x() + picture.width() / 4, picture.y() + 20);
        QTest::mousePress(&pane, Qt::LeftButton, {}, line);
        const QPoint to(picture.x() + picture.width() / 2, line.y());
        QMouseEvent move(QEvent::MouseMove, to, pane.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&pane, &move);
        QCOMPARE(turned.count(), 0);
        QVERIFY(std::abs(wiped.last().first().toDouble() - 0.5) < 0.01);
        QSignalSpy cancelled(&pane, &ComparePane::dragCancelled);
        QTest::keyClick(&pane, Qt::Key_Escape);
        QCOMPARE(cancelled.count(), 1);
        QVERIFY(!pane.dragging());
    }

    void keysOfAPaneOrbitPanAndZoom() {
        ComparePane pane("pane");
        pane.show();
        QSignalSpy orbits(&pane, &ComparePane::orbited), pans(&pane, &ComparePane::panned);
        QSignalSpy zooms(&pane, &ComparePane::zoomed), wipes(&pane, &ComparePane::wipeMoved);
        QTest::keyClick(&pane, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(orbits.last().first().toDouble(), 1.0 / 180);
        QTest::keyClick(&pane, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(pans.count(), 1);
        QTest::keyClick(&pane, Qt::Key_Plus);
        QCOMPARE(zooms.count(), 1);
        QTest::keyClick(&pane, Qt::Key_Left);
        QCOMPARE(wipes.count(), 0);  // the window's own key, where nothing is wiped
        pane.setWipe(plain(Qt::blue), 0.5);
        QTest::keyClick(&pane, Qt::Key_Left);
        QCOMPARE(wipes.last().first().toDouble(), 0.48);
    }

    void aColouredPaneHasANeutralFrame() {
        ComparePane pane(QStringLiteral("pane"));
        pane.resize(300, 260);
        PaneFace face{.name = "manual", .frame = QColor(0xe8, 0xb0, 0x4b)};
        pane.setFace(face);
        const auto frame = [&] { return pane.grab().toImage().pixelColor(1, 130); };
        QCOMPARE(frame(), *face.frame);
        face.coloured = true;
        pane.setFace(face);
        QCOMPARE(frame(), coloursOverPictures().line);
        const QImage unchosen = pane.grab().toImage();
        pane.show();
        pane.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&pane));
        pane.setFocus();
        QVERIFY(pane.hasFocus());
        const QImage chosen = pane.grab().toImage();
        int signs = 0;
        for (int x = 0; x < chosen.width(); ++x)
            if (chosen.pixelColor(x, 3) != unchosen.pixelColor(x, 3)) {
                QCOMPARE(chosen.pixelColor(x, 3), coloursOverPictures().text);
                ++signs;
            }
        QVERIFY(signs > 50);
    }

    void noWordOfAPairIsCut() {
        const QString longest = "2: (b) Manually designed piecewise linear OTF";
        ComparePanel panel;
        panel.setPanes({{}, {.curve = CurveKind::linear}},
                       {"(a) Linear OTF", "(b) Manually designed piecewise linear OTF"});
        panel.resize(329, 900);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto* first = panel.findChild<NarrowCombo*>("compare.first");
        auto* second = panel.findChild<NarrowCombo*>("compare.second");
        QCOMPARE(first->shownText(), QString("1: (a) Linear OTF"));
        QCOMPARE(second->currentText(), longest);
        QCOMPARE(second->shownText(), QString("2: (b) Manually designed…"));
        QVERIFY(second->fontMetrics().horizontalAdvance(second->shownText()) < second->width());
        QVERIFY2(second->toolTip().startsWith(longest + ". Right of"), qPrintable(second->toolTip()));
        second->setEnabled(true);
        second->showPopup();
        QVERIFY(second->view()->viewport()->width() > second->fontMetrics().horizontalAdvance(longest));
        second->hidePopup();
    }
};

ECHOLUCENT_TEST_CLASS(TestCompare)
#include "test_compare.moc"
