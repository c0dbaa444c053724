#include "widgets/panels/measurements_panel.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr std::array<MeasurementKind, 2> allKinds{MeasurementKind::distance, MeasurementKind::angle};

QString measureToolText(MeasurementKind kind) {
    QString text = textOf(nameOf(kind));
    text[0] = text[0].toUpper();
    return text;
}

QString tipOf(MeasurementKind kind) {
    return kind == MeasurementKind::distance
               ? MeasurementsPanel::tr("Click two places in a plane, or two on what the 3D picture shows (M)")
               : MeasurementsPanel::tr("Click three places in a plane; the angle is that at the second (Shift + M)");
}

}  // namespace

MeasurementsPanel::MeasurementsPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("measurements");
    setAccessibleName(tr("Measurements"));
    auto* group = new QGroupBox(tr("Measurements"));
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(6, 6, 6, 6);
    auto* tools = new QHBoxLayout;
    for (const MeasurementKind kind : allKinds) {
        auto* button = named(new QToolButton, "measurements." + textOf(nameOf(kind)),
                             tr("Measure: %1").arg(measureToolText(kind)), tipOf(kind));
        button->setText(measureToolText(kind));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this,
                [this, kind](bool on) { emit toolChosen(on ? std::optional(kind) : std::nullopt); });
        m_tools[static_cast<std::size_t>(kind)] = button;
        tools->addWidget(button);
    }
    column->addLayout(tools);
    column->addWidget(createList());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(6, 6, 6, 0);
    outer->addWidget(group);
    setRows({});
}

QWidget* MeasurementsPanel::createList() {
    m_list = named(new QListWidget, "measurements.list", tr("List of measurements"),
                   tr("A click shows the phase and the plane in which it was measured"));
    m_list->setFixedHeight(84);
    auto* remove = named(new QPushButton(tr("Remove")), "measurements.remove", tr("Remove the selected measurement"),
                         tr("The measurement selected in the list"));
    auto* removeAll = named(new QPushButton(tr("Remove all")), "measurements.removeAll", tr("Remove all measurements"),
                            tr("Of all phases"));
    connect(m_list, &QListWidget::itemClicked, this, [this] { emit chosen(selectedId()); });
    connect(m_list, &QListWidget::itemActivated, this, [this] { emit chosen(selectedId()); });
    connect(remove, &QPushButton::clicked, this, [this] {
        if (selectedId() != 0) emit removed(selectedId());
    });
    connect(removeAll, &QPushButton::clicked, this, &MeasurementsPanel::allRemoved);
    auto* row = new QHBoxLayout;
    row->addWidget(remove);
    row->addWidget(removeAll);
    m_listed = new QWidget;
    auto* column = new QVBoxLayout(m_listed);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_list);
    column->addLayout(row);
    return m_listed;
}

int MeasurementsPanel::selectedId() const {
    const int row = m_list->currentRow();
    return row < 0 ? 0 : m_rows[static_cast<std::size_t>(row)].id;
}

void MeasurementsPanel::setRows(const std::vector<MeasurementRow>& rows) {
    const int selected = selectedId();
    // Select a new measurement. Otherwise keep the selection; if the selected measurement was removed, select the last
    // one.
    const bool grown = rows.size() > m_rows.size();
    const QSignalBlocker blocker(m_list);
    m_rows = rows;
    m_list->clear();
    for (const MeasurementRow& row : m_rows) m_list->addItem(row.text);
    const auto kept = std::ranges::find(m_rows, selected, &MeasurementRow::id);
    const bool last = grown || kept == m_rows.end();
    m_list->setCurrentRow(last ? m_list->count() - 1 : static_cast<int>(kept - m_rows.begin()));
    m_listed->setVisible(!m_rows.empty());
}

void MeasurementsPanel::setTool(std::optional<MeasurementKind> tool) {
    for (const MeasurementKind kind : allKinds) m_tools[static_cast<std::size_t>(kind)]->setChecked(kind == tool);
}

}  // namespace echolucent
