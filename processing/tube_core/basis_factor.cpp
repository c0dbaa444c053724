#include "processing/tube_core/basis_factor.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/tube_core/basis_factor.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using DoubleVector = hn::Vec<Doubles>;
using Words = hn::RebindToUnsigned<Doubles>;

HWY_INLINE DoubleVector constant(double value) { return hn::Set(Doubles(), value); }

// Products and sums stay apart on purpose: fused ones would give other bits on some machines.
HWY_INLINE DoubleVector timesPlus(DoubleVector a, DoubleVector b, double c) {
    return hn::Add(hn::Mul(a, b), constant(c));
}

/// A sum or difference, and its rounding error (Knuth's two-sum).
struct Exact {
    DoubleVector value, lost;
};
HWY_INLINE Exact exactSum(DoubleVector a, DoubleVector b) {
    const auto value = hn::Add(a, b);
    const auto ofB = hn::Sub(value, a);
    return {value, hn::Add(hn::Sub(a, hn::Sub(value, ofB)), hn::Sub(b, ofB))};
}

/// Adding and subtracting 1.5 * 2^52 / 2^n rounds to multiples of 2^-n.
constexpr double roundsToWhole = 6755399441055744.0;
constexpr double roundsTo24Bits = roundsToWhole / 16777216.0;

/// e^x for x from -700 to 700 within 0.6 ulp: the Taylor series within half of ln 2, times a power of two.
HWY_INLINE DoubleVector exponential(DoubleVector x) {
    const auto magic = constant(roundsToWhole);
    const auto shifted = hn::Add(hn::Mul(x, constant(1.4426950408889634)), magic);
    const auto power = hn::Sub(shifted, magic);
    // ln 2 in two parts: the first has few digits, so that its product with the power is exact.
    const auto rest = hn::Sub(hn::Sub(x, hn::Mul(power, constant(6.93147180369123816490e-01))),
                              hn::Mul(power, constant(1.90821492927058770002e-10)));
    // Estrin's scheme computes pairs, then pairs of pairs, instead of one long chain.
    const auto square = hn::Mul(rest, rest), fourth = hn::Mul(square, square), eighth = hn::Mul(fourth, fourth);
    const auto pair = [&](double low, double high) { return timesPlus(constant(high), rest, low); };
    const auto p01 = pair(0.5, 1.0 / 6.0), p23 = pair(1.0 / 24.0, 1.0 / 120.0);
    const auto p45 = pair(1.0 / 720.0, 1.0 / 5040.0), p67 = pair(1.0 / 40320.0, 1.0 / 362880.0);
    const auto p89 = pair(1.0 / 3628800.0, 1.0 / 39916800.0);
    const auto pab = pair(1.0 / 479001600.0, 1.0 / 6227020800.0);
    const auto low = hn::Add(hn::Add(p01, hn::Mul(p23, square)), hn::Mul(hn::Add(p45, hn::Mul(p67, square)), fourth));
    const auto p = hn::Add(low, hn::Mul(hn::Add(p89, hn::Mul(pab, square)), eighth));
    const auto mantissa = hn::Add(constant(1.0), hn::Add(rest, hn::Mul(square, p)));
    const Words words;
    // The lowest bits of `shifted` are the power.
    const auto exponent = hn::ShiftLeft<52>(hn::Add(hn::BitCast(words, shifted), hn::Set(words, 1023)));
    return hn::Mul(mantissa, hn::BitCast(Doubles(), exponent));
}

