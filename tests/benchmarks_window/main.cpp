// echolucent-bench-window measures the workstation's real window on the display at hand (scripts/with-display gives a
// virtual one): frames a second, updates a second and memory in the review room, and the longest stalls of the event
// loop. It prints tables and writes build/bench/window.json.
#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>
#include <QTextStream>

#include "app/window/theme.h"
#include "io/writers/meta_image_writer.h"
#include "processing/phantom/phantom.h"
#include "tests/benchmarks_window/large_study.h"
#include "tests/benchmarks_window/movie_under_way.h"
#include "tests/benchmarks_window/opening_time.h"
#include "tests/benchmarks_window/report.h"
#include "tests/benchmarks_window/room_under_test.h"
#include "tests/benchmarks_window/tube_cores_under_test.h"
#include "tests/benchmarks_window/window_under_test.h"

using namespace echolucent;
using namespace echolucent::bench;

namespace {

struct Options {
    QStringList parts;
    QList<int> sizes;
    Amount amount;
    int edge = 0;  // voxels of every phantom; with 0 those of the frames are 199 x 197 x 199, as the paper's scan
    bool shaded = false;
    int openings = 0, edits = 0;
    QString volume, large;  // files in the place of phantoms
    QString json, pictures;
};

constexpr int roomVoxels = 256, largeVoxels = 512, movieVoxels = 128;  // along each edge
constexpr int moviePhases = 8;

Options parse(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Measures the real window: frames a second, updates in the review room, memory, stalls.");
    parser.addHelpOption();
    parser.addOptions(
        {{"parts",
          "What is measured; \"edits\" is how soon an edit of the document is seen, \"opening\" how soon a volume is, "
          "\"tubes\" how soon a tube core is explained, \"cine\" needs --volume of a 4D study.",
          "NAME,NAME", "room,frames,stalls,movie"},
         {"sizes", "Edges of the picture in device pixels; panes of the room have the first.", "N,N", "512,1024"},
         {"seconds", "How long each action is measured.", "S", "4"},
         {"frames", "Measure so many frames instead.", "N", "0"},
         {"views", "Views of the high-quality picture.", "N", "20"},
         {"edge",
          "Phantoms of that many voxels an edge instead of 199 x 197 x 199 (frames), 256 (room) and 512 "
          "(stalls).",
          "N", "0"},
         {"shaded", "Frames with light."},
         {"volume",
          "A volume's file in the phantom's place; the part \"cine\" plays its phases, and the movie shows them.",
          "FILE"},
         {"large", "A volume's file in the place of the phantom of 512.", "FILE"},
         {"openings", "How often a volume is opened.", "N", "9"},
         {"edits", "How often the document is edited, and undone, and how many tube cores are explained.", "N", "40"},
         {"json", "Where the figures go.", "FILE", ECHOLUCENT_BENCH_FILE},
         {"pictures", "Saves what is seen in motion and at rest.", "FOLDER"}});
    parser.process(application);
    Options options;
    options.parts = parser.value("parts").split(',');
    for (const QString& size : parser.value("sizes").split(',')) options.sizes << size.toInt();
    options.amount = {parser.value("seconds").toDouble(), parser.value("frames").toInt(),
                      parser.value("views").toInt()};
    options.edge = parser.value("edge").toInt();
    options.shaded = parser.isSet("shaded");
    options.volume = parser.value("volume");
    options.large = parser.value("large");
    options.openings = parser.value("openings").toInt();
    options.edits = parser.value("edits").toInt();
    options.json = parser.value("json");
    options.pictures = parser.value("pictures");
    return options;
}

/// Writes the fetus to a file; with an edge of 0 voxels as large as the paper's scan.
QString fetus(int edge, int bits, const QString& folder, int phaseCount = 1) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    if (edge > 0) config.size = {edge, edge, edge};
    config.bits = bits;
    const QString path = QString("%1/fetus-%2-%3.mha").arg(folder).arg(edge).arg(phaseCount);
    std::vector<std::shared_ptr<const Volume>> phases;
    for (int phase = 0; phase < phaseCount; ++phase) {
        config.phase = static_cast<double>(phase) / phaseCount;
        phases.push_back(std::make_shared<const Volume>(*makePhantom(config)));
    }
    if (!writeMetaImage(path.toStdString(), phases, MetaImageVoxels::plain))
        qFatal("cannot write %s", qPrintable(path));
    return path;
}

/// The phases of a 4D study, quiet and lit as it is opened, in a window of one size.
void measureCine(const QString& volume, int edge, const Options& options, Findings& findings,
                 const std::function<void(Row)>& tell) {
    WindowUnderTest window(volume, edge, true);
    if (window.phases() == 1) qFatal("%s holds one phase, and the cine needs several", qPrintable(volume));
    for (Row row : window.playPhases(options.amount)) {
        row.curve = "each phase's";
        row.edge = edge;
        row.shaded = true;
        tell(row);
    }
    findings.kept << window.kept();
}

/// Edits of the document in a window of one size.
void measureEdits(const Options& options, const QString& volume, int edge, const std::function<void(Row)>& tell) {
    WindowUnderTest window(volume, edge, options.shaded);
    for (Row row : window.editDocument(std::max(1, options.edits))) {
        row.curve = "manual";
        row.edge = edge;
        row.shaded = options.shaded;
        tell(row);
    }
}

