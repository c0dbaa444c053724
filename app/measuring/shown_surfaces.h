// What OTFs make of the surfaces of a scan: of the true ones, if they are known, and of those that tube cores find.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/measuring/study_output.h"
#include "processing/comparison/classification_measures.h"
#include "processing/comparison/shown_depth.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

/// What one OTF makes of the surfaces of a scan.
struct ShownSurfaces {
    /// By the truth of a simulated scan: each ray whose first interface leads from fluid into something.
    struct ByTruth {
        ShownDepth objects;              ///< rays into an object
        ShownDepth walls;                ///< rays into tissue
        std::optional<double> contrast;  ///< CNR_S of the objects
        [[nodiscard]] ShownDepth all() const;
    };
    std::optional<ByTruth> truth;      ///< no value if nobody knows the truth
    ClassificationMeasures tubeCores;  ///< with foundSurfaces()
};
/// One a classification, in order. `raw` holds the voxels as they were read, `shown` those of the picture. `truth` is
/// null if nobody knows it.
[[nodiscard]] std::vector<ShownSurfaces> shownSurfacesOf(const Volume& raw, const Volume& shown, const Viewpoint& view,
                                                         const PhantomTruth* truth,
                                                         std::span<const Classification> classifications);

/// The surfaces that a share is taken of.
enum class SurfaceKind { objects, walls, all, tubeCores };
inline constexpr std::array allSurfaceKinds{SurfaceKind::objects, SurfaceKind::walls, SurfaceKind::all,
                                            SurfaceKind::tubeCores};
/// "objects", "walls", "all", "tube_cores".
[[nodiscard]] std::string nameOf(SurfaceKind kind);
/// "right", "early", "late", "never".
[[nodiscard]] std::string nameOf(ShownSurface shown);
/// The share of the surfaces of a kind, percent; no value if there is no such surface, or no truth.
[[nodiscard]] std::optional<double> percentOf(const ShownSurfaces& one, SurfaceKind kind, ShownSurface shown);

/// The names of the columns of a CSV: right_objects_percent and so on, by kind, each in the order of allShownSurfaces.
[[nodiscard]] std::vector<std::string> shownSurfaceColumns();
/// The cells under these.
[[nodiscard]] std::vector<CsvCell> shownSurfaceCells(const ShownSurfaces& one);

/// One OTF on one scan, under the OTF's name.
struct NamedSurfaces {
    std::string name, condition;
    ShownSurfaces surfaces;
};
/// The mean over the scans of a name in one condition, percent; without a condition, the mean of the conditions' means.
/// No value if no scan has one.
[[nodiscard]] std::optional<double> meanPercent(const std::vector<NamedSurfaces>& rows, const std::string& name,
                                                const std::string& condition, SurfaceKind kind, ShownSurface shown);
[[nodiscard]] std::optional<double> meanPercent(const std::vector<NamedSurfaces>& rows, const std::string& name,
                                                SurfaceKind kind, ShownSurface shown);
[[nodiscard]] std::vector<std::string> conditionsOf(const std::vector<NamedSurfaces>& rows);
/// One row a name, in the order in which they first occur: the means over its scans, percent, of all kinds that are
/// known.
[[nodiscard]] TextTable shownSurfaceTable(const std::vector<NamedSurfaces>& rows);
/// The percentage of all surfaces that is right, by name and condition, with the mean over the conditions: by the
/// truth (SurfaceKind::all) or by tube cores.
[[nodiscard]] TextTable rightTable(const std::vector<NamedSurfaces>& rows, SurfaceKind kind);
/// A sentence on how far the truth and the tube cores put the names in the same order: the rank correlation of the
/// means over scans of what is right. Empty if there is none.
[[nodiscard]] std::string rankSentence(const std::vector<NamedSurfaces>& rows);

}  // namespace echolucent::cli
