#include "processing/card_picture/card_pictures.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "processing/light/light_sweep.h"
#include "processing/parallel.h"
#include "processing/ray_caster/packed/empty_space.h"
#include "processing/ray_caster/packed/packed_gradients.h"
#include "processing/ray_caster/packed/packed_presence.h"
#include "processing/ray_caster/packed/packed_voxels.h"
#include "processing/volume/filled_volume.h"
#include "processing/volume/row_marks.h"

namespace echolucent {

namespace {

using namespace ray_casting;
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

std::shared_ptr<const CardScan> scanOf(const Volume& volume) {
    CardScan scan{filledVoxels(volume), {}, 1.0f};
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            scan.toPosition = PackedVoxels<Voxel>::toTable(scan.filled.whiteLevel());
            if constexpr (std::is_same_v<Voxel, float>) {
                scan.positions.resize(voxels.size());
                const double factor = TransferTable::intervals / scan.filled.whiteLevel();
                parallelFor(LoopRange<std::size_t>(0, voxels.size(), 1 << 16), [&](const auto& part) {
                    for (std::size_t i = part.begin(); i < part.end(); ++i)
                        scan.positions[i] = positionOfFloat(voxels[i], factor);
                });
            }
        },
        scan.filled.voxels());
    return std::make_shared<const CardScan>(std::move(scan));
}

std::shared_ptr<const Volume> presenceOf(const Volume& volume) {
    auto presence = presenceIn(volume);
    return presence ? std::make_shared<const Volume>(std::move(*presence)) : nullptr;
}

}  // namespace

class CardPictures::Parts {
public:
    explicit Parts(std::shared_ptr<const Volume> given)
        : volume(std::move(given)), m_scan(scanOf(*volume)), m_presence(presenceOf(*volume)) {
        findRanges();
    }

    void setCut(std::shared_ptr<const Volume> given) {
        const RowMarks masked = rowsMaskedOtherwise(*volume, *given);
        volume = std::move(given);
        if (m_sweep) m_sweep->setCut(volume, masked);
        m_light = nullptr;
        if (!masked.any()) return;
        m_presence = presenceOf(*volume);
        findRanges();
    }

    std::optional<CardPicture> make(const Classification& classification, const RayCastSettings& settings,
                                    const Progress& progress) {
        const auto begin = Clock::now();
        const RayGeometry rays(volume->geometry(), settings);
        const bool direct = settings.mode == RenderMode::direct;
        CardPicture picture;
        picture.scan = m_scan;
        picture.presence = m_presence;
        picture.settings = settings;
        picture.rays = rays.plan();
        picture.pixels = rays.visiblePixels();
        if (direct) picture.classification = classification;
        if (direct && classification.isTwoDimensional()) {
            if (!findGradients(*classification.twoDimensional(), progress)) return std::nullopt;
            picture.gradients = m_gradients->levels();
            picture.firstVisible = m_visible->firstVisible();
        }
        picture.table = tableOf(classification, settings);
        if (direct && settings.skipEmptySpace) picture.bricks = bricksUnder(classification, *picture.table);
        if (direct && settings.shading && settings.shading->asksWhatReaches()) {
            const auto sinceLight = Clock::now();
            if (!findLight(classification, picture.gradients.get(), settings, progress)) return std::nullopt;
            picture.light = m_light;
            picture.lightMilliseconds = millisecondsSince(sinceLight);
        }
        if (settings.cutSurface) {
            if (!m_surface || *m_surface != *settings.cutSurface)
                m_surface = std::make_shared<const CutSurface>(*settings.cutSurface);
            picture.surface = m_surface;
        }
        if (progress.cancelled()) return std::nullopt;
        picture.milliseconds = millisecondsSince(begin);
        return picture;
    }

    [[nodiscard]] std::size_t keptBytes() const {
        const auto voxels = static_cast<std::size_t>(volume->geometry().voxelCount());
        std::size_t bytes = m_scan->positions.size() * sizeof(float);
        if (m_presence) bytes += 2 * voxels;
        if (m_gradients) bytes += 3 * voxels;
        return bytes;
    }

    std::shared_ptr<const Volume> volume;

private:
    void findRanges() {
        const PackedPresence presence(*volume);
        m_ranges.emplace(m_scan->filled, presence);
        m_empty.emplace(m_ranges->grid());
        m_bricks = nullptr;
    }

