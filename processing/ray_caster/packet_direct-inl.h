// Direct volume rendering of a packet of rays, front to back: Petersch 2005, eqs. 2 and 3.
#include <optional>

#include "processing/picture/reaching_light.h"
#include "processing/ray_caster/packet_gathered-inl.h"
#include "processing/ray_caster/packet_plain-inl.h"
#include "processing/ray_caster/packet_two_dimensional-inl.h"

#include <hwy/contrib/math/math-inl.h>

#if defined(ECHOLUCENT_PACKET_DIRECT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_DIRECT_INL
#undef ECHOLUCENT_PACKET_DIRECT_INL
#else
#define ECHOLUCENT_PACKET_DIRECT_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// If `isTwoDimensional`, KernelJob::twoDimensional gives opacities, else KernelJob::table. Each kernel knows its own
/// way only.
template <typename Voxel, bool isTwoDimensional>
class DirectKernel {
public:
    explicit DirectKernel(const KernelJob<Voxel>& job) : m_job(job), m_colours(job.table->colours()) {
        std::fill_n(m_half, lanes, 2.0f);
        m_rich = job.light != nullptr || job.depthTint != nullptr || !job.picture->depthMm.empty();
    }

    void cast(DirectRays<Voxel>& rays) {
        m_rays = &rays;
        const Packet<Voxel>& packet = rays.packet;
        const std::int64_t common = packet.longestCommonRun();
        if (common == 0) rays.kept = nullptr;  // samples are kept only if all rays go together
        const std::optional<PlainCuts> cuts = plainCuts();
        if (cuts)
            add(ofAlive(cuts->head));
        else
            castCut(packet.rays().head);
        for (std::int64_t next = packet.first(); next < packet.last();) {
            const std::int64_t empty = mayJump() ? packet.emptyFrom(next) : 0;
            if (empty > 0) {
                if (rays.light) passEmpty(next, empty, common > 0);
                next += empty;
            } else if (common > 0) {
                const std::int64_t done = castRun(packet.run(next, common, -1));
                if (done == 0) break;
                next += done;
            } else {
                const std::int64_t end = std::min(next + packet.longestSingleRun(), packet.last());
                for (int lane = 0; lane < lanes; ++lane) castAlone(lane, next, end);
                next = end;
            }
            if (!anyAlive()) return;
        }
        if (cuts)
            add(ofAlive(cuts->tail));
        else
            castCut(packet.rays().tail);
    }

private:
    [[nodiscard]] bool mayJump() const { return m_job.distances != nullptr && m_rays->kept == nullptr; }

    /// Casts the part of a step at the beginning or the end of each ray.
    void castCut(const CutSteps<lanes>& cut) {
        bool any = false;
        for (int i = 0; i < lanes; ++i) any = any || cut.length[i] > 0.0;
        if (!any) return;
        const Run<Voxel> all = m_rays->packet.run(cut, -1);
        if (all.near) {
            blendCut(all, cut);
            return;
        }
        for (int lane = 0; lane < lanes; ++lane)
            if (cut.length[lane] > 0.0) blendCut(m_rays->packet.run(cut, lane), cut);
    }

    HWY_NOINLINE void blendCut(const Run<Voxel>& run, const CutSteps<lanes>& cut) {
        prepareLanes(cut.at, 0.0);
        const Floats floats;
        Blend blend{set(0.0f), set(0.0f), set(0.0f), set(0.0f), set(-1.0f)};
        const auto number = set(0.0f);
        const auto alive = hn::Lt(blend.opacity, hn::Load(floats, m_limit));
        const auto position = sampled(run, run.at(number), run.inRange(number));
        const auto units =
            hn::Mul(inFloats([&](Doubles, int i) { return load(cut.length + i); }), set(m_job.stepUnits));
        const RichStep step{number, position, opacityOfPart(run, position, cut, units), units,
                            run.volume.presence != nullptr};
        auto shares = m_rays->cutFaces.shares();
        blendRich(run, step, alive, shares, blend);
        m_rays->cutFaces.setShares(shares);
        add(blend);
    }

    /// Adds samples first ... last - 1 of one ray.
    void castAlone(int lane, std::int64_t first, std::int64_t last) {
        for (std::int64_t next = first; next < last;) {
            const std::int64_t done = castRun(m_rays->packet.run(next, last - next, lane));
            if (done == 0) return;
            next += done;
        }
    }

