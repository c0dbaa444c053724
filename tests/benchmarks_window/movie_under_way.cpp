#include "tests/benchmarks_window/movie_under_way.h"

#include <QElapsedTimer>

#include "app/motion/movie_files.h"

namespace echolucent::bench {

namespace {
constexpr int atRest = 3000;  // ms
}  // namespace

MovieUnderWay::MovieUnderWay(const QString& volume)
    : m_heartbeat([this] { return QStringList{window().movieFiles().busy() ? "writing" : "nothing"}; }) {
    window().resize(1280, 720);
    show();
    openVolume(volume);
    Document next = window().document().document();
    next.motion.scenario = MotionScenario::object;
    next.motion.otf = MotionOtf::eachView;
    window().document().edit(next, QStringLiteral("what moves"));
    await("quiet phases", [&] { return !window().openStudy().quietPhases().busy(); });
    waitUntilConverged();
}

void MovieUnderWay::rest() {
    m_heartbeat.begin(QStringLiteral("rest"));
    QElapsedTimer rested;
    rested.start();
    await("the rest", [&] { return rested.elapsed() > atRest; });
    m_heartbeat.end();
}

MovieCost MovieUnderWay::write(const QString& ending, const QSize& size) {
    const Document& document = window().document().document();
    const int phases = static_cast<int>(window().openStudy().study()->phases.size());
    MovieCost cost{.ending = ending};
    cost.frames = static_cast<int>(turnOf(document, firstPane, phases).size());
    std::optional<bool> written;
    QObject context;
    QObject::connect(&window().movieFiles(), &MovieFiles::ended, &context, [&](bool done) { written = done; });
    QElapsedTimer clock;
    clock.start();
    m_heartbeat.begin("movie" + ending);
    window().movieFiles().begin(FrameOutput::movie, {.path = m_out.filePath("movie" + ending), .size = size});
    await("the movie", [&] { return written.has_value(); });
    m_heartbeat.end();
    cost.seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
    if (!*written) qFatal("the movie was not written");
    return cost;
}

}  // namespace echolucent::bench
