// For classes that need an event loop and no screen.
#include "tests/qt_program/test_classes.h"

std::unique_ptr<QCoreApplication> echolucent::makeTestApplication(int& count, char** arguments) {
    return std::make_unique<QCoreApplication>(count, arguments);
}
