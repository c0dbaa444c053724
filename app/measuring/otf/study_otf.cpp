// `study otf`: error against run time of the adaptive OTF, and the readings of the method side by side.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/options/option_text.h"
#include "app/measuring/otf/study_otf.h"
#include "app/measuring/study.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent::cli {

namespace {

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

/// The settings' errors are measured in these conditions, the readings in all. Run times are measured in "base" alone,
/// because they hardly depend on the voxels' values.
bool isForErrors(const std::string& condition) {
    return condition == "base" || condition == "attenuation_shadow" || condition == "hard_full_speckle" ||
           condition == "hard_ramp8" || condition == "front_wall";
}

/// Adds CNR_S of the fixed curves and of the new readings, if the condition is one of the six.
void addContrast(const StudyPhantom& phantom, const std::string& condition, std::span<ReadingResult> readings,
                 OtfStudy& study) {
    bool isOne = false;
    for (const NamedPhantom& one : contrastConditions(phantom.config)) isOne = isOne || one.name == condition;
    if (!isOne) return;
    std::vector<Classification> curves{parabolaCurve(), linearCurve()};
    for (const ReadingResult& reading : readings) curves.emplace_back(OpacityCurve(reading.curve));
    const auto rays = trueSurfaces(phantom.volume.geometry(), phantom.truth, Viewpoint{}, InterfaceInto::object);
    const auto measures = *measuresOf(phantom.volume, Viewpoint{}, rays, curves);
    study.fixed.push_back({condition, phantom.config.seed, measures[0].contrast.contrastToNoise(),
                           measures[1].contrast.contrastToNoise()});
    for (std::size_t i = 0; i < readings.size(); ++i) readings[i].contrast = measures[i + 2].contrast.contrastToNoise();
}

void measurePhantom(const GroupedPhantom& grouped, int repeats, OtfStudy& study) {
    const StudyPhantom phantom(grouped.phantom.config);
    const std::string& condition = grouped.phantom.name;
    for (const Viewpoint& view : {Viewpoint{}, obliqueView}) {
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

std::string paretoFile(const std::string& function) { return "otf-pareto-" + function + ".svg"; }

class OtfStudyCommand final : public StudyCommand {
public:
    OtfStudyCommand() : StudyCommand({"otf", "Error against run time of the adaptive OTF", "otf --phantoms -o study"}) {
        phantoms.seeds = "1";
    }

private:
    void addOptions(CLI::App& command) override {
        addVolume(command);
        view.addTo(command);
        command.add_flag("--phantoms", m_onPhantoms, "On simulated scans with known surfaces instead of a VOLUME");
        phantoms.addTo(command);
        addCount(command, "--repeats", m_repeats, 1, 1000, "Runs of each setting; the median counts");
        addFolder(command, "Folder for the page, the tables and the plots");
    }

    std::vector<std::string> files() const override {
        std::vector<std::string> names{"otf-settings.csv", "otf-readings.csv", "otf.html"};
        for (const std::string& function : interfaceFunctions) names.push_back(paretoFile(function));
        return names;
    }

    Result<void> check() override {
        if (m_onPhantoms == !volume.path.empty())
            return fail(FailureKind::wrongUsage, "", "", "either a VOLUME or --phantoms is needed");
        return {};
    }

    void measurePhantoms(OtfStudy& study) const {
        study.truthKnown = true;
        const auto& size = bases.front().size;
        study.subject = fmt::format(
            "Simulated scans with known surfaces (scene shapes, {}x{}x{} voxels, seeds {}), along the beam and "
            "obliquely.",
            size[0], size[1], size[2], phantoms.seeds);
        for (const PhantomConfig& base : bases)
            for (const GroupedPhantom& grouped : allConditions(base)) measurePhantom(grouped, m_repeats, study);
    }

    Result<void> measureVolume(OtfStudy& study) const {
        const auto read = readVolume();
        if (!read) return tl::unexpected<Failure>(read.error());
        const auto from = viewOf(**read);
        if (!from) return tl::unexpected<Failure>(from.error());
        const auto& size = (*read)->geometry().size;
        study.subject = fmt::format(
            "{} ({}x{}x{} voxels), beam axis {}, azimuth {}°, elevation {}°, front {} mm. Its true surfaces "
            "are not known: there is no detection error, only the curve's.",
            volume.path, size[0], size[1], size[2], nameOf(from->beamAxis), from->azimuthDegrees,
            from->elevationDegrees, frontDepthMm(*from));
        const OtfCase one{volume.path, read->get(), *from, nullptr};
        for (const MethodReading reading : allReadings) study.readings.push_back(measureReading(one, reading));
        measureErrors(one, study.variants);
        measureTimes(one, m_repeats, study.variants);
        return {};
    }

    Result<StudyFindings> measure() override {
        OtfStudy study;
        study.repeats = m_repeats;
        if (m_onPhantoms)
            measurePhantoms(study);
        else if (auto measured = measureVolume(study); !measured)
            return tl::unexpected<Failure>(measured.error());
        markFront(study.variants);
        StudyFindings found{{{"otf-settings.csv", variantsCsv(study)},
                             {"otf-readings.csv", readingsCsv(study)},
                             {"otf.html", otfPage(study)}},
                            summaryText(study) + "\n" + pathOf("otf.html") + "\n"};
        for (const std::string& function : interfaceFunctions)
            found.files.emplace_back(paretoFile(function), svgOf(paretoPlot(study, function, false)));
        return found;
    }

    bool m_onPhantoms = false;
    int m_repeats = 9;
};

}  // namespace

std::shared_ptr<StudyCommand> otfStudy() { return std::make_shared<OtfStudyCommand>(); }

}  // namespace echolucent::cli
