// Who renders: the choice, what OpenGL says about itself, and cards that fail in every way that a test can feign.
#include <vtkOpenGLRenderWindow.h>
#include <vtkOutputWindow.h>
#include <QTest>

#include "processing/card_picture/card_pictures.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/scene/graphics_card/card_answers.h"

using namespace echolucent;
using namespace echolucent::testing;

namespace {

constexpr int pixelsOfScene = 40;

/// What a card answers in the place of the one there is.
struct FeignedCard {
    std::string name = "A card";
    std::int64_t freeBytes = -1;
    CardError error = CardError::none;
    bool drawsWrongly = false, compiles = true;
    int asked = 0, checked = 0;

    CardAnswers answers() {
        CardAnswers answers;
        answers.describe = [this](vtkOpenGLRenderWindow&) {
            ++asked;
            return GraphicsCard{name, 2048, freeBytes};
        };
        answers.error = [this](vtkOpenGLRenderWindow& window) {
            (void)newestCardError(window);
            return error;
        };
        answers.shaderSource = [this](std::string source) { return compiles ? source : source + "no word of GLSL"; };
        answers.drewKnownPicture = [this](Picture picture) {
            ++checked;
            if (drawsWrongly)
                for (float& value : picture.rgba) value *= 0.8f;
            return picture;
        };
        return answers;
    }
};

/// A scene whose software picture is red.
struct CardScene {
    explicit CardScene(FeignedCard& card) : drawn(pixelsOfScene, pixelsOfScene) {
        drawn.scene.setCardAnswers(card.answers());
        drawn.scene.setVolume(volume);
        settings.width = settings.height = pixelsOfScene;
        settings.camera = cameraOn(*volume, {});
        showSoftware();
    }
    void showSoftware() {
        drawn.scene.show(
            std::make_shared<const ScreenPicture>(plainPicture(pixelsOfScene, pixelsOfScene, {200, 0, 0, 255})),
            settings.camera);
        drawn.draw();
    }
    /// Begins a picture that needs several drawings.
    void drawSlowly() {
        drawn.scene.setCardPatience(0.0);
        settings.step = 0.01;
        settings.width = settings.height = 5 * pixelsOfScene;
        drawByCard();
    }
    void drawByCard() {
        drawn.scene.show(
            std::make_shared<const CardPicture>(CardPictures(volume).make(PowerCurve{1, 1.0}, settings).value()),
            known);
        drawn.draw();
    }
    [[nodiscard]] bool showsSoftware() { return drawn.at(20, 20) == Level{200, 0, 0}; }
    [[nodiscard]] bool isByCard() const { return drawn.scene.rendererInUse() == RendererChoice::graphicsCard; }
    [[nodiscard]] bool says(const char* words) const {
        const std::string why = drawn.scene.whySoftware();
        return why.find(words) != std::string::npos && why.back() == '.' && why.find(". ") == std::string::npos;
    }
    std::shared_ptr<const Volume> volume = ballInTheCorner();
    std::shared_ptr<const KnownCardPicture> known = std::make_shared<const KnownCardPicture>(knownCardPicture());
    RayCastSettings settings;
    DrawnScene drawn;
};

}  // namespace