    /// Returns the number of samples done. If the rest of the run shows nothing, because its rays have ended or empty
    /// space begins, the rest does not count. 0 if its rays show nothing from `first` on.
    HWY_NOINLINE std::int64_t castRun(const Run<Voxel>& run) {
        for (int i = 0; i < lanes; ++i) m_middle[i] = static_cast<double>(run.first) + 0.5;
        prepareLanes(m_middle, 1.0);
        const Floats floats;
        const bool stored = prepareKept(run);
        if constexpr (!isTwoDimensional)
            if (m_job.colourBends != nullptr) return castPlainly(run, stored);
        Blend blend{set(0.0f), set(0.0f), set(0.0f), set(0.0f), set(-1.0f)};
        const auto limit = hn::Load(floats, m_limit);
        std::int64_t block = 0;
        for (; block < run.count; block += blockSize) {
            const auto alive = hn::Lt(blend.opacity, limit);
            if (hn::AllFalse(floats, hn::And(alive, hn::Gt(run.end, set(static_cast<float>(block)))))) break;
            if (endsAt(run, block)) break;
            const std::int64_t last = std::min(run.count, block + blockSize);
            if (last == block + blockSize)
                blendGroup<static_cast<int>(blockSize)>(run, block, stored, alive, blend);
            else
                // Runs of single rays may be shorter than a block.
                for (std::int64_t i = block; i < last; ++i) blendGroup<1>(run, i, stored, alive, blend);
        }
        add(blend);
        return done(run, block, stored);
    }
    /// Adds samples i ... i + group - 1. Each stage handles all samples before the next stage begins. So the processor
    /// has other samples to begin while one waits for its voxels.
    template <int group>
    HWY_INLINE void blendGroup(const Run<Voxel>& run, std::int64_t i, bool stored, LaneMask alive, Blend& blend) {
        const Floats floats;
        const bool borders = bordersOn(run, i / blockSize * blockSize);
        FloatVector position[group], opacity[group];
        positionsOf<group>(run, i, stored, position);
        auto most = set(0.0f);
        for (int k = 0; k < group; ++k) {
            const auto number = set(static_cast<float>(i + k));
            opacity[k] = opacityOf(run, number, position[k], alive);
            most = hn::Max(most, opacity[k]);
        }
        const auto units = set(m_job.stepUnits);
        // With a curve that clears fluid, half of the samples show nothing.
        const bool clear = hn::AllFalse(floats, hn::Gt(most, set(0.0f)));
        if (clear && !m_rays->light) return;
        auto shares = m_rays->cutFaces.shares();
        if (clear && !borders && hn::AllFalse(floats, hn::Gt(shares, set(0.0f)))) return;
        for (int k = 0; k < group; ++k) {
            const RichStep step{set(static_cast<float>(i + k)), position[k], opacity[k], units, borders};
            blendRich(run, step, alive, shares, blend);
        }
        m_rays->cutFaces.setShares(shares);
    }
    /// The table positions of samples i ... i + group - 1.
    template <int group>
    HWY_INLINE void positionsOf(const Run<Voxel>& run, std::int64_t i, bool stored, FloatVector (&position)[group]) {
        const auto number = [&](int k) { return set(static_cast<float>(i + k)); };
        if (m_rays->kept != nullptr) {
            for (int k = 0; k < group; ++k) position[k] = positionOf(run, i + k, number(k), stored);
            return;
        }
        if constexpr (std::is_same_v<Voxel, std::uint8_t>) {
            CubeOfBytes cube[group];
            const Cubes<Voxel>& volume = run.volume;
            for (int k = 0; k < group; ++k) {
                const Position exact = run.at(number(k)), at = m_job.nearest ? nearestVoxel(exact) : exact;
                cube[k] =
                    cubeOfBytes(volume.cubes, volume.sliceStride, volume.offsetOf(at), at, run.inRange(number(k)));
            }
            for (int k = 0; k < group; ++k)
                position[k] = tablePositionOf<Voxel>(hn::Mul(meanOf(cube[k]), set(1.0f / byteScale)), m_job.toTable);
        } else {
            for (int k = 0; k < group; ++k) position[k] = sampled(run, run.at(number(k)), run.inRange(number(k)));
        }
    }
    /// Ends the run behind sample `behind` - 1, or at its own end. Returns how many of its samples were used.
    std::int64_t done(const Run<Voxel>& run, std::int64_t behind, bool stored) {
        const std::int64_t samples = std::min(behind, run.count);
        if (m_rays->kept != nullptr && !stored)
            m_rays->kept->samples.resize(static_cast<std::size_t>((run.first + samples - m_rays->kept->first) * lanes));
        return samples;
    }
    /// Whether data may end in the block that begins at a sample of a run.
    [[nodiscard]] bool bordersOn(const Run<Voxel>& run, std::int64_t sample) const {
        if (run.volume.presence == nullptr) return false;
        return m_rays->packet.bordersOn(run.first + sample, blockSize);
    }
    [[nodiscard]] bool endsAt(const Run<Voxel>& run, std::int64_t sample) const {
        // Shorter jumps cost more than they save.
        const bool atCheck = sample % (2 * blockSize) == 0 && sample > 0;
        return atCheck && mayJump() && m_rays->packet.emptyFrom(run.first + sample) > 0;
    }

