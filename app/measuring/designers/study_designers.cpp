// `study designers`: all OTF designers on simulated scans with known truth, or on a volume.
#include "app/measuring/designers/study_designers.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "app/cli/options/look_options.h"
#include "app/cli/report/opening_report.h"
#include "app/measuring/study.h"
#include "processing/picture/view_limits.h"

namespace echolucent::cli {

namespace {

/// A folder's own name may be a patient's, so it is left out.
std::string nameOfFile(const std::string& path) {
    std::error_code unreadable;
    return std::filesystem::is_directory(path, unreadable) ? "a folder" : withoutFolders(path);
}

class DesignersStudyCommand final : public StudyCommand {
public:
    DesignersStudyCommand()
        : StudyCommand({"designers", "All OTF designers side by side: pictures, shown depth, contrast, time",
                        "designers -o designers"}) {}

private:
    void addOptions(CLI::App& command) override {
        addVolume(command);
        addFolder(command, "Folder for designers.html and designers.csv");
        phantoms.addTo(command);
        addCount(command, "--repeats", m_repeats, 1, 1000,
                 "Timed runs of each designer and picture; the median counts");
        addCount(command, "--picture-size", m_pictureSize, 16, 1024, "Pixels along each edge of the pictures");
        view.addTo(command);
        method.addTo(command);
        m_lookOptions.addTo(command, {"reduction", "lighting"});
    }
    std::vector<std::string> files() const override { return {"designers.csv", "designers.html"}; }

    Result<void> check() override {
        const auto look = m_lookOptions.get();
        if (!look) return tl::unexpected<Failure>(look.error());
        m_look = *look;
        return {};
    }

    DesignerCase caseOf(std::string name, std::shared_ptr<const Volume> raw, const Viewpoint& from) const {
        DesignerCase one{.name = std::move(name), .raw = std::move(raw), .reduction = m_look.reduction, .view = from};
        one.method = config;
        one.shown = std::make_shared<const Volume>(*quietVolume(*one.raw, m_look.reduction));
        one.settings = rayCastSettings(m_look);
        one.settings.width = one.settings.height = m_pictureSize;
        one.settings.camera = defaultCamera(one.raw->dataBox(), from, 1.0);
        one.settings = limitedTo(from, one.raw->geometry(), one.settings);
        return one;
    }

    Result<std::vector<DesignerCase>> cases() const {
        if (!volume.path.empty()) {
            const auto read = readVolume();
            if (!read) return tl::unexpected<Failure>(read.error());
            const auto from = viewOf(**read);
            if (!from) return tl::unexpected<Failure>(from.error());
            return std::vector{caseOf(nameOfFile(volume.path), *read, *from)};
        }
        const auto from = view.getOfSimulatedScan();
        if (!from) return tl::unexpected<Failure>(from.error());
        std::vector<DesignerCase> all;
        for (const PhantomScene scene : {PhantomScene::fetus, PhantomScene::shapes}) {
            PhantomConfig scan = defaultPhantom(scene);
            scan.size = bases.front().size;
            scan.seed = bases.front().seed;
            all.push_back(caseOf("simulated " + std::string(nameOf(scene)),
                                 std::make_shared<const Volume>(*makePhantom(scan)), *from));
            all.back().truth.emplace(scan);
        }
        return all;
    }

    Result<StudyFindings> measure() override {
        const auto shown = cases();
        if (!shown) return tl::unexpected<Failure>(shown.error());
        DesignersStudy study{.seeds = phantoms.seeds, .reduction = m_look.reduction, .repeats = m_repeats};
        if (volume.path.empty())
            for (const PhantomConfig& base : bases)
                for (DesignerRow& row :
                     measureDesigners(base, {shown->front().view, config, m_look.reduction, m_repeats}))
                    study.rows.push_back(std::move(row));
        for (const DesignerCase& one : *shown) study.shown.push_back({one.name, showDesigners(one, m_repeats)});
        return StudyFindings{{{"designers.csv", designersCsv(study)}, {"designers.html", designersPage(study)}},
                             designersSummary(study)};
    }

    LookOptions m_lookOptions;
    Look m_look;
    int m_repeats = 3, m_pictureSize = 240;
};

}  // namespace

std::shared_ptr<StudyCommand> designersStudy() { return std::make_shared<DesignersStudyCommand>(); }

}  // namespace echolucent::cli
