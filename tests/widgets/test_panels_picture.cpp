// The panel of the picture: real keys and clicks, each heard once; setters are silent.
#include <QByteArray>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QList>
#include <QLocale>
#include <QObject>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QString>
#include <QTest>
#include <QToolButton>
#include <QWidget>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/panels/light_amount.h"
#include "widgets/panels/view_panel.h"

using namespace echolucent;

class TestPanelsPicture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void nearCutBySliderAndByNumber() {
        ViewPanel panel;
        panel.setFrontRange(46.84);
        AllSignals all(panel);
        QSignalSpy spy(&panel, &ViewPanel::frontChanged);
        QTest::keyClick(child<QSlider>(panel, "view.nearCut"), Qt::Key_Right);
        QCOMPARE(spy.takeFirst().first().toDouble(), 0.1);
        auto* number = child<QDoubleSpinBox>(panel, "view.nearCut.value");
        number->selectAll();
        QTest::keyClicks(number, "18");
        QTest::keyClick(number, Qt::Key_Return);
        QCOMPARE(spy.takeFirst().first().toDouble(), 18.0);
        QCOMPARE(child<QSlider>(panel, "view.nearCut")->value(), 180);
        QTest::keyClick(child<QSlider>(panel, "view.nearCut"), Qt::Key_End);
        QCOMPARE(spy.takeFirst().first().toDouble(), 46.8);  // one decimal, within the range
        QCOMPARE(panel.frontMm(), 46.8);
        QCOMPARE(all.count(), 3);
    }

    void nearCutRangeClampsSilently() {
        ViewPanel panel;
        panel.setFrontRange(50);
        panel.setFrontMm(40);
        AllSignals all(panel);
        panel.setFrontRange(30);
        QCOMPARE(panel.frontMm(), 30.0);
        panel.setFrontMm(99);
        QCOMPARE(panel.frontMm(), 30.0);
        panel.setFrontRange(-1);
        QCOMPARE(panel.frontMm(), 0.0);
        QCOMPARE(all.count(), 0);
    }

    void unknownSpacingIsSaid() {
        ViewPanel panel;
        auto* number = child<QDoubleSpinBox>(panel, "view.nearCut.value");
        panel.setFrontRange(10, false);
        QVERIFY(number->text().contains("guess"));
        panel.setFrontRange(10, true);
        QCOMPARE(number->text(), "0.0 mm");
    }

    void choicesGiveTheirValueOnce_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("keysDown");
        QTest::newRow("colour map") << "view.colourMap" << 2;
        QTest::newRow("interpolation") << "view.interpolation" << 1;
        QTest::newRow("projection") << "view.projection" << 1;
        QTest::newRow("beam axis") << "view.beamAxis" << 1;
        QTest::newRow("mode") << "view.mode" << 3;
        QTest::newRow("renderer") << "view.renderer" << 1;
    }
    void choicesGiveTheirValueOnce() {
        QFETCH(QString, name);
        QFETCH(int, keysDown);
        ViewPanel panel;
        AllSignals all(panel);
        auto* comboBox = child<QComboBox>(panel, name.toLatin1());
        for (int i = 0; i < keysDown; ++i) QTest::keyClick(comboBox, Qt::Key_Down);
        QCOMPARE(all.count(), keysDown);
    }

    void choicesSayWhatTheyShow() {
        ViewPanel panel;
        QCOMPARE(panel.look(), lookAtStart());
        QCOMPARE(panel.beamAxis(), BeamAxis::plusZ);
        QSignalSpy look(&panel, &ViewPanel::lookChanged);
        QSignalSpy beam(&panel, &ViewPanel::beamAxisChanged);
        QTest::keyClicks(child<QComboBox>(panel, "view.colourMap"), "I");
        QTest::keyClicks(child<QComboBox>(panel, "view.interpolation"), "N");
        QTest::keyClicks(child<QComboBox>(panel, "view.projection"), "Pe");
        QTest::keyClicks(child<QComboBox>(panel, "view.beamAxis"), "+y");
        Look expected = lookAtStart();
        expected.colourMap = ColourMap::ice;
        expected.interpolation = Interpolation::nearest;
        expected.projection = Projection::perspective;
        QCOMPARE(look.last().first().value<Look>(), expected);
        QCOMPARE(panel.look(), expected);
        QCOMPARE(beam.last().first().value<BeamAxis>(), BeamAxis::plusY);
    }

    void beamAxesReadAsWhatTheyAre() {
        ViewPanel panel;
        auto* comboBox = child<QComboBox>(panel, "view.beamAxis");
        const QList<std::pair<BeamAxis, QString>> axes{{BeamAxis::plusX, "+x"}, {BeamAxis::minusX, "−x"},
                                                       {BeamAxis::plusY, "+y"}, {BeamAxis::minusY, "−y"},
                                                       {BeamAxis::plusZ, "+z"}, {BeamAxis::minusZ, "−z"}};
        for (const auto& [axis, text] : axes) {
            panel.setBeamAxis(axis);
            QCOMPARE(comboBox->currentText(), text);
            QCOMPARE(panel.beamAxis(), axis);
        }
    }

    void everyChoiceOfTheLookHasAControl() {
        ViewPanel panel;
        panel.show();
        for (const Parameter<Look>& row : lookParameters()) {
            if (!row.inPanels) continue;
            const std::string name = "view." + camelCase(row.name);
            auto* control = child<QWidget>(panel, name.c_str());
            QVERIFY2(control && control->isVisible(), name.c_str());
            QCOMPARE(control->accessibleName().toStdString(), std::string(row.label));
            if (const auto* choices = qobject_cast<QComboBox*>(control))
                QCOMPARE(static_cast<std::size_t>(choices->count()), row.choices.size());
        }
    }

    void lightAndButtons() {
        ViewPanel panel;
        AllSignals all(panel);
        QSignalSpy look(&panel, &ViewPanel::lookChanged);
        QSignalSpy reset(&panel, &ViewPanel::resetRequested);
        QSignalSpy save(&panel, &ViewPanel::savePictureRequested);
        QSignalSpy suggest(&panel, &ViewPanel::frontSuggestionRequested);
        QTest::keyClick(child<QComboBox>(panel, "view.lighting"), Qt::Key_Up);
        QCOMPARE(look.takeFirst().first().value<Look>().lighting, Lighting::surface);
        QTest::mouseClick(child<QToolButton>(panel, "view.reset"), Qt::LeftButton);
        QTest::mouseClick(child<QPushButton>(panel, "view.savePicture"), Qt::LeftButton);
        QTest::mouseClick(child<QPushButton>(panel, "view.nearCut.suggest"), Qt::LeftButton);
        QCOMPARE(reset.count(), 1);
        QCOMPARE(save.count(), 1);
        QCOMPARE(suggest.count(), 1);
        QCOMPARE(all.count(), 4);
    }

    void lightDirectionByTwoSliders() {
        ViewPanel panel;
        AllSignals all(panel);
        QSignalSpy look(&panel, &ViewPanel::lookChanged);
        QTest::keyClick(child<QSlider>(panel, "view.lightAzimuth"), Qt::Key_Right);
        LightDirection expected = lookAtStart().light;
        ++expected.azimuthDegrees;
        QCOMPARE(look.takeFirst().first().value<Look>().light, expected);
        QTest::keyClick(child<QSlider>(panel, "view.lightElevation"), Qt::Key_Home);
        expected.elevationDegrees = -90;
        QCOMPARE(look.takeFirst().first().value<Look>().light, expected);
        QTest::keyClick(child<QSlider>(panel, "view.lightAzimuth"), Qt::Key_End);
        QCOMPARE(panel.look().light.azimuthDegrees, 180.0);
        QCOMPARE(all.count(), 3);
        Look moved = panel.look();
        moved.light = {12.4, -7.6};
        panel.setLook(moved);
        QCOMPARE(panel.look(), moved);
        QCOMPARE(child<QDoubleSpinBox>(panel, "view.lightAzimuth.value")->value(), 12.0);
        QCOMPARE(child<QDoubleSpinBox>(panel, "view.lightElevation.value")->value(), -8.0);
        QCOMPARE(all.count(), 3);
        // Another control leaves the light as exact as it was.
        QTest::keyClick(child<QCheckBox>(panel, "view.depthColouring"), Qt::Key_Space);
        QCOMPARE(panel.look().light, moved.light);
    }

    void everyLightSliderHasALabelAndAReset() {
        ViewPanel panel;
        panel.show();
        for (const char* name : {"view.lightAzimuth", "view.lightElevation", "view.lightSoftness", "view.shadow",
                                 "view.occlusion", "view.translucency"}) {
            auto* slider = child<QSlider>(panel, name);
            bool labelled = false;
            for (const QLabel* label : panel.findChildren<QLabel*>())
                labelled |= label->isVisible() && label->buddy() == slider->parentWidget() &&
                            label->text() == slider->accessibleName();
            QVERIFY2(labelled, name);
            auto* reset = child<QToolButton>(panel, (QByteArray(name) + ".reset").constData());
            QVERIFY2(!reset->isEnabled(), name);
            const int standard = slider->value();
            QTest::keyClick(slider, Qt::Key_Home);
            QVERIFY2(slider->value() != standard && reset->isEnabled(), name);
            QTest::mouseClick(reset, Qt::LeftButton);
            QCOMPARE(slider->value(), standard);
            QVERIFY2(!reset->isEnabled(), name);
        }
        QCOMPARE(panel.look(), lookAtStart());
    }

    void oneSliderGoesFromFlatToDeepShadows() {
        QCOMPARE(lightAmount(lookAtStart()), 0.75);
        QCOMPARE(withLightAmount(lookAtStart(), 0.75), lookAtStart());
        Look look = withLightAmount(lookAtStart(), 0.4);
        QCOMPARE(look.lighting, Lighting::depth);
        QVERIFY(look.reaching.shadow == 0.4 && look.reaching.occlusion == 0.4);
        QCOMPARE(look.reaching.translucency, lookAtStart().reaching.translucency);
        QCOMPARE(lightAmount(look), 0.4);
        look = withLightAmount(look, 0);
        QCOMPARE(look.lighting, Lighting::flat);
        QCOMPARE(look.light, lookAtStart().light);
        QCOMPARE(lightAmount(look), 0.0);
        look.lighting = Lighting::surface;
        QVERIFY(lightAmount(look) > 0.0 && lightAmount(look) < 0.1);
        look.lighting = Lighting::depth;  // light without any shadow is light
        look.reaching = {};
        look.reaching.shadow = look.reaching.occlusion = 0.0;
        QVERIFY(lightAmount(look) > 0.0);

        ViewPanel panel;
        AllSignals all(panel);
        QSignalSpy moved(&panel, &ViewPanel::lightAmountChanged);
        auto* slider = child<QSlider>(panel, "view.lightAmount");
        auto* number = child<QDoubleSpinBox>(panel, "view.lightAmount.value");
        QCOMPARE(number->value(), 75.0);
        QVERIFY(qAbs(slider->value() - 0.75 * slider->maximum()) < 1);
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(moved.takeFirst().first().value<Look>().lighting, Lighting::flat);
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(moved.takeFirst().first().value<Look>().reaching.shadow, 1.0);
        QCOMPARE(panel.look().lighting, Lighting::depth);
        QCOMPARE(all.count(), 2);
        // The slider follows whoever sets the light.
        QTest::keyClick(child<QComboBox>(panel, "view.lighting"), Qt::Key_Home);
        QCOMPARE(number->value(), 0.0);
    }

    void whatIsGreyedSaysWhy() {
        ViewPanel panel;
        auto* none = child<QPushButton>(panel, "view.front.none");
        const QString meaning = none->toolTip();
        panel.setFrontThere(false);
        QVERIFY(!none->isEnabled());
        QVERIFY(none->toolTip().endsWith("There is no front to take away."));
        panel.setFrontThere(true);
        QCOMPARE(none->toolTip(), meaning);
        Look look = lookAtStart();
        look.mode = RenderMode::maximum;
        panel.setLook(look);
        QWidget* light = child<QSlider>(panel, "view.lightAmount")->parentWidget();
        QVERIFY(!light->isEnabled());
        QVERIFY(light->toolTip().endsWith("There is light in the mode Direct rendering only (More)."));
        QVERIFY(child<QComboBox>(panel, "view.lighting")->toolTip().endsWith("It plays a part only in direct mode."));
        panel.setLook(lookAtStart());
        QVERIFY(!light->toolTip().contains("only"));
    }

    void moreOpensWhatIsSetRarely() {
        ViewPanel panel;
        panel.show();
        auto* more = child<QToolButton>(panel, "view.more");
        QTest::mouseClick(more, Qt::LeftButton);
        for (const char* name : {"view.brightness", "view.reduction", "view.lightAmount", "view.nearCut",
                                 "view.nearCut.suggest", "view.front.fromHere", "view.front.none"})
            QVERIFY2(child<QWidget>(panel, name)->isVisible(), name);
        for (const char* name : {"view.lighting", "view.colourMap", "view.renderer", "view.beamAxis", "view.mode"})
            QVERIFY2(!child<QWidget>(panel, name)->isVisible(), name);
        panel.setMoreShown(true);
        QVERIFY(child<QWidget>(panel, "view.beamAxis")->isVisible());
    }

    void everyGroupHasAReset() {
        ViewPanel panel;
        QSignalSpy resets(&panel, &ViewPanel::lookReset);
        QSignalSpy cut(&panel, &ViewPanel::frontResetRequested);
        Look changed;
        changed.mode = RenderMode::mean;
        changed.lighting = Lighting::flat;
        changed.light = {10, 10};
        changed.depthColoured = true;
        changed.colourMap = ColourMap::ice;
        changed.projection = Projection::perspective;
        changed.interpolation = Interpolation::nearest;
        panel.setLook(changed);
        const auto click = [&](const char* name) {
            QTest::mouseClick(child<QToolButton>(panel, name), Qt::LeftButton);
            return panel.look();
        };
        Look look = click("view.light.reset");
        QCOMPARE(look.light, lookAtStart().light);
        QCOMPARE(look.lighting, lookAtStart().lighting);
        QCOMPARE(look.colourMap, ColourMap::ice);
        QCOMPARE(resets.last().at(1).toString(), "Light in detail");
        QCOMPARE(click("view.speckle.reset").reduction, lookAtStart().reduction);
        look = click("view.colours.reset");
        QVERIFY(look.colourMap == lookAtStart().colourMap && !look.depthColoured);
        QCOMPARE(look.mode, RenderMode::mean);
        QCOMPARE(click("view.rendering.reset"), lookAtStart());
        QCOMPARE(resets.count(), 4);
        click("view.rendering.reset");  // nothing is left to be set back
        QCOMPARE(resets.count(), 4);
        click("view.cut.reset");
        QCOMPARE(cut.count(), 1);
    }

    void theLightIsMovedOnlyWhereThereIsOne() {
        ViewPanel panel;
        const auto enabled = [&](const char* name) { return child<QWidget>(panel, name)->isEnabled(); };
        QVERIFY(enabled("view.lightAzimuth") && enabled("view.lightElevation.value"));
        QTest::keyClick(child<QComboBox>(panel, "view.lighting"), Qt::Key_Home);
        QVERIFY(!enabled("view.lightAzimuth") && !enabled("view.lightElevation.value"));
        Look look = lookAtStart();
        panel.setLook(look);
        QVERIFY(enabled("view.lightAzimuth"));
        look.mode = RenderMode::mean;
        panel.setLook(look);
        QVERIFY(!enabled("view.lightAzimuth") && !enabled("view.lighting") && !enabled("view.depthColouring"));
        QCOMPARE(panel.look().lighting, Lighting::depth);  // as it was, for the way back
        look.mode = RenderMode::direct;
        panel.setLook(look);
        QVERIFY(enabled("view.lightAzimuth") && enabled("view.lighting") && enabled("view.depthColouring"));
    }

    void modesSayThatTheCurvePlaysNoPart() {
        ViewPanel panel;
        panel.show();
        auto* remark = child<QLabel>(panel, "view.mode.remark");
        QVERIFY(!remark->isVisible());
        QSignalSpy look(&panel, &ViewPanel::lookChanged);
        QTest::keyClicks(child<QComboBox>(panel, "view.mode"), "Max");
        QCOMPARE(look.takeFirst().first().value<Look>().mode, RenderMode::maximum);
        QVERIFY(remark->isVisible());
        QVERIFY(remark->text().contains("curve"));
        panel.setLook(lookAtStart());
        QVERIFY(!remark->isVisible());
        QCOMPARE(look.count(), 0);
    }

    void depthColours() {
        ViewPanel panel;
        QVERIFY(!panel.look().depthColoured);
        QSignalSpy look(&panel, &ViewPanel::lookChanged);
        QTest::keyClick(child<QCheckBox>(panel, "view.depthColouring"), Qt::Key_Space);
        QVERIFY(look.takeFirst().first().value<Look>().depthColoured);
        QVERIFY(panel.look().depthColoured);
    }

    void aGraphicsCardIsChosenOnlyWhereThereIsOne() {
        ViewPanel panel;
        QSignalSpy renderer(&panel, &ViewPanel::rendererChanged);
        auto* comboBox = child<QComboBox>(panel, "view.renderer");
        QTest::keyClick(comboBox, Qt::Key_End);
        QCOMPARE(renderer.takeFirst().first().value<RendererChoice>(), RendererChoice::software);
        panel.setGraphicsCardUsable(true);
        QTest::keyClick(comboBox, Qt::Key_Down);
        QCOMPARE(renderer.takeFirst().first().value<RendererChoice>(), RendererChoice::graphicsCard);
        // A wish that cannot be met now is kept for the day when it can.
        panel.setGraphicsCardUsable(false);
        QCOMPARE(panel.renderer(), RendererChoice::graphicsCard);
    }

    void viewSettersAreSilent() {
        ViewPanel panel;
        AllSignals all(panel);
        Look look;
        look.mode = RenderMode::minimum;
        look.light = {20, 30};
        look.depthColoured = true;
        look.colourMap = ColourMap::grey;
        look.interpolation = Interpolation::nearest;
        look.projection = Projection::perspective;
        panel.setLook(look);
        panel.setBeamAxis(BeamAxis::minusY);
        panel.setFrontMm(5);
        panel.setRenderer(RendererChoice::software);
        QCOMPARE(all.count(), 0);
        QCOMPARE(panel.look(), look);
        QCOMPARE(child<QComboBox>(panel, "view.colourMap")->currentText(), "Grey");
        QCOMPARE(child<QComboBox>(panel, "view.mode")->currentText(), "Minimum");
        QCOMPARE(child<QComboBox>(panel, "view.lighting")->currentText(), "Flat");
        QCOMPARE(panel.frontMm(), 5.0);
        QCOMPARE(panel.renderer(), RendererChoice::software);
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsPicture)
#include "test_panels_picture.moc"