    /// The cut steps of all rays, front and back. The kernel computes them side by side: while one waits for its
    /// voxels, the other goes on.
    struct PlainCuts {
        Blend head, tail;
    };
    std::optional<PlainCuts> plainCuts() const {
        const Packet<Voxel>& packet = m_rays->packet;
        if (isTwoDimensional || m_job.colourBends == nullptr) return std::nullopt;
        const auto head = packet.run(packet.rays().head, -1), tail = packet.run(packet.rays().tail, -1);
        if (!head.near || !tail.near) return std::nullopt;
        return PlainCuts{plainCut(head, packet.rays().head), plainCut(tail, packet.rays().tail)};
    }
    /// The blend without the rays that have ended.
    Blend ofAlive(const Blend& blend) const {
        const auto share = inFloats([&](Doubles, int i) {
            const auto left = load(m_rays->gathered.transmittance + i), zero = setDouble(0.0);
            const auto alive = hn::And(hn::Gt(left, zero), hn::Ge(left, setDouble(m_job.endTransmittance)));
            return hn::IfThenElse(alive, setDouble(1.0), zero);
        });
        const auto alive = hn::Gt(share, set(0.5f));
        const auto kept = [&](FloatVector value) { return hn::IfThenElseZero(alive, value); };
        return {kept(blend.opacity), kept(blend.red), kept(blend.green), kept(blend.blue), blend.half};
    }
    HWY_INLINE Blend plainCut(const Run<Voxel>& run, const CutSteps<lanes>& cut) const {
        const auto zero = set(0.0f);
        const auto present = run.inRange(zero);
        const auto position = sampled(run, run.at(zero), present);
        auto opacity = hn::IfThenElseZero(present, opacityOfPart(position, cut));
        if (run.volume.presence != nullptr)
            opacity = hn::Mul(opacity, coverageOf(presenceOf(run, zero, present), m_job.nearest));
        constexpr float white = TransferTable::intervals;
        PlainSums sums{opacity, hn::Mul(opacity, position), {zero, zero, zero}};
        for (int i = 0; i < ColourBends::count; ++i)
            sums.beyond[i] = hn::Mul(opacity, hn::Max(hn::Sub(position, set(white * ColourBends::at(i))), zero));
        return blendOf(*m_job.colourBends, sums, white);
    }
    /// 1 - (1 - opacity)^length.
    HWY_INLINE FloatVector opacityOfPart(FloatVector position, const CutSteps<lanes>& cut) const {
        const auto length = inFloats([&](Doubles, int i) { return load(cut.length + i); });
        const auto extinction = entryAt(m_job.table->extinctions(), position);
        return hn::Neg(hn::Expm1(Floats(), hn::Neg(hn::Mul(length, extinction))));
    }

    std::int64_t castPlainly(const Run<Voxel>& run, bool stored) {
        const bool keeps = m_rays->kept != nullptr;
        constexpr bool bytes = std::is_same_v<Voxel, std::uint8_t>;
        const float positionOfValue = bytes ? m_job.toTable / byteScale : 1.0f;
        const float white = TransferTable::intervals / positionOfValue;
        const PlainRun<Voxel> from{run,
                                   bytes ? m_job.byteOpacities->data() : m_job.table->opacities(),
                                   m_job.colourBends->any ? ColourBends::count : 0,
                                   m_job.toTable,
                                   bytes ? m_job.byteOpacities->firstVisible() * (byteScale / ByteOpacities::perLevel)
                                         : m_job.table->firstVisible(),
                                   white,
                                   bytes && white < 255.0f * byteScale,
                                   m_job.nearest,
                                   m_job.keptPerPosition * positionOfValue,
                                   keeps ? keptAt(run, 0) : nullptr,
                                   hn::Load(Floats(), m_limit)};
        const auto ends = [&](std::int64_t sample) { return endsAt(run, sample); };
        const auto zero = set(0.0f);
        PlainSums sums{zero, zero, {zero, zero, zero}};
        const Keeping keeping = !keeps ? Keeping::none : stored ? Keeping::reuse : Keeping::keep;
        const auto borders = [&](std::int64_t sample) { return bordersOn(run, sample); };
        const std::int64_t behind = run.volume.presence == nullptr ? blendRun<false>(from, keeping, ends, borders, sums)
                                                                   : blendRun<true>(from, keeping, ends, borders, sums);
        add(blendOf(*m_job.colourBends, sums, white));
        return done(run, behind, stored);
    }

