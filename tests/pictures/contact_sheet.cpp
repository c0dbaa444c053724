#include "tests/pictures/contact_sheet.h"

#include <QDir>
#include <QImage>
#include <QPainter>

bool writeContactSheet(const QString& file, const QStringList& folders) {
    QStringList names;
    for (const QString& folder : folders) names += QDir(folder).entryList({"*.png"}, QDir::Files);
    names.sort();
    names.removeDuplicates();
    constexpr int width = 480, height = 380, title = 20;
    QImage sheet(width * static_cast<int>(folders.size()), (height + title) * static_cast<int>(names.size()),
                 QImage::Format_RGB888);
    sheet.fill(Qt::black);
    QPainter painter(&sheet);
    painter.setPen(Qt::white);
    for (int row = 0; row < names.size(); ++row)
        for (int column = 0; column < folders.size(); ++column) {
            const QRect place(column * width, row * (height + title), width, height + title);
            painter.drawText(place.adjusted(4, 2, 0, 0), QDir(folders[column]).dirName() + ": " + names[row]);
            const QImage picture(QDir(folders[column]).filePath(names[row]));
            if (picture.isNull()) continue;
            const QImage fitted = picture.scaled(width - 4, height, Qt::KeepAspectRatio, Qt::SmoothTransformation);
            painter.drawImage(place.x(), place.y() + title, fitted);
        }
    painter.end();
    return sheet.save(file);
}
