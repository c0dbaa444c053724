// Direct volume rendering of a packet of rays, front to back: Petersch 2005, eqs. 2 and 3.
#include <limits>
#include <optional>

#include "processing/ray_caster/packet_colour-inl.h"

#include <hwy/contrib/math/math-inl.h>

#if defined(ECHOLUCENT_PACKET_DIRECT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_DIRECT_INL
#undef ECHOLUCENT_PACKET_DIRECT_INL
#else
#define ECHOLUCENT_PACKET_DIRECT_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// What rays have gathered. In double, and of each run its opacity, not its transmittance: a product of many factors
/// near 1 keeps its digits.
struct Gathered {
    alignas(64) double transmittance[lanes];
    alignas(64) double colour[3][lanes];
    alignas(64) float depthMm[lanes];

    Gathered() {
        for (int i = 0; i < lanes; ++i) {
            transmittance[i] = 1.0;
            colour[0][i] = colour[1][i] = colour[2][i] = 0.0;
            depthMm[i] = std::numeric_limits<float>::infinity();
        }
    }
};

/// Of a run alone, in shares of the light that reaches it.
struct Blend {
    FloatVector opacity, red, green, blue;
    FloatVector half;  ///< the sample at which the pixel's opacity reaches one half
};

/// A packet of rays on its way.
template <typename Voxel>
struct DirectRays {
    Packet<Voxel> packet;
    KeptSamples::Packet* kept;  ///< null: samples are not kept
    std::optional<Light<Voxel>> light;
    Gathered gathered;

    DirectRays(const KernelJob<Voxel>& job, int column, int row, KeptSamples::Packet* keptSamples)
        : packet(job, column, row), kept(keptSamples) {
        if (job.light != nullptr && !packet.empty()) light.emplace(job, packet.rays());
    }
};

template <typename Voxel>
class DirectKernel {
public:
    explicit DirectKernel(const KernelJob<Voxel>& job) : m_job(job), m_colours(job.table->colours()) {
        m_rich = job.light != nullptr || job.depthTint != nullptr || !job.picture->depthMm.empty();
    }

