#include "app/lesson/shipped_lessons.h"

#include <QDir>
#include <QFile>
#include <QLocale>
#include <stdexcept>

namespace echolucent {

namespace {

QString folderOf(const QString& name) { return QStringLiteral(":/lessons/") + name; }

}  // namespace

QStringList shippedLessons() {
    // From the first question of a class to the last one.
    QStringList names;
    for (const char* name : {"x-squared", "tube-core", "others-and-speckle", "one-otf-or-one-a-view"})
        if (QFile::exists(folderOf(name))) names << name;
    return names;
}

LessonFiles filesOfShipped(const QString& name) {
    const QDir folder(folderOf(name));
    LessonFiles files{name.toStdString(), {}};
    for (const QString& each : folder.entryList(QDir::Files)) {
        QFile file(folder.filePath(each));
        if (file.open(QIODevice::ReadOnly)) files.bytes[each.toStdString()] = file.readAll().toStdString();
    }
    if (files.bytes.empty()) throw std::invalid_argument("filesOfShipped: there is no lesson of this name");
    return files;
}

std::string languageOfDesktop() { return QLocale().name().replace('_', '-').toLower().toStdString(); }

}  // namespace echolucent
