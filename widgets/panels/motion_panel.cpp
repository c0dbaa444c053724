#include "widgets/panels/motion_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <cmath>
#include <utility>

#include "widgets/controls/flow_layout.h"
#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/tool_icons.h"
#include "widgets/motion/motion_words.h"
#include "widgets/panels/angle_slider.h"
#include "widgets/panels/phase_controls.h"

namespace echolucent {
namespace {

QString bytesText(std::size_t bytes) {
    return QLocale::c().formattedDataSize(static_cast<qint64>(bytes), 0, QLocale::DataSizeTraditionalFormat);
}

}  // namespace

MotionPanel::MotionPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("motion");
    setAccessibleName(tr("Motion"));
    createControls();
    createSpeed();
    createChoices();
    arrange();
    setPlaying(false);
    setStudy(1, {});
    showAngle();
    connectControls();
    connectChoices();
}

void MotionPanel::createControls() {
    m_play = named(new QPushButton, "motion.play", tr("Play"));
    m_phase = new PhaseSlider;
    m_phaseOrder = new PhaseOrder;
    m_angle = named<QSlider>(new AngleSlider, "motion.angle", tr("Angle"),
                             tr("Angle of the rotation, from the view in which it began (← and →: one degree)"));
    wheelNeedsFocus(m_angle);
    m_angleValue = named(new QLabel, "motion.angle.value", tr("Angle"));
    m_angleValue->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_angleValue->setMinimumWidth(m_angleValue->fontMetrics().horizontalAdvance(angleText(firstMotionAngle)) + 4);
    m_axis = named(new QComboBox, "motion.axis", tr("Axis of the rotation"),
                   tr("The axis of the rotation: upright or across the screen, as it lay when the rotation began; in "
                      "plane the picture turns like a wheel"));
    for (const MotionAxis axis : screenAxes) m_axis->addItem(shortAxisText(axis), static_cast<int>(axis));
    wheelNeedsFocus(m_axis);
    m_pingPong = named(new QCheckBox(tr("Swing")), "motion.pingPong", tr("Swing"),
                       tr("The rotation plays back and forth; otherwise it starts from −45° again"));
    m_frameRate = named(new QLabel, "motion.frameRate", tr("Frame rate"));
    // Reserve the room now: neither the controls beside it nor the picture above may move when playing begins.
    m_frameRate->setMinimumWidth(m_frameRate->fontMetrics().horizontalAdvance(tr("%1 frames/s").arg(888)));
    m_frameRate->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void MotionPanel::createSpeed() {
    m_speed = named(new QComboBox, "motion.speed", tr("Speed"));
    for (const double speed : {0.25, 0.5, 1.0, 2.0, 4.0}) m_speed->addItem(speedText(speed), speed);
    wheelNeedsFocus(m_speed);
}

void MotionPanel::createChoices() {
    m_scenario = named(new QComboBox, "motion.scenario", tr("What plays"));
    m_scenario->addItem(tr("Rotation"), static_cast<int>(MotionScenario::probe));
    m_scenario->addItem(tr("Volumes in time"), static_cast<int>(MotionScenario::object));
    m_scenario->addItem(tr("Both"), static_cast<int>(MotionScenario::both));
    wheelNeedsFocus(m_scenario);

    m_modeGroup = new QButtonGroup(this);
    const auto mode = [this](MotionOtf otf, const QString& text, const QString& name, const QString& accessibleName,
                             const QString& toolTip) {
        auto* button = named(new QRadioButton(text), "motion.mode." + name, accessibleName, toolTip);
        m_modeGroup->addButton(button, static_cast<int>(otf));
        m_modes[static_cast<std::size_t>(otf)] = button;
    };
    // The texts of the first two depend on what moves.
    mode(MotionOtf::oneOtf, {}, "static", {}, {});
    mode(MotionOtf::eachView, {}, "eachView", {},
         tr("The adaptive OTF is computed anew for each frame, and not smoothed: the picture may flicker"));
    mode(MotionOtf::mean, tr("Mean of 5"), "mean", tr("Mean of the newest five OTFs"),
         tr("An OTF for each frame, and of these the mean of the newest five is shown: calm, but late"));
    mode(MotionOtf::movingLeastSquares, tr("Least squares"), "movingLeastSquares", tr("Moving least squares"),
         tr("A polynomial of order two through the newest five OTFs, taken at the present frame: in time, but hardly "
            "calmer"));
    mode(MotionOtf::leastFlicker, tr("Least flicker"), "leastFlicker", tr("Least flicker"),
         tr("Weights on the newest OTFs that flicker least for their delay: the smoothing to take where nothing speaks "
            "for another"));
    m_otfPhase = named(new WholeNumberBox, "motion.otfPhase", tr("Volume of the one OTF"),
                       tr("The volume whose OTF every frame shows (A takes the volume that is shown)"));
    m_otfPhase->setAlignment(Qt::AlignRight);
    wheelNeedsFocus(m_otfPhase);
}

void MotionPanel::connectControls() {
    connect(m_play, &QPushButton::clicked, this, [this] { emit playRequested(!m_playing); });
    connect(m_phase, &PhaseSlider::phaseChanged, this, &MotionPanel::phaseChanged);
    connect(m_angle, &QSlider::valueChanged, this, [this](int degrees) {
        showAngle();
        emit angleChanged(degrees);
    });
}

void MotionPanel::connectChoices() {
    /// Wraps a change of the choice as a slot of a control.
    const auto changes = [this](const QString& what, auto change) {
        return [this, what, change](auto... value) {
            MotionChoice next = m_choice;
            change(next, value...);
            take(next, what);
        };
    };
    connect(m_axis, &QComboBox::currentIndexChanged, this, changes(tr("axis of the rotation"), [this](auto& next, int) {
                next.axis = static_cast<MotionAxis>(m_axis->currentData().toInt());
            }));
    connect(m_scenario, &QComboBox::currentIndexChanged, this, changes(tr("what plays"), [this](auto& next, int) {
                next.scenario = static_cast<MotionScenario>(m_scenario->currentData().toInt());
            }));
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            changes(tr("speed"), [this](auto& next, int) { next.speed = m_speed->currentData().toDouble(); }));
    connect(m_pingPong, &QCheckBox::toggled, this,
            changes(tr("rotation back and forth"), [](auto& next, bool pingPong) { next.pingPong = pingPong; }));
    connect(m_phaseOrder, &PhaseOrder::pingPongChanged, this,
            changes(tr("volumes back and forth"), [](auto& next, bool pingPong) { next.phasesPingPong = pingPong; }));
    connect(m_phaseOrder, &PhaseOrder::rangeChanged, this,
            changes(tr("volumes that play"), [](auto& next, const auto& range) { next.phaseRange = range; }));
    connect(m_otfPhase, &QSpinBox::valueChanged, this,
            changes(tr("volume of the OTF"), [](auto& next, int number) { next.otfPhase = number - 1; }));
    connect(m_modeGroup, &QButtonGroup::idToggled, this, [this](int mode, bool checked) {
        if (!checked) return;
        MotionChoice next = m_choice;
        next.otf = static_cast<MotionOtf>(mode);
        if (next.otf == MotionOtf::oneOtf) next.otfPhase = phase();
        take(next, tr("OTF of the motion"));
    });
}