    bool findGradients(const TwoDimensionalOtf& otf, const Progress& progress) {
        if (m_visibleOf != otf) {
            m_visible.emplace(otf);
            m_visibleOf = otf;
        }
        if (m_gradients && m_gradients->levels()->largest == otf.largestGradient) return true;
        auto levels = gradientLevels(m_scan->filled, otf.largestGradient, Progress{{}, progress.cancel});
        if (!levels) return false;
        m_gradients.emplace(m_scan->filled, std::make_shared<const GradientLevels>(std::move(*levels)),
                            m_ranges->grid());
        return true;
    }

    std::shared_ptr<const TransferTable> tableOf(const Classification& classification,
                                                 const RayCastSettings& settings) {
        const TableOf asked{classification, settings.colourMap, settings.step};
        if (!m_table || m_tableOf != asked) {
            m_table = std::make_shared<const TransferTable>(classification.curve(), settings.colourMap, settings.step);
            m_tableOf = asked;
        }
        return m_table;
    }

    /// Null if no brick is empty.
    std::shared_ptr<const CardBricks> bricksUnder(const Classification& classification, const TransferTable& table) {
        if (m_bricks && m_bricksOf == classification) return m_empty->any() ? m_bricks : nullptr;
        if (classification.isTwoDimensional())
            m_empty->update(*m_ranges, *m_gradients, *m_visible);
        else
            m_empty->update(*m_ranges, table);
        m_bricks = std::make_shared<const CardBricks>(CardBricks{m_empty->grid().size, m_empty->distances()});
        m_bricksOf = classification;
        return m_empty->any() ? m_bricks : nullptr;
    }

    bool findLight(const Classification& classification, const GradientLevels* gradients,
                   const RayCastSettings& settings, const Progress& progress) {
        const LightScene scene = lightSceneOf(settings, volume->geometry());
        if (m_light && m_lightOf == classification && m_lightScene == scene) return true;
        m_light = nullptr;
        if (!m_sweep) m_sweep.emplace(volume);
        auto light = m_sweep->lightVolume({classification, gradients}, scene, Progress{{}, progress.cancel});
        if (!light) return false;
        m_light = std::make_shared<const LightVolume>(std::move(*light));
        m_lightOf = classification;
        m_lightScene = scene;
        return true;
    }

    std::shared_ptr<const CardScan> m_scan;
    std::shared_ptr<const Volume> m_presence;
    std::optional<BrickRanges> m_ranges;
    std::optional<EmptySpace> m_empty;
    std::shared_ptr<const CardBricks> m_bricks;
    Classification m_bricksOf;
    std::optional<PackedGradients> m_gradients;
    std::optional<VisibleNodes> m_visible;  ///< of m_visibleOf
    std::optional<TwoDimensionalOtf> m_visibleOf;
    struct TableOf {
        Classification classification;
        ColourMap colourMap = ColourMap::sepia;
        double step = 0.0;
        friend bool operator==(const TableOf&, const TableOf&) = default;
    };
    std::shared_ptr<const TransferTable> m_table;
    std::shared_ptr<const CutSurface> m_surface;
    TableOf m_tableOf;
    std::optional<LightSweep> m_sweep;
    std::shared_ptr<const LightVolume> m_light;
    Classification m_lightOf;
    LightScene m_lightScene;
};

CardPictures::CardPictures(std::shared_ptr<const Volume> volume)
    : m_parts(std::make_unique<Parts>(std::move(volume))) {}
CardPictures::~CardPictures() = default;
CardPictures::CardPictures(CardPictures&&) noexcept = default;
CardPictures& CardPictures::operator=(CardPictures&&) noexcept = default;

const std::shared_ptr<const Volume>& CardPictures::volume() const { return m_parts->volume; }

void CardPictures::setCut(std::shared_ptr<const Volume> volume) {
    if (!volume->isSameScanAs(*m_parts->volume)) throw std::invalid_argument("CardPictures::setCut: another scan");
    if (volume != m_parts->volume) m_parts->setCut(std::move(volume));
}

std::optional<CardPicture> CardPictures::make(const Classification& classification, const RayCastSettings& settings,
                                              const Progress& progress) {
    return m_parts->make(classification, settings, progress);
}

std::size_t CardPictures::keptBytes() const { return m_parts->keptBytes(); }

}  // namespace echolucent
