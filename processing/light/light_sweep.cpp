#include "processing/light/light_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "processing/light/coarse_extinction.h"
#include "processing/light/grid_sweep.h"
#include "processing/light/light_grid.h"
#include "processing/light/slice_kernel.h"
#include "processing/parallel.h"
#include "processing/progress_count.h"
#include "processing/volume/filled_volume.h"

namespace echolucent {

int coarsenessWithin(const VolumeGeometry& geometry, std::int64_t places) {
    int coarseness = 1;
    const auto tooMany = [&] {
        return static_cast<std::int64_t>(light::LightGrid(geometry, coarseness).places()) > places;
    };
    while (coarseness < light::coarsest && tooMany()) ++coarseness;
    return coarseness;
}

LightScene lightSceneOf(const RayCastSettings& settings, const VolumeGeometry& geometry) {
    const ViewFrame& frame = settings.camera.frame;
    const Shading shading = settings.shading.value_or(Shading{});
    const Vec3 light = shading.towardsLight;
    LightScene scene;
    scene.towardsKey = frame.right * light[0] + frame.down * light[1] + frame.forward * light[2];
    scene.towardsViewer = -frame.forward;
    scene.rendered = {settings.front, settings.box, settings.clippingPlanes, settings.cutSurface};
    scene.keyHalfAngleDegrees = shading.keyHalfAngleDegrees;
    const std::int64_t edge = usualVolumeEdge / settings.lightCoarseness;
    scene.coarseness = coarsenessWithin(geometry, edge * edge * edge);
    return scene;
}

namespace {

void check(const LightScene& scene) {
    const auto isDirection = [](const Vec3& v) { return std::isfinite(length(v)) && length(v) > 0.0; };
    if (!isDirection(scene.towardsKey) || !isDirection(scene.towardsViewer))
        throw std::invalid_argument("LightScene: directions must have a length above 0");
    if (!(scene.keyHalfAngleDegrees >= 0.0 && scene.keyHalfAngleDegrees <= 45.0))
        throw std::invalid_argument("LightScene: keyHalfAngleDegrees must be within 0 and 45");
    if (!(scene.attenuation > 0.0 && scene.attenuation <= 1.0))
        throw std::invalid_argument("LightScene: attenuation must be above 0 and at most 1");
    if (scene.coarseness < 1 || scene.coarseness > light::coarsest)
        throw std::invalid_argument("LightScene: coarseness must be within 1 and 16");
}

/// One light: its bundles, and the sum of what they have swept so far. The sum fits: all light is 255 * 256, and a
/// bundle rounds by at most a half. Whole numbers have the same sum in whatever order the bundles end.
class SweptLight {
public:
    SweptLight(std::vector<light::DirectionBundle> given, const light::LightGrid& grid)
        : bundles(std::move(given)), m_grid(grid) {}

    std::vector<light::DirectionBundle> bundles;

    /// Adds what a bundle has swept. Several threads may call it.
    void add(const light::DirectionBundle& bundle, const std::vector<std::uint16_t>& swept) {
        const std::lock_guard alone(*m_access);
        std::vector<std::uint16_t>& sum = bundle.alongX() ? m_yFastest : m_xFastest;
        if (sum.empty()) sum.resize(m_grid.places());
        std::ranges::transform(sum, swept, sum.begin(), [](std::uint16_t whole, std::uint16_t part) {
            return static_cast<std::uint16_t>(whole + part);
        });
    }
    /// The sum over all bundles, x fastest.
    [[nodiscard]] std::vector<std::uint16_t> takeSum() {
        m_xFastest.resize(m_grid.places());
        const auto columns = static_cast<std::size_t>(m_grid.size[0]), rows = static_cast<std::size_t>(m_grid.size[1]);
        if (!m_yFastest.empty())
            parallelFor(0, m_grid.size[2], [&](int z) {
                const std::size_t plane = static_cast<std::size_t>(z) * columns * rows;
                const std::uint16_t* turned = m_yFastest.data() + plane;
                std::uint16_t* sum = m_xFastest.data() + plane;
                for (std::size_t y = 0; y < rows; ++y)
                    for (std::size_t x = 0; x < columns; ++x)
                        sum[y * columns + x] = static_cast<std::uint16_t>(sum[y * columns + x] + turned[x * rows + y]);
            });
        m_yFastest = std::vector<std::uint16_t>();
        return std::move(m_xFastest);
    }

private:
    const light::LightGrid& m_grid;
    std::unique_ptr<std::mutex> m_access = std::make_unique<std::mutex>();
    std::vector<std::uint16_t> m_xFastest, m_yFastest;  ///< empty if no bundle was swept in that order
};

/// Both lights as bytes, rounded from 256ths.
std::vector<std::uint8_t> bytesOf(const std::vector<std::uint16_t>& key, const std::vector<std::uint16_t>& around) {
    std::vector<std::uint8_t> bytes(2 * key.size());
    parallelFor(LoopRange<std::size_t>(0, key.size(), 1 << 15), [&](const auto& part) {
        for (std::size_t i = part.begin(); i < part.end(); ++i) {
            bytes[2 * i] = static_cast<std::uint8_t>((key[i] + 128U) >> 8);
            bytes[2 * i + 1] = static_cast<std::uint8_t>((around[i] + 128U) >> 8);
        }
    });
    return bytes;
}

}  // namespace

class LightSweep::Parts {
public:
    explicit Parts(std::shared_ptr<const Volume> given) : volume(std::move(given)), m_extinction(*volume) {}

