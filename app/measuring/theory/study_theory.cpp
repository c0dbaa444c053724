// `study theory`: section 4 of the paper as numbers, beside pictures of volumes of two intensities.
#include "app/measuring/theory/study_theory.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>

#include "app/cli/options/option_text.h"
#include "app/measuring/study.h"
#include "processing/theory/theory_plots.h"

namespace echolucent::cli {

namespace {

std::vector<CsvCell> cellsOf(const TwoIntensities& model) {
    return {model.tissue, model.fluid, model.fluidUnits, model.tissueUnits};
}

class TheoryStudy final : public StudyCommand {
public:
    TheoryStudy()
        : StudyCommand({"theory", "Section 4 of the paper as numbers, beside pictures of volumes of two intensities",
                        "theory -o theory"}) {}

private:
    void addOptions(CLI::App& command) override {
        addFolder(command, "Folder for the page and the tables");
        const auto level = [&command](const char* name, double& value, const char* meaning) {
            command.add_option(name, value, meaning)->check(CLI::Range(0.0, 255.0))->capture_default_str();
        };
        level("--tissue", m_tissue, "c1: the tissue's intensity, 0 to 255");
        level("--fluid", m_fluid, "c2: the fluid's intensity, 0 to 255");
        addCount(command, "--fluid-units", m_fluidUnits, 0, most, "Thickness of the fluid");
        addCount(command, "--tissue-units", m_tissueUnits, 1, most, "Thickness of the tissue");
        command.add_option("--scale", m_scale, "a, a factor on all opacities")
            ->check(CLI::Range(0.0, TheorySetting::largestScale))
            ->capture_default_str();
        addCount(command, "--edge", m_edge, 8, 512, "Voxels across the field with speckle");
        addCount(command, "--seed", m_seed, 0, 1'000'000, "Of the speckle");
    }
    std::vector<std::string> files() const override {
        return {"theory.html", "theory-courses.csv", "theory-pictures.csv"};
    }

    [[nodiscard]] TheorySetting setting() const {
        TheorySetting setting;
        setting.model = {m_tissue / 255.0, m_fluid / 255.0, m_fluidUnits, m_tissueUnits, 0.0};
        setting.scale = m_scale;
        return setting;
    }

    Result<void> check() override {
        if (!(m_tissue > 0.0)) return wrongUsage("--tissue", "must be above 0", "c2 / c1 runs over it.");
        if (const std::string problem = problemOf(setting()); !problem.empty())
            return wrongUsage("study theory", "cannot run: " + problem);
        return {};
    }

    Result<StudyFindings> measure() override {
        const TheoryMeasure wanted{setting(), m_edge, static_cast<std::uint64_t>(m_seed)};
        const TheoryFindings found = measureTheory(wanted);
        return StudyFindings{{{"theory.html", theoryPage(found)},
                              {"theory-courses.csv", theoryCoursesCsv(wanted.setting)},
                              {"theory-pictures.csv", theoryPicturesCsv(found)}},
                             theorySummary(found)};
    }

    static constexpr int most = 2000;  // units
    double m_tissue = 85.0, m_fluid = 14.0, m_scale = 1.0;
    int m_fluidUnits = 30, m_tissueUnits = 40, m_edge = 64, m_seed = 1;
};

}  // namespace

std::string theoryCoursesCsv(const TheorySetting& setting) {
    CsvTable csv({"scaling", "axis", "place", "curve", "opacity_at_fluid", "opacity_at_tissue", "fluid_pixel",
                  "tissue_pixel", "difference", "michelson", "weber"});
    for (const OpacityScaling scaling : {OpacityScaling::sameScale, OpacityScaling::sameAtTissue})
        for (const CourseAxis axis : allCourseAxes) {
            TheorySetting scaled = setting;
            scaled.scaling = scaling;
            const ContrastCourse course = courseOf(scaled, axis);
            for (std::size_t i = 0; i < course.places.size(); ++i)
                for (const CurveContrast& one : course.contrasts[i])
                    csv.row({nameOf(scaling), nameOf(axis), course.places[i], one.name, one.atFluid, one.atTissue,
                             one.pixels.fluid, one.pixels.tissue, contrastOf(one.pixels, ContrastKind::difference),
                             contrastOf(one.pixels, ContrastKind::michelson),
                             contrastOf(one.pixels, ContrastKind::weber)});
        }
    return csv.text();
}

std::string theoryPicturesCsv(const TheoryFindings& found) {
    CsvTable csv({"curve", "scaling", "tissue", "fluid", "fluid_units", "tissue_units", "speckle", "speckle_size",
                  "theory_fluid", "theory_tissue", "speckled_theory_fluid", "speckled_theory_tissue", "fluid_mean",
                  "fluid_spread", "tissue_mean", "tissue_spread", "largest_error", "difference",
                  "difference_to_noise"});
    for (const auto* rows : {&found.plain, &found.speckled})
        for (const TheoryRow& row : *rows) {
            std::vector<CsvCell> cells{row.curve, nameOf(row.scaling)};
            for (CsvCell& cell : cellsOf(row.model)) cells.push_back(std::move(cell));
            const auto mean = [&](double ModelPixels::*pixel) {
                return row.mean ? std::optional((*row.mean).*pixel) : std::nullopt;
            };
            for (CsvCell cell :
                 std::vector<CsvCell>{row.speckle, row.speckleSize, row.theory.fluid, row.theory.tissue,
                                      mean(&ModelPixels::fluid), mean(&ModelPixels::tissue), row.picture.fluid.mean,
                                      row.picture.fluid.spread, row.picture.tissue.mean, row.picture.tissue.spread,
                                      row.largestError(), row.difference(), row.toNoise()})
                cells.push_back(std::move(cell));
            csv.row(cells);
        }
    return csv.text();
}

std::shared_ptr<StudyCommand> theoryStudy() { return std::make_shared<TheoryStudy>(); }

}  // namespace echolucent::cli
