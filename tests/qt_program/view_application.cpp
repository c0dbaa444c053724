// For classes that show the 3D view.
#include <QApplication>

#include "tests/qt_program/test_classes.h"
#include "widgets/volume_view/volume_view_widget.h"

std::unique_ptr<QCoreApplication> echolucent::makeTestApplication(int& count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    return std::make_unique<QApplication>(count, arguments);
}