    /// For samples at `at` + i * perSample steps, prepares the opacity of a run above which a ray ends, the opacity at
    /// which the pixel's opacity is one half, and depths.
    void prepareLanes(const double (&at)[lanes], double perSample) {
        const double(&transmittance)[lanes] = m_rays->gathered.transmittance;
        for (int i = 0; i < lanes; ++i) {
            const bool ended = transmittance[i] <= 0.0 || transmittance[i] < m_job.endTransmittance;
            const double limit = 1.0 - m_job.endTransmittance / (ended ? 1.0 : transmittance[i]);
            m_limit[i] = static_cast<float>(ended ? -1.0 : limit);
        }
        if (!m_rich) return;
        const RayBundle<lanes>& rays = m_rays->packet.rays();
        for (int i = 0; i < lanes; ++i) {
            m_half[i] = transmittance[i] > 0.5 ? static_cast<float>(1.0 - 0.5 / transmittance[i]) : 2.0f;
            m_before[i] = static_cast<float>(transmittance[i]);
            m_depthMm[i] = rays.depthMm[i] + rays.depthStepMm[i] * at[i];
            m_depthStepMm[i] = rays.depthStepMm[i] * perSample;
        }
        if (m_job.depthTint == nullptr) return;
        const DepthTint& depth = *m_job.depthTint;
        for (int i = 0; i < lanes; ++i) {
            m_tintStart[i] = static_cast<float>((m_depthMm[i] - depth.nearDepthMm) * depth.perMm);
            m_tintStep[i] = static_cast<float>(m_depthStepMm[i] * depth.perMm);
        }
    }
    [[nodiscard]] bool anyAlive() const {
        const RayBundle<lanes>& rays = m_rays->packet.rays();
        double least, most;
        findRange([&](int i) { return hn::Lt(load(rays.enter + i), load(rays.leave + i)); },
                  [&](int i) { return load(m_rays->gathered.transmittance + i); }, least, most);
        return most > 0.0 && most >= m_job.endTransmittance;
    }

    /// Whether all samples of the run are kept already. If not, makes room for them.
    bool prepareKept(const Run<Voxel>& run) {
        if (m_rays->kept == nullptr) return false;
        if (m_rays->kept->samples.empty()) {
            m_rays->kept->first = run.first;
            // Reserve all that may be needed. Growth would take up to twice as much.
            m_rays->kept->samples.reserve(static_cast<std::size_t>((m_rays->packet.last() - run.first) * lanes));
        }
        const auto last = static_cast<std::size_t>((run.first + run.count - m_rays->kept->first) * lanes);
        if (m_rays->kept->samples.size() >= last) return true;
        m_rays->kept->samples.resize(last);
        return false;
    }
    [[nodiscard]] std::uint16_t* keptAt(const Run<Voxel>& run, std::int64_t i) const {
        return m_rays->kept->samples.data() + (run.first + i - m_rays->kept->first) * lanes;
    }

    HWY_INLINE FloatVector sampled(const Run<Voxel>& run, const Position& at, LaneMask active) const {
        return tablePositionAt(run.volume, m_job.nearest ? nearestVoxel(at) : at, m_job.toTable, active);
    }
    /// The table positions of sample i.
    HWY_INLINE FloatVector positionOf(const Run<Voxel>& run, std::int64_t i, FloatVector number, bool stored) const {
        if (m_rays->kept == nullptr) return sampled(run, run.at(number), run.inRange(number));
        std::uint16_t* const kept = keptAt(run, i);
        // Plain pictures keep values brighter than white too.
        if (stored)
            return hn::Min(keptValue(kept, m_job.keptPerPosition), set(static_cast<float>(TransferTable::intervals)));
        const auto position = sampled(run, run.at(number), run.inRange(number));
        keepValue(position, m_job.keptPerPosition, kept);
        return position;
    }

