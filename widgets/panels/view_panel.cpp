#include "widgets/panels/view_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <algorithm>

#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {
namespace {

template <typename Choice>
QComboBox* createChoice(const QString& name, const QString& accessibleName, const QString& toolTip,
                        std::initializer_list<std::pair<QString, Choice>> entries) {
    auto* comboBox = named(new QComboBox, "view." + name, accessibleName, toolTip);
    for (const auto& [text, choice] : entries) comboBox->addItem(text, static_cast<int>(choice));
    wheelNeedsFocus(comboBox);
    return comboBox;
}

template <typename Choice>
Choice chosen(const QComboBox* comboBox) {
    return static_cast<Choice>(comboBox->currentData().toInt());
}

}  // namespace

ViewPanel::ViewPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("view");
    setAccessibleName(tr("Picture"));
    m_nearCut = new ValueSlider("view.nearCut", tr("Near cut"), 0.1, 1);
    m_nearCut->setToolTip(tr("Removes what lies before this distance along the view; the tube cores begin there too"));
    createChoices();
    createLight();
    createPhaseSelector();
    arrange();
    setNearCutRange(100);
    setPhaseCount(1);
    setGraphicsCardUsable(false);
    updateForMode();
    connectControls();
}

void ViewPanel::connectControls() {
    connect(m_nearCut, &ValueSlider::valueChanged, this, &ViewPanel::nearCutChanged);
    connect(m_mode, &QComboBox::currentIndexChanged, this, [this] {
        updateForMode();
        emit modeChanged(mode());
    });
    connect(m_shaded, &QCheckBox::toggled, this, [this](bool shaded) {
        updateForMode();
        emit shadedChanged(shaded);
    });
    connect(m_lightAzimuth, &ValueSlider::valueChanged, this, [this] { emit lightChanged(light()); });
    connect(m_lightElevation, &ValueSlider::valueChanged, this, [this] { emit lightChanged(light()); });
    connect(m_depthColoured, &QCheckBox::toggled, this, &ViewPanel::depthColouredChanged);
    connect(m_colourMap, &QComboBox::currentIndexChanged, this, [this] { emit colourMapChanged(colourMap()); });
    connect(m_interpolation, &QComboBox::currentIndexChanged, this,
            [this] { emit interpolationChanged(interpolation()); });
    connect(m_projection, &QComboBox::currentIndexChanged, this, [this] { emit projectionChanged(projection()); });
    connect(m_renderer, &QComboBox::currentIndexChanged, this, [this] { emit rendererChanged(renderer()); });
    connect(m_beamAxis, &QComboBox::currentIndexChanged, this, [this] { emit beamAxisChanged(beamAxis()); });
}

void ViewPanel::createChoices() {
    m_mode = createChoice<RenderMode>("mode", tr("Mode"), tr("What a ray shows of the volume"),
                                      {{tr("Direct rendering"), RenderMode::direct},
                                       {tr("Maximum"), RenderMode::maximum},
                                       {tr("Minimum"), RenderMode::minimum},
                                       {tr("Mean (x-ray)"), RenderMode::mean}});
    m_renderer =
        createChoice<PreferredRenderer>("renderer", tr("Renderer"), tr("The software renderer needs no graphics card"),
                                        {{tr("Automatic"), PreferredRenderer::automatic},
                                         {tr("Software"), PreferredRenderer::software},
                                         {tr("Graphics card"), PreferredRenderer::graphicsCard}});
    m_colourMap = createChoice<ColourMap>(
        "colourMap", tr("Colour map"), tr("Colours from dark to bright echoes"),
        {{tr("Sepia"), ColourMap::sepia}, {tr("Grey"), ColourMap::grey}, {tr("Ice"), ColourMap::ice}});
    m_interpolation = createChoice<Interpolation>(
        "interpolation", tr("Interpolation"), tr("How intensities between voxels are taken"),
        {{tr("Trilinear"), Interpolation::trilinear}, {tr("Nearest voxel"), Interpolation::nearest}});
    m_projection = createChoice<Projection>(
        "projection", tr("Projection"), tr("Parallel keeps sizes, perspective gives depth"),
        {{tr("Parallel"), Projection::parallel}, {tr("Perspective"), Projection::perspective}});
    m_beamAxis = createChoice<BeamAxis>("beamAxis", tr("Beam axis"),
                                        tr("The grid axis along which sound travelled: the default view direction"),
                                        {{"+x", BeamAxis::plusX},
                                         {"−x", BeamAxis::minusX},
                                         {"+y", BeamAxis::plusY},
                                         {"−y", BeamAxis::minusY},
                                         {"+z", BeamAxis::plusZ},
                                         {"−z", BeamAxis::minusZ}});
    selectData(m_beamAxis, static_cast<int>(BeamAxis::plusZ));
}

