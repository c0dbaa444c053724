// echolucent-bench-stroke: how soon a stroke of the scalpel shows, and how soon it is taken back.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/median.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/look.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "widgets/casting/qualities.h"

namespace {

using namespace echolucent;

constexpr int window = 512;  // pixels along a side

/// Of all threads, ms; where others use the machine too, it says more than wall time.
double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// What the window holds of an open volume.
struct Opened {
    std::shared_ptr<const Volume> scan, quiet;
    OpacityCurve curve;
    RayCastSettings settings;  ///< as settingsAt() takes them
};

/// The simulated fetus; where it is a sector, no data lies beside a fan about the z axis.
Opened opened(std::int64_t edge, bool sector) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {edge, edge, edge};
    Opened made;
    made.scan = std::make_shared<const Volume>(*makePhantom(config));
    if (sector) {
        const VolumeGeometry& geometry = made.scan->geometry();
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(geometry.voxelCount()));
        const double middle = 0.5 * static_cast<double>(edge);
        for (std::int64_t z = 0; z < edge; ++z)
            for (std::int64_t y = 0; y < edge; ++y)
                for (std::int64_t x = 0; x < edge; ++x) {
                    const double across = static_cast<double>(x) - middle, beside = static_cast<double>(y) - middle;
                    const double reach = 0.2 * middle + 0.45 * static_cast<double>(z);
                    const bool held = std::abs(across) < reach && std::abs(beside) < reach;
                    mask[static_cast<std::size_t>(geometry.offset(x, y, z))] = held ? 1 : 0;
                }
        made.scan = std::make_shared<const Volume>(made.scan->withDataMask(std::move(mask)));
    }
    const Look look = lookAtStart();
    made.quiet = std::make_shared<const Volume>(*quietVolume(*made.scan, look.reduction));
    Viewpoint view;
    made.curve = adaptOpacity(*made.scan, view, {}, {}, {made.quiet.get(), look.reduction})->curve;
    // No border of a stroke lies along a grid axis.
    view.azimuthDegrees = 20;
    view.elevationDegrees = -12;
    made.settings = rayCastSettings(look);
    made.settings.width = made.settings.height = window;
    made.settings.camera = defaultCamera(made.scan->dataBox(), view, 1.0);
    return made;
}

/// A stroke drawn by hand; another one in each run.
ScalpelStroke strokeOf(const Camera& camera, double radius, int run) {
    ScalpelStroke stroke{.camera = camera};
    const double shift = 0.002 * (run % 17);
    for (int i = 0; i < 200; ++i) {
        const double angle = 2 * std::numbers::pi * i / 200, wobbly = radius * (1 + 0.2 * std::sin(5 * angle));
        stroke.places.push_back({0.03 + shift + wobbly * std::cos(angle), -0.02 + wobbly * std::sin(angle)});
    }
    return stroke;
}

/// A stroke that the others do not meet.
std::vector<ScalpelStroke> strokeBeside(const Camera& camera) {
    return {{.tool = ScalpelTool::eraser, .camera = camera, .places = {{-0.45, -0.3}, {-0.45, 0.3}}, .radius = 0.03}};
}

struct Times {
    std::vector<double> mask, caster, picture, total, processor;
    void add(double first, double second, double third, double ofThreads) {
        processor.push_back(ofThreads);
        mask.push_back(first);
        caster.push_back(second);
        picture.push_back(third);
        total.push_back(first + second + third);
    }
    void print(const std::string& volume, const std::string& what) const {
        fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", volume, what, medianOf(mask),
                   medianOf(caster), medianOf(picture), medianOf(total), *std::ranges::min_element(total),
                   *std::ranges::min_element(processor));
        std::fflush(stdout);
    }
};

/// One window's scalpel, caster and picture.
class Scalpel {
public:
    explicit Scalpel(const Opened& opened) : m_opened(opened), m_cuts(opened.scan->geometry()), m_caster(opened.quiet) {
        settle();
    }

