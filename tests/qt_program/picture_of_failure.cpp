// Of programs that have a screen.
#include <QDir>
#include <QGuiApplication>
#include <QPixmap>
#include <QScreen>
#include <QTest>
#include <cstdio>

#include "tests/qt_program/test_classes.h"

namespace echolucent {

void keepPictureOfFailure() {
    if (!QTest::currentTestFailed()) return;
    QString name = QString::fromStdString(runningClass()) + '.' + QTest::currentTestFunction();
    if (const char* row = QTest::currentDataTag()) name += QString(".") + row;
    for (QChar& letter : name)
        if (!letter.isLetterOrNumber() && letter != '.' && letter != '-') letter = '_';
    const QDir folder(QCoreApplication::applicationDirPath() + "/../failed");
    const QString path = QDir::cleanPath(folder.filePath(name + ".png"));
    if (folder.mkpath(".") && QGuiApplication::primaryScreen()->grabWindow(0).save(path))
        std::printf("The screen at the failure: %s\n", qPrintable(path));
}

}  // namespace echolucent
