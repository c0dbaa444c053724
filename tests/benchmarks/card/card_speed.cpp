#include "tests/benchmarks/card/card_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "processing/card_picture/card_pictures.h"
#include "processing/median.h"
#include "processing/picture/converged.h"
#include "tests/benchmarks/card/card_case.h"

namespace echolucent::bench {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Viewpoint turnedBy(int degrees) { return {BeamAxis::plusZ, 20.0 + degrees, -12.0}; }

/// Lit as a picture starts, as while a hand turns or as at rest.
RayCastSettings settingsFor(const Volume& volume, const std::array<int, 2>& size, bool bowed, bool atRest) {
    RayCastSettings settings;
    settings.width = size[0];
    settings.height = size[1];
    settings.shading = Shading{};
    settings.shading->ambient = 0.5;
    settings.shading->diffuse = 1.3;
    settings.shading->reaching = ReachingLight{};
    const ViewFrame frame = frameOf(turnedBy(10));
    if (bowed)
        settings.cutSurface = bowedFront(volume, frame);
    else
        settings.front = CuttingFace{frame.forward, frame.forward.dot(volume.geometry().centreMm())};
    if (atRest) return converged(settings);
    settings.terminationTransmittance = 1.0 / 128;
    settings.lightCoarseness *= 2;
    return settings;
}

struct Times {
    std::vector<double> prepare, light, upload, draw;
};

bool drawOne(CardWindow& window, CardPictures& maker, const RayCastSettings& settings, Times& times) {
    const OpacityCurve curve = ManualCurve{{{0.25, 0.0}, {0.4, 0.4}, {1.0, 0.9}}};
    const auto picture = std::make_shared<const CardPicture>(maker.make(curve, settings).value());
    if (!window.draw(picture)) {
        fmt::print(stderr, "{}\n", window.renderer().failure());
        return false;
    }
    times.prepare.push_back(picture->milliseconds);
    times.light.push_back(picture->lightMilliseconds);
    times.upload.push_back(window.renderer().uploadMilliseconds());
    times.draw.push_back(window.renderer().drawMilliseconds());
    return true;
}

void printRow(const std::string& name, const Times& times) {
    const double prepare = medianOf(times.prepare), upload = medianOf(times.upload), draw = medianOf(times.draw);
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", name, prepare, medianOf(times.light),
               upload, draw, 1000.0 / (upload + draw), 1000.0 / std::max(prepare, upload + draw));
    std::fflush(stdout);
}

bool measureVolume(CardWindow& window, const SpeedPlan& plan, int edge) {
    const auto volume = simulated(true, edge);
    auto begin = Clock::now();
    CardPictures maker(volume);
    const double making = millisecondsSince(begin);
    Times first;
    if (!drawOne(window, maker, settingsFor(*volume, {64, 64}, false, false), first)) return false;
    fmt::print("| {}^3: voxels prepared {:.0f} ms, brought to the card {:.1f} ms |||||||\n", edge, making,
               first.upload.front());
    for (const auto& size : plan.sizes)
        for (const CardReading reading : {CardReading::filter, CardReading::eightFetches})
            for (const bool bowed : {false, true})
                for (const bool atRest : {false, true}) {
                    window.renderer().setReading(reading);
                    Times times, warm;
                    RayCastSettings settings = settingsFor(*volume, size, bowed, atRest);
                    for (int frame = -2; frame < plan.frames; ++frame) {
                        settings.camera =
                            defaultCamera(volume->dataBox(), turnedBy(frame), static_cast<double>(size[0]) / size[1]);
                        if (!drawOne(window, maker, settings, frame < 0 ? warm : times)) return false;
                    }
                    printRow(fmt::format("{}^3, {} x {}, {}, {} front, {}", edge, size[0], size[1],
                                         reading == CardReading::filter ? "filter" : "eight fetches",
                                         bowed ? "bowed" : "flat", atRest ? "at rest" : "turning"),
                             times);
                }
    return true;
}

/// Volumes of one grid that hold different voxels.
std::vector<std::shared_ptr<const Volume>> phasesOf(int edge, int count) {
    const auto volume = simulated(true, edge);
    std::vector<std::shared_ptr<const Volume>> phases{volume};
    for (int phase = 1; phase < count; ++phase) {
        auto voxels = std::get<VoxelArray<std::uint8_t>>(volume->voxels()).toVector();
        std::rotate(voxels.begin(), voxels.begin() + phase, voxels.end());
        phases.push_back(std::make_shared<const Volume>(volume->geometry(), std::move(voxels)));
    }
    return phases;
}

bool measurePhases(CardWindow& window, const SpeedPlan& plan) {
    const int edge = plan.edges.front();
    std::vector<CardPictures> makers;
    for (const auto& phase : phasesOf(edge, plan.phases)) makers.emplace_back(phase);
    window.renderer().setReading(CardReading::filter);
    const int before = window.renderer().volumesBrought();
    for (int turn = 0; turn < 3; ++turn) {
        Times times;
        for (CardPictures& maker : makers) {
            RayCastSettings settings = settingsFor(*maker.volume(), plan.sizes.front(), false, false);
            settings.camera = defaultCamera(maker.volume()->dataBox(), turnedBy(0), 1.0);
            if (!drawOne(window, maker, settings, times)) return false;
        }
        printRow(fmt::format("{} phases of {}^3, {} x {}, turn {}", plan.phases, edge, plan.sizes.front()[0],
                             plan.sizes.front()[1], turn + 1),
                 times);
    }
    fmt::print("\nPhases were brought to the card {} times in three turns of {}.\n",
               window.renderer().volumesBrought() - before, plan.phases);
    return true;
}

}  // namespace

bool measureSpeed(CardWindow& window, const SpeedPlan& plan) {
    fmt::print(
        "\n| lit | prepare, ms | of it light | bring, ms | draw, ms | pictures a second, drawn | with preparation in "
        "another thread |\n| --- | --- | --- | --- | --- | --- | --- |\n");
    for (const int edge : plan.edges)
        if (!measureVolume(window, plan, edge)) return false;
    return plan.phases == 0 || measurePhases(window, plan);
}

}  // namespace echolucent::bench
