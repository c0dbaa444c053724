#include "widgets/panels/view_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <algorithm>
#include <array>
#include <string_view>

#include "widgets/panels/look_controls.h"
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
    m_look = new LookControls(this);
    createChoices();
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
    connect(m_look, &LookControls::changed, this, [this](const Look& look) {
        updateForMode();
        emit lookChanged(look);
    });
    connect(m_renderer, &QComboBox::currentIndexChanged, this, [this] { emit rendererChanged(renderer()); });
    connect(m_beamAxis, &QComboBox::currentIndexChanged, this, [this] { emit beamAxisChanged(beamAxis()); });
}

void ViewPanel::createChoices() {
    m_renderer =
        createChoice<RendererChoice>("renderer", tr("Renderer"), tr("The software renderer needs no graphics card"),
                                     {{tr("Automatic"), RendererChoice::automatic},
                                      {tr("Software"), RendererChoice::software},
                                      {tr("Graphics card"), RendererChoice::graphicsCard}});
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

QLayout* ViewPanel::createLightRow() {
    auto* row = new QHBoxLayout;
    row->addWidget(m_look->control("light_azimuth"), 1);
    row->addWidget(m_look->control("light_elevation"), 1);
    return row;
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
                          tr("Looks along this view for fluid behind a wall, and cuts inside the fluid"));
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
    row->addWidget(m_look->control("depth_colouring"), 1);
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
    const auto addChoice = [&](int row, int column, const char* name) {
        QWidget* control = m_look->control(name);
        add(row, column, control, control->accessibleName());
    };
    addChoice(2, 0, "mode");
    add(2, 2, m_beamAxis, tr("Beam axis"));
    grid->addWidget(m_modeRemark, 3, 0, 1, 4);
    addChoice(4, 0, "colour_map");
    addChoice(4, 2, "projection");
    addChoice(5, 0, "interpolation");
    add(5, 2, m_renderer, tr("Renderer"));
    addChoice(6, 0, "reduction");
    addChoice(6, 2, "lighting");
    grid->addLayout(createLightRow(), 7, 0, 1, 4);
    addRest(*grid);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addLayout(createButtons());
    layout->addStretch(1);
}

/// Choices of the look that have no place of their own: a row each, below the others.
void ViewPanel::addRest(QGridLayout& grid) {
    static constexpr std::array<std::string_view, 9> placed{"mode",          "reduction",       "lighting",
                                                            "light_azimuth", "light_elevation", "colour_map",
                                                            "projection",    "interpolation",   "depth_colouring"};
    for (const Parameter<Look>& row : lookParameters()) {
        QWidget* control = m_look->control(row.name);
        if (control == nullptr || std::find(placed.begin(), placed.end(), row.name) != placed.end()) continue;
        const int next = grid.rowCount();
        if (!std::holds_alternative<bool>(*row.get(Look{})))
            grid.addWidget(labelFor(control, LookControls::label(row)), next, 0);
        grid.addWidget(control, next, 1, 1, 3);
    }
}

void ViewPanel::updateForMode() { m_modeRemark->setVisible(look().mode != RenderMode::direct); }

double ViewPanel::nearCutMm() const { return m_nearCut->value(); }

void ViewPanel::setNearCutMm(double mm) { m_nearCut->setValue(mm); }

void ViewPanel::setNearCutRange(double maxMm, bool spacingKnown) {
    m_nearCut->setRange(0, std::max(0.0, maxMm));
    m_nearCut->setSuffix(spacingKnown ? tr(" mm") : tr(" mm (guess)"));
}

const Look& ViewPanel::look() const { return m_look->look(); }

void ViewPanel::setLook(const Look& look) {
    m_look->setLook(look);
    updateForMode();
}

RendererChoice ViewPanel::renderer() const { return chosen<RendererChoice>(m_renderer); }
void ViewPanel::setRenderer(RendererChoice renderer) { selectData(m_renderer, static_cast<int>(renderer)); }

void ViewPanel::setGraphicsCardUsable(bool usable) {
    auto* model = qobject_cast<QStandardItemModel*>(m_renderer->model());
    QStandardItem* item = model->item(m_renderer->findData(static_cast<int>(RendererChoice::graphicsCard)));
    item->setEnabled(usable);
    item->setToolTip(usable ? QString() : tr("No graphics card is usable here"));
}

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