/// The explanation of tube cores in a window of 1280 x 720.
void measureTubeCores(const Options& options, const QString& volume, const std::function<void(Row)>& tell) {
    TubeCoresUnderTest window(volume);
    for (Row row : {window.explain(std::max(1, options.edits)), window.grow(options.amount)}) {
        row.curve = "adaptive";
        tell(row);
    }
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
        window.showCurve(curve);
        finished(window.orbit(options.amount));
        finished(window.edit(curve, options.amount));
        if (options.shaded) finished(window.turnLight(options.amount));
        finished(window.highQuality(options.amount));
        if (!options.pictures.isEmpty())
            window.takePictures(options.pictures, QString("%1-%2").arg(edge).arg(QString(name).replace(' ', '-')));
        if (name != curves[1].first) continue;  // the document's own curve follows its sliders
        finished(window.slide("view.threshold", "threshold", options.amount));
        finished(window.slide("view.nearCut", "front", options.amount));
    }
}

/// What a person drags with all four panes visible, as a study is opened and with everything on.
Memory measureRoom(const Options& options, const QString& volume, const std::function<void(Row)>& tell) {
    RoomUnderTest room(volume, options.sizes.first());
    const auto finished = [&](Row row, const char* state) {
        row.curve = QString::fromLatin1(state);
        row.edge = options.sizes.first();
        row.shaded = true;
        tell(row);
    };
    finished(room.dragReference(options.amount), "as opened");
    finished(room.orbit(options.amount), "as opened");
    room.switchEverythingOn();
    const Memory memory = room.memory();
    finished(room.dragReference(options.amount), "everything on");
    finished(room.dragBox(options.amount), "everything on");
    finished(room.orbit(options.amount), "everything on");
    return memory;
}

/// A movie into each container, while a heartbeat listens.
QList<Stall> measureMovies(const Options& options, const QString& volume, QTextStream& out) {
    MovieUnderWay window(volume);
    window.rest();
    for (const char* ending : {".avi", ".mp4", ".mkv"}) {
        const int edge = options.sizes.first();
        const MovieCost cost = window.write(QString::fromLatin1(ending), {edge, edge});
        out << QString("A movie %1 of %2 frames of %3 x %3 took %4 s.")
                   .arg(cost.ending)
                   .arg(cost.frames)
                   .arg(edge)
                   .arg(cost.seconds, 0, 'f', 1)
            << '\n'
            << Qt::flush;
    }
    return window.stalls();
}

}  // namespace

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    wearTheme(Theme::dark);
    const Options options = parse(application);
    const QTemporaryDir folder;
    const auto phantom = [&](int usual, int bits) {
        return fetus(options.edge > 0 ? options.edge : usual, bits, folder.path());
    };
    QTextStream out(stdout);
    Findings findings;
    const auto tell = [&](const Row& row) {
        findings.rows << row;
        out << tableLine(row) << '\n' << Qt::flush;
    };
    const bool room = options.parts.contains("room"), frames = options.parts.contains("frames");
    const bool cine = options.parts.contains("cine"), edits = options.parts.contains("edits");
    if (cine && options.volume.isEmpty()) qFatal("the part \"cine\" needs --volume FILE of a 4D study");
    const bool tubes = options.parts.contains("tubes");
    if (room || frames || edits || cine || tubes) out << tableHeader() << '\n' << Qt::flush;
    if (room) {
        const QString volume = phantom(roomVoxels, 8);
        forgetPeak();  // what making the phantom took
        findings.memory = measureRoom(options, volume, tell);
        out << memoryLine(findings.memory) << '\n' << Qt::flush;
    }
    if (frames) {
        const QString volume = options.volume.isEmpty() ? phantom(0, 8) : options.volume;
        for (const int edge : options.sizes) measure(options, volume, edge, tell);
    }
    if (edits) {
        const QString volume = options.volume.isEmpty() ? phantom(0, 8) : options.volume;
        for (const int edge : options.sizes) measureEdits(options, volume, edge, tell);
    }
    if (tubes) measureTubeCores(options, options.volume.isEmpty() ? phantom(0, 8) : options.volume, tell);
    if (cine) {
        for (const int edge : options.sizes) {
            measureCine(options.volume, edge, options, findings, tell);
            out << keptLine(findings.kept.last()) << '\n' << Qt::flush;
        }
    }
    if (options.parts.contains("opening")) {
        const QString volume = options.large.isEmpty() ? phantom(largeVoxels, 8) : options.large;
        findings.opening = OpeningTime().measure(volume, std::max(1, options.openings));
        out << openingTable(*findings.opening) << '\n' << Qt::flush;
    }
    if (options.parts.contains("stalls")) {
        // Two bytes a voxel: twice the memory to read, to make quiet and to let go.
        const QString volume = options.large.isEmpty() ? phantom(largeVoxels, 16) : options.large;
        LargeStudy study;
        findings.stalls = study.stalls(volume);
        out << stallTable(findings.stalls) << '\n';
        out << QString("The checksum of the volume was there after %1 ms.").arg(study.checksumMilliseconds(), 0, 'f', 0)
            << '\n'
            << Qt::flush;
    }
    if (options.parts.contains("movie")) {
        const QString volume = options.volume.isEmpty()
                                   ? fetus(options.edge > 0 ? options.edge : movieVoxels, 8, folder.path(), moviePhases)
                                   : options.volume;
        const QList<Stall> stalls = measureMovies(options, volume, out);
        out << stallTable(stalls) << '\n' << Qt::flush;
        findings.stalls << stalls;
    }
    if (!writeJson(options.json, findings)) qFatal("cannot write %s", qPrintable(options.json));
    return 0;
}
