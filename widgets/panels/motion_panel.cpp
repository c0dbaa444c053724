#include "widgets/panels/motion_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyleOptionSlider>
#include <cmath>

#include "widgets/panels/flow_layout.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {
namespace {

QIcon playIcon(bool playing, const QColor& colour) {
    QPixmap pixmap(32, 32);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    if (playing) {
        painter.drawRect(QRectF(7, 5, 6, 22));
        painter.drawRect(QRectF(19, 5, 6, 22));
    } else {
        painter.drawPolygon(QPolygonF{{8, 4}, {28, 16}, {8, 28}});
    }
    return QIcon(pixmap);
}

/// Marks every 15 degrees below the groove. Drawn here, because a style sheet's sliders have no tick marks.
class AngleSlider : public QSlider {
public:
    AngleSlider() : QSlider(Qt::Horizontal) {
        setRange(firstMotionAngle, lastMotionAngle);
        setPageStep(15);
        setMinimumSize(56, 26);
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        QSlider::paintEvent(event);
        QStyleOptionSlider option;
        initStyleOption(&option);
        const int handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
        QColor colour = palette().color(QPalette::WindowText);
        colour.setAlphaF(0.6);
        QPainter painter(this);
        for (int angle = minimum(); angle <= maximum(); angle += pageStep()) {
            const int x =
                handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), angle, width() - handle - 1);
            painter.fillRect(x, height() - 4, 1, angle == 0 ? 4 : 2, colour);
        }
    }
};

}  // namespace

MotionPanel::MotionPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("motion");
    setAccessibleName(tr("Motion"));
    createControls();
    createChoices();
    arrange();
    setPlaying(false);
    setPhaseCount(1);
    showAngle();

    connect(m_play, &QPushButton::clicked, this, [this] { emit playRequested(!m_playing); });
    connect(m_angle, &QSlider::valueChanged, this, [this](int degrees) {
        showAngle();
        emit angleChanged(degrees);
    });
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] { emit axisChanged(axis()); });
    connect(m_scenario, &QComboBox::currentIndexChanged, this, [this] { emit scenarioChanged(scenario()); });
    connect(m_modeGroup, &QButtonGroup::idToggled, this, [this](int mode, bool checked) {
        if (checked) emit otfChanged(static_cast<MotionOtf>(mode));
    });
    connect(m_pingPong, &QCheckBox::toggled, this, &MotionPanel::pingPongChanged);
}

void MotionPanel::createControls() {
    m_play = named(new QPushButton, "motion.play", tr("Play"));
    m_angle = named<QSlider>(new AngleSlider, "motion.angle", tr("Angle"),
                             tr("Angle from the view in which the motion began (← and →: one degree)"));
    wheelNeedsFocus(m_angle);
    m_angleValue = named(new QLabel, "motion.angle.value", tr("Angle"));
    m_angleValue->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_angleValue->setMinimumWidth(m_angleValue->fontMetrics().horizontalAdvance(angleText(firstMotionAngle)) + 4);
    m_axis = named(new QComboBox, "motion.axis", tr("Axis of the motion"), tr("The axis about which the view turns"));
    m_axis->addItem(tr("x axis (elevation)"), static_cast<int>(MotionAxis::x));
    m_axis->addItem(tr("y axis (azimuth)"), static_cast<int>(MotionAxis::y));
    m_axis->addItem(tr("z axis (roll)"), static_cast<int>(MotionAxis::z));
    selectData(m_axis, static_cast<int>(MotionAxis::y));
    wheelNeedsFocus(m_axis);
    m_pingPong = named(new QCheckBox(tr("Back and forth")), "motion.pingPong", tr("Back and forth"),
                       tr("The probe turns back at the ends; otherwise the motion starts from −45° again"));
    m_pingPong->setChecked(true);
    m_frameRate = named(new QLabel, "motion.frameRate", tr("Frame rate"));
    // Room from the start: what stands beside it must not move, nor the picture above, when playing begins.
    m_frameRate->setMinimumWidth(m_frameRate->fontMetrics().horizontalAdvance(tr("%1 frames/s").arg(88)));
    m_frameRate->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void MotionPanel::createChoices() {
    m_scenario = named(new QComboBox, "motion.scenario", tr("What moves"));
    m_scenario->addItem(tr("Moving probe"), static_cast<int>(MotionScenario::probe));
    m_scenario->addItem(tr("Moving object"), static_cast<int>(MotionScenario::object));
    m_scenario->addItem(tr("Both move"), static_cast<int>(MotionScenario::both));
    wheelNeedsFocus(m_scenario);

    m_modeGroup = new QButtonGroup(this);
    const auto mode = [this](MotionOtf otf, const QString& text, const QString& name, const QString& accessibleName,
                             const QString& toolTip) {
        auto* button = named(new QRadioButton(text), "motion.mode." + name, accessibleName, toolTip);
        m_modeGroup->addButton(button, static_cast<int>(otf));
        m_modes[static_cast<std::size_t>(otf)] = button;
    };
    mode(MotionOtf::oneOtf, tr("One OTF"), "static", tr("One OTF for every frame"),
         tr("Every frame shows the OTF that was computed before the motion: it cannot flicker"));
    mode(MotionOtf::eachView, tr("Each view"), "eachView", tr("An OTF for each view"),
         tr("The adaptive OTF is computed anew for each frame, and not smoothed: the picture may flicker"));
    mode(MotionOtf::mean, tr("Mean of 5"), "mean", tr("Mean of the newest five OTFs"),
         tr("An OTF for each frame, and of these the mean of the newest five is shown: calm, but late"));
    mode(MotionOtf::movingLeastSquares, tr("Least squares"), "movingLeastSquares", tr("Moving least squares"),
         tr("A polynomial of order two through the newest five OTFs, taken at the present frame: in time, but hardly "
            "calmer"));
    mode(MotionOtf::leastFlicker, tr("Least flicker"), "leastFlicker", tr("Least flicker"),
         tr("Weights on the newest OTFs that flicker least for their delay: the smoothing to take where nothing speaks "
            "for another"));
    m_modes.front()->setChecked(true);
}

void MotionPanel::arrange() {
    auto* first = new QHBoxLayout;
    first->setSpacing(5);
    first->addWidget(m_play);
    first->addWidget(secondaryLabel(angleText(firstMotionAngle)));
    first->addWidget(m_angle, 1);
    first->addWidget(secondaryLabel(angleText(lastMotionAngle)));
    first->addWidget(m_angleValue);
    first->addWidget(m_scenario);
    first->addWidget(m_axis);

    auto* second = new FlowLayout(10);
    for (QRadioButton* button : m_modes) second->addWidget(button);
    second->addStretch();
    second->addWidget(m_frameRate);
    second->addWidget(m_pingPong);

    auto* layout = new QVBoxLayout(this);
    layout->addLayout(first);
    layout->addLayout(second);
}

void MotionPanel::setPlaying(bool playing) {
    m_playing = playing;
    m_play->setText(playing ? tr("Pause") : tr("Play"));
    m_play->setAccessibleName(m_play->text());
    m_play->setToolTip(playing ? tr("Holds the motion (Space)") : tr("Starts the motion (Space)"));
    showPlayIcon();
}

void MotionPanel::showPlayIcon() {
    m_play->ensurePolished();  // the style sheet's colours are in the palette only from then on
    m_play->setIcon(playIcon(m_playing, m_play->palette().color(QPalette::ButtonText)));
}

void MotionPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) showPlayIcon();
}

void MotionPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showPlayIcon();
}

double MotionPanel::angle() const { return m_angle->value(); }

void MotionPanel::setAngle(double degrees) {
    const QSignalBlocker blocker(m_angle);
    m_angle->setValue(static_cast<int>(std::lround(degrees)));
    showAngle();
}

void MotionPanel::showAngle() { m_angleValue->setText(angleText(m_angle->value())); }

MotionAxis MotionPanel::axis() const { return static_cast<MotionAxis>(m_axis->currentData().toInt()); }
void MotionPanel::setAxis(MotionAxis axis) { selectData(m_axis, static_cast<int>(axis)); }

void MotionPanel::setPhaseCount(int count) {
    if (count < 2) selectData(m_scenario, static_cast<int>(MotionScenario::probe));
    m_scenario->setEnabled(count > 1);
    m_scenario->setToolTip(count > 1
                               ? tr("The probe turns around the object, the object moves through the %1 phases of "
                                    "the study, or both")
                                     .arg(count)
                               : tr("The study holds one moment only, so that the object cannot move. Open a 4D "
                                    "study for that."));
}

MotionScenario MotionPanel::scenario() const { return static_cast<MotionScenario>(m_scenario->currentData().toInt()); }

void MotionPanel::setScenario(MotionScenario scenario) {
    Q_ASSERT(m_scenario->isEnabled() || scenario == MotionScenario::probe);
    selectData(m_scenario, static_cast<int>(scenario));
}

MotionOtf MotionPanel::otf() const { return static_cast<MotionOtf>(m_modeGroup->checkedId()); }

void MotionPanel::setOtf(MotionOtf otf) {
    const QSignalBlocker blocker(m_modeGroup);
    m_modes[static_cast<std::size_t>(otf)]->setChecked(true);
}

bool MotionPanel::pingPong() const { return m_pingPong->isChecked(); }

void MotionPanel::setPingPong(bool pingPong) {
    const QSignalBlocker blocker(m_pingPong);
    m_pingPong->setChecked(pingPong);
}

void MotionPanel::setFrameRate(std::optional<double> framesPerSecond, int keptFrames) {
    if (!framesPerSecond) return m_frameRate->clear();
    const QString rate = tr("%1 frames/s").arg(QLocale().toString(*framesPerSecond, 'f', 0));
    m_frameRate->setText(keptFrames > 0 ? tr("%1, %2 in memory").arg(rate).arg(keptFrames) : rate);
}

}  // namespace echolucent
