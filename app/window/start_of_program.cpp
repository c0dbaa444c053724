#include "app/window/start_of_program.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace echolucent {

namespace {

/// What Qt has said while it opened the display.
QStringList& said() {
    static QStringList lines;
    return lines;
}

/// Qt's reason why there is no display, as part of a sentence; empty if it gave none.
QString reason() {
    for (const QString& line : said())
        if (line.contains(QLatin1String("display")) || line.contains(QLatin1String("Could not find")))
            return QStringLiteral(" (%1)").arg(line.simplified());
    return {};
}

[[noreturn]] void endWithoutDisplay() {
    const QString sentence =
        QStringLiteral(
            "Echolucent needs a display, and none could be opened%1: start it on a desktop, or use the command "
            "line, echolucent-cli, which needs none.")
            .arg(reason());
    std::fprintf(stderr, "%s\n", sentence.toUtf8().constData());
    std::_Exit(1);  // Qt would abort, and half an application cannot be taken down
}

void hear(QtMsgType type, const QMessageLogContext& /*place*/, const QString& text) {
    said() << text;
    if (type == QtFatalMsg) endWithoutDisplay();
}

}  // namespace

bool asksForWordsOnly(int count, char** arguments) {
    constexpr std::array<std::string_view, 5> words{"-h", "--help", "--help-all", "-v", "--version"};
    for (int i = 1; i < count && arguments[i] != std::string_view("--"); ++i)
        if (std::ranges::find(words, arguments[i]) != words.end()) return true;
    return false;
}

std::unique_ptr<QApplication> applicationOnDisplay(int& count, char** arguments) {
    const QtMessageHandler before = qInstallMessageHandler(&hear);
    auto application = std::make_unique<QApplication>(count, arguments);
    if (QGuiApplication::primaryScreen() == nullptr) endWithoutDisplay();
    qInstallMessageHandler(before);
    for (const QString& line : said()) std::fprintf(stderr, "%s\n", line.toUtf8().constData());
    said().clear();
    return application;
}

void writeNumbersAlike() {
    QLocale::setDefault(QLocale::c());
    std::setlocale(LC_NUMERIC, "C");
}

}  // namespace echolucent
