// The parts of `study designers`: the measures of each OTF designer, and the page.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/measuring/measures/picture_difference.h"
#include "app/measuring/shown_surfaces.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/phantom/phantom_config.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"

namespace echolucent::cli {

/// A compared designer with its config, or the parabola x^2, which no designer makes.
struct ComparedDesigner {
    std::string name;                      ///< of the designer, "x2", or nameOfAim()
    std::optional<DesignerConfig> config;  ///< no value for "x2"
    std::optional<double> aim{};           ///< of the adaptive method, in place of its own; [0,1]
};
/// "aim 0.25": the adaptive method with this aim.
[[nodiscard]] std::string nameOfAim(double aim);
/// x^2 first, then all designers with their defaults, in the order of allDesigners. Each of `aims` follows the adaptive
/// one, if `method` has an aim.
[[nodiscard]] std::vector<ComparedDesigner> comparedDesigners(const AdaptiveOtfConfig& method,
                                                              std::span<const double> aims);
/// The aims that `study designers` measures beside the method's own: both ends.
inline constexpr std::array endsOfAim{0.0, 1.0};

/// A designer's result on one set of voxels, and its time.
struct DesignTimed {
    Design design;
    double milliseconds = 0.0;  ///< median of the runs, wall time; 0 for x^2
};
[[nodiscard]] DesignTimed timedDesign(const ComparedDesigner& designer, const DesignerInput& input, int repeats);

/// One designer on one simulated scan with known truth.
struct DesignerRow {
    std::string designer, condition;
    std::uint64_t seed = 0;
    ShownSurfaces surfaces{};
    double milliseconds = 0.0;  ///< median wall time of the designer
};
/// How scans are measured: the view of the tube cores, the method, and the reduction of the shown voxels.
struct DesignersSetting {
    Viewpoint view;
    AdaptiveOtfConfig method;
    SpeckleReduction reduction = SpeckleReduction::off;
    int repeats = 1;
};
/// All designers on the six conditions of a scan.
[[nodiscard]] std::vector<DesignerRow> measureDesigners(const PhantomConfig& base, const DesignersSetting& setting);

/// A volume to show with each designer's OTF.
struct DesignerCase {
    std::string name;
    std::shared_ptr<const Volume> raw{}, shown{};
    SpeckleReduction reduction = SpeckleReduction::off;
    Viewpoint view{};
    AdaptiveOtfConfig method{};
    RayCastSettings settings{};
    std::optional<PhantomTruth> truth{};  ///< no value if nobody knows it
};
/// The picture and the results of one designer on a case.
struct DesignerPicture {
    std::string designer;
    DesignTimed made;
    Picture picture;
    double castMilliseconds = 0.0;  ///< median of a picture that is cast anew, with light
    PictureError error;             ///< of the kernel's small lit picture, from the plain route's one
    ShownSurfaces surfaces{};
};
[[nodiscard]] std::vector<DesignerPicture> showDesigners(const DesignerCase& one, int repeats);

struct DesignersStudy {
    std::string seeds;
    SpeckleReduction reduction = SpeckleReduction::off;
    int repeats = 0;
    std::vector<DesignerRow> rows{};
    struct Shown {
        std::string name;
        std::vector<DesignerPicture> pictures;
    };
    std::vector<Shown> shown{};
};
/// For each OTF but the adaptive ones: what it shows of the surfaces beside the adaptive OTF, and in which conditions
/// it is worst. If the truth is known, these are the true surfaces, and the sentences say what makes the OTF so; else
/// they are the tube cores' ones. Names in `rows` are those of ComparedDesigner.
[[nodiscard]] std::vector<std::string> besideAdaptive(const std::vector<NamedSurfaces>& rows);
/// A ComparedDesigner's name for a person: "Otsu ramp", "x²", "Adaptive, aim 0".
[[nodiscard]] std::string labelOfCompared(const std::string& name);

[[nodiscard]] std::string designersCsv(const DesignersStudy& study);
[[nodiscard]] std::string designersPage(const DesignersStudy& study);
/// The tables of surfaces, contrasts and pictures, for a terminal.
[[nodiscard]] std::string designersSummary(const DesignersStudy& study);

}  // namespace echolucent::cli
