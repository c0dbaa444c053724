#include "app/cli/report/phantom_report.h"

#include <nlohmann/json.hpp>

#include "app/cli/report/report_json.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent::cli {

namespace {

VolumeGeometry geometryOf(const PhantomConfig& config) {
    VolumeGeometry geometry;
    geometry.size = config.size;
    geometry.spacing = config.spacing;
    return geometry;
}

Json configJson(const PhantomConfig& config) {
    return {{"scene", nameOf(config.scene)},
            {"size", config.size},
            {"spacing_mm", vectorJson(config.spacing)},
            {"fluid", config.fluid},
            {"tissue", config.tissue},
            {"object", config.object},
            {"ramp_units", config.ramp},
            {"gain_variation", config.gainVariation},
            {"speckle", config.speckle},
            {"speckle_size_voxels", config.speckleSize},
            {"attenuation_per_unit", config.attenuation},
            {"shadow_per_unit", config.shadow},
            {"specular", config.specular},
            {"log_compress_db", config.logCompressDecibel},
            {"front_wall", config.frontWall},
            {"bits", config.bits},
            {"seed", config.seed}};
}

Json primitivesJson(const PhantomTruth& truth) {
    Json all = Json::array();
    for (const PhantomPrimitive& primitive : truth.primitives())
        all.push_back({{"name", primitive.name},
                       {"kind", primitive.kind},
                       {"material", primitive.material},
                       {"carves", primitive.carves},
                       {"seam_mm", primitive.seamMm},
                       {"echo", primitive.echo},
                       {"parameters_mm", primitive.parameters}});
    return all;
}

/// The truth along one tube core. Depths are in units from the place where the picture begins on the tube core's axis.
/// They are null if no surface is met, or if the axis misses the volume.
Json tubeJson(const PhantomTruth& truth, const VolumeGeometry& geometry, const Viewpoint& view, const TubeAxis& axis,
              int cellSize) {
    Json tube{{"u", axis.column},         {"v", axis.row},
              {"entry_voxel", nullptr},   {"depth_units", nullptr},
              {"surface_voxel", nullptr}, {"corner_depths_units", Json::array({nullptr, nullptr, nullptr, nullptr})}};
    if (!axis.entryVoxel) return tube;
    tube["entry_voxel"] = vectorJson(*axis.entryVoxel);
    const Vec3 entry = geometry.gridMmFromVoxel(*axis.entryVoxel);
    const double nearPlane = nearPlaneDepthMm(view, geometry);
    const auto depthOf = [&](const Vec3& surface) { return axis.directionMm.dot(surface - entry) / geometry.unit(); };
    if (const auto surface = truth.firstInterfacePoint(entry, axis.directionMm, nearPlane)) {
        tube["depth_units"] = depthOf(*surface);
        tube["surface_voxel"] = vectorJson(geometry.voxelFromGridMm(*surface));
    }
    const ViewFrame frame = frameOf(view);
    const double half = 0.5 * (cellSize - 1) * geometry.unit();
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const Vec3 origin =
            entry + frame.right * (corner & 1 ? half : -half) + frame.down * (corner & 2 ? half : -half);
        if (const auto surface = truth.firstInterfacePoint(origin, axis.directionMm, nearPlane))
            tube["corner_depths_units"][corner] = depthOf(*surface);
    }
    return tube;
}

Json tubesJson(const PhantomTruth& truth, const PhantomConfig& config, const Viewpoint& view, const TubeGrid& tubes,
               int cellSize) {
    const VolumeGeometry geometry = geometryOf(config);
    Json all = Json::array();
    for (const TubeAxis& axis : tubeAxes(geometry, view, tubes, cellSize))
        all.push_back(tubeJson(truth, geometry, view, axis, cellSize));
    return all;
}

}  // namespace

std::string truthReport(const std::vector<PhantomConfig>& phases, const Viewpoint& view, const TubeGrid& tubes,
                        int cellSize) {
    const PhantomConfig& first = phases.front();
    Json report;
    report["config"] = configJson(first);
    report["view"] = {{"beam_axis", nameOf(view.beamAxis)},
                      {"azimuth_degrees", view.azimuthDegrees},
                      {"elevation_degrees", view.elevationDegrees},
                      {"near_mm", frontDepthMm(view)},
                      {"direction_mm", vectorJson(frameOf(view).forward)}};
    const auto spacing = tubeSpacingUnits(geometryOf(first), view, tubes, cellSize);
    report["tube_grid"] = {
        {"columns", tubes.columns}, {"rows", tubes.rows}, {"spacing_units", spacing}, {"cell_size_units", cellSize}};
    const auto add = [&](Json& to, const PhantomConfig& config) {
        const PhantomTruth truth(config);
        to["primitives"] = primitivesJson(truth);
        to["tubes"] = tubesJson(truth, config, view, tubes, cellSize);
    };
    add(report, first);
    if (phases.size() > 1)
        for (const PhantomConfig& config : phases) {
            Json phase{{"phase", config.phase}};
            add(phase, config);
            report["phases"].push_back(std::move(phase));
        }
    return report.dump(1) + "\n";
}

}  // namespace echolucent::cli
