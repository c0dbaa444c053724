#include "processing/ray_caster/ray_caster.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "processing/parallel.h"
#include "processing/picture/view_limits.h"
#include "processing/progress_count.h"
#include "processing/ray_caster/between_rays.h"
#include "processing/ray_caster/kept_views.h"
#include "processing/ray_caster/kernel_job.h"
#include "processing/ray_caster/light_reaching.h"
#include "processing/ray_caster/packed/empty_space.h"
#include "processing/ray_caster/packed/packed_gradients.h"
#include "processing/sampling/gradient_levels.h"
#include "processing/volume/row_marks.h"

namespace echolucent {

namespace {

using namespace ray_casting;

constexpr int tileEdge = 32;

/// False if cancelled. Tiles start at the first packets that may see the volume.
template <typename Voxel>
bool castTiles(const KernelJob<Voxel>& job, const Progress& progress) {
    const RayGeometry::PixelBox box = job.rays->visiblePixels();
    const PacketShape shape = packetShape();
    const int acrossPacket = shape.columns * job.apart, downPacket = shape.rows * job.apart;
    const int left = box.firstColumn / acrossPacket * acrossPacket, top = box.firstRow / downPacket * downPacket;
    // Larger tiles would be too few for many threads.
    const int edge = tileEdge * std::min(job.apart, 2);
    const int columns = (std::max(0, box.lastColumn - left) + edge - 1) / edge;
    const int rows = (std::max(0, box.lastRow - top) + edge - 1) / edge;
    ProgressCount count(progress, static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    parallelFor(LoopRectangle<int>(rows, columns), [&](const auto& tiles) {
        for (int row = tiles.rows().begin(); row < tiles.rows().end(); ++row)
            for (int column = tiles.columns().begin(); column < tiles.columns().end(); ++column) {
                if (progress.cancelled()) return;
                const int x = left + column * edge, y = top + row * edge;
                castTile(job, {x, std::min(x + edge, box.lastColumn), y, std::min(y + edge, box.lastRow)});
                count.oneDone();
            }
    });
    return !progress.cancelled();
}

/// As castTiles(), but casts only pixels that cannot be interpolated between others (RayCastSettings::pixelTolerance).
/// Sets the share of the visible pixels that were cast.
template <typename Voxel>
bool castSparsely(KernelJob<Voxel> job, int apart, double tolerance, const Progress& progress, double& share) {
    const RayGeometry::PixelBox box = job.rays->visiblePixels();
    const double pixels = static_cast<double>(box.lastColumn - box.firstColumn) * (box.lastRow - box.firstRow);
    const Progress untold{{}, progress.cancel};
    job.apart = apart;
    if (!castTiles(job, untold)) return false;
    job.apart = 1;
    double cast = pixels / (apart * apart);
    for (; apart > 1; apart /= 2) {
        const PixelsLeft left = fillBetweenRays(*job.picture, box, apart, tolerance);
        cast += static_cast<double>(left.count);
        job.chosen = left.chosen.data();
        if (!castTiles(job, apart > 2 ? untold : progress)) return false;
    }
    share = pixels > 0.0 ? std::min(1.0, cast / pixels) : 1.0;
    return true;
}

DepthTint depthTint(const DepthColouring& colouring, const VolumeGeometry& geometry, const RayCastSettings& settings) {
    DepthTint tint;
    for (int channel = 0; channel < 3; ++channel) {
        tint.near[static_cast<std::size_t>(channel)] = static_cast<float>(colouring.nearTint[channel]);
        tint.change[static_cast<std::size_t>(channel)] =
            static_cast<float>(colouring.farTint[channel] - colouring.nearTint[channel]);
    }
    tint.nearDepthMm = nearestDepthMm(settings, geometry);
    const double range = geometry.depthsAlong(settings.camera.frame.forward).farthest - tint.nearDepthMm;
    tint.perMm = range > 0.0 ? 1.0 / range : 0.0;
    return tint;
}

}  // namespace

class RayCaster::Parts {
public:
    explicit Parts(const std::shared_ptr<const Volume>& given) : Parts(given, filledVoxels(*given)) {}
    /// RayCaster::sharing().
    Parts(const Parts& other)
        : volume(other.volume),
          m_presence(*volume),
          m_ranges(other.m_ranges),
          m_empty(m_ranges.grid()),
          m_borders(other.m_borders),
          m_packed(other.m_packed),
          m_reaching(volume) {}
    Parts& operator=(const Parts&) = delete;
    Parts(Parts&&) = delete;
    Parts& operator=(Parts&&) = delete;
    ~Parts() = default;