    /// The opacity of sample `number` of a run in a step of the ray.
    HWY_INLINE FloatVector opacityOf(const Run<Voxel>& run, FloatVector number, FloatVector position,
                                     LaneMask alive) const {
        if constexpr (isTwoDimensional)
            return twoDimensionalOpacity(m_job, run, number, position, hn::And(alive, run.inRange(number)),
                                         set(m_job.stepUnits));
        else
            return opacityAt(position);
    }
    /// The opacity of a part of a step, `units` long.
    HWY_INLINE FloatVector opacityOfPart(const Run<Voxel>& run, FloatVector position, const CutSteps<lanes>& cut,
                                         FloatVector units) const {
        const auto number = set(0.0f);
        if constexpr (isTwoDimensional)
            return twoDimensionalOpacity(m_job, run, number, position, run.inRange(number), units);
        else
            return opacityOfPart(position, cut);
    }
    /// `position` is a table position, 0 ... intervals.
    HWY_INLINE FloatVector opacityAt(FloatVector position) const {
        if (m_job.byteOpacities != nullptr)
            return loadEntries(m_job.byteOpacities->data(),
                               rounded(hn::Mul(position, set(ByteOpacities::perLevel / m_job.toTable))));
        return entryAt(m_job.table->opacities(), position);
    }

    /// The presence of data at sample `number` of a run.
    HWY_INLINE FloatVector presenceOf(const Run<Voxel>& run, FloatVector number, LaneMask active) const {
        const Position exact = run.at(number), place = m_job.nearest ? nearestVoxel(exact) : exact;
        return presenceAt(run.volume, run.volume.offsetOf(place), place, active);
    }

    /// A sample of each ray.
    struct RichStep {
        FloatVector number, position, opacity;
        FloatVector units;  ///< length of the step
        bool borders;       ///< whether data may end near it
    };

    /// Adds samples with light, tint and depth. `shares` are those of the cut's face (CutFaces).
    HWY_INLINE void blendRich(const Run<Voxel>& run, const RichStep& step, LaneMask alive, FloatVector& shares,
                              Blend& blend) {
        const Floats floats;
        const auto inRange = run.inRange(step.number);
        auto opacity = hn::IfThenElseZero(hn::And(alive, inRange), step.opacity);
        auto border = set(0.0f);
        if (step.borders) {
            const auto presence = presenceOf(run, step.number, inRange);
            opacity = hn::Mul(opacity, coverageOf(presence, m_job.nearest));
            border = borderOf(presence);
        }
        auto unlit = border;
        if (m_rays->light && (step.borders || !hn::AllFalse(floats, hn::Gt(shares, set(0.0f)))))
            unlit = CutFaces::pass(step.units, step.opacity, border, inRange, shares);
        // With a curve that clears fluid, half of the samples show nothing.
        if (hn::AllFalse(floats, hn::Gt(opacity, set(0.0f)))) return;
        const auto added = hn::NegMulAdd(opacity, blend.opacity, opacity);
        Colour colour = m_colours.at(step.position);
        if (m_rays->light) light(run, step.number, hn::Mul(added, hn::Load(floats, m_before)), unlit, colour);
        if (m_job.depthTint != nullptr) tint(step.number, colour);
        addSample(added, colour, step.number, blend);
    }

    /// `seen` is how much the samples add to their pixels' opacity.
    HWY_INLINE void light(const Run<Voxel>& run, FloatVector number, FloatVector seen, FloatVector unlit,
                          Colour& colour) const {
        const Light<Voxel>& light = *m_rays->light;
        const auto worth = hn::Ge(seen, set(m_job.worthGradient));
        constexpr auto share = static_cast<float>(leastReachedShare);
        const auto reached = hn::Ge(seen, set(m_job.worthGradient * share));
        const LitBy by = light.at(run, number, worth, reached);
        colour = {light.lit(colour.red, by.red, unlit, 0), light.lit(colour.green, by.green, unlit, 1),
                  light.lit(colour.blue, by.blue, unlit, 2)};
    }