void MotionPanel::take(const MotionChoice& choice, const QString& what) {
    setChoice(choice);
    emit choiceChanged(choice, what);
}

void MotionPanel::arrange() {
    m_angleBar = new QWidget;
    auto* angle = new QHBoxLayout(m_angleBar);
    angle->setContentsMargins(0, 0, 0, 0);
    angle->setSpacing(5);
    angle->addWidget(secondaryLabel(angleText(firstMotionAngle)));
    angle->addWidget(m_angle, 1);
    angle->addWidget(secondaryLabel(angleText(lastMotionAngle)));
    angle->addWidget(m_angleValue);

    auto* whatPlays = new QWidget;
    auto* choice = new QHBoxLayout(whatPlays);
    choice->setContentsMargins(0, 0, 0, 0);
    choice->setSpacing(5);
    choice->addWidget(labelFor(m_scenario, tr("Plays")));
    choice->addWidget(m_scenario);

    auto* first = m_firstRow = new FlowLayout(8);
    first->addWidget(m_play);
    first->addWidget(whatPlays);
    first->addWidget(m_angleBar);
    first->addWidget(m_axis);
    first->addWidget(m_pingPong);
    first->addWidget(m_phase);
    first->addWidget(m_phaseOrder);
    first->addWidget(m_speed);
    first->addWidget(m_folded = createFold());

    m_otfs = new QWidget;
    auto* second = m_otfRow = new FlowLayout(10, m_otfs);
    for (QRadioButton* button : m_modes) {
        second->addWidget(button);
        if (button == m_modes.front()) second->addWidget(m_otfPhase);
    }
    second->addStretch();
    second->addWidget(m_frameRate);

    auto* layout = new QVBoxLayout(this);
    layout->addLayout(first);
    layout->addWidget(m_otfs);

    // After a click on the bar its keys are the window's: Space plays, the arrows turn the probe. So what is clicked
    // gives the focus to the bar, but for sliders, whose arrows do the same, and fields.
    setFocusPolicy(Qt::ClickFocus);
    for (QComboBox* list : findChildren<QComboBox*>()) list->setFocusPolicy(Qt::TabFocus);
}