    /// Another cut of the same scan. Only the presence of data changes, and only around the rows that the new cut masks
    /// otherwise.
    void setCut(std::shared_ptr<const Volume> given) {
        kept.forget();
        const RowMarks masked = rowsMaskedOtherwise(*volume, *given);
        volume = std::move(given);
        if (!masked.any()) return m_reaching.setCut(volume, masked);
        const RowMarks present = m_presence.follow(*volume, masked);
        // Side by side, because a part of the work on the borders runs in one thread.
        parallelFor(0, 3, [&](int which) {
            if (which == 0) m_borders.follow(m_presence, present);
            if (which == 1) m_ranges.follow(m_presence, present);
            if (which == 2) m_reaching.setCut(volume, masked);
        });
    }

    std::optional<Picture> cast(const Classification& otf, const RayCastSettings& settings, const Progress& progress) {
        const RayGeometry rays(volume->geometry(), settings);
        const bool direct = settings.mode == RenderMode::direct;
        const bool readsGradients = direct && otf.isTwoDimensional();
        if (readsGradients && !prepareGradients(otf, progress)) return std::nullopt;
        const GradientLevels* const levels = readsGradients ? m_gradients->levels().get() : nullptr;
        if (!m_reaching.update({otf, levels}, settings, progress)) return std::nullopt;
        const bool mixes = direct && settings.mixing.share > 0.0;
        std::optional<Picture> other;
        // Cast the mixed-in picture first, so that the samples kept at the end are the direct picture's.
        if (mixes && !(other = castOne(rays, otf, mixedIn(settings), progress))) return std::nullopt;
        auto picture = castOne(rays, otf, settings, progress);
        if (picture && mixes) mixIn(*picture, *other, settings.mixing.share);
        return picture;
    }

    std::optional<Picture> castOne(const RayGeometry& rays, const Classification& otf, const RayCastSettings& settings,
                                   const Progress& progress) {
        Picture picture = emptyPicture(settings.width, settings.height, settings.findDepth);
        const bool finished = std::visit(
            [&](const auto& packed) { return castVoxels(packed, rays, otf, settings, picture, progress); }, *m_packed);
        if (!finished) return std::nullopt;
        kept.finishPicture();
        if (settings.brightness != 1.0) brighten(picture, settings.brightness);
        return picture;
    }

    [[nodiscard]] double lightMilliseconds() const { return m_reaching.milliseconds(); }
    [[nodiscard]] double castShare() const { return m_castShare; }

    std::shared_ptr<const Volume> volume;
    KeptViews kept;

private:
    using Packed = std::variant<PackedVoxels<std::uint8_t>, PackedVoxels<std::uint16_t>, PackedVoxels<float>>;

    Parts(std::shared_ptr<const Volume> given, const Volume& filled)
        : volume(std::move(given)),
          m_presence(*volume),
          m_ranges(filled, m_presence),
          m_empty(m_ranges.grid()),
          m_borders(m_presence),
          m_packed(std::make_shared<const Packed>(pack(filled))),
          m_reaching(volume) {}

    static Packed pack(const Volume& filled) {
        return std::visit([&]<typename Voxel>(const VoxelArray<Voxel>&) { return Packed(PackedVoxels<Voxel>(filled)); },
                          filled.voxels());
    }

    /// Gradients and visible nodes of a two-dimensional OTF. False if cancelled.
    bool prepareGradients(const Classification& otf, const Progress& progress) {
        if (m_visibleOf && *m_visibleOf == otf) return true;
        const double largest = otf.twoDimensional()->largestGradient;
        if (!m_gradients || m_gradients->levels()->largest != largest) {
            // Gradients depend on the scan alone, not on the cut. So do the values that fill voxels without data.
            const Volume filled = filledVoxels(*volume);
            auto levels = gradientLevels(filled, largest, Progress{{}, progress.cancel});
            if (!levels) return false;
            m_gradients.emplace(filled, std::make_shared<const GradientLevels>(std::move(*levels)), m_ranges.grid());
        }
        m_visible.emplace(*otf.twoDimensional());
        m_visibleOf = otf;
        return true;
    }

