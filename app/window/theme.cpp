#include "app/window/theme.h"

#include <QApplication>
#include <QFile>
#include <QRegularExpression>
#include <QStringView>
#include <algorithm>
#include <stdexcept>

namespace echolucent {

namespace {

QString hexadecimal(const ThemeColours& colours, QStringView name) {
    const auto rows = themeColourRows();
    const auto row = std::ranges::find_if(rows, [name](const ThemeColourRow& each) {
        return name == QLatin1String(each.name.data(), static_cast<qsizetype>(each.name.size()));
    });
    if (row == rows.end()) throw std::logic_error("there is no colour of the name " + name.toString().toStdString());
    return (colours.*row->member).name();
}

}  // namespace

QString styleSheetOf(Theme theme) {
    QFile file(QStringLiteral(":/theme.qss"));
    if (!file.open(QIODevice::ReadOnly)) throw std::logic_error("the style sheet was not built into the program");
    const QString names = QString::fromUtf8(file.readAll());
    static const QRegularExpression name(QStringLiteral("@(overPictures\\.)?(\\w+)"));
    QString sheet;
    qsizetype end = 0;
    for (auto found = name.globalMatch(names); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const ThemeColours& colours = match.hasCaptured(1) ? coloursOverPictures() : coloursOf(theme);
        sheet += names.mid(end, match.capturedStart() - end) + hexadecimal(colours, match.capturedView(2));
        end = match.capturedEnd();
    }
    return sheet + names.mid(end);
}

void wearTheme(Theme theme) {
    const QString sheet = styleSheetOf(theme);
    if (qApp->styleSheet() == sheet) return;
    if (qApp->styleSheet().isEmpty()) QApplication::setStyle(QStringLiteral("Fusion"));
    // Styling all controls of a window takes a moment.
    QApplication::setOverrideCursor(Qt::WaitCursor);
    QApplication::setPalette(paletteOf(theme));
    qApp->setStyleSheet(sheet);
    QApplication::restoreOverrideCursor();
}

}  // namespace echolucent