    void cast(DirectRays<Voxel>& rays) {
        m_rays = &rays;
        const Packet<Voxel>& packet = rays.packet;
        const std::int64_t common = packet.longestCommonRun();
        if (common == 0) rays.kept = nullptr;  // samples are kept of all rays together
        castCut(packet.rays().head);
        for (std::int64_t next = packet.first(); next < packet.last();) {
            const std::int64_t empty = mayJump() ? packet.emptyFrom(next) : 0;
            if (empty > 0) {
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
        castCut(packet.rays().tail);
    }

private:
    [[nodiscard]] bool mayJump() const { return m_job.distances != nullptr && m_rays->kept == nullptr; }

    /// The part of a step at the begin or the end of each ray.
    void castCut(const CutSteps<lanes>& cut) {
        bool any = false;
        for (int i = 0; i < lanes; ++i) any = any || cut.length[i] > 0.0;
        if (!any) return;
        if (m_rays->packet.longestCommonRun() > 0) {
            blendCut(m_rays->packet.run(cut, -1), cut);
            return;
        }
        for (int lane = 0; lane < lanes; ++lane)
            if (cut.length[lane] > 0.0) blendCut(m_rays->packet.run(cut, lane), cut);
    }

    HWY_NOINLINE void blendCut(const Run<Voxel>& run, const CutSteps<lanes>& cut) {
        prepareLanes(cut.at, 0.0);
        const Floats floats;
        alignas(64) float length[lanes];
        for (int i = 0; i < lanes; ++i) length[i] = static_cast<float>(cut.length[i]);
        Blend blend{set(0.0f), set(0.0f), set(0.0f), set(0.0f), set(-1.0f)};
        const auto number = set(0.0f);
        const auto alive = hn::Lt(blend.opacity, hn::Load(floats, m_limit));
        const auto position = sampled(run, run.at(number), run.inRange(number));
        // 1 - (1 - opacity)^length.
        const auto extinction = entryAt(m_job.table->extinctions(), hn::Max(position, number));
        const auto part = hn::Neg(hn::Expm1(floats, hn::Neg(hn::Mul(hn::Load(floats, length), extinction))));
        blendRich(run, number, position, part, alive, blend);
        add(blend);
    }

    /// Samples first ... last - 1 of one ray.
    void castAlone(int lane, std::int64_t first, std::int64_t last) {
        for (std::int64_t next = first; next < last;) {
            const std::int64_t done = castRun(m_rays->packet.run(next, last - next, lane));
            if (done == 0) return;
            next += done;
        }
    }

    /// The number of samples done: all of the run, or up to where nothing more of it shows; 0: nor anything behind it.
    HWY_NOINLINE std::int64_t castRun(const Run<Voxel>& run) {
        for (int i = 0; i < lanes; ++i) m_middle[i] = static_cast<double>(run.first) + 0.5;
        prepareLanes(m_middle, 1.0);
        const Floats floats;
        const bool stored = prepareKept(run);
        Blend blend{set(0.0f), set(0.0f), set(0.0f), set(0.0f), set(-1.0f)};
        const auto limit = hn::Load(floats, m_limit);
        auto before = set(-1.0f);
        if (m_job.preIntegration != nullptr) before = endPosition(run, set(-0.5f), run.inRange(set(0.0f)));
        std::int64_t block = 0;
        for (; block < run.count; block += blockSize) {
            const auto alive = hn::Lt(blend.opacity, limit);
            if (hn::AllFalse(floats, hn::And(alive, hn::Gt(run.end, set(static_cast<float>(block)))))) break;
            // Shorter jumps cost more than they save.
            const bool atCheck = block % (2 * blockSize) == 0 && block > 0;
            if (atCheck && mayJump() && m_rays->packet.emptyFrom(run.first + block) > 0) break;
            const std::int64_t last = std::min(run.count, block + blockSize);
            const bool full = run.full && hn::AllTrue(floats, alive);
            if (m_job.preIntegration != nullptr)
                for (std::int64_t i = block; i < last; ++i) blendSegment(run, i, alive, before, blend);
            else if (m_rich)
                for (std::int64_t i = block; i < last; ++i) {
                    const auto number = set(static_cast<float>(i));
                    const auto position = positionOf(run, i, number, stored);
                    blendRich(run, number, position, opacityAt(hn::Max(position, set(0.0f))), alive, blend);
                }
            else if (full)
                for (std::int64_t i = block; i < last; ++i) blendSample<true>(run, i, alive, stored, blend);
            else
                for (std::int64_t i = block; i < last; ++i) blendSample<false>(run, i, alive, stored, blend);
        }
        add(blend);
        const std::int64_t done = std::min(block, run.count);
        if (m_rays->kept != nullptr && !stored)
            m_rays->kept->samples.resize(static_cast<std::size_t>((run.first + done - m_rays->kept->first) * lanes));
        return done;
    }

    /// For samples at `at` + i * perSample steps: a run's opacity above which a ray ends and at which the pixel's opacity is
    /// one half; depths.
    void prepareLanes(const double (&at)[lanes], double perSample) {
        const double (&transmittance)[lanes] = m_rays->gathered.transmittance;
        for (int i = 0; i < lanes; ++i) {
            const bool ended = transmittance[i] <= 0.0 || transmittance[i] < m_job.endTransmittance;
            const double limit = 1.0 - m_job.endTransmittance / (ended ? 1.0 : transmittance[i]);
            m_limit[i] = static_cast<float>(ended ? -1.0 : limit);
        }
        if (!m_rich && m_job.preIntegration == nullptr) return;
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
        double most = 0.0;
        for (int i = 0; i < lanes; ++i) {
            const bool isRay = m_rays->packet.rays().enter[i] < m_rays->packet.rays().leave[i];
            most = std::max(most, isRay ? m_rays->gathered.transmittance[i] : 0.0);
        }
        return most > 0.0 && most >= m_job.endTransmittance;
    }

    /// True where all samples of the run are kept already; else makes room for them.
    bool prepareKept(const Run<Voxel>& run) {
        if (m_rays->kept == nullptr) return false;
        if (m_rays->kept->samples.empty()) {
            m_rays->kept->first = run.first;
            // As much as there may be, not the twice as much that growth would take.
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
    /// Table positions of sample i, -1 where there is no data.
    HWY_INLINE FloatVector positionOf(const Run<Voxel>& run, std::int64_t i, FloatVector number, bool stored) const {
        if (m_rays->kept == nullptr) return sampled(run, run.at(number), run.inRange(number));
        const Floats floats;
        const Ints ints;
        const hn::Rebind<std::uint16_t, Floats> words;
        std::uint16_t* const kept = keptAt(run, i);
        if (stored) {
            const auto value = hn::PromoteTo(ints, hn::LoadU(words, kept));
            const auto position =
                hn::Mul(hn::ConvertTo(floats, value), set(1.0f / KeptSamples::perTablePosition));
            return hn::IfThenElse(hn::RebindMask(floats, hn::Eq(value, set(std::int32_t{KeptSamples::noData}))),
                                  set(-1.0f), position);
        }
        const auto position = sampled(run, run.at(number), run.inRange(number));
        const auto value = hn::NearestInt(hn::Mul(position, set(KeptSamples::perTablePosition)));
        const auto known = hn::IfThenElse(hn::Lt(value, hn::Zero(ints)), set(std::int32_t{KeptSamples::noData}), value);
        hn::StoreU(hn::DemoteTo(words, known), words, kept);
        return position;
    }

    /// position: 0 ... intervals.
    HWY_INLINE FloatVector opacityAt(FloatVector position) const {
        return entryAt(m_job.table->opacities(), position);
    }
    static HWY_INLINE FloatVector entryAt(const float* entries, FloatVector position) {
        const Floats floats;
        const auto left = truncated(position);
        return between(hn::GatherIndex(floats, entries, left), hn::GatherIndex(floats, entries + 1, left),
                       hn::Sub(position, hn::ConvertTo(floats, left)));
    }

    template <bool full>
    HWY_INLINE void blendSample(const Run<Voxel>& run, std::int64_t i, LaneMask alive, bool stored, Blend& blend) {
        const auto number = set(static_cast<float>(i));
        const auto position = positionOf(run, i, number, stored);
        const auto known = m_job.missing != nullptr ? hn::Max(position, set(0.0f)) : position;
        auto opacity = opacityAt(known);
        if (m_job.missing != nullptr) opacity = hn::IfThenElseZero(hn::Ge(position, set(0.0f)), opacity);
        if constexpr (!full) opacity = hn::IfThenElseZero(hn::And(alive, run.inRange(number)), opacity);
        // Half of the samples of a curve that clears fluid show nothing.
        if (hn::AllFalse(Floats(), hn::Gt(opacity, set(0.0f)))) return;
        const auto added = hn::NegMulAdd(opacity, blend.opacity, opacity);
        const Colour colour = m_colours.at(known);
        blend.opacity = hn::Add(blend.opacity, added);
        blend.red = hn::MulAdd(added, colour.red, blend.red);
        blend.green = hn::MulAdd(added, colour.green, blend.green);
        blend.blue = hn::MulAdd(added, colour.blue, blend.blue);
    }

    /// The same with light, tint and depth.
    HWY_INLINE void blendRich(const Run<Voxel>& run, FloatVector number, FloatVector position, FloatVector stepOpacity,
                              LaneMask alive, Blend& blend) {
        const Floats floats;
        const auto active = hn::And(hn::And(alive, run.inRange(number)), hn::Ge(position, set(0.0f)));
        position = hn::Max(position, set(0.0f));
        const auto opacity = hn::IfThenElseZero(active, stepOpacity);
        const auto added = hn::NegMulAdd(opacity, blend.opacity, opacity);
        Colour colour = m_colours.at(position);
        if (m_rays->light) {
            const Light<Voxel>& light = *m_rays->light;
            const auto seen = hn::Mul(added, hn::Load(floats, m_before));
            const auto worth = hn::Ge(seen, set(m_job.worthGradient));
            auto factor = set(light.even());
            if (!hn::AllFalse(floats, worth))
                factor = hn::IfThenElse(worth, light.factorAt(run, run.at(number), worth), factor);
            colour = {light.lit(colour.red, factor, 0), light.lit(colour.green, factor, 1),
                      light.lit(colour.blue, factor, 2)};
        }
        if (m_job.depthTint != nullptr) tint(number, colour);
        addSample(added, colour, number, blend);
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

    /// Table position at an end of a sample's segment, within the volume's box.
    HWY_INLINE FloatVector endPosition(const Run<Voxel>& run, FloatVector number, LaneMask active) const {
        Position at = run.at(number);
        IntVector* const components[3] = {&at.x, &at.y, &at.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double corner = static_cast<double>(run.corner[axis]);
            const auto place = [&](double cell) {
                return set(static_cast<std::int32_t>(std::clamp(cell - corner, -32767.0, 32767.0) * oneCell));
            };
            const double size = static_cast<double>(m_job.geometry.size[axis]);
            *components[axis] = hn::Min(hn::Max(*components[axis], place(0.5)), place(size + 0.5 - 1e-4));
        }
        return sampled(run, at, active);
    }

    HWY_INLINE void blendSegment(const Run<Voxel>& run, std::int64_t i, LaneMask alive, FloatVector& before,
                                 Blend& blend) {
        const auto number = set(static_cast<float>(i)), next = set(static_cast<float>(i + 1));
        const auto behind = endPosition(run, hn::Add(number, set(0.5f)), hn::Or(run.inRange(number), run.inRange(next)));
        const auto zero = set(0.0f);
        const auto frontData = hn::Ge(before, zero), backData = hn::Ge(behind, zero);
        const auto front = hn::Max(hn::IfThenElse(frontData, before, behind), zero);
        const auto back = hn::Max(hn::IfThenElse(backData, behind, before), zero);
        const auto active = hn::And(hn::And(alive, run.inRange(number)), hn::Or(frontData, backData));
        Colour colour{zero, zero, zero};
        const auto whole = segmentOpacity(front, back, colour);
        // The half of a step towards an end without data shows nothing.
        const auto half = hn::Sub(set(1.0f), hn::Sqrt(hn::Sub(set(1.0f), whole)));
        const auto opacity = hn::IfThenElseZero(active, hn::IfThenElse(hn::And(frontData, backData), whole, half));
        const auto added = hn::NegMulAdd(opacity, blend.opacity, opacity);
        if (m_job.depthTint != nullptr) tint(number, colour);
        addSample(added, colour, number, blend);
        before = behind;
    }

    HWY_INLINE FloatVector segmentOpacity(FloatVector front, FloatVector back, Colour& colour) const {
        const Floats floats;
        constexpr float scale = static_cast<float>(PreIntegration::intervals) / TransferTable::intervals;
        const auto a = hn::Mul(front, set(scale)), b = hn::Mul(back, set(scale));
        const auto apart = hn::Sub(b, a);
        const auto far = hn::Gt(hn::Abs(apart), set(PreIntegration::closest));
        const auto middle = hn::Mul(hn::Add(front, back), set(0.5f));
        colour = m_colours.at(middle);
        const auto point = opacityAt(middle);
        if (hn::AllFalse(floats, far)) return point;
        const auto perInterval = hn::Div(set(1.0f), hn::IfThenElse(far, apart, set(1.0f)));
        const auto mean = [&](int component) {
            return hn::Mul(hn::Sub(integralAt(b, component), integralAt(a, component)), perInterval);
        };
        const auto extinction = hn::Max(mean(0), set(0.0f));
        const auto visible = hn::And(far, hn::Gt(extinction, set(1e-12f)));
        const auto seen = hn::Div(mean(1), hn::IfThenElse(visible, extinction, set(1.0f)));
        const auto inside = hn::Min(hn::Max(hn::Mul(seen, set(1.0f / scale)), hn::Min(front, back)), hn::Max(front, back));
        colour = m_colours.at(hn::IfThenElse(visible, inside, middle));
        return hn::IfThenElse(far, hn::Neg(hn::Expm1(floats, hn::Neg(extinction))), point);
    }
    HWY_INLINE FloatVector integralAt(FloatVector position, int component) const {
        return entryAt(m_job.preIntegration->integrals(component), position);
    }

    /// Puts a run behind what the rays have gathered.
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
        if (!m_rich && m_job.preIntegration == nullptr) return;
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