    std::shared_ptr<const Volume> volume;

    void setCut(std::shared_ptr<const Volume> given, const RowMarks& masked) {
        volume = std::move(given);
        m_extinction.setCut(*volume, masked);
        for (Classified& kept : m_classified) kept.stale.add(masked);
        m_aroundScene.reset();
    }

    std::optional<LightVolume> make(const LightOtf& otf, const LightScene& scene, const Progress& progress) {
        const light::LightGrid grid(volume->geometry(), scene.coarseness);
        if (!classify(otf, scene.coarseness, grid, progress)) return std::nullopt;
        LightScene aroundScene = scene;
        aroundScene.towardsKey = {0, 0, 1};
        aroundScene.keyHalfAngleDegrees = 0.0;
        aroundScene.keyDirections = light::DirectionRule::one;
        const bool keptAround = m_aroundScene == aroundScene;
        std::vector<SweptLight> lights;
        const auto add = [&](const Vec3& towards, double halfAngleDegrees, light::DirectionRule rule) {
            const auto directions = light::directionsWithin(towards, halfAngleDegrees, rule);
            lights.emplace_back(light::DirectionBundle::of(directions, grid), grid);
        };
        add(scene.towardsKey, scene.keyHalfAngleDegrees, scene.keyDirections);
        if (!keptAround) add(scene.towardsViewer, light::hemisphereDegrees, scene.aroundDirections);
        sweepAll(lights, scene, grid, progress);
        if (progress.cancelled()) return std::nullopt;
        if (!keptAround) m_around = lights[1].takeSum();
        m_aroundScene = aroundScene;
        return LightVolume{grid.size, grid.firstMm, grid.spacingMm, bytesOf(lights[0].takeSum(), m_around)};
    }

private:
    /// Puts an entry first, in the place of one of its coarseness. Two stay.
    template <typename Kept>
    static Kept& keep(std::list<Kept>& all, Kept made) {
        constexpr std::size_t most = 2;
        all.remove_if([&](const Kept& other) { return other.coarseness == made.coarseness; });
        if (all.size() >= most) all.pop_back();
        all.push_front(std::move(made));
        return all.front();
    }

    /// Extinctions of the whole volume.
    struct Classified {
        Classification otf;
        int coarseness;
        std::vector<float> extinctions;  ///< and spareFloats more
        RowMarks stale;                  ///< rows of voxels whose extinctions are those of another cut
    };

    /// What a cutting surface leaves of each place.
    struct LeftBySurface {
        CutSurface surface;
        int coarseness;
        std::vector<float> shares;
    };

    /// Puts the extinctions of the OTF first in m_classified. False if the work was cancelled.
    bool classify(const LightOtf& given, int coarseness, const light::LightGrid& grid, const Progress& progress) {
        const Classification& otf = given.classification;
        const auto found = std::ranges::find(m_classified, coarseness, &Classified::coarseness);
        const bool isNewest = found == m_classified.begin() && found != m_classified.end();
        if (!isNewest || found->otf != otf) m_aroundScene.reset();
        if (found != m_classified.end() && found->otf == otf) {
            m_classified.splice(m_classified.begin(), m_classified, found);
        } else {
            keep(m_classified, {otf, coarseness, std::vector<float>(grid.places() + light::spareFloats),
                                RowMarks(volume->geometry().size, true)});
        }
        Classified& kept = m_classified.front();
        if (!kept.stale.any()) return true;
        if (!makeExtinctions(given, kept, grid, progress)) return false;
        if (progress.cancelled()) return false;
        kept.stale = RowMarks(volume->geometry().size);
        return true;
    }

    /// False if the work was cancelled before any was made.
    bool makeExtinctions(const LightOtf& otf, Classified& kept, const light::LightGrid& grid,
                         const Progress& progress) const {
        if (!otf.classification.isTwoDimensional()) {
            m_extinction.make(kept.extinctions, kept.stale, otf.classification.curve(), grid, progress);
            return true;
        }
        const TwoDimensionalOtf& twoDimensional = *otf.classification.twoDimensional();
        std::optional<GradientLevels> made;
        if (otf.gradients == nullptr) {
            made = gradientLevels(filledVoxels(*volume), twoDimensional.largestGradient, Progress{{}, progress.cancel});
            if (!made) return false;
        }
        const GradientLevels& levels = made ? *made : *otf.gradients;
        m_extinction.make(kept.extinctions, kept.stale, twoDimensional, levels, grid, progress);
        return true;
    }