    /// Passes `count` empty samples from `first` on. If data may end, it looks for edges in the last block only: edges
    /// farther back hardly matter any more.
    HWY_NOINLINE void passEmpty(std::int64_t first, std::int64_t count, bool together) {
        const std::int64_t looked = m_job.borders != nullptr ? blockSize : 0, behind = first + count - looked;
        const RayBundle<lanes>& rays = m_rays->packet.rays();
        const auto samples = inFloats([&](Doubles, int i) {
            const auto limited = [&](const double* number) {
                return hn::Min(hn::Max(load(number + i), setDouble(static_cast<double>(first))),
                               setDouble(static_cast<double>(behind)));
            };
            return hn::Sub(limited(rays.last), limited(rays.first));
        });
        m_rays->cutFaces.passClear(samples, m_job.stepUnits);
        if (looked == 0 || behind + looked > m_rays->packet.last()) return;
        if (together) return passEmpty(m_rays->packet.run(behind, looked, -1));
        for (int lane = 0; lane < lanes; ++lane)
            for (std::int64_t i = 0; i < looked; ++i) passEmpty(m_rays->packet.run(behind + i, 1, lane));
    }
    void passEmpty(const Run<Voxel>& run) {
        const bool borders = run.volume.presence != nullptr;
        auto shares = m_rays->cutFaces.shares();
        for (std::int64_t i = 0; i < run.count; ++i) {
            const auto number = set(static_cast<float>(i)), zero = set(0.0f);
            const auto inRange = run.inRange(number);
            const auto border = borders ? borderOf(presenceOf(run, number, inRange)) : zero;
            (void)CutFaces::pass(set(m_job.stepUnits), zero, border, inRange, shares);
        }
        m_rays->cutFaces.setShares(shares);
    }

    HWY_INLINE void addSample(FloatVector added, const Colour& colour, FloatVector number, Blend& blend) {
        const Floats floats;
        blend.opacity = hn::Add(blend.opacity, added);
        blend.red = hn::MulAdd(added, colour.red, blend.red);
        blend.green = hn::MulAdd(added, colour.green, blend.green);
        blend.blue = hn::MulAdd(added, colour.blue, blend.blue);
        const auto reached = hn::And(hn::Ge(blend.opacity, hn::Load(floats, m_half)), hn::Lt(blend.half, set(0.0f)));
        blend.half = hn::IfThenElse(reached, number, blend.half);
    }

    HWY_INLINE void tint(FloatVector number, Colour& colour) const {
        const Floats floats;
        const auto along = hn::MulAdd(number, hn::Load(floats, m_tintStep), hn::Load(floats, m_tintStart));
        const auto share = hn::Min(hn::Max(along, set(0.0f)), set(1.0f));
        const auto tinted = [&](FloatVector channel, std::size_t c) {
            return hn::Mul(channel, hn::MulAdd(share, set(m_job.depthTint->change[c]), set(m_job.depthTint->near[c])));
        };
        colour = {tinted(colour.red, 0), tinted(colour.green, 1), tinted(colour.blue, 2)};
    }

    /// Composites a run behind the light gathered so far.
    void add(const Blend& blend) {
        const Floats floats;
        alignas(64) float opacity[lanes], colour[3][lanes], half[lanes];
        hn::Store(blend.opacity, floats, opacity);
        hn::Store(blend.red, floats, colour[0]);
        hn::Store(blend.green, floats, colour[1]);
        hn::Store(blend.blue, floats, colour[2]);
        for (int channel = 0; channel < 3; ++channel)
            for (int i = 0; i < lanes; ++i)
                m_rays->gathered.colour[channel][i] +=
                    m_rays->gathered.transmittance[i] * static_cast<double>(colour[channel][i]);
        for (int i = 0; i < lanes; ++i)
            m_rays->gathered.transmittance[i] -= m_rays->gathered.transmittance[i] * static_cast<double>(opacity[i]);
        if (!m_rich) return;
        hn::Store(blend.half, floats, half);
        for (int i = 0; i < lanes; ++i)
            if (half[i] >= 0.0f)
                m_rays->gathered.depthMm[i] =
                    static_cast<float>(m_depthMm[i] + m_depthStepMm[i] * static_cast<double>(half[i]));
    }

    const KernelJob<Voxel>& m_job;
    Colours m_colours;
    bool m_rich = false;
    DirectRays<Voxel>* m_rays = nullptr;
    alignas(64) float m_limit[lanes], m_half[lanes], m_before[lanes], m_tintStart[lanes], m_tintStep[lanes];
    alignas(64) double m_middle[lanes], m_depthMm[lanes], m_depthStepMm[lanes];
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
