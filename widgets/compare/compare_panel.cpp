#include "widgets/compare/compare_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <variant>

#include "processing/adaptive/method_reading.h"
#include "processing/document/panes.h"
#include "widgets/compare/pane_words.h"
#include "widgets/controls/narrow_combo.h"
#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/panels/designer_parameters.h"
#include "widgets/surface_colours.h"
#include "widgets/tube_cores/reading_parameters.h"

namespace echolucent {

namespace {

// The entries of a pane's choice: the curves, the designers, and the adaptive method without a tube core.
constexpr int designerEntries = static_cast<int>(allCurveKinds.size());
constexpr int withoutTubeEntry = designerEntries + static_cast<int>(allDesigners.size());

constexpr std::array readings{MethodReading::asPublished, MethodReading::settled, MethodReading::firstVersion,
                              MethodReading::standard};
// The entries of a pane's method: the document's, the readings, and parameters that are no reading.
constexpr int ownMethodEntry = static_cast<int>(readings.size()) + 1;

int methodEntryOf(const Pane& choice) {
    if (!choice.method) return 0;
    const auto reading = readingOf(*choice.method);
    const auto found = reading ? std::ranges::find(readings, *reading) : readings.end();
    return found == readings.end() ? ownMethodEntry : static_cast<int>(found - readings.begin()) + 1;
}

int entryOf(const Pane& choice) {
    if (isAdaptive(choice) && !choice.withoutTubes.empty()) return withoutTubeEntry;
    if (!choice.designer) return static_cast<int>(indexOf(choice.curve));
    return designerEntries + static_cast<int>(choice.designer->index());
}

QGridLayout* gridIn(QGroupBox* group) {
    auto* grid = new QGridLayout(group);
    grid->setContentsMargins(6, 6, 6, 6);
    grid->setColumnStretch(1, 1);
    return grid;
}

/// A tool tip that begins with the whole entry: the closed box may be too narrow for it.
QString tipOfPair(const QComboBox& box, const QString& meaning) {
    return box.count() == 0 ? meaning : QStringLiteral("%1. %2").arg(box.currentText(), meaning);
}

}  // namespace

ComparePanel::ComparePanel(QWidget* parent) : QWidget(parent) {
    setObjectName("compare");
    setAccessibleName(tr("Compare"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(m_switch = new QToolButton);
    m_switch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column->addWidget(createPanes());
    column->addWidget(m_layoutGroup = createLayout());
    column->addWidget(m_table = new CompareTable);
    connect(m_table, &CompareTable::flickerRequested, this, &ComparePanel::flickerRequested);
    connect(m_table, &CompareTable::pageRequested, this, &ComparePanel::pageRequested);
    column->addStretch(1);
    showAll();
}

void ComparePanel::setSwitch(QAction& compares) {
    m_switch->setDefaultAction(&compares);
    named(m_switch, "compare.switch", tr("Compare OTFs"),
          tr("Shows two to four OTFs beside each other under one camera, and leaves the comparison (F5)"));
}

QGroupBox* ComparePanel::createPanes() {
    auto* group = new QGroupBox(tr("Panes under one camera"));
    QGridLayout* grid = gridIn(group);
    m_count = named(new WholeNumberBox, "compare.count", tr("Number of panes"),
                    tr("Two to four; the first is the 3D view's"));
    m_count->setRange(static_cast<int>(fewestPanes), static_cast<int>(mostPanes));
    wheelNeedsFocus(m_count);
    connect(m_count, &QSpinBox::valueChanged, this, &ComparePanel::countChosen);
    grid->addWidget(labelFor(m_count, tr("Panes")), 0, 0);
    grid->addWidget(m_count, 0, 1);
    for (std::size_t i = 0; i < m_controls.size(); ++i) {
        PaneControls& pane = m_controls[i];
        const QString number = QString::number(i + 1);
        pane.otf = named(new NarrowCombo, "compare.otf" + number, tr("OTF of pane %1").arg(number),
                         tr("What this pane is rendered with: a curve or a designer"));
        for (const CurveKind kind : allCurveKinds) pane.otf->addItem(labelOfCurve(kind));
        for (const Designer designer : allDesigners) pane.otf->addItem(labelOfDesigner(designer));
        pane.otf->addItem(tr("Adaptive without tube core …"));
        pane.otf->insertSeparator(designerEntries);  // later entries count one more
        pane.tube =
            named(new WholeNumberBox, "compare.tube" + number, tr("Tube core left out of pane %1").arg(number),
                  tr("Number of the tube core, row by row from the upper left; it is never placed, so that ranks and "
                     "weights of the others follow"));
        wheelNeedsFocus(pane.tube);
        pane.phase = named(new WholeNumberBox, "compare.phase" + number, tr("Volume of pane %1").arg(number),
                           tr("The volume of the 4D study that this pane shows"));
        pane.phase->setSpecialValueText(tr("as pane 1"));
        wheelNeedsFocus(pane.phase);
        pane.motion = named(new NarrowCombo, "compare.motion" + number, tr("OTF of pane %1 in the motion").arg(number),
                            tr("Which OTF the frames of the motion show in this pane"));
        pane.motion->addItem(tr("OTF as in the motion"));
        for (const MotionOtf otf : allMotionOtfs) pane.motion->addItem(wordsOf(otf));
        connect(pane.otf, &QComboBox::activated, this, [this, i] { choose(i); });
        connect(pane.motion, &QComboBox::activated, this, [this, i] { choose(i); });
        connect(pane.tube, &QSpinBox::valueChanged, this, [this, i] { choose(i); });
        connect(pane.phase, &QSpinBox::valueChanged, this, [this, i] { choosePhase(i); });
        pane.method = named(new NarrowCombo, "compare.method" + number, tr("Parameters of pane %1").arg(number),
                            tr("How tube cores are read for this pane, and what curve they make: as the panel Method "
                               "says, or by one reading of the paper"));
        pane.method->addItem(tr("Parameters as in Method"));
        for (const MethodReading reading : readings) pane.method->addItem(tr("Parameters %1").arg(wordsOf(reading)));
        pane.method->addItem(tr("Parameters of its own"));
        pane.edits = named(new QToolButton, "compare.parameters" + number, tr("Parameters of pane %1").arg(number),
                           tr("Shows what this pane can be set to for itself"));
        pane.edits->setText(tr("Parameters…"));
        pane.edits->setCheckable(true);
        pane.parameters = new DesignerParameters(QStringLiteral("compare.pane") + number);
        connect(pane.method, &QComboBox::activated, this, [this, i] { chooseMethod(i); });
        connect(pane.edits, &QToolButton::toggled, this, [this, i] { showParameters(i); });
        connect(pane.parameters, &DesignerParameters::changed, this, [this, i](const DesignerConfig& config) {
            Pane choice = m_panes.at(i);
            // A field that is hidden may still report a number of the designer before.
            if (!choice.designer || choice.designer->index() != config.index()) return;
            choice.designer = config;
            if (choice != m_panes[i]) emit paneChosen(static_cast<int>(i), choice);
        });
        if (i > 0) {
            pane.reading = new ReadingParameters(QStringLiteral("compare.method") + number);
            connect(pane.reading, &ReadingParameters::configChanged, this,
                    [this, i](const AdaptiveOtfConfig& config) { takeMethod(i, config); });
        }
        const int row = static_cast<int>(7 * i) + 1;
        grid->addWidget(pane.label = labelFor(pane.otf, number), row, 0);
        grid->addWidget(pane.otf, row, 1, 1, 2);
        grid->addWidget(pane.tube, row + 1, 1);
        grid->addWidget(pane.phase, row + 1, 2);
        grid->addWidget(pane.motion, row + 2, 1, 1, 2);
        grid->addWidget(pane.method, row + 3, 1, 1, 2);
        grid->addWidget(pane.edits, row + 4, 1, 1, 2, Qt::AlignLeft);
        grid->addWidget(pane.parameters, row + 5, 0, 1, 3);
        if (pane.reading != nullptr) grid->addWidget(pane.reading, row + 6, 0, 1, 3);
    }
    return group;
}

QGroupBox* ComparePanel::createLayout() {
    auto* group = new QGroupBox(tr("Shown as"));
    QGridLayout* grid = gridIn(group);
    m_layout =
        named(new NarrowCombo, "compare.layout", tr("How panes are shown"), tr("All of them, or two in one picture"));
    m_layout->addItem(tr("Side by side"));
    m_layout->addItem(tr("Difference of two"));
    m_layout->addItem(tr("Wipe between two"));
    m_first = named(new NarrowCombo, "compare.first", tr("First of the two"));
    m_second = named(new NarrowCombo, "compare.second", tr("Second of the two"));
    m_amplification = named(new NumberBox, "compare.amplification", tr("Amplification of the difference"),
                            tr("Grey is equal; brighter is where the first is brighter"));
    m_amplification->setRange(leastAmplification, largestAmplification);
    m_amplification->setDecimals(1);
    m_amplification->setPrefix(QStringLiteral("× "));
    wheelNeedsFocus(m_amplification);
    connect(m_layout, &QComboBox::activated, this, [this] { chooseComparison(tr("layout of the comparison")); });
    connect(m_first, &QComboBox::activated, this, [this] { chooseComparison(tr("pair of panes")); });
    connect(m_second, &QComboBox::activated, this, [this] { chooseComparison(tr("pair of panes")); });
    connect(m_amplification, &QDoubleSpinBox::valueChanged, this,
            [this] { chooseComparison(tr("amplification of the difference")); });
    m_colours = named(new QCheckBox(tr("Colour by shown depth")), "compare.colours", tr("Colour by shown depth"),
                      surfaceColoursSentence());
    connect(m_colours, &QCheckBox::toggled, this, [this] { chooseComparison(tr("colours of the comparison")); });
    grid->addWidget(labelFor(m_layout, tr("Layout")), 0, 0);
    grid->addWidget(m_layout, 0, 1);
    grid->addWidget(labelFor(m_first, tr("First")), 1, 0);
    grid->addWidget(m_first, 1, 1);
    grid->addWidget(labelFor(m_second, tr("Second")), 2, 0);
    grid->addWidget(m_second, 2, 1);
    grid->addWidget(labelFor(m_amplification, tr("Difference")), 3, 0);
    grid->addWidget(m_amplification, 3, 1);
    grid->addWidget(m_colours, 4, 0, 1, 2);
    auto* insets = named(new QCheckBox(tr("OTF in each pane")), "compare.insets", tr("OTF in each pane"),
                         tr("Draws the opacity of each pane over intensity, or over intensity and gradient, in a "
                            "corner of its picture; on the full screen it is always there"));
    connect(insets, &QCheckBox::toggled, this, &ComparePanel::insetsSwitched);
    grid->addWidget(insets, 5, 0, 1, 2);
    return group;
}

void ComparePanel::choose(std::size_t place) {
    const PaneControls& pane = m_controls.at(place);
    const int index = pane.otf->currentIndex();
    const int entry = index > designerEntries ? index - 1 : index;
    Pane choice{.curve = m_panes.at(place).curve};
    if (entry == withoutTubeEntry) {
        choice.designer = AdaptiveConfig{};
        // If several tube cores were left out, they stay until a person types a number.
        const std::vector<int>& before = m_panes[place].withoutTubes;
        choice.withoutTubes =
            before.size() > 1 && before.front() == pane.tube->value() ? before : std::vector{pane.tube->value()};
    } else if (entry < designerEntries) {
        choice.curve = allCurveKinds[static_cast<std::size_t>(entry)];
    } else {
        const Designer designer = allDesigners[static_cast<std::size_t>(entry - designerEntries)];
        const auto& before = m_panes[place].designer;
        choice.designer = before && designerOf(*before) == designer ? *before : defaultConfigOf(designer);
    }
    if (choice.curve == m_panes[place].curve) choice.linear = m_panes[place].linear;
    if (isAdaptive(choice)) choice.method = m_panes[place].method;
    choice.phase = m_panes[place].phase;  // kept even if this study has fewer phases
    if (place > 0 && isAdaptive(choice) && pane.motion->currentIndex() > 0)
        choice.motionOtf = allMotionOtfs.at(static_cast<std::size_t>(pane.motion->currentIndex() - 1));
    if (choice != m_panes[place]) emit paneChosen(static_cast<int>(place), choice);
}

void ComparePanel::choosePhase(std::size_t place) {
    Pane choice = m_panes.at(place);
    const int phase = m_controls.at(place).phase->value();
    choice.phase = phase > 0 ? std::optional(phase - 1) : std::nullopt;
    if (choice != m_panes[place]) emit paneChosen(static_cast<int>(place), choice);
}

void ComparePanel::chooseMethod(std::size_t place) {
    Pane choice = m_panes.at(place);
    const int entry = m_controls.at(place).method->currentIndex();
    if (entry > 0 && entry < ownMethodEntry)
        return takeMethod(place, configOf(readings.at(static_cast<std::size_t>(entry - 1))));
    // Its own begin with those that it has now.
    if (entry == ownMethodEntry) return takeMethod(place, choice.method.value_or(m_method));
    choice.method.reset();
    if (choice != m_panes[place]) emit paneChosen(static_cast<int>(place), choice);
}

void ComparePanel::takeMethod(std::size_t place, AdaptiveOtfConfig method) {
    Pane choice = m_panes.at(place);
    if (!isAdaptive(choice)) return;
    method.grid = choice.method ? choice.method->grid : m_method.grid;  // it belongs to no reading
    // Always the document's (Pane::method).
    method.grid.withoutTubes.clear();
    method.initial = AdaptiveOtfConfig{}.initial;
    choice.method = method;
    if (choice != m_panes[place]) emit paneChosen(static_cast<int>(place), choice);
}

void ComparePanel::showParameters(std::size_t place) {
    const PaneControls& pane = m_controls.at(place);
    const bool there = place < m_panes.size(), adaptive = there && pane.reading && isAdaptive(m_panes[place]);
    const bool designed = there && m_panes[place].designer && !isAdaptive(m_panes[place]);
    pane.edits->setVisible(designed || adaptive);
    if (adaptive) pane.reading->setConfig(m_panes[place].method.value_or(m_method));
    if (pane.reading != nullptr) pane.reading->setVisible(adaptive && pane.edits->isChecked());
    pane.parameters->setVisible(designed && pane.edits->isChecked());
    if (designed) pane.parameters->setConfig(*m_panes[place].designer);
}

void ComparePanel::chooseComparison(const QString& what) {
    Comparison next = m_comparison;
    next.layout = static_cast<ComparisonLayout>(m_layout->currentIndex());
    next.first = m_first->currentIndex();
    next.second = m_second->currentIndex();
    if (next.first == next.second) {  // the one that the person did not change makes way
        if (next.first != m_comparison.first)
            next.second = m_comparison.first;
        else
            next.first = m_comparison.second;
    }
    next.amplification = m_amplification->value();
    next.colours = m_colours->isChecked();
    emit comparisonChosen(next, what);
}

void ComparePanel::setPanes(const std::vector<Pane>& panes, const QStringList& names) {
    if (panes == m_panes && names == m_names) return;
    m_panes = panes;
    m_names = names;
    showAll();
}

void ComparePanel::setComparison(const Comparison& comparison) {
    if (comparison == m_comparison) return;
    m_comparison = comparison;
    showAll();
}

void ComparePanel::setLimits(int phases, const AdaptiveOtfConfig& method) {
    if (phases == m_phases && method == m_method) return;
    m_phases = phases;
    m_method = method;
    showAll();
}

void ComparePanel::setMeasuringFlicker(bool measuring) {
    m_measuring = measuring;
    m_table->setMeasuringFlicker(measuring, !m_panes.empty());
}

void ComparePanel::showAll() {
    const QSignalBlocker countBlocker(m_count);
    const int tubes = m_method.grid.columns * m_method.grid.rows;
    m_count->setValue(static_cast<int>(std::max(m_panes.size(), fewestPanes)));
    const QSignalBlocker firstBlocker(m_first), secondBlocker(m_second), amplificationBlocker(m_amplification),
        coloursBlocker(m_colours);
    m_first->clear();
    m_second->clear();
    for (std::size_t i = 0; i < m_controls.size(); ++i) {
        PaneControls& pane = m_controls[i];
        const bool there = i < m_panes.size();
        const QSignalBlocker tubeBlocker(pane.tube), phaseBlocker(pane.phase);
        pane.label->setVisible(there);
        pane.otf->setVisible(there);
        pane.tube->setRange(0, std::max(0, tubes - 1));
        pane.phase->setRange(0, m_phases);
        const bool withoutTube = there && entryOf(m_panes[i]) == withoutTubeEntry;
        pane.tube->setVisible(withoutTube);
        pane.phase->setVisible(there && i > 0 && m_phases > 1);
        pane.motion->setVisible(there && i > 0 && isAdaptive(m_panes[i]));
        pane.method->setVisible(there && i > 0 && isAdaptive(m_panes[i]));
        showParameters(i);
        if (!there) continue;
        const int entry = entryOf(m_panes[i]);
        pane.otf->setCurrentIndex(entry >= designerEntries ? entry + 1 : entry);
        if (withoutTube)
            pane.tube->setValue(m_panes[i].withoutTubes.front());
        else
            pane.tube->setValue(tubes / 2);
        pane.phase->setValue(m_panes[i].phase ? *m_panes[i].phase + 1 : 0);
        pane.motion->setCurrentIndex(m_panes[i].motionOtf ? static_cast<int>(*m_panes[i].motionOtf) + 1 : 0);
        pane.method->setCurrentIndex(methodEntryOf(m_panes[i]));
        const QString name = QStringLiteral("%1: %2").arg(i + 1).arg(m_names.value(static_cast<qsizetype>(i)));
        m_first->addItem(name);
        m_second->addItem(name);
    }
    m_layout->setCurrentIndex(static_cast<int>(m_comparison.layout));
    m_first->setCurrentIndex(m_comparison.first);
    m_second->setCurrentIndex(m_comparison.second);
    m_first->setToolTip(
        tipOfPair(*m_first, tr("Left of the wipe's line; in a difference, the second is subtracted from it")));
    m_second->setToolTip(
        tipOfPair(*m_second, tr("Right of the wipe's line; in a difference, it is subtracted from the first")));
    m_amplification->setValue(m_comparison.amplification);
    m_colours->setChecked(m_comparison.colours);
    enableOrSayWhy(*m_colours, m_comparison.layout != ComparisonLayout::difference,
                   tr("A difference has colours of its own."));
    const bool pair = m_comparison.layout != ComparisonLayout::sideBySide;
    for (QComboBox* one : {m_first, m_second})
        enableOrSayWhy(*one, pair, tr("The layout shows all panes side by side."));
    enableOrSayWhy(*m_amplification, m_comparison.layout == ComparisonLayout::difference,
                   tr("The layout shows no difference."));
    m_layoutGroup->setVisible(!m_panes.empty());
    m_table->setVisible(!m_panes.empty());
    setMeasuringFlicker(m_measuring);
}

}  // namespace echolucent
