// How much of a cut's face (CutFace) the samples of a packet of rays show.
#include "processing/ray_caster/packet_run-inl.h"

#include <hwy/contrib/math/math-inl.h>

#if defined(ECHOLUCENT_PACKET_CUT_FACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_CUT_FACE_INL
#undef ECHOLUCENT_PACKET_CUT_FACE_INL
#else
#define ECHOLUCENT_PACKET_CUT_FACE_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// The shares of a packet's rays behind their newest samples. A share below `least` counts as 0.
class CutFaces {
public:
    static constexpr float least = 1e-8f;  // too little to change a colour in single precision

    HWY_INLINE CutFaces() { std::fill_n(m_unlit, lanes, 1.0f); }

    [[nodiscard]] HWY_INLINE FloatVector shares() const { return hn::Load(Floats(), m_unlit); }
    HWY_INLINE void setShares(FloatVector shares) { hn::Store(shares, Floats(), m_unlit); }

    /// The shares in a step of `units`, with its intensity's opacity. Moves the `shares` of rays in range behind the
    /// step.
    static HWY_INLINE FloatVector pass(FloatVector units, FloatVector opacity, FloatVector border, LaneMask inRange,
                                       FloatVector& shares) {
        constexpr auto fluid = static_cast<float>(1.0 / CutFace::fluidDepth);
        constexpr auto all = static_cast<float>(clearRate);
        constexpr auto perOpacity = static_cast<float>(1.0 / CutFace::tissueOpacity);
        const auto tissue = hn::Min(units, hn::Mul(opacity, set(perOpacity)));
        const auto rate = hn::NegMulAdd(tissue, set(fluid), hn::Mul(units, set(all)));
        const auto one = set(1.0f), left = hn::Div(one, hn::MulAdd(rate, set(0.5f), one));
        const auto unlit = hn::Max(hn::Mul(shares, left), border);
        const auto behind = hn::Mul(unlit, left);
        const auto counted = hn::IfThenElseZero(hn::Ge(behind, set(least)), behind);
        shares = hn::IfThenElse(inRange, counted, shares);
        return unlit;
    }
    /// Moves each ray behind `steps` clear steps of `units` each.
    HWY_INLINE void passClear(FloatVector steps, float units) {
        const double each = -2.0 * std::log1p(0.5 * clearRate * static_cast<double>(units));
        const Floats floats;
        const auto behind =
            hn::Mul(hn::Load(floats, m_unlit), hn::Exp(floats, hn::Mul(steps, set(static_cast<float>(each)))));
        hn::Store(hn::IfThenElseZero(hn::Ge(behind, set(least)), behind), floats, m_unlit);
    }

private:
    static constexpr double clearRate = 1.0 / CutFace::tissueDepth + 1.0 / CutFace::fluidDepth;
    alignas(64) float m_unlit[lanes];
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
