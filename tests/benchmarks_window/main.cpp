// echolucent-bench-window measures frames a second in the workstation's real window, on the display at hand
// (scripts/with-display gives a virtual one). It prints a table and writes build/bench/window.json.
#include <QApplication>
#include <QCommandLineParser>
#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>

#include "io/output/meta_image_writer.h"
#include "processing/phantom/phantom.h"
#include "tests/benchmarks_window/report.h"
#include "tests/benchmarks_window/window_under_test.h"

using namespace echolucent;
using namespace echolucent::bench;

namespace {

struct Options {
    QList<int> sizes;
    Amount amount;
    int edge = 0;  // voxels of the phantom; with 0 the fetus is as large as the paper's scan, 199 x 197 x 199
    bool shaded = false;
    QString volume;  // a file in the phantom's place
    QString json, pictures;
};

Options parse(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription("Measures frames a second in the real window.");
    parser.addHelpOption();
    parser.addOptions({{"sizes", "Edges of the picture in device pixels.", "N,N", "512,1024"},
                       {"seconds", "How long each action is measured.", "S", "4"},
                       {"frames", "Measure so many frames instead.", "N", "0"},
                       {"views", "Views of the high-quality picture.", "N", "20"},
                       {"edge", "A phantom of that many voxels an edge instead of 199 x 197 x 199.", "N", "0"},
                       {"shaded", "With light."},
                       {"volume", "A volume's file in the phantom's place; of 4D, its phases are played too.", "FILE"},
                       {"json", "Where the figures go.", "FILE", ECHOLUCENT_BENCH_FILE},
                       {"pictures", "Saves what is seen in motion and at rest.", "FOLDER"}});
    parser.process(application);
    Options options;
    for (const QString& size : parser.value("sizes").split(',')) options.sizes << size.toInt();
    options.amount = {parser.value("seconds").toDouble(), parser.value("frames").toInt(),
                      parser.value("views").toInt()};
    options.edge = parser.value("edge").toInt();
    options.shaded = parser.isSet("shaded");
    options.volume = parser.value("volume");
    options.json = parser.value("json");
    options.pictures = parser.value("pictures");
    return options;
}

/// Writes the fetus to a file.
QString fetus(int edge, const QString& folder) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    if (edge > 0) config.size = {edge, edge, edge};
    const QString path = folder + "/fetus.mha";
    if (!writeMetaImage(path.toStdString(), {std::make_shared<const Volume>(*makePhantom(config))}))
        qFatal("cannot write %s", qPrintable(path));
    return path;
}

/// All actions in a window of one size; `tell` gets each row as soon as it is there.
void measure(const Options& options, const QString& volume, int edge, const std::function<void(Row)>& tell) {
    WindowUnderTest window(volume, edge, options.shaded);
    const std::pair<QString, OpacityCurve> curves[] = {{"parabolic 0.5", PowerCurve{2, 0.5}},
                                                       {"adaptive", window.adaptiveCurve()}};
    for (const auto& [name, curve] : curves) {
        const auto finished = [&, curveName = name](Row row) {
            row.curve = curveName;
            row.edge = edge;
            row.shaded = options.shaded;
            tell(row);
        };
        window.show(curve);
        finished(window.orbit(options.amount));
        finished(window.edit(curve, options.amount));
        if (options.shaded) finished(window.turnLight(options.amount));
        finished(window.highQuality(options.amount));
        if (!options.pictures.isEmpty())
            window.takePictures(options.pictures, QString("%1-%2").arg(edge).arg(QString(name).replace(' ', '-')));
    }
    if (window.phases() == 1) return;
    for (Row row : window.playPhases(options.amount)) {
        row.curve = "each phase's";
        row.edge = edge;
        row.shaded = options.shaded;
        tell(row);
    }
}

}  // namespace

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    QApplication::setStyle("Fusion");
    QFile theme(":/dark.qss");
    if (theme.open(QIODevice::ReadOnly)) application.setStyleSheet(QString::fromUtf8(theme.readAll()));
    const Options options = parse(application);
    const QTemporaryDir folder;
    const QString volume = options.volume.isEmpty() ? fetus(options.edge, folder.path()) : options.volume;
    QTextStream out(stdout);
    out << tableHeader() << '\n' << Qt::flush;
    QList<Row> rows;
    for (const int edge : options.sizes)
        measure(options, volume, edge, [&](const Row& row) {
            rows << row;
            out << tableLine(row) << '\n' << Qt::flush;
        });
    if (!writeJson(options.json, rows)) qFatal("cannot write %s", qPrintable(options.json));
    return 0;
}