    /// Shows what strokes leave as soon as the window would, and lets the picture settle.
    void show(const std::vector<ScalpelStroke>& strokes, Times& times) {
        const double before = processorTime();
        const auto start = std::chrono::steady_clock::now();
        const auto raw = std::make_shared<const Volume>(*m_cuts.cut(*m_opened.scan, strokes));
        const auto cut = std::make_shared<const Volume>(m_opened.quiet->withCut(raw->cut()));
        const double mask = since(start);
        m_caster.setCut(cut);
        const double caster = since(start);
        (void)m_caster.cast(m_opened.curve, settingsAt(firstQuality, m_opened.settings));
        times.add(mask, caster - mask, since(start) - caster, processorTime() - before);
        m_raw = raw;
        settle();
    }

private:
    /// The finer picture that the window shows when the hand rests, which needs the light of its own grid.
    void settle() { (void)m_caster.cast(m_opened.curve, settingsAt(highQuality, m_opened.settings)); }

    const Opened& m_opened;
    ScalpelCuts m_cuts;
    RayCaster m_caster;
    std::shared_ptr<const Volume> m_raw;  ///< which the window keeps for planes and method
};

/// The same picture where nothing is known of what was before: mask, caster (voxels are packed too) and light.
void showAnew(const Opened& opened, const std::vector<ScalpelStroke>& strokes, Times& times) {
    const double before = processorTime();
    const auto start = std::chrono::steady_clock::now();
    const auto raw = ScalpelCuts(opened.scan->geometry()).cut(*opened.scan, strokes);
    const auto cut = std::make_shared<const Volume>(opened.quiet->withCut(raw->cut()));
    const double mask = since(start);
    RayCaster fresh(cut);
    const double caster = since(start);
    (void)fresh.cast(opened.curve, settingsAt(firstQuality, opened.settings));
    times.add(mask, caster - mask, since(start) - caster, processorTime() - before);
}

void measure(const Opened& opened, const std::string& name, const std::vector<ScalpelStroke>& before, int runs) {
    Scalpel scalpel(opened);
    Times warm;
    constexpr std::array<std::pair<const char*, double>, 2> sizes{{{"small stroke", 0.05}, {"large stroke", 0.3}}};
    for (const auto& [what, radius] : sizes) {
        Times stroke, undo, redo, anew;
        scalpel.show(before, warm);
        for (int run = 0; run < runs; ++run) {
            std::vector<ScalpelStroke> strokes = before;
            strokes.push_back(strokeOf(opened.settings.camera, radius, run));
            scalpel.show(strokes, stroke);
            scalpel.show(before, undo);
            scalpel.show(strokes, redo);
            scalpel.show(before, warm);
            if (run % 5 == 0) showAnew(opened, strokes, anew);
        }
        stroke.print(name, what);
        undo.print(name, fmt::format("undo of a {}", what));
        redo.print(name, fmt::format("redo of a {}", what));
        anew.print(name, fmt::format("{}, all anew", what));
    }
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app{"Measures how soon a stroke of the scalpel shows: a Markdown table of medians, wall ms."};
    int runs = 25, threads = 2;
    std::int64_t edge = 256;
    app.add_option("--runs", runs, "strokes of which the median is taken")->check(CLI::PositiveNumber);
    app.add_option("--threads", threads, "threads that work")->check(CLI::PositiveNumber);
    app.add_option("--edge", edge, "voxels along each axis of the simulated volume")->check(CLI::Range(32, 1024));
    CLI11_PARSE(app, count, arguments);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    fmt::print("| volume | what | mask | caster | picture | total | least total | least processor time |\n");
    fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    const Opened whole = opened(edge, false);
    measure(whole, "all data", {}, runs);
    measure(whole, "all data, cut before", strokeBeside(whole.settings.camera), runs);
    measure(opened(edge, true), "sector", {}, runs);
    return 0;
}