class RendererChoiceTest : public QObject {
    Q_OBJECT

private slots:
    void softwareIsChosenWhereOpenGlIsSoftware() {
        DrawnScene drawn(40, 40);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::software);  // nothing known yet
        QVERIFY(drawn.scene.openGlRenderer().empty());
        drawn.draw();
        QVERIFY(!drawn.scene.openGlRenderer().empty());
        const bool software = isSoftwareOpenGl(drawn.scene.openGlRenderer());
        QCOMPARE(drawn.scene.graphicsCardAtHand(), !software);
        QCOMPARE(drawn.scene.rendererInUse(), software ? RendererChoice::software : RendererChoice::graphicsCard);
        QCOMPARE(drawn.scene.whySoftware().empty(), !software);
        drawn.scene.setRenderer(RendererChoice::graphicsCard);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::graphicsCard);
        drawn.scene.setRenderer(RendererChoice::software);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::software);
        QVERIFY(drawn.scene.whySoftware().empty());  // it was the choice
    }

    void softwareOpenGlIsKnownByName_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("software");
        QTest::newRow("llvmpipe") << "llvmpipe (LLVM 15.0.6, 256 bits)" << true;
        QTest::newRow("softpipe") << "softpipe" << true;
        QTest::newRow("SWR") << "SWR (LLVM 11.0.1, 256 bits)" << true;
        QTest::newRow("SwiftShader")
            << "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)" << true;
        QTest::newRow("Software Rasterizer") << "Software Rasterizer" << true;
        QTest::newRow("Intel") << "Mesa Intel(R) UHD Graphics 620 (KBL GT2)" << false;
        QTest::newRow("AMD") << "AMD Radeon RX 6700 XT (radeonsi, navi22, LLVM 15.0.6, DRM 3.49)" << false;
        QTest::newRow("NVIDIA") << "NVIDIA GeForce RTX 3060/PCIe/SSE2" << false;
        QTest::newRow("Apple") << "Apple M1" << false;
    }
    void softwareOpenGlIsKnownByName() {
        QFETCH(QString, name);
        QFETCH(bool, software);
        QCOMPARE(isSoftwareOpenGl(name.toStdString()), software);
    }

    void aVolumeThatDoesNotFitIsLeftToTheRayCasterWithItsReason() {
        const GraphicsCard card{"card", 2048, std::int64_t{100} << 20};
        VolumeGeometry geometry = geometryOf(2048, 10, 10);
        QVERIFY(whyTooLarge(geometry, 1000, card).empty());
        geometry.size[1] = 2049;
        QVERIFY(whyTooLarge(geometry, 1000, card).find("2049") != std::string::npos);
        geometry.size[1] = 10;
        QVERIFY(whyTooLarge(geometry, std::int64_t{101} << 20, card).find("101 MB") != std::string::npos);
        QVERIFY(whyTooLarge(geometry, std::int64_t{101} << 20, GraphicsCard{"silent", 2048, -1}).empty());

        FeignedCard small{.freeBytes = 100000};
        CardScene scene(small);
        QVERIFY(!scene.isByCard());  // 46,080 voxels, their light and the picture need more
        QVERIFY(scene.says("of its memory"));
        FeignedCard narrow;
        CardScene other(narrow);
        QVERIFY(other.isByCard());
        other.drawn.scene.setVolume(volumeOf(geometryOf(2049, 1, 1), [](double, double, double) { return 100; }));
        QVERIFY(!other.isByCard() && other.says("2049"));
        other.drawn.scene.setVolume(other.volume);
        QVERIFY(other.isByCard());  // the next volume fits
    }

    void aCardThatDrawsRightlyDraws() {
        FeignedCard card;
        CardScene scene(card);
        QVERIFY(scene.isByCard());
        scene.drawByCard();
        QVERIFY(scene.isByCard() && scene.drawn.scene.whySoftware().empty());
        QVERIFY(!scene.showsSoftware());
        QCOMPARE(card.checked, 1);
        scene.settings.step = 0.9;
        scene.drawByCard();
        QCOMPARE(card.checked, 1);  // once
        QCOMPARE(card.asked, 1);
    }

    void aCardThatDrawsWronglyIsNotUsed() {
        FeignedCard card{.drawsWrongly = true};
        CardScene scene(card);
        QVERIFY(scene.isByCard());  // nobody knows yet
        scene.drawByCard();
        QVERIFY(!scene.isByCard());
        QVERIFY2(scene.says("known"), scene.drawn.scene.whySoftware().c_str());
        QVERIFY(scene.showsSoftware());  // nothing is lost
        scene.drawn.scene.setVolume(scene.volume);
        scene.drawn.scene.setRenderer(RendererChoice::graphicsCard);
        QVERIFY(!scene.isByCard());  // it gets no other chance
    }

    void anotherCardIsAskedAndCheckedAnew() {
        FeignedCard card;
        CardScene scene(card);
        scene.drawByCard();
        QCOMPARE(card.checked, 1);
        // The window moves to a screen of another card, which draws wrongly.
        card.name = "Another card";
        card.drawsWrongly = true;
        scene.drawn.scene.forgetCard();
        scene.drawn.draw();
        QCOMPARE(scene.drawn.scene.openGlRenderer(), std::string("Another card"));
        QCOMPARE(card.checked, 2);
        QVERIFY(!scene.isByCard() && scene.says("known"));
        // And back.
        card.name = "A card";
        card.drawsWrongly = false;
        scene.drawn.scene.forgetCard();
        scene.drawn.draw();
        QVERIFY(scene.isByCard());
        scene.drawByCard();
        QCOMPARE(card.checked, 3);
        QVERIFY(scene.isByCard());
    }

    void aNewContextIsCheckedAnewAndShowsThePictureAgain() {
        FeignedCard card;
        CardScene scene(card);
        scene.drawByCard();
        const Level before = scene.drawn.at(11, 9);
        scene.drawn.window->Finalize();  // the context ends, and with it all textures
        scene.drawn.draw();
        QCOMPARE(card.checked, 2);
        QVERIFY(scene.isByCard());
        QCOMPARE(scene.drawn.at(11, 9), before);
    }

    void failuresLeaveThePictureAndSayWhy_data() {
        QTest::addColumn<CardError>("error");
        QTest::addColumn<QString>("words");
        QTest::newRow("memory refused") << CardError::outOfMemory << "too little memory";
        QTest::newRow("context lost") << CardError::contextLost << "was lost";
    }
    void failuresLeaveThePictureAndSayWhy() {
        QFETCH(CardError, error);
        QFETCH(QString, words);
        FeignedCard card;
        CardScene scene(card);
        card.error = error;
        scene.drawByCard();
        QVERIFY(!scene.isByCard());
        QVERIFY2(scene.says(qPrintable(words)), scene.drawn.scene.whySoftware().c_str());
        QVERIFY(scene.showsSoftware());
        // The next volume, or the person's choice, gives the card another chance.
        card.error = CardError::none;
        scene.drawn.scene.setRenderer(RendererChoice::automatic);
        QVERIFY(scene.isByCard());
        scene.drawByCard();
        QVERIFY2(scene.isByCard() && !scene.showsSoftware(), scene.drawn.scene.whySoftware().c_str());
        // The card's own picture stays too, if the card is there.
        const Level before = scene.drawn.at(11, 9);
        QVERIFY(before != (Level{0, 0, 0}));
        card.error = error;
        scene.settings.step = 0.5;
        scene.drawByCard();
        QVERIFY(!scene.isByCard());
        QCOMPARE(scene.drawn.at(11, 9), error == CardError::contextLost ? (Level{0, 0, 0}) : before);
    }

    void whatACardHasNotFinishedEndsWithTheSoftwaresPicture() {
        FeignedCard card;
        CardScene scene(card);
        scene.drawSlowly();
        QVERIFY(scene.drawn.scene.cardGoesOn());
        scene.showSoftware();
        QVERIFY(!scene.drawn.scene.cardGoesOn());
        QVERIFY(scene.showsSoftware());
    }

    void nobodySeesTheKnownPicture() {
        FeignedCard card;
        CardScene scene(card);
        scene.drawByCard();
        scene.drawSlowly();
        scene.drawn.scene.forgetCard();
        scene.drawn.draw();
        QVERIFY(scene.drawn.scene.cardGoesOn());
        QCOMPARE(scene.drawn.at(pixelsOfScene / 2, pixelsOfScene / 2), (Level{0, 0, 0}));
    }

    void aDriverThatDoesNotUnderstandTheShaderIsNoTrouble() {
        vtkObject::GlobalWarningDisplayOff();  // VTK would print the shader
        FeignedCard card{.compiles = false};
        CardScene scene(card);
        scene.drawByCard();
        vtkObject::GlobalWarningDisplayOn();
        QVERIFY(!scene.isByCard() && scene.says("shader"));
        QVERIFY(scene.showsSoftware());
    }
};

ECHOLUCENT_TEST_CLASS(RendererChoiceTest)
#include "test_renderer_choice.moc"
