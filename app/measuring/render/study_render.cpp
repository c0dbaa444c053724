// `study render`: error against run time of the ray caster.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/options/option_text.h"
#include "app/measuring/render/study_render.h"
#include "app/measuring/study.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

constexpr int usualRepeats = 9, quickRepeats = 3;

class RenderStudyCommand final : public StudyCommand {
public:
    RenderStudyCommand()
        : StudyCommand({"render", "Error of the ray caster's pictures against their run time",
                        "render heart.nrrd --beam-axis +y --near 110 -o render"}) {
        view.view = obliqueView;
    }

private:
    void addOptions(CLI::App& command) override {
        addVolume(command);
        addFolder(command, "Folder for render.html, its plot and the table");
        addOtf(command);
        command.add_option("--size", m_size, "Pixels [512x512; 160x160 with --quick]")->type_name("WxH");
        command.add_flag("--shade", m_shade, "Gradient shading: light from the upper left in front");
        command.add_option("--repeats", m_repeats, "Runs of each setting; the median counts [9; 3 with --quick]")
            ->check(CLI::Range(1, 1000));
        command
            .add_option("--phantom-size", m_phantomSize,
                        "Voxels along each edge of the simulated fetus, which stands where no VOLUME is given "
                        "[199x197x199]")
            ->check(CLI::Range(16, 512));
        command.add_flag("--quick", m_quick, "Small pictures and few runs: for a look, not for figures");
        view.addTo(command);
        method.addTo(command);
    }
    std::vector<std::string> files() const override { return {"render.csv", "render-pareto.svg", "render.html"}; }

    Result<void> check() override {
        constexpr int leastEdge = 16, largestEdge = 2048;  // pixels
        const std::string text = !m_size.empty() ? m_size : m_quick ? "160x160" : "512x512";
        const auto size = parseWholePair(text, leastEdge, largestEdge, "--size", "512x512");
        if (!size) return tl::unexpected<Failure>(size.error());
        m_reference.width = (*size)[0];
        m_reference.height = (*size)[1];
        if (m_shade) m_reference.shading = Shading{};
        return {};
    }

    std::string subjectOf(const Volume& rendered, const Viewpoint& from) const {
        const auto& size = rendered.geometry().size;
        return fmt::format(
            "{} ({}x{}x{} voxels, {}), beam axis {}, azimuth {:g}°, elevation {:g}°, front {:g} mm, parallel "
            "projection, opacity curve {}{}, {}. Pictures of {}x{} pixels.",
            volume.path.empty() ? "The simulated fetus" : volume.path, size[0], size[1], size[2], rendered.typeName(),
            nameOf(from.beamAxis), from.azimuthDegrees, from.elevationDegrees, frontDepthMm(from), otf,
            method.opacityScale ? fmt::format(" of scale {:g}", *method.opacityScale) : "",
            m_shade ? "shaded" : "unshaded", m_reference.width, m_reference.height);
    }

    Result<std::shared_ptr<const Volume>> rendered() const {
        if (!volume.path.empty()) return readVolume();
        return std::make_shared<const Volume>(*makePhantom(scaledPhantom(PhantomScene::fetus, m_phantomSize)));
    }

    Result<StudyFindings> measure() override {
        const auto shown = rendered();
        if (!shown) return tl::unexpected<Failure>(shown.error());
        const auto from = viewOf(**shown);
        if (!from) return tl::unexpected<Failure>(from.error());
        RenderCase one{*shown, curveFor(**shown, *from), m_reference};
        one.reference.camera =
            defaultCamera(one.volume->dataBox(), *from, static_cast<double>(m_reference.width) / m_reference.height);
        if (from->frontPlane) one.reference.front = cuttingFaceOf(*from->frontPlane, one.volume->geometry());
        RenderStudy study = measureRendering(one, m_repeats.value_or(m_quick ? quickRepeats : usualRepeats));
        study.subject = subjectOf(*one.volume, *from);
        return StudyFindings{{{"render.csv", renderCsv(study)},
                              {"render-pareto.svg", svgOf(frontPlot(study))},
                              {"render.html", renderPage(study, one)}},
                             summaryText(study)};
    }

    RayCastSettings m_reference;
    std::string m_size;
    int m_phantomSize = 0;  ///< 0: the usual size
    std::optional<int> m_repeats;
    bool m_shade = false, m_quick = false;
};

}  // namespace

std::shared_ptr<StudyCommand> renderStudy() { return std::make_shared<RenderStudyCommand>(); }

}  // namespace echolucent::cli
