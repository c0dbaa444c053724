#include "app/measuring/study_phantoms.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/cli/options/option_text.h"
#include "app/measuring/study_output.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent::cli {

void PhantomChoice::addTo(CLI::App& command) {
    command.add_option("--seeds", seeds, "Seeds of the phantoms: 1,2,5 or 1-4")
        ->type_name("N,...")
        ->capture_default_str();
    command.add_option("--size", size, "Voxels of the phantoms, one number or XxYxZ [199x197x199]")->type_name("XxYxZ");
}

Result<std::vector<PhantomConfig>> PhantomChoice::bases() const {
    PhantomConfig base = defaultPhantom(PhantomScene::shapes);
    if (!size.empty()) {
        const bool one = size.find_first_of("x,") == std::string::npos;
        const auto counts = parseNumbers(size, one ? 1 : 3, "--size", "199x197x199");
        if (!counts) return tl::unexpected<Failure>(counts.error());
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double count = (*counts)[one ? 0 : axis];
            if (!(count >= 8 && count <= 512) || count != std::floor(count))
                return fail(FailureKind::wrongUsage, "", "--size", "must be whole numbers from 8 to 512");
            base.size[axis] = static_cast<std::int64_t>(count);
        }
    }
    const auto chosen = parseSeeds(seeds, "--seeds");
    if (!chosen) return tl::unexpected<Failure>(chosen.error());
    std::vector<PhantomConfig> all;
    for (const std::uint64_t seed : *chosen) {
        base.seed = seed;
        all.push_back(base);
    }
    return all;
}

PhantomConfig scaledPhantom(PhantomScene scene, int edge) {
    PhantomConfig config = defaultPhantom(scene);
    if (edge == 0) return config;
    const double extentMm = static_cast<double>(config.size[0]) * config.spacing[0];
    config.size.fill(edge);
    config.spacing = Vec3::all(extentMm / edge);
    return config;
}

std::vector<NamedPhantom> contrastConditions(const PhantomConfig& base) {
    std::vector<NamedPhantom> known = ordinaryConditions(base);
    for (NamedPhantom& hard : hardConditions(base)) known.push_back(std::move(hard));
    std::vector<NamedPhantom> chosen;
    for (const char* name :
         {"base", "specular", "little_speckle", "attenuation_shadow", "hard_full_speckle", "hard_log_compressed"}) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
        if (found == known.end()) throw std::logic_error("contrastConditions: a condition has lost its name");
        chosen.push_back(*found);
    }
    return chosen;
}

OpacityCurve parabolaCurve() { return PowerCurve{2, 1.0}; }

OpacityCurve linearCurve() { return LinearCurve{20.0 / 255.0, 0.5, 1.0}; }

std::vector<Classification> contrastCurvesOf(const Volume& volume, const Viewpoint& view, const QuietVoxels& shown) {
    std::vector<Classification> curves{parabolaCurve(), linearCurve()};
    for (const MethodReading reading : allReadings)
        curves.emplace_back(OpacityCurve(adaptOpacity(volume, view, configOf(reading), {}, shown)->curve));
    return curves;
}

std::vector<std::string> contrastCurveNames() {
    std::vector<std::string> names{"x²", "eq. 1"};
    for (const MethodReading reading : allReadings) names.emplace_back(nameOf(reading));
    return names;
}

std::optional<double> meanOf(const std::vector<std::optional<double>>& values) {
    double sum = 0.0;
    int count = 0;
    for (const auto& value : values)
        if (value) {
            sum += *value;
            ++count;
        }
    if (count == 0) return std::nullopt;
    return sum / count;
}

}  // namespace echolucent::cli
