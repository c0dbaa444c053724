// The map of an OTF over intensity and gradient magnitude in the corner of a picture.
#include <QImage>
#include <QPainter>
#include <QTest>
#include <utility>

#include "tests/qt_program/test_classes.h"
#include "widgets/compare/pane_face.h"

using namespace echolucent;

namespace {

const QRect pane(0, 0, 400, 440);

/// Opaque at bright echoes with a large gradient alone.
Classification cornerOtf() { return Classification(TwoDimensionalOtf{2, 2, 1.0, {0, 0, 0, 1}}); }

QImage painted(const PaneFace& face, const CaptionLayout& caption, InsetMap* kept = nullptr) {
    QImage image(pane.size(), QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    paintFace(painter, pane, face, caption, kept);
    return image;
}

}  // namespace

class TestInsetMap : public QObject {
    Q_OBJECT

private slots:
    void itIsBilinearBetweenTheNodes() {
        const CaptionLayout caption = captionLayout({"Levoy"}, pane.width(), QFont());
        const QImage image = painted({.name = "Levoy", .otf = cornerOtf()}, caption);
        const QRectF inset = insetIn(pictureIn(pane, caption));
        const auto greyAt = [&](double right, double up) {
            return qGray(image.pixel(
                QPointF(inset.left() + right * inset.width(), inset.bottom() - up * inset.height()).toPoint()));
        };
        QVERIFY(greyAt(0.9, 0.9) > 200);
        for (const auto& [right, up] : {std::pair(0.9, 0.1), std::pair(0.1, 0.9), std::pair(0.1, 0.1)})
            QVERIFY2(greyAt(right, up) < 40, qPrintable(QString::number(greyAt(right, up))));
        // Half of half, within what the inset's border takes of its height.
        QVERIFY2(std::abs(greyAt(0.5, 0.5) - 64) < 12, qPrintable(QString::number(greyAt(0.5, 0.5))));
    }

    void anUnchangedOneIsNotMadeAgain() {
        const CaptionLayout caption = captionLayout({"Levoy"}, pane.width(), QFont());
        PaneFace face{.name = "Levoy", .otf = cornerOtf()};
        InsetMap kept;
        const QImage first = painted(face, caption, &kept);
        const qint64 made = kept.image.cacheKey();
        face.numbers = "right 80 %";
        painted(face, caption, &kept);
        QCOMPARE(kept.image.cacheKey(), made);
        face.numbers.clear();
        face.otf = Classification(TwoDimensionalOtf{2, 2, 1.0, {1, 1, 1, 1}});
        QVERIFY(painted(face, caption, &kept) != first);
        QVERIFY(kept.image.cacheKey() != made);
        QCOMPARE(painted(face, caption, &kept), painted(face, caption));
    }
};

ECHOLUCENT_TEST_CLASS(TestInsetMap)
#include "test_inset_map.moc"
