#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/phantom_output.h"
#include "app/cli/phantom_polar.h"
#include "app/cli/report/phantom_report.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

/// The options as written. If `size`, `spacing` or `contrast` is empty, or a number has no value, the scene decides
/// (defaultPhantom()).
struct PhantomOptions {
    std::string output, scene = "fetus", polar, size, spacing, contrast, truth, tubeGrid;
    int phases = 1, bits = 8;
    std::optional<double> speckle, speckleSize, ramp, gainVariation, attenuation, shadow, specular, decibel;
    bool frontWall = false;
    std::string seed = "1";
    ViewOptions view;
    TubeGrid tubes;
    int cellSize = CellRule{}.size;
};

/// "AxBxC", or one number for all three.
Result<std::vector<double>> parseTriple(const std::string& text, const std::string& option,
                                        const std::string& example) {
    if (text.find_first_of("x,") != std::string::npos) return parseNumbers(text, 3, option, example);
    return parseNumbers(text, 1, option, example).map([](const std::vector<double>& one) {
        return std::vector<double>(3, one.front());
    });
}

Result<void> setGrid(const PhantomOptions& options, PhantomConfig& config) {
    if (!options.size.empty()) {
        const auto size = parseTriple(options.size, "--size", "199x197x199");
        if (!size) return tl::unexpected<Failure>(size.error());
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double count = (*size)[axis];
            if (!(count >= 8 && count <= 1024) || count != std::floor(count))
                return wrongUsage("--size", "must be whole numbers from 8 to 1024", "Write it as 199x197x199.");
            config.size[axis] = static_cast<std::int64_t>(count);
        }
    }
    if (!options.spacing.empty()) {
        const auto spacing = parseTriple(options.spacing, "--spacing", "0.5x0.5x1");
        if (!spacing) return tl::unexpected<Failure>(spacing.error());
        for (int axis = 0; axis < 3; ++axis) {
            const double mm = (*spacing)[static_cast<std::size_t>(axis)];
            if (!(mm >= 1e-3 && mm <= 1e3))
                return wrongUsage("--spacing", "must be 0.001 to 1000 mm", "Write it as 0.5x0.5x1.");
            config.spacing[axis] = mm;
        }
    }
    return {};
}

Result<void> setContrast(const PhantomOptions& options, PhantomConfig& config) {
    if (options.contrast.empty()) return {};
    const auto echoes = parseNumbers(options.contrast, 3, "--contrast", "14,85,170");
    if (!echoes) return tl::unexpected<Failure>(echoes.error());
    for (const double echo : *echoes)
        if (!(echo >= 0 && echo <= 255))
            return wrongUsage("--contrast", "must be three intensities from 0 to 255", "Write it as 14,85,170.");
    config.fluid = (*echoes)[0];
    config.tissue = (*echoes)[1];
    config.object = (*echoes)[2];
    return {};
}

Result<PhantomConfig> configFrom(const PhantomOptions& options) {
    const auto scene = phantomSceneFromName(options.scene);
    if (!scene) return wrongUsage("--scene", "is \"" + options.scene + "\"", "Use shapes, fetus or empty.");
    PhantomConfig config = defaultPhantom(*scene);
    if (auto set = setGrid(options, config); !set) return tl::unexpected<Failure>(set.error());
    if (auto set = setContrast(options, config); !set) return tl::unexpected<Failure>(set.error());
    config.speckle = options.speckle.value_or(config.speckle);
    config.speckleSize = options.speckleSize.value_or(config.speckleSize);
    config.ramp = options.ramp.value_or(config.ramp);
    config.gainVariation = options.gainVariation.value_or(config.gainVariation);
    config.attenuation = options.attenuation.value_or(config.attenuation);
    config.shadow = options.shadow.value_or(config.shadow);
    config.specular = options.specular.value_or(config.specular);
    config.logCompressDecibel = options.decibel.value_or(config.logCompressDecibel);
    config.frontWall = options.frontWall;
    config.bits = options.bits;
    const char* const end = options.seed.data() + options.seed.size();
    const auto [stop, problem] = std::from_chars(options.seed.data(), end, config.seed);
    if (problem != std::errc() || stop != end)
        return wrongUsage("--seed", "is \"" + options.seed + "\"",
                          "Use a whole number from 0 to 18446744073709551615.");
    if (config.frontWall && config.scene == PhantomScene::empty)
        return wrongUsage("--front-wall", "makes no sense where there is no fluid", "Leave it out with --scene empty.");
    return config;
}

