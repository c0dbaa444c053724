// `study otf`: error against run time of the adaptive OTF, and the readings of the method side by side.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/measuring/otf/study_otf.h"
#include "app/measuring/study.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent::cli {

namespace {

struct OtfStudyOptions {
    VolumeOptions volume;
    PhantomChoice phantoms;
    ViewOptions view;
    std::string folder;
    bool onPhantoms = false;
    int repeats = 9;
};

/// The view lies away from every grid axis, so that the tubes' samples must be interpolated.
const Viewpoint oblique{.azimuthDegrees = 20, .elevationDegrees = -12};

struct GroupedPhantom {
    std::string group;
    NamedPhantom phantom;
};

std::vector<GroupedPhantom> allConditions(const PhantomConfig& base) {
    std::vector<GroupedPhantom> all;
    const auto add = [&](const std::string& group, const std::vector<NamedPhantom>& phantoms) {
        for (const NamedPhantom& phantom : phantoms) all.push_back({group, phantom});
    };
    add("ordinary", ordinaryConditions(base));
    add("hard", hardConditions(base));
    add("front wall", frontWallConditions(base));
    PhantomConfig nothing = base;
    nothing.scene = PhantomScene::empty;
    add("empty", emptyConditions(nothing));
    return all;
}

/// The settings' errors are measured on these, the readings on all. Run times are measured on the first alone, because
/// how long a run takes hardly depends on what the voxels hold.
bool isForErrors(const std::string& condition) {
    return condition == "base" || condition == "attenuation_shadow" || condition == "hard_full_speckle" ||
           condition == "hard_ramp8" || condition == "front_wall";
}

/// CNR_S of the fixed curves and of the readings just measured, where the condition is one of the six.
void addContrast(const StudyPhantom& phantom, const std::string& condition, std::span<ReadingResult> readings,
                 OtfStudy& study) {
    bool isOne = false;
    for (const NamedPhantom& one : contrastConditions(phantom.config)) isOne = isOne || one.name == condition;
    if (!isOne) return;
    std::vector<OpacityCurve> curves{parabolaCurve(), linearCurve()};
    for (const ReadingResult& reading : readings) curves.emplace_back(reading.curve);
    const auto rays = objectRays(phantom.volume.geometry(), phantom.truth, Viewpoint{});
    const auto contrasts = surfaceContrasts(phantom.volume, rays, Viewpoint{}, curves);
    study.fixed.push_back(
        {condition, phantom.config.seed, contrasts[0].contrastToNoise(), contrasts[1].contrastToNoise()});
    for (std::size_t i = 0; i < readings.size(); ++i) readings[i].contrast = contrasts[i + 2].contrastToNoise();
}

void measurePhantom(const GroupedPhantom& grouped, int repeats, OtfStudy& study) {
    const StudyPhantom phantom(grouped.phantom.config);
    const std::string& condition = grouped.phantom.name;
    for (const Viewpoint& view : {Viewpoint{}, oblique}) {
        const OtfCase one{condition, &phantom.volume, view, &phantom.truth};
        const std::size_t first = study.readings.size();
        for (const MethodReading reading : allReadings) {
            study.readings.push_back(measureReading(one, reading));
            study.readings.back().group = grouped.group;
            study.readings.back().seed = phantom.config.seed;
        }
        if (view == Viewpoint{}) addContrast(phantom, condition, std::span(study.readings).subspan(first), study);
        if (!isForErrors(condition)) continue;
        measureErrors(one, study.variants);
        if (condition == "base") measureTimes(one, repeats, study.variants);
    }
}

Result<OtfStudy> studyPhantoms(const OtfStudyOptions& options) {
    const auto bases = options.phantoms.bases();
    if (!bases) return tl::unexpected<Failure>(bases.error());
    OtfStudy study;
    study.truthKnown = true;
    study.repeats = options.repeats;
    const auto& size = bases->front().size;
    study.subject = fmt::format(
        "Simulated scans with known surfaces (scene shapes, {}x{}x{} voxels, seeds {}), along the beam and obliquely.",
        size[0], size[1], size[2], options.phantoms.seeds);
    for (const PhantomConfig& base : *bases)
        for (const GroupedPhantom& grouped : allConditions(base)) measurePhantom(grouped, options.repeats, study);
    return study;
}

std::string paretoFile(const std::string& function) { return "otf-pareto-" + function + ".svg"; }

std::vector<std::string> namesOfFiles() {
    std::vector<std::string> names{"otf-settings.csv", "otf-readings.csv", "otf.html"};
    for (const std::string& function : interfaceFunctions) names.push_back(paretoFile(function));
    return names;
}

Result<OtfStudy> studyVolume(const OtfStudyOptions& options, const std::vector<std::string>& outputs) {
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto volume = options.volume.readPhase(outputs);
    if (!volume) return tl::unexpected<Failure>(volume.error());
    const auto view = options.view.get(**volume);
    if (!view) return tl::unexpected<Failure>(view.error());
    OtfStudy study;
    study.repeats = options.repeats;
    const auto& size = (*volume)->geometry().size;
    study.subject = fmt::format(
        "{} ({}x{}x{} voxels), beam axis {}, azimuth {}°, elevation {}°, near cut {} mm. Its true surfaces "
        "are not known: there is no detection error, only the curve's.",
        options.volume.path, size[0], size[1], size[2], nameOf(view->beamAxis), view->azimuthDegrees,
        view->elevationDegrees, view->nearCutMm);
    const OtfCase one{options.volume.path, volume->get(), *view, nullptr};
    for (const MethodReading reading : allReadings) study.readings.push_back(measureReading(one, reading));
    measureErrors(one, study.variants);
    measureTimes(one, options.repeats, study.variants);
    return study;
}

Result<void> writeStudy(const StudyFolder& folder, const OtfStudy& study) {
    std::vector<std::pair<std::string, std::string>> files{{"otf-settings.csv", variantsCsv(study)},
                                                           {"otf-readings.csv", readingsCsv(study)},
                                                           {"otf.html", otfPage(study)}};
    for (const std::string& function : interfaceFunctions)
        files.emplace_back(paretoFile(function), svgOf(paretoPlot(study, function, false)));
    for (const auto& [name, bytes] : files)
        if (auto written = folder.write(name, bytes); !written) return written;
    return writeFileAtomically("-", summaryText(study) + "\n" + folder.pathOf("otf.html") + "\n");
}

Result<void> studyOtf(const OtfStudyOptions& options) {
    if (options.onPhantoms == !options.volume.path.empty())
        return fail(FailureKind::wrongUsage, "", "", "either a VOLUME or --phantoms is needed");
    // This comes before the long work, so that a folder that cannot be is said at once.
    const auto folder = StudyFolder::at(options.folder, namesOfFiles());
    if (!folder) return tl::unexpected<Failure>(folder.error());
    auto study = options.onPhantoms ? studyPhantoms(options) : studyVolume(options, folder->paths());
    if (!study) return tl::unexpected<Failure>(study.error());
    markFront(study->variants);
    return writeStudy(*folder, *study);
}

}  // namespace

void addStudyOtfCommand(CLI::App& study, Action& action) {
    auto options = std::make_shared<OtfStudyOptions>();
    CLI::App& command = *study.add_subcommand("otf", "Error against run time of the adaptive OTF");
    options->volume.addTo(command);
    command.get_option("VOLUME")->required(false);
    options->view.addTo(command);
    command.add_flag("--phantoms", options->onPhantoms, "On simulated scans with known surfaces instead of a VOLUME");
    options->phantoms.seeds = "1";
    options->phantoms.addTo(command);
    command.add_option("--repeats", options->repeats, "Runs of each setting; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("-o,--output", options->folder, "Folder for the page, the tables and the plots")
        ->required()
        ->type_name("DIR");
    command.footer("Example: echolucent-cli study otf --phantoms -o study");
    command.callback([options, &action] { action = [options] { return studyOtf(*options); }; });
}

}  // namespace echolucent::cli
