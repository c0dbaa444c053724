#include "io/study/polar_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "io/files/input_file.h"
#include "processing/scan_conversion/scan_conversion.h"

namespace echolucent {

namespace {

constexpr double mebibyte = 1024.0 * 1024.0;

std::string axisText(const PolarAxis& axis) {
    if (axis.spread == PolarSpread::positions)
        return fmt::format("{:.6g} to {:.6g} mm, parallel", axis.values.front(), axis.values.back());
    constexpr double degrees = 180 / std::numbers::pi;
    return fmt::format("{:.6g} to {:.6g} degrees about an axis {:.6g} mm {} the probe's face",
                       degrees * axis.values.front(), degrees * axis.values.back(), std::abs(axis.radiusMm),
                       axis.radiusMm < 0 ? "before" : "behind");
}

void addAcquisitionFacts(const PolarGeometry& polar, const PolarSources& sources, std::vector<ImportFact>& facts) {
    const auto size = polar.size();
    const std::string assumed = sources.assumed.empty() ? "" : "; assumed: " + sources.assumed;
    facts.push_back(
        {"polar volume",
         fmt::format("{}: {} samples x {} lines x {} planes", nameOf(kindOf(polar)), size[0], size[1], size[2]),
         sources.size});
    facts.push_back({"range",
                     fmt::format("{:.6g} to {:.6g} mm from the probe's face, a sample every {:.6g} mm",
                                 polar.rangeStartMm, polar.rangeEndMm(), polar.rangeStepMm),
                     sources.range + assumed});
    facts.push_back({"lines", axisText(polar.lines), sources.lines + assumed});
    facts.push_back({"planes", axisText(polar.planes), sources.planes + assumed});
}

void addGridFacts(const ConversionGrid& grid, const ConversionMemory& memory, StudyParts& parts) {
    parts.spacingSource = fmt::format("scan conversion: finest resolution of samples, lines and planes, {:.4g} mm{}",
                                      grid.finestMm, grid.limitedByMemory ? ", widened to the memory limit" : "");
    parts.facts.push_back(
        {"memory of the scan conversion",
         fmt::format("{:.1f} MiB a phase; the limit is {:.0f} MiB a phase and {:.0f} MiB for all phases; {:.1f} MiB "
                     "of tables while voxels are converted",
                     static_cast<double>(grid.geometry.voxelCount() * memory.bytesPerVoxel) / mebibyte,
                     static_cast<double>(memory.phaseBytes) / mebibyte,
                     static_cast<double>(memory.phaseBytes * conversionPhasesInFull) / mebibyte,
                     static_cast<double>(grid.rows() * conversionRowBytes) / mebibyte),
         memory.phaseBytes == standardConversionBytes ? "standard limit" : "--conversion-memory"});
}

std::int64_t bytesPerVoxel(const Voxels& voxels) {
    return std::visit([](const auto& values) { return static_cast<std::int64_t>(sizeof(values[0])); }, voxels);
}

/// Refuses a grid one voxel thick. Its cause may be the distance of the beams, or a memory limit that widened the
/// spacing beyond the distance.
Result<void> checkThickness(const std::string& path, const ConversionGrid& grid, const PolarSources& sources) {
    const auto& size = grid.geometry.size;
    const auto thin = std::find(size.begin(), size.end(), std::int64_t{1}) - size.begin();
    if (thin == 3) return {};
    const std::array<std::string, 3> elements{"the lines of " + sources.lines, "the planes of " + sources.planes,
                                              "the range of " + sources.range};
    return fail(
        FailureKind::unreadable, path, elements[static_cast<std::size_t>(thin)],
        fmt::format("make a grid of {} voxels of {:.4g} mm, one voxel thick{}: that is a picture, not a volume",
                    sizeText(size), grid.geometry.spacing[0], grid.limitedByMemory ? " within the memory limit" : ""),
        grid.limitedByMemory ? "Correct the geometry of the beams, or allow more with --conversion-memory."
                             : "Correct the geometry of the beams.");
}

/// Progress of one of several phases, between 0.8 and 0.9 of the reading.
Progress progressOfPhase(const Progress& progress, std::size_t phase, std::size_t phases) {
    Progress part;
    part.cancel = progress.cancel;
    part.report = [&progress, phase, phases](double share) {
        progress.at(0.8 + 0.1 * (static_cast<double>(phase) + share) / static_cast<double>(phases));
    };
    return part;
}

}  // namespace

Result<void> checkPolar(const std::string& path, const PolarGeometry& polar, const std::array<std::int64_t, 3>& size,
                        const PolarSources& sources) {
    const auto refuse = [&](const std::string& element, const std::string& problem) {
        return fail(FailureKind::unreadable, path, element, problem,
                    "The geometry of the beams is wrong: export the volume again, or correct what describes it.");
    };
    if (polar.size()[0] != size[0])
        return refuse("the range of " + sources.range,
                      fmt::format("has {} samples where {} says {}", polar.size()[0], sources.size, size[0]));
    if (polar.size()[1] != size[1])
        return refuse("the lines of " + sources.lines,
                      fmt::format("are {} where {} says {}", polar.size()[1], sources.size, size[1]));
    if (polar.size()[2] != size[2])
        return refuse("the planes of " + sources.planes,
                      fmt::format("are {} where {} says {}", polar.size()[2], sources.size, size[2]));
    const auto problem = problemOf(polar);
    if (!problem) return {};
    switch (problem->part) {
        case PolarPart::range: return refuse("the range of " + sources.range, problem->words);
        case PolarPart::lines: return refuse("the lines of " + sources.lines, problem->words);
        case PolarPart::planes: break;
    }
    return refuse("the planes of " + sources.planes, problem->words);
}

Result<void> scanConvert(StudyParts& parts, const PolarGeometry& polar, const PolarSources& sources,
                         const ReadOptions& options, const Progress& progress) {
    const auto cancelled = [&] { return fail(FailureKind::cancelled, parts.path, "", "was not read: cancelled"); };
    ConversionMemory memory;
    memory.bytesPerVoxel = bytesPerVoxel(parts.voxels.phases.front());
    memory.phases = static_cast<std::int64_t>(parts.voxels.phases.size());
    memory.phaseBytes = options.conversionMebibytes << 20;
    const ConversionGrid grid = conversionGrid(polar, memory);
    if (auto thick = checkThickness(parts.path, grid, sources); !thick) return thick;
    const auto needed = static_cast<std::uint64_t>(grid.geometry.voxelCount()) *
                            static_cast<std::uint64_t>(memory.bytesPerVoxel * memory.phases + 1) +
                        static_cast<std::uint64_t>(grid.rows() * conversionRowBytes);
    if (auto enough = requireMemory(parts.path, "the scan conversion", needed); !enough) return enough;

    Progress tables;
    tables.cancel = progress.cancel;
    const ScanConversion conversion(polar, grid, tables);
    if (progress.cancelled()) return cancelled();
    for (std::size_t phase = 0; phase < parts.voxels.phases.size(); ++phase) {
        auto converted = conversion.convert(parts.voxels.phases[phase],
                                            progressOfPhase(progress, phase, parts.voxels.phases.size()));
        if (!converted) return cancelled();
        parts.voxels.phases[phase] = std::move(*converted);
    }
    parts.geometry = grid.geometry;
    if (parts.phasesSource.empty()) parts.phasesSource = parts.sizeSource;
    parts.sizeSource = "scan conversion: the smallest grid around the insonified region";
    parts.dataMask = std::make_shared<const DataMask>(conversion.mask(tables));
    if (progress.cancelled()) return cancelled();
    parts.dataMaskSource = "geometry of the beams";
    StatedProbe probe{.planesKnown = true};  // lines lie side by side along x, planes along y
    if (const auto apex = apexMm(polar)) probe.apexMm = *apex - grid.geometry.origin;
    parts.geometry.probe = probe;
    parts.probeSource = "geometry of the beams";
    addAcquisitionFacts(polar, sources, parts.facts);
    addGridFacts(grid, memory, parts);
    return {};
}

}  // namespace echolucent
