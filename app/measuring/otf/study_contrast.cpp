// `study contrast`: CNR_S of the fixed curves and of the readings, condition by condition.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/cli/options/look_options.h"
#include "app/measuring/study.h"
#include "io/output/atomic_file.h"

namespace echolucent::cli {

namespace {

using Values = std::vector<std::optional<double>>;

std::string line(const std::string& name, const Values& values) {
    std::string text = fmt::format("{:<22}", name);
    for (const auto& value : values) text += value ? fmt::format("{:>11.2f}", *value) : fmt::format("{:>11}", "-");
    return text + '\n';
}

/// The mean over the rows for every column.
Values columnMeans(const std::vector<Values>& rows) {
    Values means;
    for (std::size_t c = 0; c < rows.front().size(); ++c) {
        Values column;
        for (const Values& row : rows) column.push_back(row[c]);
        means.push_back(meanOf(column));
    }
    return means;
}

class ContrastStudy final : public StudyCommand {
public:
    ContrastStudy()
        : StudyCommand({"contrast", "How well the curves set known surfaces off from haze and leakage (CNR_S)",
                        "contrast --seeds 1-4"}) {}

private:
    void addOptions(CLI::App& command) override {
        phantoms.addTo(command);
        view.addTo(command, ViewOf::simulatedScan);
        m_look.addTo(command, {"reduction"});
        command.add_option("--csv", m_csv, "Also writes every value")->type_name("FILE");
    }

    Result<StudyFindings> measure() override {
        const auto from = view.getOfSimulatedScan();
        if (!from) return tl::unexpected<Failure>(from.error());
        const auto look = m_look.get();
        if (!look) return tl::unexpected<Failure>(look.error());
        const std::vector<std::string> names = contrastCurveNames();
        std::string text = fmt::format("CNR_S, mean of {} seed(s), speckle reduction {}\n{:<22}", bases.size(),
                                       nameOf(look->reduction), "condition");
        for (const std::string& name : names) text += fmt::format("{:>{}}", name, 11);
        text += '\n';
        CsvTable csv({"condition", "seed", "curve", "cnr_s"});
        std::vector<Values> conditions;
        const std::size_t count = contrastConditions(bases.front()).size();
        for (std::size_t c = 0; c < count; ++c) {
            std::vector<Values> seeds;
            std::string name;
            for (const PhantomConfig& base : bases) {
                const NamedPhantom phantom = contrastConditions(base)[c];
                name = phantom.name;
                seeds.push_back(contrastsOf(StudyPhantom(phantom.config), *from, look->reduction));
                for (std::size_t i = 0; i < names.size(); ++i) csv.row({name, base.seed, names[i], seeds.back()[i]});
            }
            conditions.push_back(columnMeans(seeds));
            text += line(name, conditions.back());
        }
        text += line("mean", columnMeans(conditions));
        if (!m_csv.empty())
            if (auto written = writeFileAtomically(m_csv, csv.text()); !written)
                return tl::unexpected<Failure>(written.error());
        return StudyFindings{{}, text};
    }

    LookOptions m_look;
    std::string m_csv;
};

}  // namespace

std::shared_ptr<StudyCommand> contrastStudy() { return std::make_shared<ContrastStudy>(); }

}  // namespace echolucent::cli