void ViewPanel::createLight() {
    m_shaded = named(new QCheckBox(tr("Light")), "view.shaded", tr("Light"),
                     tr("Shades surfaces. Ctrl + left drag in the picture moves the light"));
    m_shaded->setChecked(true);
    m_depthColoured = named(new QCheckBox(tr("Depth colours")), "view.depthColouring", tr("Depth colours"),
                            tr("Tints what is near warm and what is far blue"));
    const auto createAngle = [](const QString& name, const QString& accessibleName, const QString& toolTip,
                                double largest) {
        auto* angle = new ValueSlider("view." + name, accessibleName, 1, 0);
        angle->setToolTip(toolTip);
        angle->setRange(-largest, largest);
        angle->setSuffix(QStringLiteral("°"));
        return angle;
    };
    m_lightAzimuth = createAngle("lightAzimuth", tr("Azimuth of the light"),
                                 tr("How far to the right of you the light stands"), 180);
    m_lightElevation =
        createAngle("lightElevation", tr("Elevation of the light"), tr("How far above you the light stands"), 90);
    setLight({});
}

void ViewPanel::createPhaseSelector() {
    const QString toolTip = tr("Phase of the 4D study");
    m_phaseSlider = named(new QSlider(Qt::Horizontal), "view.phase", tr("Phase"), toolTip);
    m_phaseSpinBox = named(new QSpinBox, "view.phase.value", tr("Phase"), toolTip);
    m_phaseSpinBox->setKeyboardTracking(false);
    m_phaseSpinBox->setAlignment(Qt::AlignRight);
    wheelNeedsFocus(m_phaseSlider);
    wheelNeedsFocus(m_phaseSpinBox);
    connect(m_phaseSlider, &QSlider::valueChanged, this, [this](int phase) {
        showPhase(phase);
        emit phaseChanged(phase);
    });
    connect(m_phaseSpinBox, &QSpinBox::valueChanged, this, [this](int number) {
        showPhase(number - 1);
        emit phaseChanged(number - 1);
    });
    m_phaseSelector = new QWidget;
    auto* layout = new QHBoxLayout(m_phaseSelector);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_phaseSlider, 1);
    layout->addWidget(m_phaseSpinBox);
}

QLayout* ViewPanel::createNearCutRow() {
    auto* suggest = named(new QPushButton(tr("Suggest")), "view.nearCut.suggest", tr("Suggest a near cut"),
                          tr("Cuts where most tube cores have left the tissue in front and have entered fluid"));
    connect(suggest, &QPushButton::clicked, this, &ViewPanel::nearCutSuggestionRequested);
    auto* row = new QHBoxLayout;
    row->addWidget(m_nearCut, 1);
    row->addWidget(suggest);
    return row;
}

QLayout* ViewPanel::createButtons() {
    auto* reset = named(new QPushButton(tr("Reset view")), "view.reset", tr("Reset view"),
                        tr("Looks along the beam axis at the whole volume (R)"));
    auto* savePicture = named(new QPushButton(tr("Save picture…")), "view.savePicture", tr("Save picture"),
                              tr("Writes the picture as PNG (P)"));
    connect(reset, &QPushButton::clicked, this, &ViewPanel::resetRequested);
    connect(savePicture, &QPushButton::clicked, this, &ViewPanel::savePictureRequested);
    auto* row = new QHBoxLayout;
    row->addWidget(m_depthColoured, 1);
    row->addWidget(reset, 1);
    row->addWidget(savePicture, 1);
    return row;
}

