// `study cut`: the answers of the search for the near cut, volume by volume, axis by axis.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>

#include "app/measuring/study.h"
#include "io/output/atomic_file.h"
#include "processing/near_cut/near_cut.h"

namespace echolucent::cli {

namespace {

constexpr BeamAxis allAxes[] = {BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                                BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};

/// How far a cut lies behind the plane across the view through the volume's centre, mm.
double behindTheMiddle(const Viewpoint& view, const VolumeGeometry& geometry, double nearCutMm) {
    Viewpoint cut = view;
    cut = withFrontAcross(cut, nearCutMm);
    return nearPlaneDepthMm(cut, geometry) - frameOf(view).forward.dot(geometry.centreMm());
}

/// The largest move of the cut while the view turns to four sides, mm. "-" if the answer changes; empty if the answer
/// is no wall before fluid.
std::string moved(const Volume& volume, const Viewpoint& view, const NearCutFinding& found, double turn) {
    const double before = behindTheMiddle(view, volume.geometry(), found.nearCutMm);
    double most = 0.0;
    for (const auto& [azimuth, elevation] : {std::pair{turn, 0.0}, {-turn, 0.0}, {0.0, turn}, {0.0, -turn}}) {
        Viewpoint turned = view;
        turned.azimuthDegrees = azimuth;
        turned.elevationDegrees = elevation;
        const auto answer = findNearCut(volume, turned);
        if (answer->answer != found.answer) return "-";
        most = std::max(most, std::abs(behindTheMiddle(turned, volume.geometry(), answer->nearCutMm) - before));
    }
    return found.answer == NearCutAnswer::wallBeforeFluid ? fmt::format("{:.1f}", most) : "";
}

std::string rowOf(const Volume& volume, BeamAxis axis, double turn) {
    const Viewpoint view{.beamAxis = axis};
    const auto found = findNearCut(volume, view);
    const bool wall = found->answer == NearCutAnswer::wallBeforeFluid;
    return fmt::format("{:<5}{:<19}{:>8}{:>12}{:>8.0f} %{:>13}{:>12}{:>7.2f}{:>6}{:>9}\n", nameOf(axis),
                       nameOf(found->answer), wall ? fmt::format("{:.2f}", found->nearCutMm) : "",
                       wall ? fmt::format("{:.2f}", found->behindDataMm) : "",
                       100.0 * found->nearCutMm / depthAlongViewMm(view, volume.geometry()),
                       fmt::format("{}/{}", found->tubesThatSaySo, found->tubes),
                       found->surface ? fmt::format("{}", found->tubesInFluidBehindSurface) : "", found->confidence,
                       found->sure ? "yes" : "no", moved(volume, view, *found, turn));
}

class CutStudy final : public StudyCommand {
public:
    CutStudy()
        : StudyCommand(
              {"cut", "What the search for the near cut answers along all six axes", "cut chest.mha heart.nrrd"}) {}

private:
    void addOptions(CLI::App& command) override {
        command.add_option("VOLUME", m_paths, "Files to read (of 4D, the first phase)")->required();
        command.add_option("--turn", m_turn, "Degrees by which the view is turned to four sides")
            ->type_name("DEG")
            ->check(CLI::Range(0.0, 45.0))
            ->capture_default_str();
    }

    Result<StudyFindings> measure() override {
        for (const std::string& path : m_paths) {
            volume.path = path;
            const auto read = readVolume();
            if (!read) return tl::unexpected<Failure>(read.error());
            std::string text = fmt::format("{}\n{:<5}{:<19}{:>8}{:>12}{:>10}{:>13}{:>12}{:>7}{:>6}{:>9}\n", path,
                                           "axis", "answer", "near mm", "behind data", "of depth", "tube cores",
                                           "curved cut", "conf.", "sure", "moves mm");
            for (const BeamAxis axis : allAxes) text += rowOf(**read, axis, m_turn);
            if (auto written = writeFileAtomically("-", text); !written)
                return tl::unexpected<Failure>(written.error());
        }
        return StudyFindings{};
    }

    std::vector<std::string> m_paths;
    double m_turn = 8.0;
};

}  // namespace

std::shared_ptr<StudyCommand> cutStudy() { return std::make_shared<CutStudy>(); }

}  // namespace echolucent::cli
