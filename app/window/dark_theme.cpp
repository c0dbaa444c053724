#include "app/window/dark_theme.h"

#include <QApplication>
#include <QFile>
#include <QString>
#include <stdexcept>

namespace echolucent {

void wearDarkTheme() {
    QFile theme(QStringLiteral(":/dark.qss"));
    if (!theme.open(QIODevice::ReadOnly)) throw std::logic_error("the dark theme was not built into the program");
    QApplication::setStyle(QStringLiteral("Fusion"));
    qApp->setStyleSheet(QString::fromUtf8(theme.readAll()));
}

}  // namespace echolucent