/// g at `intensity`. u is split into a value with 24 bits behind the point and a rest. The square of that value is
/// exact for |u| up to 5.6; beyond, |g| is less than 2e-6. The rest comes from the exact remainder of the division, and
/// two terms of the series of e suffice for the rest.
HWY_INLINE DoubleVector basis(const BasisFactor& factor, DoubleVector intensity) {
    // From here on |g| is less than 1e-295.
    constexpr double far = 37.0;
    const auto way = exactSum(hn::Mul(intensity, constant(factor.twice)), constant(-factor.centre2));
    const auto wayLost = hn::Sub(way.lost, constant(factor.centre2Lost));
    const auto inverseGap = constant(factor.inverseGap), magic = constant(roundsTo24Bits);
    // If the gap is a few ulps, the rounding error is as large as the gap.
    const auto unbounded = hn::Mul(hn::Add(way.value, wayLost), inverseGap);
    const auto near = hn::Lt(hn::Abs(unbounded), constant(far));
    const auto u = hn::Sub(hn::Add(hn::IfThenElseZero(near, unbounded), magic), magic);
    const auto remainder =
        hn::Add(hn::Sub(hn::Sub(way.value, hn::Mul(u, constant(factor.gapHigh))), hn::Mul(u, constant(factor.gapLow))),
                wayLost);
    const auto rest = hn::IfThenElseZero(near, hn::Mul(remainder, inverseGap));
    const auto half = constant(0.5);
    const auto bell = exponential(hn::Mul(hn::Sub(constant(1.0), hn::Mul(u, u)), half));
    const auto added = hn::Mul(rest, hn::Add(u, hn::Mul(rest, half)));
    const auto correction = hn::Mul(added, hn::Sub(hn::Mul(added, half), constant(1.0)));
    const auto value = hn::Add(hn::Mul(u, bell), hn::Mul(bell, hn::Add(rest, hn::Mul(hn::Add(u, rest), correction))));
    return hn::IfThenElseZero(near, value);
}

void addFactorsTo(const BasisFactor* factors, std::size_t factorCount, const double* intensities, std::size_t count,
                  double* sums, double* lost) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t start = 0; start < count; start += lanes) {
        // Every vector is full, the last one too, so that a value does not depend on its neighbours.
        alignas(64) double x[hn::MaxLanes(d)] = {}, sum[hn::MaxLanes(d)] = {}, dropped[hn::MaxLanes(d)] = {};
        const std::size_t here = std::min(lanes, count - start);
        std::copy_n(intensities + start, here, x);
        std::copy_n(sums + start, here, sum);
        std::copy_n(lost + start, here, dropped);
        const auto intensity = hn::Load(d, x);
        Exact total{hn::Load(d, sum), hn::Load(d, dropped)};
        for (std::size_t f = 0; f < factorCount; ++f) {
            const auto term = hn::Mul(constant(factors[f].range), basis(factors[f], intensity));
            const Exact added = exactSum(total.value, term);
            total = {added.value, hn::Add(total.lost, added.lost)};
        }
        hn::Store(total.value, d, sum);
        hn::Store(total.lost, d, dropped);
        std::copy_n(sum, here, sums + start);
        std::copy_n(dropped, here, lost + start);
    }
}

}  // namespace echolucent::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

HWY_EXPORT(addFactorsTo);

BasisFactor::BasisFactor(double low, double high, double logRange) : range(logRange), twice(2.0) {
    // If the gap is tiny, 1 / gap or its product with a distance overflows. Scaling by a power of two changes no digit.
    constexpr double leastGap = 0x1p-500, scale = 0x1p500;
    if (high - low < leastGap) {
        low *= scale;
        high *= scale;
        twice *= scale;
    }
    centre2 = low + high;
    const double ofHigh = centre2 - low;
    centre2Lost = (low - (centre2 - ofHigh)) + (high - ofHigh);
    const double gap = high - low;
    const double ofLow = high - gap;
    const double gapLost = (high - (gap + ofLow)) + (ofLow - low);
    constexpr double splitter = 0x1p27 + 1.0;
    const double split = splitter * gap;
    gapHigh = split - (split - gap);
    gapLow = (gap - gapHigh) + gapLost;
    inverseGap = 1.0 / gap;
}

void addFactors(std::span<const BasisFactor> factors, std::span<const double> intensities, std::span<double> sums,
                std::span<double> lost) {
    HWY_DYNAMIC_DISPATCH(addFactorsTo)
    (factors.data(), factors.size(), intensities.data(), intensities.size(), sums.data(), lost.data());
}

}  // namespace echolucent
#endif
