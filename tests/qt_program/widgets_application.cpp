// For classes that show widgets without OpenGL.
#include <QApplication>

#include "tests/qt_program/test_classes.h"

std::unique_ptr<QCoreApplication> echolucent::makeTestApplication(int& count, char** arguments) {
    return std::make_unique<QApplication>(count, arguments);
}
