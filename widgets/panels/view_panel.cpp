#include "widgets/panels/view_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
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
    m_shaded = named(new QCheckBox(tr("Light")), "view.shaded", tr("Light"),
                     tr("Shades surfaces with a light from the upper left front"));
    m_shaded->setChecked(true);
    createChoices();
    createPhaseSelector();
    arrange();
    setNearCutRange(100);
    setPhaseCount(1);

    connect(m_nearCut, &ValueSlider::valueChanged, this, &ViewPanel::nearCutChanged);
    connect(m_shaded, &QCheckBox::toggled, this, &ViewPanel::shadedChanged);
    connect(m_colourMap, &QComboBox::currentIndexChanged, this, [this] { emit colourMapChanged(colourMap()); });
    connect(m_interpolation, &QComboBox::currentIndexChanged, this,
            [this] { emit interpolationChanged(interpolation()); });
    connect(m_projection, &QComboBox::currentIndexChanged, this, [this] { emit projectionChanged(projection()); });
    connect(m_beamAxis, &QComboBox::currentIndexChanged, this, [this] { emit beamAxisChanged(beamAxis()); });
}

void ViewPanel::createChoices() {
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

void ViewPanel::arrange() {
    auto* reset = named(new QPushButton(tr("Reset view")), "view.reset", tr("Reset view"),
                        tr("Looks along the beam axis at the whole volume (R)"));
    auto* savePicture = named(new QPushButton(tr("Save picture…")), "view.savePicture", tr("Save picture"),
                              tr("Writes the picture as PNG (P)"));
    connect(reset, &QPushButton::clicked, this, &ViewPanel::resetRequested);
    connect(savePicture, &QPushButton::clicked, this, &ViewPanel::savePictureRequested);

    auto* suggest = named(new QPushButton(tr("Suggest")), "view.nearCut.suggest", tr("Suggest a near cut"),
                          tr("Cuts where most tube cores have left the tissue in front and have entered fluid"));
    connect(suggest, &QPushButton::clicked, this, &ViewPanel::nearCutSuggestionRequested);
    auto* nearCut = new QHBoxLayout;
    nearCut->addWidget(m_nearCut, 1);
    nearCut->addWidget(suggest);

    auto* grid = new QGridLayout;
    m_phaseLabel = labelFor(m_phaseSlider, tr("Phase"));
    grid->addWidget(labelFor(m_nearCut, tr("Near cut")), 0, 0);
    grid->addLayout(nearCut, 0, 1, 1, 3);
    grid->addWidget(m_phaseLabel, 1, 0);
    grid->addWidget(m_phaseSelector, 1, 1, 1, 3);
    grid->addWidget(labelFor(m_colourMap, tr("Colour map")), 2, 0);
    grid->addWidget(m_colourMap, 2, 1);
    grid->addWidget(labelFor(m_beamAxis, tr("Beam axis")), 2, 2);
    grid->addWidget(m_beamAxis, 2, 3);
    grid->addWidget(labelFor(m_interpolation, tr("Interpolation")), 3, 0);
    grid->addWidget(m_interpolation, 3, 1);
    grid->addWidget(labelFor(m_projection, tr("Projection")), 3, 2);
    grid->addWidget(m_projection, 3, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_shaded, 1);
    buttons->addWidget(reset, 1);
    buttons->addWidget(savePicture, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addLayout(buttons);
    layout->addStretch(1);
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
