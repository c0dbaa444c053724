#include "widgets/panels/view_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/parameter_controls.h"
#include "widgets/controls/value_slider.h"
#include "widgets/panels/light_amount.h"

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

constexpr int labelWidth = 92;  // pixels; longer labels wrap, so that the panel fits a narrow column

/// A title with a button that resets the controls below it.
QToolButton* addGroup(QGridLayout& grid, const QString& resetName, const QString& title, const QString& resets) {
    auto* reset = resetButton(resetName, resets);
    auto* label = new QLabel(title);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    auto* row = new QHBoxLayout;
    row->addWidget(label, 1);
    row->addWidget(reset);
    grid.addLayout(row, grid.rowCount(), 0, 1, 2);
    return reset;
}

void addRow(QGridLayout& grid, QLabel* label, QWidget* control) {
    const int row = grid.rowCount();
    if (label != nullptr) {
        label->setWordWrap(true);
        grid.addWidget(label, row, 0);
    }
    grid.addWidget(control, row, 1);
}

template <typename Choice>
Choice chosen(const QComboBox* comboBox) {
    return static_cast<Choice>(comboBox->currentData().toInt());
}

}  // namespace

ViewPanel::ViewPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("view");
    setAccessibleName(tr("Picture"));
    m_front = new ValueSlider("view.nearCut", tr("Front"), 0.1, 1);
    m_front->setToolTip(
        tr("How deep the front lies in the body. What lies before it is cut away from wherever you look"));
    m_look = std::make_unique<ParameterControls<Look>>(lookParameters(), "view", NumberControl::resettingSlider,
                                                       [this](const Look& look, const AnyParameter&) {
                                                           followLook();
                                                           emit lookChanged(look);
                                                       });
    QWidget* lighting = m_look->of("lighting").widget;
    lighting->setToolTip(tr("%1. Ctrl + left drag in the picture moves the light").arg(lighting->toolTip()));
    createLight();
    createChoices();
    arrange();
    setFrontRange(100);
    setGraphicsCardUsable(false);
    followLook();
    connectControls();
}

ViewPanel::~ViewPanel() = default;

void ViewPanel::connectControls() {
    connect(m_light, &ValueSlider::valueChanged, this, [this](double percent) {
        setLook(withLightAmount(look(), percent / 100.0));
        emit lightAmountChanged(look());
    });
    connect(m_front, &ValueSlider::valueChanged, this, &ViewPanel::frontChanged);
    connect(m_renderer, &QComboBox::currentIndexChanged, this, [this] { emit rendererChanged(renderer()); });
    connect(m_beamAxis, &QComboBox::currentIndexChanged, this, [this] { emit beamAxisChanged(beamAxis()); });
}

void ViewPanel::createLight() {
    constexpr double step = 100.0 * leastLight;
    m_light = new ValueSlider("view.lightAmount", tr("Light, from flat to strong"), step, 1, nullptr,
                              ValueSlider::Zeros::none);
    m_light->setToolTip(
        tr("To the left the picture is flat. To the right light falls on it, and what the light does not reach grows "
           "darker. Ctrl + left drag in the picture moves the light"));
    m_light->setRange(0, 100);
    m_light->setSuffix(tr(" %"));
    m_light->setStandard(100.0 * lightAmount(lookAtStart()));
}

