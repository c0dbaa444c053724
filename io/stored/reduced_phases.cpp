#include "io/stored/reduced_phases.h"

#include <algorithm>
#include <cstring>

#include "io/files/input_file.h"
#include "io/voxels/phase_slices.h"

namespace echolucent {

namespace {

class ReducedReader {
public:
    ReducedReader(const StoredVolume& stored, StoredBytes& source, const Reduction& reduction, const Progress& progress)
        : m_stored(stored), m_source(source), m_progress(progress) {
        for (std::int64_t phase = 0; phase < stored.phases; ++phase)
            m_phases.emplace_back(stored.type, stored.geometry.size, reduction);
        m_voxelBytes = static_cast<std::size_t>(bytesOf(stored.type) * stored.channels);
        m_together = stored.phasesFastest ? static_cast<std::size_t>(stored.phases) : 1;
        m_voxels = static_cast<std::size_t>(stored.geometry.size[0] * stored.geometry.size[1]);
        m_steps = stored.geometry.size[2] * (stored.phasesFastest ? 1 : stored.phases);
    }

    Result<std::vector<VoxelBytes>> read() {
        for (std::int64_t step = 0; step < m_steps; ++step)
            if (auto done = readStep(step); !done) return tl::unexpected(done.error());
        std::vector<VoxelBytes> phases;
        for (PhaseSlices& slices : m_phases) phases.push_back(slices.take());
        return phases;
    }

private:
    /// Reads the file's next slice, or the next slice of all phases together.
    Result<void> readStep(std::int64_t step) {
        m_bytes.resize(m_voxels * m_voxelBytes * m_together);
        constexpr double shareOfReading = 0.8;
        const double share = shareOfReading / static_cast<double>(m_steps);
        if (auto read = m_source.read(m_bytes, m_progress, share * static_cast<double>(step),
                                      share * static_cast<double>(step + 1));
            !read)
            return read;
        toMachineByteOrder(m_bytes, m_stored.type, m_stored.bigEndian);
        if (m_stored.channels == 3) reduceToLuma(m_bytes, m_stored.type);
        if (m_together > 1) {
            for (std::size_t phase = 0; phase < m_together; ++phase) takeInterleaved(phase);
            return {};
        }
        PhaseSlices& slices =
            m_phases[m_stored.phasesFastest ? 0 : static_cast<std::size_t>(step / m_stored.geometry.size[2])];
        std::memcpy(slices.nextSlice().data(), m_bytes.data(), m_bytes.size());
        slices.endSlice();
        return {};
    }

    void takeInterleaved(std::size_t phase) {
        const auto width = static_cast<std::size_t>(bytesOf(m_stored.type));
        std::uint8_t* to = m_phases[phase].nextSlice().data();
        for (std::size_t voxel = 0; voxel < m_voxels; ++voxel)
            std::memcpy(to + voxel * width, m_bytes.data() + (voxel * m_together + phase) * width, width);
        m_phases[phase].endSlice();
    }

    const StoredVolume& m_stored;
    StoredBytes& m_source;
    const Progress& m_progress;
    std::vector<PhaseSlices> m_phases;
    std::size_t m_voxels = 0;      // of a slice
    std::size_t m_voxelBytes = 0;  // all channels
    std::size_t m_together = 1;    // phases whose voxels are interleaved
    std::int64_t m_steps = 0;      // reads for the whole file
    VoxelBytes m_bytes;
};

}  // namespace

Result<std::vector<VoxelBytes>> readReducedPhases(const StoredVolume& stored, StoredBytes& source,
                                                  const Reduction& reduction, const Progress& progress) {
    const auto slice =
        checkedProduct(bytesOf(stored.type) * stored.channels * (stored.phasesFastest ? stored.phases : 1),
                       stored.geometry.size[0] * stored.geometry.size[1]);
    // The slice as stored, the slice of each phase apart, and the sums of its columns.
    constexpr std::uint64_t timesTheSlice = 4;
    constexpr std::uint64_t countable = std::uint64_t{1} << 60;
    const std::uint64_t bytes = slice ? std::min(static_cast<std::uint64_t>(*slice), countable) : countable;
    if (auto enough = requireMemory(stored.path, stored.sizeKey, bytes * timesTheSlice); !enough)
        return tl::unexpected(enough.error());
    return ReducedReader(stored, source, reduction, progress).read();
}

}  // namespace echolucent
