#include "app/window/start_timer.h"

#include <time.h>
#include <unistd.h>

#include <QApplication>
#include <QTextStream>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "app/study/open_study.h"
#include "app/window/main_window.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

double millisecondsSinceProcessStart() {
    std::ifstream file("/proc/self/stat");
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    // Field 22 is the start time in clock ticks since boot; field 2, the name, may hold blanks and ends with ')'.
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string field;
    for (int number = 3; number <= 22; ++number) fields >> field;
    const double startSeconds = std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return (static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 - startSeconds) * 1e3;
}

void printStartTimes(MainWindow& window) {
    const auto print = [](const char* what) {
        QTextStream(stdout) << what << ": " << qRound(millisecondsSinceProcessStart()) << " ms\n" << Qt::flush;
    };
    const auto onlyOnce = [&window, print](auto* sender, auto signal, const char* what) {
        QObject::connect(
            sender, signal, &window, [print, what] { print(what); }, Qt::SingleShotConnection);
    };
    onlyOnce(&window, &MainWindow::shown, "window");
    onlyOnce(&window.openStudy(), &OpenStudy::studyOpened, "volume");
    onlyOnce(&window.otfs(), &PaneOtfs::computed, "otf");
    auto first = std::make_shared<bool>(true);
    QObject::connect(&window.volumeView(), &VolumeViewWidget::pictureDelivered, &window,
                     [print, first, &window](const PictureReport& report) {
                         if (!window.otfs().adaptive()) return;
                         if (std::exchange(*first, false)) print("first picture");
                         if (!report.converged) return print(report.quality.toUtf8().constData());
                         print("converged picture");
                         QApplication::quit();
                     });
    QObject::connect(&window.openStudy(), &OpenStudy::openFailed, &window, [](const QString&, const Failure& failure) {
        QTextStream(stderr) << QString::fromStdString(failure.sentence()) << '\n';
        QApplication::exit(3);
    });
}

}  // namespace echolucent