QToolButton* ViewPanel::createMore() {
    m_more = named(new QToolButton, "view.more", tr("More"),
                   tr("Opens and closes the other settings: light, colours, projection, beam"));
    m_more->setText(tr("More"));
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_more->setFocusPolicy(Qt::StrongFocus);
    m_more->setCheckable(true);
    connect(m_more, &QToolButton::toggled, this, [this](bool open) {
        m_more->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        m_rest->setVisible(open);
    });
    return m_more;
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

QLayout* ViewPanel::createButtons() {
    auto* resetAll =
        named(new QPushButton(tr("Reset all")), "view.resetAll", tr("Reset all"),
              tr("Beam, look, front, view, curves, planes, box and strokes back to what opening gave (Shift+R)"));
    auto* savePicture = named(new QPushButton(tr("Save picture…")), "view.savePicture", tr("Save picture"),
                              tr("Writes the picture as PNG (P)"));
    connect(resetAll, &QPushButton::clicked, this, &ViewPanel::resetAllRequested);
    connect(savePicture, &QPushButton::clicked, this, &ViewPanel::savePictureRequested);
    auto* row = new QHBoxLayout;
    row->addWidget(resetAll, 1);
    row->addWidget(savePicture, 1);
    return row;
}

void ViewPanel::arrange() {
    const auto newGrid = [] {
        auto* grid = new QGridLayout;
        grid->setColumnMinimumWidth(0, labelWidth);
        grid->setColumnStretch(1, 1);
        return grid;
    };
    QGridLayout *first = newGrid(), *rest = newGrid();
    addPictureRows(*first);
    addCutGroup(*first);
    addLookGroups(*rest);
    addViewGroup(*rest);
    m_rest = new QWidget;
    auto* below = new QVBoxLayout(m_rest);
    below->setContentsMargins(0, 0, 0, 0);
    below->addLayout(rest);
    below->addLayout(createButtons());
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(first);
    layout->addWidget(createMore(), 0, Qt::AlignLeft);
    layout->addWidget(m_rest);
    layout->addStretch(1);
    m_more->setChecked(true);
}

/// What a person turns most.
void ViewPanel::addPictureRows(QGridLayout& grid) {
    const auto& brightness = m_look->of("brightness");
    addRow(grid, brightness.label, brightness.widget);
    const auto& smoothing = m_look->of("reduction");
    m_resetSmoothing = resetButton("view.speckle.reset", tr("Reset: smoothing"));
    connect(m_resetSmoothing, &QToolButton::clicked, this, [this] { resetLook(tr("Smoothing"), {"reduction"}); });
    auto* row = new QWidget;
    auto* both = new QHBoxLayout(row);
    both->setContentsMargins(0, 0, 0, 0);
    both->addWidget(smoothing.widget, 1);
    both->addWidget(m_resetSmoothing);
    addRow(grid, smoothing.label, row);
    addRow(grid, labelFor(m_light, tr("Light")), m_light);
}

void ViewPanel::addCutGroup(QGridLayout& grid) {
    auto* reset =
        addGroup(grid, "view.cut.reset", tr("Front"), tr("Reset the front to that of the side that is taken"));
    connect(reset, &QToolButton::clicked, this, &ViewPanel::frontResetRequested);
    addRow(grid, labelFor(m_front, tr("Depth")), m_front);
    auto* find = named(new QPushButton(tr("Find the front")), "view.nearCut.suggest", tr("Find the front"),
                       tr("Looks along this view for fluid behind a wall, and puts the front into the fluid"));
    connect(find, &QPushButton::clicked, this, &ViewPanel::frontSuggestionRequested);
    auto* fromHere = named(new QPushButton(tr("Front from here")), "view.front.fromHere", tr("Front from here"),
                           tr("Turns the front so that it lies across what you see now (N)"));
    connect(fromHere, &QPushButton::clicked, this, &ViewPanel::frontFromHereRequested);
    m_noFront = named(new QPushButton(tr("No front")), "view.front.none", tr("No front"),
                      tr("Takes the front away, so that nothing is cut off before the picture (Shift+N)"));
    connect(m_noFront, &QPushButton::clicked, this, &ViewPanel::noFrontRequested);
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    for (QPushButton* button : {find, fromHere}) row->addWidget(button, 1);
    grid.addWidget(buttons, grid.rowCount(), 0, 1, grid.columnCount());
    auto* show = named(new QCheckBox(tr("Show in 3D")), "view.front.show", tr("Show the front in 3D"),
                       tr("Draws the front over the 3D picture, with a handle that moves it"));
    connect(show, &QCheckBox::toggled, this, &ViewPanel::frontShownIn3d);
    m_frontIn3d = show;
    auto* last = new QWidget;
    auto* lastRow = new QHBoxLayout(last);
    lastRow->setContentsMargins(0, 0, 0, 0);
    lastRow->addWidget(m_noFront, 1);
    lastRow->addWidget(show, 1);
    grid.addWidget(last, grid.rowCount(), 0, 1, grid.columnCount());
}

void ViewPanel::addLookGroups(QGridLayout& grid) {
    struct Group {
        QString name;
        QString title;
        std::vector<std::string_view> rows;
    };
    std::vector<Group> groups{
        {"light",
         tr("Light in detail"),
         {"lighting", "light_azimuth", "light_elevation", "light_softness", "shadow", "occlusion", "translucency"}},
        {"colours", tr("Colours"), {"colour_map", "depth_colouring"}},
        {"rendering", tr("Rendering"), {"mode", "mixing", "mixed_mode", "interpolation", "projection"}}};
    const auto placed = [&groups](std::string_view name) {
        return name == "brightness" || name == "reduction" || std::ranges::any_of(groups, [name](const Group& group) {
                   return std::ranges::find(group.rows, name) != group.rows.end();
               });
    };
    for (const Parameter<Look>& row : lookParameters())
        if (row.inPanels && !placed(row.name)) groups.back().rows.push_back(row.name);
    for (const Group& group : groups) {
        QToolButton* reset =
            addGroup(grid, "view." + group.name + ".reset", group.title, tr("Reset: %1").arg(group.title.toLower()));
        connect(reset, &QToolButton::clicked, this, [this, group] { resetLook(group.title, group.rows); });
        for (const std::string_view row : group.rows) {
            addRow(grid, m_look->of(row).label, m_look->of(row).widget);
            if (row == "mode") {
                m_modeRemark = named(new QLabel(tr("In this mode the opacity curve, light and depth colours play no "
                                                   "part.")),
                                     "view.mode.remark", tr("Remark on the mode"));
                m_modeRemark->setWordWrap(true);
                grid.addWidget(m_modeRemark, grid.rowCount(), 0, 1, 2);
            }
        }
    }
    addRow(grid, labelFor(m_renderer, tr("Renderer")), m_renderer);
}

void ViewPanel::addViewGroup(QGridLayout& grid) {
    QToolButton* reset = addGroup(grid, "view.reset", tr("View"),
                                  tr("Reset the view: the whole scan, seen from the side that is taken (R)"));
    connect(reset, &QToolButton::clicked, this, &ViewPanel::resetRequested);
    addRow(grid, labelFor(m_beamAxis, tr("Beam axis")), m_beamAxis);
}

void ViewPanel::resetLook(const QString& group, const std::vector<std::string_view>& rows) {
    Look look = m_look->values();
    for (const std::string_view name : rows) {
        const Parameter<Look>& row = *parameterNamed(lookParameters(), name);
        row.set(look, defaultOf(lookParameters(), row));
    }
    if (look == m_look->values()) return;
    setLook(look);
    emit lookReset(look, group);
}

void ViewPanel::followLook() {
    const bool direct = look().mode == RenderMode::direct;
    m_modeRemark->setVisible(!direct);
    m_light->setValue(std::round(100.0 * lightAmount(look())));
    enableOrSayWhy(*m_resetSmoothing, look().reduction != lookAtStart().reduction, tr("Already at its start value."));
    enableOrSayWhy(*m_light, direct, tr("There is light in the mode Direct rendering only (More)."));
}

void ViewPanel::setMoreShown(bool shown) { m_more->setChecked(shown); }

void ViewPanel::setFrontThere(bool there) {
    enableOrSayWhy(*m_noFront, there, tr("There is no front to take away."));
    enableOrSayWhy(*m_frontIn3d, there, tr("There is no front."));
}

double ViewPanel::frontMm() const { return m_front->value(); }

void ViewPanel::setFrontMm(double mm) { m_front->setValue(mm); }

void ViewPanel::setFrontRange(double maxMm, bool spacingKnown) {
    m_front->setRange(0, std::max(0.0, maxMm));
    m_front->setSuffix(spacingKnown ? tr(" mm") : tr(" mm (guess)"));
}

const Look& ViewPanel::look() const { return m_look->values(); }

void ViewPanel::setLook(const Look& look) {
    m_look->setValues(look);
    followLook();
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

}  // namespace echolucent
