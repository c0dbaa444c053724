#include "widgets/panels/room_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QToolButton>

#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_slider.h"

namespace echolucent {

namespace {

QDoubleSpinBox* createLength(const QString& name, const QString& accessibleName, const QString& toolTip, double least) {
    auto* box = named(new NumberBox, name, accessibleName, toolTip);
    box->setRange(least, 1000.0);
    box->setDecimals(1);
    box->setSuffix(QStringLiteral(" mm"));
    wheelNeedsFocus(box);
    return box;
}

QToolButton* createSwitch(const QString& text, const QString& name, const QString& accessibleName,
                          const QString& toolTip) {
    auto* button = named(new QToolButton, name, accessibleName, toolTip);
    button->setText(text);
    button->setCheckable(true);
    // The column of panels is narrow: each switch takes its share of the row, enough for its one word.
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return button;
}

QString scalpelToolText(ScalpelTool tool) {
    switch (tool) {
        case ScalpelTool::freehand: return RoomPanel::tr("Freehand");
        case ScalpelTool::polygon: return RoomPanel::tr("Polygon");
        case ScalpelTool::box: return RoomPanel::tr("Rectangle");
        case ScalpelTool::eraser: return RoomPanel::tr("Eraser");
    }
    return {};
}

constexpr std::array<ScalpelTool, 4> allTools{ScalpelTool::freehand, ScalpelTool::polygon, ScalpelTool::box,
                                              ScalpelTool::eraser};

}  // namespace

RoomPanel::RoomPanel(DocumentModel& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("room");
    setAccessibleName(tr("Planes, box and scalpel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    // What is taken in the hand first stands on top.
    column->addWidget(createScalpel());
    column->addWidget(createBox());
    column->addWidget(createPlanes());
    column->addStretch(1);
    m_document.bind(&DocumentModel::boxChanged, this, [this](const Document&) { showBox(); });
    m_document.bind(&DocumentModel::strokesChanged, this, [this](const Document&) { showStrokes(); });
    setTool(std::nullopt);
}

QGroupBox* RoomPanel::createPlanes() {
    auto* group = new QGroupBox(tr("Planes A, B, C"));
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(6, 6, 6, 6);
    auto* quiet = named(new QCheckBox(tr("Smooth the planes")), "room.quiet", tr("Smooth the planes"),
                        tr("On: the planes are as smooth as the 3D picture. Off: they show the scan as it was read"));
    auto* lines = named(new QCheckBox(tr("Show planes in 3D")), "room.linesIn3d", tr("Show planes in 3D"),
                        tr("Draws where the planes lie over the 3D picture"));
    auto* along = named(new QCheckBox(tr("Turning planes turns the 3D view")), "room.turnsView",
                        tr("Turning planes turns the 3D view"),
                        tr("When you turn plane A, B or C, the 3D view turns along by the same angle, about the "
                           "reference point"));
    auto* window = new ValueSlider("room.window", tr("Window"), 0.01, 2);
    window->setRange(leastPlaneWindow, largestPlaneWindow);
    window->setToolTip(tr("How many greys lie between black and white; right drag to the right in a plane"));
    auto* level = new ValueSlider("room.level", tr("Level"), 0.01, 2);
    level->setRange(leastPlaneLevel, largestPlaneLevel);
    level->setToolTip(tr("The grey that is shown half bright; right drag down in a plane"));
    const auto change = [this](const QString& what, auto member) {
        return [this, what, member](auto value) {
            m_document.change(what, [&](Document& next) { next.scene.planes.*member = value; });
        };
    };
    connect(quiet, &QCheckBox::toggled, this, change(tr("smoothing of planes"), &Planes::quiet));
    connect(lines, &QCheckBox::toggled, this, change(tr("planes in 3D"), &Planes::linesIn3d));
    connect(along, &QCheckBox::toggled, this, change(tr("3D view along with planes"), &Planes::turnsView));
    connect(window, &ValueSlider::valueChanged, this, change(tr("window and level"), &Planes::window));
    connect(level, &ValueSlider::valueChanged, this, change(tr("window and level"), &Planes::level));
    m_document.bind(&DocumentModel::planesChanged, this, [=](const Document& document) {
        const QSignalBlocker ofQuiet(quiet), ofLines(lines), ofAlong(along);
        quiet->setChecked(document.scene.planes.quiet);
        lines->setChecked(document.scene.planes.linesIn3d);
        along->setChecked(document.scene.planes.turnsView);
        window->setValue(document.scene.planes.window);
        level->setValue(document.scene.planes.level);
    });
    auto* reset = named(new QPushButton(tr("Reset planes")), "room.resetPlanes", tr("Reset planes"),
                        tr("The planes through the middle, unturned, whole, with their own greys"));
    connect(reset, &QPushButton::clicked, this, &RoomPanel::planesResetRequested);
    auto* grid = new QGridLayout;
    grid->addWidget(labelFor(window, tr("Window")), 0, 0);
    grid->addWidget(window, 0, 1);
    grid->addWidget(labelFor(level, tr("Level")), 1, 0);
    grid->addWidget(level, 1, 1);
    column->addWidget(quiet);
    column->addWidget(lines);
    column->addWidget(along);
    column->addLayout(grid);
    column->addWidget(reset);
    return group;
}

QGroupBox* RoomPanel::createBox() {
    auto* group = new QGroupBox(tr("Box: limits what is shown"));
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(6, 6, 6, 6);
    m_box = named(new QCheckBox(tr("Show only what lies in the box")), "room.box", tr("Show only what lies in the box"),
                  tr("What lies outside is not shown and does not shape the curve. Drag the box in the planes and in "
                     "the 3D picture (B)"));
    // If the document refuses the change, show what the document says.
    connect(m_box, &QCheckBox::toggled, this, [this](bool on) {
        emit boxSwitched(on);
        showBox();
    });
    column->addWidget(m_box);
    addSizes(*column);
    addSlab(*column);
    return group;
}

void RoomPanel::addSizes(QVBoxLayout& column) {
    static constexpr std::array names{"room.width", "room.depth", "room.height"};
    const std::array texts{tr("Box, left to right"), tr("Box, far to near"), tr("Box, top to bottom")};
    const std::array tips{tr("How wide the box is in plane A, before it is turned. Its middle stays"),
                          tr("How far the box reaches across plane A, before it is turned. Its middle stays"),
                          tr("How high the box is in plane A, before it is turned. Its middle stays")};
    auto* grid = new QGridLayout;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        m_sizes[i] = createLength(names[i], texts[i], tips[i], 0.1);
        connect(m_sizes[i], &QDoubleSpinBox::valueChanged, this, [this, i](double mm) {
            emit boxSizeChanged(static_cast<int>(i), mm);
            showBox();
        });
        grid->addWidget(labelFor(m_sizes[i], texts[i]), static_cast<int>(i), 0);
        grid->addWidget(m_sizes[i], static_cast<int>(i), 1);
    }
    auto* whole = named(new QPushButton(tr("Box around all data")), "room.wholeBox", tr("Box around all data"),
                        tr("Puts the box around the whole volume, unturned"));
    connect(whole, &QPushButton::clicked, this, &RoomPanel::wholeBoxRequested);
    column.addLayout(grid);
    column.addWidget(whole);
}

void RoomPanel::addSlab(QVBoxLayout& column) {
    m_slab = createLength("room.slab.thickness", tr("Slab"), tr("How thick a slab around a plane is"), 0.1);
    m_slab->setValue(5.0);
    auto* row = new QHBoxLayout;
    row->addWidget(labelFor(m_slab, tr("Slab")));
    row->addWidget(m_slab, 1);
    row->addWidget(new QLabel(tr("at")));
    for (const PlaneName plane : allPlaneNames) {
        const QString letter = textOf(nameOf(plane));
        auto* button = named(new QToolButton, "room.slab." + letter.toLower(), tr("Slab around plane %1").arg(letter),
                             tr("A thin box around plane %1, seen as the plane is; maximum, minimum and mean show what "
                                "lies in it")
                                 .arg(letter));
        button->setText(letter);
        connect(button, &QToolButton::clicked, this, [this, plane] { emit slabRequested(plane, m_slab->value()); });
        row->addWidget(button);
    }
    column.addLayout(row);
}

QGroupBox* RoomPanel::createScalpel() {
    auto* group = new QGroupBox(tr("Scalpel"));
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(6, 6, 6, 6);
    addTools(*column);
    addStrokes(*column);
    return group;
}

void RoomPanel::addTools(QVBoxLayout& column) {
    auto* tools = new QGridLayout;
    for (const ScalpelTool tool : allTools) {
        const auto index = static_cast<std::size_t>(tool);
        auto* button = createSwitch(
            scalpelToolText(tool), "room.scalpel." + textOf(nameOf(tool)), tr("Scalpel: %1").arg(scalpelToolText(tool)),
            tr("Draw over the 3D picture with the left button; press again to put it away (S)"));
        connect(button, &QToolButton::clicked, this,
                [this, tool](bool on) { emit toolChosen(on ? std::optional(tool) : std::nullopt); });
        m_tools[index] = button;
        tools->addWidget(button, static_cast<int>(index) / 2, static_cast<int>(index) % 2);
    }
    auto* inside = named(new QRadioButton(tr("Cut inside")), "room.scalpel.inside", tr("Cut inside"),
                         tr("What lies inside the outline is cut away"));
    m_outside = named(new QRadioButton(tr("Cut outside")), "room.scalpel.outside", tr("Cut outside"),
                      tr("What lies outside the outline is cut away"));
    inside->setChecked(true);
    auto* sides = new QHBoxLayout;
    sides->addWidget(inside);
    sides->addWidget(m_outside);
    sides->addStretch(1);
    m_eraser = createLength("room.scalpel.size", tr("Size of the eraser"), tr("How wide the eraser is"), 0.2);
    m_eraser->setValue(ScalpelSettings{}.eraserMm);
    m_limited = named(new QCheckBox(tr("Only down to")), "room.scalpel.limited", tr("Cut only down to a depth"),
                      tr("On: the scalpel cuts down to this depth. Off: it cuts through everything"));
    m_limit = createLength("room.scalpel.limit", tr("Depth behind what shows"),
                           tr("How deep the scalpel cuts, counted from what shows there"), 0.1);
    m_limit->setValue(5.0);
    connect(m_limited, &QCheckBox::toggled, this, &RoomPanel::updateEnabled);
    auto* numbers = new QGridLayout;
    numbers->addWidget(labelFor(m_eraser, tr("Size of the eraser")), 0, 0);
    numbers->addWidget(m_eraser, 0, 1);
    numbers->addWidget(m_limited, 1, 0);
    numbers->addWidget(m_limit, 1, 1);
    column.addLayout(tools);
    column.addLayout(sides);
    column.addLayout(numbers);
}

void RoomPanel::addStrokes(QVBoxLayout& column) {
    m_strokes = named(new QListWidget, "room.scalpel.strokes", tr("Strokes"), tr("The strokes of the scalpel"));
    m_strokes->setFixedHeight(84);
    m_takeBack = named(new QPushButton(tr("Remove stroke")), "room.scalpel.takeBack", tr("Remove stroke"),
                       tr("Shows again what the stroke selected in the list has cut"));
    m_takeAllBack = named(new QPushButton(tr("Remove all strokes")), "room.scalpel.takeAllBack",
                          tr("Remove all strokes"), tr("Shows all again that the scalpel has cut (Shift+S)"));
    connect(m_strokes, &QListWidget::currentRowChanged, this, &RoomPanel::updateEnabled);
    connect(m_takeBack, &QPushButton::clicked, this, [this] { emit strokeTakenBack(m_strokes->currentRow()); });
    connect(m_takeAllBack, &QPushButton::clicked, this, &RoomPanel::allStrokesTakenBack);
    auto* row = new QHBoxLayout;
    row->addWidget(m_takeBack);
    row->addWidget(m_takeAllBack);
    column.addWidget(labelFor(m_strokes, tr("Strokes")));
    column.addWidget(m_strokes);
    column.addLayout(row);
}

void RoomPanel::showBox() {
    const Box& box = m_document.document().scene.box;
    const QSignalBlocker on(m_box);
    m_box->setChecked(box.on);
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        const QSignalBlocker blocker(m_sizes[i]);
        m_sizes[i]->setValue(box.sizeMm[static_cast<int>(i)]);
        enableOrSayWhy(*m_sizes[i], box.on, tr("Show only the box first (B)."));
    }
}

void RoomPanel::setUnit(double unitMm, bool known) {
    const QString suffix = known ? tr(" mm") : tr(" mm (guess)");
    for (QDoubleSpinBox* box : {m_sizes[0], m_sizes[1], m_sizes[2], m_slab, m_eraser, m_limit}) {
        const QSignalBlocker blocker(box);
        box->setSuffix(suffix);
        box->setMinimum(std::max(0.1, unitMm));
    }
}

void RoomPanel::showStrokes() {
    const SharedList<ScalpelStroke>& strokes = m_document.document().scene.strokes;
    const QSignalBlocker blocker(m_strokes);
    m_strokes->clear();
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const ScalpelStroke& stroke = strokes[i];
        QStringList words{tr("%1. %2").arg(i + 1).arg(scalpelToolText(stroke.tool))};
        words << (stroke.side == ScalpelSide::inside ? tr("inside") : tr("outside"));
        words << (stroke.depthMm ? tr("down to a depth") : tr("through everything"));
        m_strokes->addItem(words.join(QStringLiteral(", ")));
    }
    m_strokes->setCurrentRow(m_strokes->count() - 1);
    updateEnabled();
}

void RoomPanel::setTool(std::optional<ScalpelTool> tool) {
    for (const ScalpelTool each : allTools) m_tools[static_cast<std::size_t>(each)]->setChecked(each == tool);
}

ScalpelSettings RoomPanel::scalpel() const {
    ScalpelSettings settings;
    settings.side = m_outside->isChecked() ? ScalpelSide::outside : ScalpelSide::inside;
    settings.eraserMm = m_eraser->value();
    if (m_limited->isChecked()) settings.depthMm = m_limit->value();
    return settings;
}

void RoomPanel::updateEnabled() {
    enableOrSayWhy(*m_limit, m_limited->isChecked(), tr("Tick \"Only down to\" first."));
    const bool any = m_strokes->count() > 0;
    enableOrSayWhy(*m_takeBack, m_strokes->currentRow() >= 0,
                   any ? tr("No stroke is selected.") : tr("The scalpel has cut nothing."));
    enableOrSayWhy(*m_takeAllBack, any, tr("The scalpel has cut nothing."));
}

}  // namespace echolucent
