// The largest, smallest or mean intensity along the rays of a packet.
#include <limits>

#include "processing/ray_caster/packet_run-inl.h"

#if defined(ECHOLUCENT_PACKET_EXTREMES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_EXTREMES_INL
#undef ECHOLUCENT_PACKET_EXTREMES_INL
#else
#define ECHOLUCENT_PACKET_EXTREMES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// The rays' results so far.
struct Seen {
    alignas(64) double value[lanes];  ///< table position: largest, smallest, or sum
    alignas(64) double count[lanes];  ///< steps with data
    alignas(64) float depthMm[lanes];
};

template <typename Voxel>
class ExtremesKernel {
public:
    ExtremesKernel(const KernelJob<Voxel>& job, const Packet<Voxel>& packet) : m_job(job), m_packet(packet) {
        for (int i = 0; i < lanes; ++i) {
            m_seen.value[i] = m_seen.count[i] = 0.0;
            m_seen.depthMm[i] = std::numeric_limits<float>::infinity();
        }
    }

    void cast() {
        const std::int64_t common = m_packet.longestCommonRun();
        const std::int64_t length = common > 0 ? common : m_packet.longestSingleRun();
        addCut(m_packet.rays().head);
        for (int i = 0; i < lanes; ++i) m_weight[i] = 1.0f;
        for (std::int64_t first = m_packet.first(); first < m_packet.last(); first += length) {
            for (int i = 0; i < lanes; ++i) m_middle[i] = static_cast<double>(first) + 0.5;
            if (common > 0)
                add(m_packet.run(first, length, -1), m_middle);
            else
                for (int lane = 0; lane < lanes; ++lane) add(m_packet.run(first, length, lane), m_middle);
            if (m_job.mode == RenderMode::maximum && allWhite()) return;
        }
        addCut(m_packet.rays().tail);
    }

    [[nodiscard]] const Seen& seen() const { return m_seen; }

private:
    /// Adds the part of a step at the beginning or the end of each ray. A mean weights it by its length.
    void addCut(const CutSteps<lanes>& cut) {
        bool any = false;
        for (int i = 0; i < lanes; ++i) {
            any = any || cut.length[i] > 0.0;
            m_weight[i] = static_cast<float>(cut.length[i]);
        }
        if (!any) return;
        const Run<Voxel> all = m_packet.run(cut, -1);
        if (all.near) {
            add(all, cut.at);
            return;
        }
        for (int lane = 0; lane < lanes; ++lane)
            if (cut.length[lane] > 0.0) add(m_packet.run(cut, lane), cut.at);
    }

    /// `middle` are the places of the first samples, in steps.
    HWY_NOINLINE void add(const Run<Voxel>& run, const double (&middle)[lanes]) {
        const Floats floats;
        const bool sums = m_job.mode == RenderMode::mean;
        const float sign = m_job.mode == RenderMode::minimum ? -1.0f : 1.0f;
        const auto none = set(-std::numeric_limits<float>::max());
        auto best = none, sum = set(0.0f), count = set(0.0f), at = set(-1.0f);
        for (std::int64_t i = 0; i < run.count; ++i) {
            const auto number = set(static_cast<float>(i));
            const auto inRange = run.inRange(number);
            const Position exact = run.at(number), place = m_job.nearest ? nearestVoxel(exact) : exact;
            const auto position = tablePositionAt(run.volume, place, m_job.toTable, inRange);
            auto active = inRange;
            if (run.volume.presence != nullptr) {
                const auto presence = presenceAt(run.volume, run.volume.offsetOf(place), place, inRange);
                active = hn::And(inRange, hn::Ge(presence, set(0.5f)));
            }
            const auto signedPosition = hn::Mul(position, set(sign));
            const auto better = hn::And(active, sums ? hn::Eq(count, set(0.0f)) : hn::Gt(signedPosition, best));
            best = hn::IfThenElse(better, signedPosition, best);
            at = hn::IfThenElse(better, number, at);
            const auto weight = hn::IfThenElseZero(active, hn::Load(floats, m_weight));
            if (sums) sum = hn::MulAdd(weight, position, sum);
            count = hn::Add(count, weight);
        }
        alignas(64) float bests[lanes], sums_[lanes], counts[lanes], numbers[lanes];
        hn::Store(hn::Mul(best, set(sign)), floats, bests);
        hn::Store(sum, floats, sums_);
        hn::Store(count, floats, counts);
        hn::Store(at, floats, numbers);
        for (int i = 0; i < lanes; ++i) {
            if (counts[i] == 0.0f) continue;
            const bool first = m_seen.count[i] == 0.0;
            const double value = static_cast<double>(bests[i]);
            const bool better = first || (m_job.mode == RenderMode::maximum && value > m_seen.value[i]) ||
                                (m_job.mode == RenderMode::minimum && value < m_seen.value[i]);
            m_seen.count[i] += static_cast<double>(counts[i]);
            if (sums) m_seen.value[i] += static_cast<double>(sums_[i]);
            if (!sums && better) m_seen.value[i] = value;
            if (sums ? !first : !better) continue;
            const RayBundle<lanes>& rays = m_packet.rays();
            const double number = middle[i] + static_cast<double>(numbers[i]);
            m_seen.depthMm[i] = static_cast<float>(rays.depthMm[i] + rays.depthStepMm[i] * number);
        }
    }

    [[nodiscard]] bool allWhite() const {
        for (int i = 0; i < lanes; ++i) {
            const bool isRay = m_packet.rays().enter[i] < m_packet.rays().leave[i];
            if (isRay && m_seen.value[i] < TransferTable::intervals) return false;
        }
        return true;
    }

    const KernelJob<Voxel>& m_job;
    const Packet<Voxel>& m_packet;
    Seen m_seen;
    alignas(64) float m_weight[lanes];
    alignas(64) double m_middle[lanes];
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