QToolButton* MotionPanel::createFold() {
    auto* button = named(new QToolButton, "motion.otf", tr("OTF of the frames"), tr("Which OTF the frames show"));
    button->setText(tr("OTF"));
    m_popup = new QFrame(this, Qt::Popup);
    m_popup->setObjectName("motion.otf.popup");
    m_popup->setFrameShape(QFrame::StyledPanel);
    new QVBoxLayout(m_popup);
    connect(button, &QToolButton::clicked, this, [this] {
        m_popup->adjustSize();
        m_popup->move(mapToGlobal(QPoint(0, -m_popup->height())));  // above the bar
        m_popup->show();
    });
    return button;
}

void MotionPanel::setOtfsShown(bool shown) {
    m_otfsShown = shown;
    foldOtfs();
}

/// The bar has two rows at most, so that the picture stays large: if there is no room, the choice of the OTF opens from
/// a button.
void MotionPanel::foldOtfs() {
    const QMargins around = layout()->contentsMargins();
    const int room = width() - around.left() - around.right();
    m_folded->hide();
    // Before it is seen the bar has no width that means anything.
    const bool folds = isVisible() && m_otfsShown && m_firstRow->rows(room) + m_otfRow->rows(room) > 2;
    if (folds != (m_otfs->parentWidget() == m_popup))
        (folds ? static_cast<QWidget*>(m_popup) : this)->layout()->addWidget(m_otfs);
    m_otfs->setVisible(m_otfsShown);
    m_folded->setVisible(folds);
}

void MotionPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != event->size().width()) foldOtfs();
}

void MotionPanel::setPlaying(bool playing) {
    m_playing = playing;
    m_play->setText(playing ? tr("Pause") : tr("Play"));
    m_play->setAccessibleName(m_play->text());
    m_play->setToolTip(playing ? tr("Holds the motion (Space)") : tr("Starts the motion (Space)"));
    m_play->setIcon(toolIcon(playing ? ToolPicture::pause : ToolPicture::play));
}

void MotionPanel::showEvent(QShowEvent* event) {
    foldOtfs();
    QWidget::showEvent(event);
}

double MotionPanel::angle() const { return m_angle->value(); }

void MotionPanel::setAngle(double degrees) {
    const QSignalBlocker blocker(m_angle);
    m_angle->setValue(static_cast<int>(std::lround(degrees)));
    showAngle();
}

void MotionPanel::showAngle() { m_angleValue->setText(angleText(m_angle->value())); }

int MotionPanel::phase() const { return m_phase->phase(); }
void MotionPanel::setPhase(int phase) { m_phase->setPhase(phase); }

void MotionPanel::setStudy(int phases, const PhaseTimes& times) {
    m_phases = phases;
    m_times = times;
    m_phase->setStudy(phases, times);
    m_phaseOrder->setPhases(phases);
    {
        const QSignalBlocker blocker(m_otfPhase);
        m_otfPhase->setRange(1, phases);
    }
    m_scenario->setToolTip(
        tr("What plays: the volumes of the study one after the other, a rotation of the view, or both at once"));
    enableOrSayWhy(*m_scenario, phases > 1,
                   tr("This study holds one volume only. Open a 4D study to play volumes in time."));
    MotionChoice choice = m_choice;
    if (phases < 2) choice.scenario = MotionScenario::probe;
    setChoice(choice);
}

