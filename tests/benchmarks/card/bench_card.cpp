// Compares a graphics card's pictures with the processor's, and measures how fast the card draws.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/study/study.h"
#include "tests/benchmarks/card/card_comparison.h"
#include "tests/benchmarks/card/card_speed.h"

namespace {

using namespace echolucent;
using namespace echolucent::bench;

struct Plan {
    std::vector<std::string> files, sizes, parts{"pictures", "speed"};
    std::vector<int> edges;
    ComparisonPlan comparison{.views = 0, .plainly = false, .pictures = {}};
    SpeedPlan speed{.frames = 0};
    int edge = 64, pixels = 0;
    std::string only;
    bool egl = false;
};

/// What is not said follows the machine: software OpenGL does little, and says what it leaves out.
void choose(Plan& plan, bool software) {
    if (plan.comparison.views == 0) plan.comparison.views = software ? 1 : 40;
    if (plan.pixels == 0) plan.pixels = software ? 96 : 512;
    if (plan.speed.frames == 0) plan.speed.frames = software ? 2 : 20;
    if (!plan.edges.empty())
        plan.speed.edges = plan.edges;
    else if (software)
        plan.speed.edges = {64};
    if (software && plan.sizes.empty()) plan.sizes = {"256x256"};
    if (software) plan.speed.phases = 3;
    if (!plan.sizes.empty()) plan.speed.sizes.clear();
    for (const std::string& size : plan.sizes) {
        std::array<int, 2> pixels{};
        if (std::sscanf(size.c_str(), "%dx%d", &pixels[0], &pixels[1]) == 2 && pixels[0] > 0 && pixels[1] > 0)
            plan.speed.sizes.push_back(pixels);
    }
    if (software)
        fmt::print(
            "OpenGL is software: small pictures of small volumes only. A card also does 40 views of 512 pixels, "
            "256^3 and 512^3 voxels at 1024x1024, 1920x1080 and 3840x2160, and 20 phases.\n\n");
}

std::optional<std::vector<CardCase>> comparedCases(const Plan& plan) {
    std::vector<CardCase> cases = casesOfPhantoms(plan.edge, plan.pixels);
    for (const std::string& file : plan.files) {
        const auto study = readStudy(file);
        if (!study) {
            fmt::print(stderr, "{}\n", study.error().sentence());
            return std::nullopt;
        }
        const std::string name = std::filesystem::path(file).filename().string();
        const std::size_t phases = study->phases.size();
        for (std::size_t phase = 0; phase < phases; phase += std::max<std::size_t>(phases - 1, 1)) {
            const auto more = casesOf(name + (phase > 0 ? ", last phase" : ""), study->phases[phase], plan.pixels);
            cases.insert(cases.end(), more.begin(), more.end());
        }
    }
    std::erase_if(cases, [&](const CardCase& one) {
        return (one.volume + ", " + one.look).find(plan.only) == std::string::npos;
    });
    return cases;
}

bool does(const Plan& plan, const char* part) {
    return std::find(plan.parts.begin(), plan.parts.end(), part) != plan.parts.end();
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("Compares a graphics card's pictures with the processor's, and measures how fast the card draws");
    Plan plan;
    app.add_option("--volume", plan.files, "Volumes that are compared besides the simulated ones");
    app.add_option("--parts", plan.parts, "pictures, speed")->check(CLI::IsMember({"pictures", "speed"}));
    app.add_option("--views", plan.comparison.views, "Views of each case")->check(CLI::Range(1, 1000));
    app.add_option("--edge", plan.edge, "Voxels along an edge of the compared simulated volumes")
        ->check(CLI::Range(16, 512))
        ->capture_default_str();
    app.add_option("--pixels", plan.pixels, "Pixels along an edge of compared pictures")->check(CLI::Range(16, 4096));
    app.add_option("--only", plan.only, "Only cases with these words in volume and look");
    app.add_flag("--plainly", plan.comparison.plainly, "Compares with the slow, obvious route of the processor");
    app.add_option("--pictures", plan.comparison.pictures, "A folder for the pictures that are farthest off");
    app.add_option("--edges", plan.edges, "Voxels along an edge of the volumes whose speed is measured")
        ->check(CLI::Range(16, 1024));
    app.add_option("--sizes", plan.sizes, "Sizes of pictures whose speed is measured, WIDTHxHEIGHT");
    app.add_option("--frames", plan.speed.frames, "Pictures that are timed of each row")->check(CLI::Range(1, 1000));
    app.add_flag("--egl", plan.egl, "Without an X server");
    CLI11_PARSE(app, count, arguments);
    if (plan.egl && !CardWindow::hasEgl()) {
        fmt::print(stderr, "VTK was built here without EGL: the program needs an X server.\n");
        return 2;
    }
    CardWindow window(plan.egl);
    fmt::print("OpenGL: {}\n\n", window.renderer().card().renderer);
    choose(plan, isSoftwareOpenGl(window.renderer().card().renderer));
    if (does(plan, "pictures")) {
        const auto cases = comparedCases(plan);
        if (!cases) return 3;
        if (!compareCases(window, *cases, plan.comparison)) return 1;
    }
    return !does(plan, "speed") || measureSpeed(window, plan.speed) ? 0 : 1;
}