/// Refuses what CLI11's ranges let through: numbers that are not finite, and more memory than a person can have meant.
Result<void> check(const PhantomOptions& options, const PhantomConfig& config) {
    for (const double value :
         {config.speckle, config.speckleSize, config.ramp, config.gainVariation, config.attenuation, config.shadow,
          config.specular, config.logCompressDecibel, options.tubes.spacing})
        if (!std::isfinite(value)) return wrongUsage("", "every option's number must be finite");
    constexpr double largest = 4e9;
    double bytes = (config.bits == 8 ? 1.0 : 2.0) * options.phases;
    for (const std::int64_t count : config.size) bytes *= static_cast<double>(count);
    if (bytes > largest) return wrongUsage("--size", "makes more than 4 GB", "Use fewer voxels or phases.");
    return {};
}

Result<void> writeOnGrid(const std::string& path, const std::vector<PhantomConfig>& phases) {
    std::vector<std::shared_ptr<const Volume>> volumes;
    volumes.reserve(phases.size());
    for (const PhantomConfig& phase : phases) volumes.push_back(std::make_shared<const Volume>(*makePhantom(phase)));
    return writePhantom(path, volumes);
}

Result<void> makeAndWrite(const PhantomOptions& options) {
    if (!isPolarName(options.output))
        if (auto named = checkPhantomName(options.output); !named) return named;
    if (auto checked = checkOutputs({options.output, layoutBeside(options.output), options.truth}); !checked)
        return checked;
    const auto config = configFrom(options);
    if (!config) return tl::unexpected<Failure>(config.error());
    if (auto checked = check(options, *config); !checked) return checked;
    const auto view = options.view.getOfSimulatedScan();
    if (!view) return tl::unexpected<Failure>(view.error());
    const Result<TubeGrid> tubes =
        options.tubeGrid.empty() ? Result<TubeGrid>(options.tubes) : tubeGridFrom(options.tubeGrid, options.tubes);
    if (!tubes) return tl::unexpected<Failure>(tubes.error());

    const auto polar = polarOfPhantom(options.output, options.polar, options.phases, *config);
    if (!polar) return tl::unexpected<Failure>(polar.error());

    std::vector<PhantomConfig> phases;
    for (int index = 0; index < options.phases; ++index) {
        phases.push_back(*config);
        phases.back().phase = static_cast<double>(index) / options.phases;
    }
    auto written = *polar ? writePolarPhantom(options.output, **polar, phases) : writeOnGrid(options.output, phases);
    if (!written || options.truth.empty()) return written;
    return writeFileAtomically(options.truth, truthReport(phases, *view, *tubes, options.cellSize));
}