void ViewPanel::arrange() {
    m_modeRemark = named(new QLabel(tr("In this mode the opacity curve, light and depth colours play no part.")),
                         "view.mode.remark", tr("Remark on the mode"));
    m_modeRemark->setWordWrap(true);
    auto* grid = new QGridLayout;
    const auto add = [grid](int row, int column, QWidget* control, const QString& text) {
        grid->addWidget(labelFor(control, text), row, column);
        grid->addWidget(control, row, column + 1);
    };
    m_phaseLabel = labelFor(m_phaseSlider, tr("Phase"));
    grid->addWidget(labelFor(m_nearCut, tr("Near cut")), 0, 0);
    grid->addLayout(createNearCutRow(), 0, 1, 1, 3);
    grid->addWidget(m_phaseLabel, 1, 0);
    grid->addWidget(m_phaseSelector, 1, 1, 1, 3);
    add(2, 0, m_mode, tr("Mode"));
    add(2, 2, m_beamAxis, tr("Beam axis"));
    grid->addWidget(m_modeRemark, 3, 0, 1, 4);
    add(4, 0, m_colourMap, tr("Colour map"));
    add(4, 2, m_projection, tr("Projection"));
    add(5, 0, m_interpolation, tr("Interpolation"));
    add(5, 2, m_renderer, tr("Renderer"));
    auto* light = new QHBoxLayout;
    light->addWidget(m_lightAzimuth, 1);
    light->addWidget(m_lightElevation, 1);
    grid->addWidget(m_shaded, 6, 0);
    grid->addLayout(light, 6, 1, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addLayout(createButtons());
    layout->addStretch(1);
}

void ViewPanel::updateForMode() {
    const bool direct = mode() == RenderMode::direct;
    m_modeRemark->setVisible(!direct);
    m_shaded->setEnabled(direct);
    m_depthColoured->setEnabled(direct);
    m_lightAzimuth->setEnabled(direct && shaded());
    m_lightElevation->setEnabled(direct && shaded());
}

double ViewPanel::nearCutMm() const { return m_nearCut->value(); }

void ViewPanel::setNearCutMm(double mm) { m_nearCut->setValue(mm); }

void ViewPanel::setNearCutRange(double maxMm, bool spacingKnown) {
    m_nearCut->setRange(0, std::max(0.0, maxMm));
    m_nearCut->setSuffix(spacingKnown ? tr(" mm") : tr(" mm (guess)"));
}

bool ViewPanel::shaded() const { return m_shaded->isChecked(); }

void ViewPanel::setShaded(bool shaded) {
    const QSignalBlocker blocker(m_shaded);
    m_shaded->setChecked(shaded);
    updateForMode();
}

LightDirection ViewPanel::light() const { return {m_lightAzimuth->value(), m_lightElevation->value()}; }

void ViewPanel::setLight(const LightDirection& light) {
    m_lightAzimuth->setValue(light.azimuthDegrees);
    m_lightElevation->setValue(light.elevationDegrees);
}

bool ViewPanel::depthColoured() const { return m_depthColoured->isChecked(); }

void ViewPanel::setDepthColoured(bool coloured) {
    const QSignalBlocker blocker(m_depthColoured);
    m_depthColoured->setChecked(coloured);
}

RenderMode ViewPanel::mode() const { return chosen<RenderMode>(m_mode); }

void ViewPanel::setMode(RenderMode mode) {
    selectData(m_mode, static_cast<int>(mode));
    updateForMode();
}

PreferredRenderer ViewPanel::renderer() const { return chosen<PreferredRenderer>(m_renderer); }
void ViewPanel::setRenderer(PreferredRenderer renderer) { selectData(m_renderer, static_cast<int>(renderer)); }

void ViewPanel::setGraphicsCardUsable(bool usable) {
    auto* model = qobject_cast<QStandardItemModel*>(m_renderer->model());
    QStandardItem* item = model->item(m_renderer->findData(static_cast<int>(PreferredRenderer::graphicsCard)));
    item->setEnabled(usable);
    item->setToolTip(usable ? QString() : tr("No graphics card is usable here"));
}

ColourMap ViewPanel::colourMap() const { return chosen<ColourMap>(m_colourMap); }
void ViewPanel::setColourMap(ColourMap map) { selectData(m_colourMap, static_cast<int>(map)); }
Interpolation ViewPanel::interpolation() const { return chosen<Interpolation>(m_interpolation); }
void ViewPanel::setInterpolation(Interpolation choice) { selectData(m_interpolation, static_cast<int>(choice)); }
Projection ViewPanel::projection() const { return chosen<Projection>(m_projection); }
void ViewPanel::setProjection(Projection projection) { selectData(m_projection, static_cast<int>(projection)); }
BeamAxis ViewPanel::beamAxis() const { return chosen<BeamAxis>(m_beamAxis); }
void ViewPanel::setBeamAxis(BeamAxis axis) { selectData(m_beamAxis, static_cast<int>(axis)); }

void ViewPanel::setPhaseCount(int count) {
    Q_ASSERT(count >= 1);
    const int kept = phase() < count ? phase() : 0;
    {
        const QSignalBlocker sliderBlocker(m_phaseSlider);
        const QSignalBlocker spinBoxBlocker(m_phaseSpinBox);
        m_phaseSlider->setRange(0, count - 1);
        m_phaseSpinBox->setRange(1, count);
        m_phaseSpinBox->setSuffix(tr(" of %1").arg(count));
    }
    showPhase(kept);
    m_phaseLabel->setVisible(count > 1);
    m_phaseSelector->setVisible(count > 1);
}

int ViewPanel::phase() const { return m_phaseSlider->value(); }
void ViewPanel::setPhase(int phase) { showPhase(phase); }

void ViewPanel::showPhase(int phase) {
    const QSignalBlocker sliderBlocker(m_phaseSlider);
    const QSignalBlocker spinBoxBlocker(m_phaseSpinBox);
    m_phaseSlider->setValue(phase);
    m_phaseSpinBox->setValue(phase + 1);
}

}  // namespace echolucent
