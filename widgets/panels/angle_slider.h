// The slider of the motion's angle.
#pragma once

#include <QSlider>

namespace echolucent {

/// Marks every 15 degrees below the groove. Style sheets draw no tick marks on sliders.
class AngleSlider : public QSlider {
public:
    AngleSlider();

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace echolucent
