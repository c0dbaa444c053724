// What the part of a ray between two intensities shows, of all intensities between them.
#include "processing/ray_caster/packet_colour-inl.h"

#include <hwy/contrib/math/math-inl.h>

#if defined(ECHOLUCENT_PACKET_SEGMENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_SEGMENT_INL
#undef ECHOLUCENT_PACKET_SEGMENT_INL
#else
#define ECHOLUCENT_PACKET_SEGMENT_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

class SegmentLook {
public:
    /// All of them must outlive it. opacities: TransferTable's, of points.
    SegmentLook(const PreIntegration& integrals, const float* opacities, const Colours& colours)
        : m_integrals(integrals), m_opacities(opacities), m_colours(colours) {}

    /// Of a step from one table position to another, both 0 ... intervals.
    HWY_INLINE FloatVector opacity(FloatVector front, FloatVector back, Colour& colour) const {
        const auto apart = hn::Sub(back, front);
        const auto far = hn::Gt(hn::Abs(apart), set(PreIntegration::closest));
        const auto middle = hn::Mul(hn::Add(front, back), set(0.5f));
        colour = m_colours.at(middle);
        const auto point = entryAt(m_opacities, middle);
        if (hn::AllFalse(Floats(), far)) return point;
        const auto perInterval = hn::Div(set(1.0f), hn::IfThenElse(far, apart, set(1.0f)));
        const auto mean = [&](const PreIntegration::Integral& integral) {
            return hn::Mul(between(integral, front, back), perInterval);
        };
        const auto extinction = hn::Max(mean(m_integrals.extinction()), set(0.0f));
        const auto visible = hn::And(far, hn::Gt(extinction, set(1e-12f)));
        const auto seen = hn::Div(mean(m_integrals.weighted()), hn::IfThenElse(visible, extinction, set(1.0f)));
        const auto inside = hn::Min(hn::Max(seen, hn::Min(front, back)), hn::Max(front, back));
        colour = m_colours.at(hn::IfThenElse(visible, inside, middle));
        return hn::IfThenElse(far, hn::Neg(hn::Expm1(Floats(), hn::Neg(extinction))), point);
    }

private:
    static HWY_INLINE FloatVector between(const PreIntegration::Integral& integral, FloatVector first,
                                          FloatVector last) {
        const Floats floats;
        const std::int32_t* const entries = integral.entries.data();
        const auto firstLeft = truncated(first), lastLeft = truncated(last);
        const auto entry = [&](IntVector left, int offset) { return hn::GatherIndex(Ints(), entries + offset, left); };
        const auto atFirst = entry(firstLeft, 0), atLast = entry(lastLeft, 0);
        const auto beyond = [&](FloatVector position, IntVector left, IntVector at) {
            return hn::Mul(hn::ConvertTo(floats, hn::Sub(entry(left, 1), at)),
                           hn::Sub(position, hn::ConvertTo(floats, left)));
        };
        const auto difference = hn::Add(hn::ConvertTo(floats, hn::Sub(atLast, atFirst)),
                                        hn::Sub(beyond(last, lastLeft, atLast), beyond(first, firstLeft, atFirst)));
        return hn::Mul(difference, set(integral.unit));
    }

    const PreIntegration& m_integrals;
    const float* m_opacities;
    const Colours& m_colours;
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
