#include "widgets/motion/otf_course_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <cstddef>

#include "widgets/controls/panel_controls.h"
#include "widgets/motion/otf_curves_canvas.h"
#include "widgets/motion/otf_map_canvas.h"

namespace echolucent {
namespace {

struct ModeName {
    const char* key;
    QString name;
};

ModeName shownNameOf(MotionOtf mode) {
    switch (mode) {
        case MotionOtf::oneOtf: return {"static", OtfCoursePanel::tr("One OTF")};
        case MotionOtf::eachView: return {"eachView", OtfCoursePanel::tr("Each view")};
        case MotionOtf::mean: return {"mean", OtfCoursePanel::tr("Mean of 5")};
        case MotionOtf::movingLeastSquares: return {"movingLeastSquares", OtfCoursePanel::tr("Least squares")};
        case MotionOtf::leastFlicker: return {"leastFlicker", OtfCoursePanel::tr("Least flicker")};
    }
    return {};
}

enum class MapRows { shown, unsmoothed };

}  // namespace

OtfCoursePanel::OtfCoursePanel(const OtfCourse& course, QWidget* parent)
    : QWidget(parent),
      m_course(course),
      m_map(new OtfMapCanvas(course)),
      m_curves(new OtfCurvesCanvas(course)),
      m_rows(named(new QComboBox, "motion.map.rows", tr("What the map shows"),
                   tr("The OTFs that the frames were shown with, or these before smoothing"))),
      m_reading(named(secondaryLabel(), "motion.map.reading", tr("What is pointed at"))) {
    setObjectName("motion.mapPanel");
    setAccessibleName(tr("OTF over angle"));
    m_rows->addItem(tr("OTFs as shown"), static_cast<int>(MapRows::shown));
    m_rows->addItem(tr("Not smoothed"), static_cast<int>(MapRows::unsmoothed));
    wheelNeedsFocus(m_rows);
    connect(m_rows, &QComboBox::currentIndexChanged, this, &OtfCoursePanel::showRows);
    connect(m_map, &OtfMapCanvas::pointed, m_reading, &QLabel::setText);
    m_reading->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_reading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // must not keep the dock wide

    auto* top = new QHBoxLayout;
    top->addWidget(m_rows);
    top->addWidget(m_reading, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_map, 4);
    layout->addWidget(m_curves, 3);
    layout->addWidget(createFlickerTable());
    showCourse();
}

QWidget* OtfCoursePanel::createFlickerTable() {
    auto* table = new QWidget;
    table->setToolTip(tr("Root mean square of the second difference of opacity in time, over all intensities and the "
                         "newest %1 frames without a jump. All modes run side by side on the same OTFs.")
                          .arg(OtfCourse::flickerFrames));
    auto* grid = new QGridLayout(table);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    grid->addWidget(new QLabel(tr("Flicker of the OTF")), 0, 0, 1, 3);
    int line = 1;
    for (const MotionOtf mode : allMotionOtfs) {
        const ModeName name = shownNameOf(mode);
        FlickerRow& row = m_flicker[static_cast<std::size_t>(mode)];
        row.name = new QLabel(name.name);
        row.value =
            named(new QLabel, QStringLiteral("motion.map.flicker.") + name.key, tr("Flicker: %1").arg(name.name));
        row.value->setAlignment(Qt::AlignRight);
        row.share = secondaryLabel();
        grid->addWidget(row.name, line, 0);
        grid->addWidget(row.value, line, 1);
        grid->addWidget(row.share, line, 2);
        ++line;
    }
    grid->setColumnMinimumWidth(1, 64);
    grid->setColumnStretch(2, 1);
    grid->setHorizontalSpacing(14);
    return table;
}

void OtfCoursePanel::setMode(MotionOtf mode) {
    m_mode = mode;
    m_curves->setMode(mode);
    showRows();
    showFlicker();
}

void OtfCoursePanel::showRows() {
    const bool shown = m_rows->currentData().toInt() == static_cast<int>(MapRows::shown);
    m_map->setMode(shown ? m_mode : MotionOtf::eachView);
}

void OtfCoursePanel::setValueWindow(const ValueWindow& window) { m_map->setValueWindow(window); }

void OtfCoursePanel::showCourse() {
    m_map->showCourse();
    m_curves->showCourse();
    showFlicker();
}

void OtfCoursePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showFlicker();
}

void OtfCoursePanel::showFlicker() {
    if (!isVisible()) return;  // else each frame of the motion would compute the flicker of all modes
    const QLocale locale = QLocale::c();
    const auto ofEachView = m_course.flicker(MotionOtf::eachView);
    for (const MotionOtf mode : allMotionOtfs) {
        const FlickerRow& row = m_flicker[static_cast<std::size_t>(mode)];
        QFont font = row.name->font();
        font.setBold(mode == m_mode);
        row.name->setFont(font);
        row.value->setFont(font);
        const auto flicker = m_course.flicker(mode);
        row.value->setText(flicker ? locale.toString(*flicker, 'f', 4) : QStringLiteral("–"));
        const bool compared = flicker && ofEachView && *ofEachView > 0.0 && mode != MotionOtf::eachView;
        row.share->setText(compared ? tr("%1 × each view").arg(locale.toString(*flicker / *ofEachView, 'f', 2))
                                    : QString());
    }
}

}  // namespace echolucent