    template <typename Voxel>
    bool castVoxels(const PackedVoxels<Voxel>& packed, const RayGeometry& rays, const Classification& otf,
                    const RayCastSettings& settings, Picture& picture, const Progress& progress) {
        const bool direct = settings.mode == RenderMode::direct;
        const TransferTable table(otf.curve(), settings.colourMap, settings.step);
        KernelJob<Voxel> job;
        job.voxels = &packed;
        job.presence = m_presence.cubes();
        job.geometry = volume->geometry();
        job.rays = &rays;
        job.toTable = PackedVoxels<Voxel>::toTable(volume->whiteLevel());
        job.table = &table;
        job.worthGradient = static_cast<float>(LightSource::worthGradient * std::min(1.0, settings.step));
        job.bricks = m_ranges.grid().size;
        job.borders = m_borders.distances().empty() ? nullptr : &m_borders;
        job.stepUnits = static_cast<float>(settings.step);
        job.mode = settings.mode;
        job.colourMap = settings.colourMap;
        job.nearest = settings.interpolation == Interpolation::nearest;
        job.endTransmittance = settings.terminationTransmittance;
        std::optional<TwoDimensionalNodes> nodes;
        if (direct && otf.isTwoDimensional()) {
            const TwoDimensionalOtf& given = *otf.twoDimensional();
            job.twoDimensional =
                &nodes.emplace(TwoDimensionalNodes{given.opacities.data(), given.intensities, given.gradients,
                                                   m_gradients->cubes(), m_visible->firstVisible()});
        }
        if (nodes)
            kept.useNone();
        else
            job.kept = kept.samplesFor(settings, rays, sampleMemoryLimit);
        job.picture = &picture;
        std::optional<LightSource> light;
        std::optional<DepthTint> tint;
        std::optional<ByteOpacities> byteOpacities;
        std::optional<ColourBends> colourBends;
        if (direct) {
            if (settings.shading) {
                job.light = &light.emplace(
                    lightSource(*settings.shading, job.geometry, settings.camera.frame, settings.colourMap));
                job.reaching = m_reaching.packed();
            }
            if (settings.depthColouring)
                job.depthTint = &tint.emplace(depthTint(*settings.depthColouring, job.geometry, settings));
        }
        const bool plain = direct && !nodes && !settings.shading && !settings.depthColouring && !settings.findDepth;
        constexpr bool bytes = std::is_same_v<Voxel, std::uint8_t>;
        const bool fine = bytes && volume->whiteLevel() >= ByteOpacities::leastWhite;
        if (fine && direct) {
            job.byteOpacities = &byteOpacities.emplace(table, static_cast<double>(job.toTable));
            job.keptPerPosition = KeptSamples::perByte / job.toTable;
        }
        if (plain && (fine || !bytes)) job.colourBends = &colourBends.emplace(settings.colourMap);
        if (direct && settings.skipEmptySpace) {
            if (nodes)
                m_empty.update(m_ranges, *m_gradients, *m_visible);
            else
                m_empty.update(m_ranges, table);
            if (m_empty.any()) job.distances = m_empty.distances().data();
        }
        const int apart = raysApart(rays.widestPixelMm(volume->geometry()) / volume->geometry().unit());
        m_castShare = 1.0;
        const bool sparse =
            direct && settings.pixelTolerance > 0.0 && !settings.findDepth && job.kept == nullptr && apart > 1;
        // The picture's colours are multiplied later, and so are their errors.
        const double tolerance = settings.pixelTolerance / std::max(1.0, settings.brightness);
        return sparse ? castSparsely(job, apart, tolerance, progress, m_castShare) : castTiles(job, progress);
    }

    PackedPresence m_presence;
    BrickRanges m_ranges;
    EmptySpace m_empty;
    BorderSpace m_borders;
    std::shared_ptr<const Packed> m_packed;
    LightReaching m_reaching;
    std::optional<PackedGradients> m_gradients;  ///< of the newest two-dimensional OTF
    std::optional<VisibleNodes> m_visible;
    std::optional<Classification> m_visibleOf;
    double m_castShare = 1.0;
};

RayCaster::RayCaster(const std::shared_ptr<const Volume>& volume) : m_parts(std::make_unique<Parts>(volume)) {}

RayCaster::RayCaster(std::unique_ptr<Parts> parts) : m_parts(std::move(parts)) {}
RayCaster RayCaster::sharing() const { return RayCaster(std::make_unique<Parts>(*m_parts)); }
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::setCut(std::shared_ptr<const Volume> volume) {
    if (!volume->isSameScanAs(*m_parts->volume)) throw std::invalid_argument("RayCaster::setCut: another scan");
    if (volume != m_parts->volume) m_parts->setCut(std::move(volume));
}

const std::shared_ptr<const Volume>& RayCaster::volume() const { return m_parts->volume; }

std::optional<Picture> RayCaster::cast(const Classification& classification, const RayCastSettings& settings,
                                       const Progress& progress) {
    return m_parts->cast(classification, settings, progress);
}

double RayCaster::lightMilliseconds() const { return m_parts->lightMilliseconds(); }

double RayCaster::castShare() const { return m_parts->castShare(); }

SampleUse RayCaster::sampleUse() const { return m_parts->kept.sampleUse(); }

std::size_t RayCaster::keptSampleBytes() const { return m_parts->kept.bytes(); }

std::optional<Picture> castRays(const Volume& volume, const Classification& classification,
                                const RayCastSettings& settings, const Progress& progress) {
    if (progress.cancelled()) return std::nullopt;
    // Not owned: the caller keeps the volume during this call.
    return RayCaster(std::shared_ptr<const Volume>(std::shared_ptr<const Volume>(), &volume))
        .cast(classification, settings, progress);
}

}  // namespace echolucent