void addLook(CLI::App& command, PhantomOptions& options) {
    const auto share = CLI::Range(0.0, 1.0);
    command.add_option("--speckle", options.speckle, "s of 1 + s (R - 1), R Rayleigh of unit mean [0.5; fetus 0.3]")
        ->check(share);
    command
        .add_option("--speckle-size", options.speckleSize,
                    "FWHM of the speckle's smoothing, voxels; 0: uncorrelated [2]")
        ->check(CLI::Range(0.0, 64.0));
    command.add_option("--contrast", options.contrast, "Mean echoes of fluid, tissue and object, 0 to 255 [14,85,170]")
        ->type_name("FLUID,TISSUE,OBJECT");
    command.add_option("--ramp", options.ramp, "Width of a boundary, units (smallest spacing) [4]")
        ->check(CLI::Range(0.0, 100.0));
    command.add_option("--gain-variation", options.gainVariation, "Slow change of gain, share [0.15]")->check(share);
    command.add_option("--attenuation", options.attenuation, "Loss along +z per unit [0; fetus 0.002]")
        ->check(CLI::Range(0.0, 1.0));
    command.add_option("--shadow", options.shadow, "Loss per unit of object (bone) passed along +z [0; fetus 0.02]")
        ->check(CLI::Range(0.0, 1.0));
    command
        .add_option("--specular", options.specular,
                    "Brightening of surfaces that face the probe, share [0; fetus 0.25]")
        ->check(CLI::Range(0.0, 10.0));
    command.add_option("--log-compress", options.decibel, "Logarithmic compression to this many decibels [none]")
        ->type_name("DB")
        ->check(CLI::Range(1.0, 200.0));
    command.add_flag("--front-wall", options.frontWall, "A wall of tissue, 20 to 25 units thick, before everything");
}

void addTruth(CLI::App& command, PhantomOptions& options) {
    const auto within = [](std::string_view name) {
        const ParameterRange range = parameterNamed(methodParameters(), name)->range;
        return CLI::Range(range.least, range.largest);
    };
    command.add_option("--truth", options.truth, "Also writes the true surfaces as JSON (docs/cli-phantom.md)")
        ->type_name("FILE");
    options.view.addTo(command, ViewOf::simulatedScan);
    command.add_option("--tube-grid", options.tubeGrid, "Tube cores of the truth across and down the view [15x15]")
        ->type_name("NxM");
    command.add_option("--tube-spacing", options.tubes.spacing, "Units between tube cores; 0: automatic")
        ->check(within("tube_spacing"))
        ->capture_default_str();
    command.add_option("--cell-size", options.cellSize, "Width of a tube core, units, for the truth's corner rays")
        ->check(within("cell_size"))
        ->capture_default_str();
}

}  // namespace

void addPhantomCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<PhantomOptions>();
    CLI::App& command =
        *program.add_subcommand("phantom", "Writes a simulated 3D ultrasound volume with known surfaces");
    command.add_option("OUT", options->output, "File to write: " + phantomEndings() + "; along beams: .vol or .raw")
        ->required();
    command.add_option("--scene", options->scene, "shapes, fetus or empty")->type_name("NAME")->capture_default_str();
    command
        .add_option("--polar", options->polar,
                    "Samples the scene along the beams of a probe: linear, convex, linear-wobbler or wobbler [.vol: "
                    "wobbler]")
        ->type_name("KIND");
    command.add_option("--phases", options->phases, "Number of phases of a moving scene; more than 1 makes a 4D file")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command
        .add_option("--size", options->size,
                    "Voxels along x, y, z (samples, lines, planes with --polar), or one number for all [199x197x199]")
        ->type_name("XxYxZ");
    command
        .add_option("--spacing", options->spacing,
                    "mm between voxels, three numbers or one; between samples with --polar [0.5]")
        ->type_name("XxYxZ");
    command.add_option("--bits", options->bits, "Bits stored: 8, 12 or 16")
        ->check(CLI::IsMember({8, 12, 16}))
        ->capture_default_str();
    command.add_option("--seed", options->seed, "Seed of speckle and gain, a whole number from 0 to 2^64 - 1")
        ->type_name("N")
        ->capture_default_str();
    addLook(command, *options);
    addTruth(command, *options);
    command.footer(
        "Example: echolucent-cli phantom shapes.mha --scene shapes --size 160 --speckle 1 --seed 7 --truth "
        "shapes.json\n"
        "         echolucent-cli phantom heart.mha --phases 8\n"
        "         echolucent-cli phantom fetus.vol");
    command.callback([options, &action] { action = [options] { return makeAndWrite(*options); }; });
}

}  // namespace echolucent::cli
