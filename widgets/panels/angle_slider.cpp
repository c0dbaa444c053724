#include "widgets/panels/angle_slider.h"

#include <QPainter>
#include <QStyleOptionSlider>

#include "processing/motion/motion_choice.h"

namespace echolucent {

AngleSlider::AngleSlider() : QSlider(Qt::Horizontal) {
    setRange(firstMotionAngle, lastMotionAngle);
    setPageStep(15);
    setMinimumSize(56, 26);
}

void AngleSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
    QColor colour = palette().color(QPalette::WindowText);
    colour.setAlphaF(0.6F);
    QPainter painter(this);
    for (int angle = minimum(); angle <= maximum(); angle += pageStep()) {
        const int x = handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), angle, width() - handle - 1);
        painter.fillRect(x, height() - 4, 1, angle == 0 ? 4 : 2, colour);
    }
}

}  // namespace echolucent
