// `study light`: error of the light volume against its run time.
#include "app/measuring/light/study_light.h"

#include <CLI/CLI.hpp>

#include <array>

#include "app/cli/options/option_text.h"
#include "app/measuring/study.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

class LightStudyCommand final : public StudyCommand {
public:
    LightStudyCommand()
        : StudyCommand({"light", "Error of the light that reaches against its run time", "light -o light"}) {
        view.view = obliqueView;
    }

private:
    void addOptions(CLI::App& command) override {
        addVolume(command);
        addFolder(command, "Folder for light.html and light.csv");
        addOtf(command);
        command.add_option("--size", m_size, "Pixels")->type_name("WxH")->capture_default_str();
        addCount(command, "--repeats", m_repeats, 1, 1000, "Timed runs of each light volume; the median counts");
        addCount(command, "--rings", m_rings, 1, 16,
                 "The reference marches along 3 RINGS^2 directions to each of both lights");
        addCount(command, "--phantom-size", m_phantomSize, 16, 512,
                 "Voxels along each edge of the simulated scans, which stand where no VOLUME is given");
        view.addTo(command);
        method.addTo(command);
    }
    std::vector<std::string> files() const override { return {"light.csv", "light.html"}; }

    Result<void> check() override {
        constexpr int leastEdge = 16, largestEdge = 1024;  // pixels
        const auto pixels = parseWholePair(m_size, leastEdge, largestEdge, "--size", "128x128");
        if (!pixels) return tl::unexpected<Failure>(pixels.error());
        m_pixels = *pixels;
        return {};
    }

    Result<LightCase> caseOf(const std::string& name, std::shared_ptr<const Volume> lit) const {
        const auto from = viewOf(*lit);
        if (!from) return tl::unexpected<Failure>(from.error());
        LightCase one{name, std::move(lit), PowerCurve{}, {}};
        one.curve = curveFor(*one.volume, *from);
        const VolumeGeometry& geometry = one.volume->geometry();
        one.settings.width = m_pixels[0];
        one.settings.height = m_pixels[1];
        one.settings.camera = defaultCamera(geometry, *from, static_cast<double>(m_pixels[0]) / m_pixels[1]);
        if (from->frontPlane) one.settings.front = cuttingFaceOf(*from->frontPlane, geometry);
        one.settings.shading = Shading{};
        one.settings.shading->ambient = ambientWithReachingLight;
        one.settings.shading->diffuse = diffuseWithReachingLight;
        one.settings.shading->reaching = ReachingLight{};
        return one;
    }

    Result<StudyFindings> measure() override {
        std::vector<Result<LightCase>> cases;
        if (!volume.path.empty()) {
            const auto read = readVolume();
            if (!read) return tl::unexpected<Failure>(read.error());
            cases.push_back(caseOf(volume.path, *read));
        } else {
            for (const PhantomScene scene : {PhantomScene::fetus, PhantomScene::shapes})
                cases.push_back(
                    caseOf("simulated " + std::string(nameOf(scene)),
                           std::make_shared<const Volume>(*makePhantom(scaledPhantom(scene, m_phantomSize)))));
        }
        std::vector<LightStudy> studies;
        for (const auto& one : cases) {
            if (!one) return tl::unexpected<Failure>(one.error());
            studies.push_back(measureLight(*one, m_repeats, m_rings));
        }
        return StudyFindings{{{"light.csv", lightCsv(studies)}, {"light.html", lightPage(studies, m_repeats, m_rings)}},
                             lightSummary(studies)};
    }

    std::string m_size = "128x128";
    std::array<int, 2> m_pixels{};
    int m_phantomSize = 100, m_repeats = 9, m_rings = 4;
};

}  // namespace

std::shared_ptr<StudyCommand> lightStudy() { return std::make_shared<LightStudyCommand>(); }

}  // namespace echolucent::cli
