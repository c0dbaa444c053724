#include "app/cli/phantom_polar.h"

#include <filesystem>

#include "app/cli/options/option_text.h"
#include "app/cli/options/polar_options.h"
#include "io/headers/raw_volume.h"
#include "io/output/atomic_file.h"
#include "io/study/study.h"
#include "io/writers/kretz_writer.h"
#include "processing/ascii_letters.h"
#include "processing/phantom/phantom.h"
#include "processing/phantom/polar_sampling.h"

namespace echolucent::cli {

namespace {

enum class Ending { kretz, raw, other };

Ending polarEndingOf(const std::string& path) {
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    return extension == ".vol" ? Ending::kretz : extension == ".raw" ? Ending::raw : Ending::other;
}

/// A raw file of bytes or little-endian words, and the layout beside it.
Result<void> writeRaw(const std::string& path, const PolarGeometry& polar, const Voxels& voxels) {
    std::string bytes;
    RawLayout layout;
    layout.size = polar.size();
    layout.polar = polar;
    if (const auto* small = std::get_if<VoxelArray<std::uint8_t>>(&voxels)) {
        bytes.assign(small->begin(), small->end());
    } else {
        layout.type = "uint16";
        for (const std::uint16_t value : std::get<VoxelArray<std::uint16_t>>(voxels)) {
            bytes.push_back(static_cast<char>(value & 0xFF));
            bytes.push_back(static_cast<char>(value >> 8));
        }
    }
    if (auto written = writeFileAtomically(path, bytes); !written) return written;
    return rememberRawLayout(path, layout);
}

}  // namespace

bool isPolarName(const std::string& path) { return polarEndingOf(path) != Ending::other; }

std::string layoutBeside(const std::string& path) {
    return polarEndingOf(path) == Ending::raw ? rawLayoutPath(path) : "";
}

Result<std::optional<PolarGeometry>> polarOfPhantom(const std::string& path, const std::string& kind, int phases,
                                                    const PhantomConfig& config) {
    const Ending ending = polarEndingOf(path);
    if (kind.empty() && ending == Ending::raw)
        return wrongUsage("--polar", "is missing for a raw file", "Give it, or write a MetaImage (.mha).");
    if (kind.empty() && ending == Ending::other) return std::optional<PolarGeometry>();
    if (ending == Ending::other)
        return wrongUsage("--polar", "needs a file that holds voxels along beams", "Write to FILE.vol or FILE.raw.");
    const auto named = kind.empty() ? PolarKind::wobbler : polarKindOf(kind, "--polar");
    if (!named) return tl::unexpected<Failure>(named.error());
    if (ending == Ending::kretz && *named != PolarKind::wobbler)
        return wrongUsage("--polar", "must be wobbler for a .vol file", "Write other probes to FILE.raw.");
    if (ending == Ending::kretz && config.bits != 8)
        return wrongUsage("--bits", "must be 8 for a .vol file", "Write more bits to FILE.raw.");
    if (ending == Ending::raw && phases > 1)
        return wrongUsage("--phases", "must be 1 for a raw file", "Write several phases to FILE.vol.");
    if (config.spacing[0] != config.spacing[1] || config.spacing[0] != config.spacing[2])
        return wrongUsage("--spacing", "must be one number along beams",
                          "Give the mm from sample to sample, such as --spacing 0.5.");
    const PolarGeometry polar = polarGeometry(usualPolar(*named, config.size[0], config.spacing[0]), config.size);
    if (const auto problem = problemOf(polar))
        return wrongUsage("--spacing", "makes beams whose range " + problem->words,
                          "Choose a spacing in mm that scanners have.");
    return std::optional(polar);
}

Result<void> writePolarPhantom(const std::string& path, const PolarGeometry& polar,
                               std::vector<PhantomConfig>& phases) {
    ConversionMemory memory;
    memory.bytesPerVoxel = phases.front().bits == 8 ? 1 : 2;
    memory.phases = static_cast<std::int64_t>(phases.size());
    const ConversionGrid grid = conversionGrid(polar, memory);
    std::vector<Voxels> voxels;
    for (PhantomConfig& phase : phases) {
        phase = configOnGrid(phase, grid);
        voxels.push_back(*makePolarPhantom(phase, polar, grid));
    }
    if (polarEndingOf(path) == Ending::raw) return writeRaw(path, polar, voxels.front());
    std::vector<std::vector<std::uint8_t>> bytes;
    bytes.reserve(voxels.size());
    for (const Voxels& phase : voxels) bytes.push_back(std::get<VoxelArray<std::uint8_t>>(phase).toVector());
    return writeKretz(path, polar, bytes);
}

}  // namespace echolucent::cli