    void sweepAll(std::vector<SweptLight>& lights, const LightScene& scene, const light::LightGrid& grid,
                  const Progress& progress) {
        const RenderedShares shares(scene.rendered, grid.spacingMm);
        std::vector<float> cut;
        if (!shares.everywhere()) cut = renderedExtinctions(shares, scene.coarseness, grid);
        light::GridExtinctions extinctions{grid, shares.everywhere() ? m_classified.front().extinctions : cut, {}};
        std::vector<std::pair<const light::DirectionBundle*, SweptLight*>> jobs;
        bool alongX = false;
        for (SweptLight& light : lights)
            for (const light::DirectionBundle& bundle : light.bundles) {
                jobs.emplace_back(&bundle, &light);
                alongX = alongX || bundle.alongX();
            }
        if (alongX) extinctions.yFastest = light::withYFastest(extinctions.xFastest, grid);
        ProgressCount count(progress, jobs.size());
        parallelFor(LoopRange<std::size_t>(0, jobs.size(), 1), [&](const auto& part) {
            for (std::size_t i = part.begin(); i < part.end(); ++i) {
                const auto& [bundle, light] = jobs[i];
                light->add(*bundle, bundle->sweep(extinctions, scene.attenuation, progress));
                count.oneDone();
            }
        });
    }

    /// Calls forRow(y, z, the row's first place) for each row of places.
    template <typename ForRow>
    static void forRowsOf(const light::LightGrid& grid, const ForRow& forRow) {
        parallelFor(0, grid.size[2], [&](int z) {
            for (int y = 0; y < grid.size[1]; ++y)
                forRow(y, z, (std::int64_t{z} * grid.size[1] + y) * std::int64_t{grid.size[0]});
        });
    }

    /// The extinctions that remain if only a part of the volume is rendered.
    [[nodiscard]] std::vector<float> renderedExtinctions(const RenderedShares& shares, int coarseness,
                                                         const light::LightGrid& grid) {
        std::vector<float> rendered = m_classified.front().extinctions;
        const float* const left = shares.surface() ? leftBySurface(shares, coarseness, grid).data() : nullptr;
        forRowsOf(grid, [&](int y, int z, std::int64_t first) {
            float* const row = rendered.data() + first;
            shares.multiplyRowByFaces(grid.gridMm(0, y, z), grid.spacingMm[0], grid.size[0], row);
            for (int x = 0; left != nullptr && x < grid.size[0]; ++x) row[x] *= left[first + x];
        });
        return rendered;
    }

    /// What the surface leaves of all places.
    const std::vector<float>& leftBySurface(const RenderedShares& shares, int coarseness,
                                            const light::LightGrid& grid) {
        const auto found = std::ranges::find(m_surfaces, coarseness, &LeftBySurface::coarseness);
        if (found != m_surfaces.end() && found->surface == *shares.surface()) return found->shares;
        LeftBySurface made{*shares.surface(), coarseness, std::vector<float>(grid.places())};
        forRowsOf(grid, [&](int y, int z, std::int64_t first) {
            shares.surfaceShares(grid.gridMm(0, y, z), grid.spacingMm[0], grid.size[0], made.shares.data() + first);
        });
        return keep(m_surfaces, std::move(made)).shares;
    }

    light::CoarseExtinction m_extinction;
    std::list<Classified> m_classified;       ///< the newest first, each of another coarseness
    std::list<LeftBySurface> m_surfaces;      ///< the newest first, each of another coarseness
    std::optional<LightScene> m_aroundScene;  ///< the scene of m_around, without its key light
    std::vector<std::uint16_t> m_around;      ///< 256ths of a level
};

LightSweep::LightSweep(std::shared_ptr<const Volume> volume) : m_parts(std::make_unique<Parts>(std::move(volume))) {}
LightSweep::~LightSweep() = default;
LightSweep::LightSweep(LightSweep&&) noexcept = default;
LightSweep& LightSweep::operator=(LightSweep&&) noexcept = default;
const std::shared_ptr<const Volume>& LightSweep::volume() const { return m_parts->volume; }

void LightSweep::setCut(std::shared_ptr<const Volume> volume, const RowMarks& masked) {
    m_parts->setCut(std::move(volume), masked);
}

std::optional<LightVolume> LightSweep::lightVolume(const LightOtf& otf, const LightScene& scene,
                                                   const Progress& progress) {
    check(scene);
    return m_parts->make(otf, scene, progress);
}

}  // namespace echolucent