void MotionPanel::setChoice(const MotionChoice& choice) {
    Q_ASSERT(m_phases > 1 || choice.scenario == MotionScenario::probe);
    m_choice = choice;
    showAxis();
    selectData(m_scenario, static_cast<int>(choice.scenario));
    m_phaseOrder->setRange(choice.phaseRange);
    m_phaseOrder->setPingPong(choice.phasesPingPong);
    m_phase->setPlayed(playedPhases(choice, m_phases));
    const QSignalBlocker pingPong(m_pingPong), modes(m_modeGroup), otfPhase(m_otfPhase);
    m_pingPong->setChecked(choice.pingPong);
    m_modes[static_cast<std::size_t>(choice.otf)]->setChecked(true);
    m_otfPhase->setValue(choice.otfPhase + 1);
    enableOrSayWhy(*m_otfPhase, choice.otf == MotionOtf::oneOtf, tr("Choose \"Of volume\" first."));
    showSpeed();
    showWhatMoves();
}

/// The list shows an axis of an older program while the document has it.
void MotionPanel::showAxis() {
    const QSignalBlocker blocker(m_axis);
    constexpr int usual = static_cast<int>(screenAxes.size());
    while (m_axis->count() > usual) m_axis->removeItem(usual);
    const int axis = static_cast<int>(m_choice.axis);
    if (m_axis->findData(axis) < 0) m_axis->addItem(shortAxisText(m_choice.axis), axis);
    m_axis->setCurrentIndex(m_axis->findData(axis));
}

/// A document may have a speed that is not in the list. The list shows this speed while it is set.
void MotionPanel::showSpeed() {
    const QSignalBlocker blocker(m_speed);
    constexpr int usual = 5;
    while (m_speed->count() > usual) m_speed->removeItem(usual);
    if (m_speed->findData(m_choice.speed) < 0) m_speed->addItem(speedText(m_choice.speed), m_choice.speed);
    m_speed->setCurrentIndex(m_speed->findData(m_choice.speed));
    m_speed->setToolTip(speedTip(m_choice, m_times));
}

void MotionPanel::showWhatMoves() {
    const bool probe = movesProbe(m_choice.scenario), object = movesObject(m_choice.scenario), phases = m_phases > 1;
    m_phase->setVisible(object);
    m_phaseOrder->setVisible(object);
    m_angleBar->setVisible(probe);
    m_axis->setVisible(probe);
    m_pingPong->setVisible(probe);
    m_otfPhase->setVisible(phases);
    foldOtfs();
    QRadioButton& one = *m_modes[static_cast<std::size_t>(MotionOtf::oneOtf)];
    one.setText(phases ? tr("Of volume") : tr("One OTF"));
    one.setAccessibleName(phases ? tr("The OTF of one volume for every frame") : tr("One OTF for every frame"));
    one.setToolTip(phases ? tr("Every frame shows the OTF of one volume, at first of the one that is shown: it cannot "
                               "flicker")
                          : tr("Every frame shows the OTF that was computed before the motion: it cannot flicker"));
    QRadioButton& each = *m_modes[static_cast<std::size_t>(MotionOtf::eachView)];
    each.setText(!object ? tr("Each view") : probe ? tr("Each frame's") : tr("Each volume's"));
    each.setAccessibleName(!object ? tr("An OTF for each view")
                           : probe ? tr("An OTF for each frame")
                                   : tr("An OTF for each volume"));
}

void MotionPanel::setFrameRate(std::optional<double> framesPerSecond, const KeptMotion& kept) {
    m_frameRate->setToolTip({});
    if (!framesPerSecond) return m_frameRate->clear();
    m_frameRate->setText(tr("%1 frames/s").arg(QLocale::c().toString(*framesPerSecond, 'f', 0)));
    m_frameRate->setToolTip(tr("Kept in memory: %1 pictures (%2), quiet voxels of %3 volumes (%4), %5 OTFs (%6)")
                                .arg(kept.frames)
                                .arg(bytesText(kept.frameBytes))
                                .arg(kept.quietPhases)
                                .arg(bytesText(kept.quietBytes))
                                .arg(kept.otfs)
                                .arg(bytesText(kept.otfBytes)));
}

}  // namespace echolucent
