#include "processing/phantom/speckle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/phantom/splitmix.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/phantom/speckle.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVector = hn::Vec<Floats>;
using WordVector = hn::Vec<Words>;

// Products and sums are separate on purpose: fused ones would give other bits on other machines.
HWY_INLINE FloatVector timesPlus(FloatVector a, FloatVector b, float c) {
    return hn::Add(hn::Mul(a, b), hn::Set(Floats(), c));
}

/// A 32-bit mixing function with full avalanche, of shifts and multiplications in two rounds. C. Wellons published it
/// under the name "hash prospector".
HWY_INLINE WordVector mixed(WordVector value) {
    const Words d;
    value = hn::Xor(value, hn::ShiftRight<16>(value));
    value = hn::Mul(value, hn::Set(d, 0x21f0aaadU));
    value = hn::Xor(value, hn::ShiftRight<15>(value));
    value = hn::Mul(value, hn::Set(d, 0xd35a2d97U));
    return hn::Xor(value, hn::ShiftRight<15>(value));
}

/// Natural logarithm of positive normal numbers, with a relative error of about 1e-7. The polynomial is that of logf in
/// S. Moshier's Cephes library.
HWY_INLINE FloatVector naturalLog(FloatVector value) {
    const Floats d;
    const hn::RebindToSigned<Floats> integers;
    const auto bits = hn::Sub(hn::BitCast(integers, value), hn::Set(integers, 0x3f3504f3));
    const auto exponent = hn::ConvertTo(d, hn::ShiftRight<23>(bits));
    const auto mantissaBits = hn::Add(hn::And(bits, hn::Set(integers, 0x007fffff)), hn::Set(integers, 0x3f3504f3));
    const FloatVector x = hn::Sub(hn::BitCast(d, mantissaBits), hn::Set(d, 1.0F));
    FloatVector p = hn::Set(d, 7.0376836292e-2F);
    p = timesPlus(p, x, -1.1514610310e-1F);
    p = timesPlus(p, x, 1.1676998740e-1F);
    p = timesPlus(p, x, -1.2420140846e-1F);
    p = timesPlus(p, x, 1.4249322787e-1F);
    p = timesPlus(p, x, -1.6668057665e-1F);
    p = timesPlus(p, x, 2.0000714765e-1F);
    p = timesPlus(p, x, -2.4999993993e-1F);
    p = timesPlus(p, x, 3.3333331174e-1F);
    const FloatVector square = hn::Mul(x, x);
    FloatVector result = hn::Mul(hn::Mul(x, square), p);
    result = hn::Sub(result, hn::Mul(square, hn::Set(d, 0.5F)));
    result = hn::Add(result, hn::Mul(exponent, hn::Set(d, -2.12194440e-4F)));
    return hn::Add(hn::Add(x, result), hn::Mul(exponent, hn::Set(d, 0.693359375F)));
}

/// -2 ln of a uniform number in (0,1], made of the upper 24 bits.
HWY_INLINE FloatVector squaredRadius(WordVector bits) {
    const Floats d;
    const hn::RebindToSigned<Floats> integers;
    const auto whole = hn::ConvertTo(d, hn::BitCast(integers, hn::ShiftRight<8>(bits)));
    const FloatVector uniform = hn::Mul(hn::Add(whole, hn::Set(d, 0.5F)), hn::Set(d, 0x1p-24F));
    return hn::Mul(hn::Set(d, -2.0F), naturalLog(uniform));
}

struct RowKeys {
    std::uint32_t first, second;
};

HWY_INLINE WordVector radiusBits(RowKeys keys, std::uint32_t index) {
    const Words d;
    const auto counter = hn::Mul(hn::Iota(d, index), hn::Set(d, 0x9e3779b9U));
    return mixed(hn::Xor(counter, hn::Set(d, keys.first)));
}

/// Rayleigh noise of unit mean without correlation.
void rayleighRow(std::uint64_t key, std::int64_t count, float* out) {
    const Floats d;
    const RowKeys keys{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
    const FloatVector scale = hn::Set(d, static_cast<float>(std::sqrt(2 / std::numbers::pi)));
    for (std::int64_t i = 0; i < count; i += static_cast<std::int64_t>(hn::Lanes(d))) {
        const auto radius = hn::Sqrt(squaredRadius(radiusBits(keys, static_cast<std::uint32_t>(i))));
        hn::StoreU(hn::Mul(radius, scale), d, out + i);
    }
}

/// Complex Gaussian noise of unit variance in each part, by Box and Muller.
void gaussianRow(std::uint64_t key, std::int64_t count, float* real, float* imaginary) {
    const Floats d;
    const Words words;
    const hn::RebindToSigned<Floats> integers;
    const RowKeys keys{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)};
    for (std::int64_t i = 0; i < count; i += static_cast<std::int64_t>(hn::Lanes(d))) {
        const WordVector bits = radiusBits(keys, static_cast<std::uint32_t>(i));
        const FloatVector radius = hn::Sqrt(squaredRadius(bits));
        const WordVector turn = mixed(hn::Add(bits, hn::Set(words, keys.second)));
        // Two bits choose the quarter, 24 bits the angle from -45 to 45 degrees within it.
        const auto fine = hn::BitCast(integers, hn::And(hn::ShiftRight<2>(turn), hn::Set(words, 0xffffffU)));
        const FloatVector angle = hn::Mul(hn::Add(hn::ConvertTo(d, fine), hn::Set(d, -8388607.5F)),
                                          hn::Set(d, static_cast<float>(std::numbers::pi / 2) * 0x1p-24F));
        const FloatVector square = hn::Mul(angle, angle);
        FloatVector sine = timesPlus(hn::Set(d, -1.9515295891e-4F), square, 8.3321608736e-3F);
        sine = timesPlus(sine, square, -1.6666654611e-1F);
        sine = hn::Add(hn::Mul(hn::Mul(sine, square), angle), angle);
        FloatVector cosine = timesPlus(hn::Set(d, 2.443315711809948e-5F), square, -1.388731625493765e-3F);
        cosine = timesPlus(cosine, square, 4.166664568298827e-2F);
        cosine = timesPlus(hn::Mul(cosine, square), square, 1.0F);
        cosine = hn::Sub(cosine, hn::Mul(square, hn::Set(d, 0.5F)));
        const auto odd = hn::TestBit(turn, hn::Set(words, 1U));
        const auto quarter = hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(words, odd)));
        const auto flip = hn::BitCast(d, hn::ShiftLeft<30>(hn::And(turn, hn::Set(words, 2U))));
        const FloatVector across = hn::IfThenElse(quarter, hn::Neg(sine), cosine);
        const FloatVector up = hn::IfThenElse(quarter, cosine, sine);
        hn::StoreU(hn::Mul(radius, hn::Xor(across, flip)), d, real + i);
        hn::StoreU(hn::Mul(radius, hn::Xor(up, flip)), d, imaginary + i);
    }
}

/// out[i] = sum over the rows k of taps[k] * rows[k][i]; the taps are symmetric.
void weightedSum(const float* const* rows, const float* taps, std::int64_t tapCount, std::int64_t count, float* out) {
    const Floats d;
    const std::int64_t middle = tapCount / 2;
    for (std::int64_t i = 0; i < count; i += static_cast<std::int64_t>(hn::Lanes(d))) {
        FloatVector sum = hn::Mul(hn::LoadU(d, rows[middle] + i), hn::Set(d, taps[middle]));
        for (std::int64_t k = 0; k < middle; ++k) {
            const FloatVector pair = hn::Add(hn::LoadU(d, rows[k] + i), hn::LoadU(d, rows[tapCount - 1 - k] + i));
            sum = hn::Add(sum, hn::Mul(pair, hn::Set(d, taps[k])));
        }
        hn::StoreU(sum, d, out + i);
    }
}

/// Modulus of complex noise, scaled from unit variance of each part to unit mean.
void modulusRow(const float* real, const float* imaginary, std::int64_t count, float* out) {
    const Floats d;
    const FloatVector scale = hn::Set(d, static_cast<float>(std::sqrt(2 / std::numbers::pi)));
    for (std::int64_t i = 0; i < count; i += static_cast<std::int64_t>(hn::Lanes(d))) {
        const FloatVector a = hn::LoadU(d, real + i), b = hn::LoadU(d, imaginary + i);
        hn::StoreU(hn::Mul(hn::Sqrt(hn::Add(hn::Mul(a, a), hn::Mul(b, b))), scale), d, out + i);
    }
}

void finishRow(const float* echo, const float* rayleigh, std::int64_t count, const EchoFinish& finish,
               std::uint16_t* stored) {
    const Floats d;
    const hn::RebindToSigned<Floats> integers;
    const hn::Rebind<std::uint16_t, Floats> halves;
    const FloatVector zero = hn::Zero(d), white = hn::Set(d, finish.whiteLevel);
    const FloatVector toWhite = hn::Set(d, finish.whiteLevel / 255.0F);
    // 255 (1 + 20 log10(e / 255) / D) = 255 + b ln(e / 255)
    const float decibelScale =
        finish.decibel > 0 ? static_cast<float>(255.0 * 20 / std::numbers::ln10 / finish.decibel) : 0;
    for (std::int64_t i = 0; i < count; i += static_cast<std::int64_t>(hn::Lanes(d))) {
        FloatVector value = hn::LoadU(d, echo + i);
        if (rayleigh != nullptr) {
            const FloatVector excess = hn::Sub(hn::LoadU(d, rayleigh + i), hn::Set(d, 1.0F));
            value = hn::Mul(value, timesPlus(hn::Set(d, finish.speckle), excess, 1.0F));
        }
        if (finish.decibel > 0) {
            const FloatVector share = hn::Max(hn::Mul(value, hn::Set(d, 1.0F / 255)), hn::Set(d, 1e-30F));
            value = timesPlus(naturalLog(share), hn::Set(d, decibelScale), 255.0F);
        }
        value = hn::Min(hn::Max(hn::Mul(value, toWhite), zero), white);
        hn::StoreU(hn::DemoteTo(halves, hn::BitCast(integers, hn::NearestInt(value))), halves, stored + i);
    }
}

}  // namespace echolucent::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

HWY_EXPORT(rayleighRow);
HWY_EXPORT(gaussianRow);
HWY_EXPORT(weightedSum);
HWY_EXPORT(modulusRow);
HWY_EXPORT(finishRow);

namespace {

/// Rows and slices may lie before the volume (the smoothing's margin), so offsets keep their indices positive.
std::uint64_t rowKey(std::uint64_t seed, std::int64_t y, std::int64_t z) {
    const auto row = static_cast<std::uint64_t>(y + 4096), slice = static_cast<std::uint64_t>(z + 4096);
    return splitmix64(splitmix64(seed) ^ (slice << 32 | row));
}

void makeUncorrelated(const SpeckleConfig& config, std::int64_t first, std::int64_t last, const SpeckleUse& use) {
    const std::int64_t stride = paddedRow(config.size[0]);
    std::vector<float> slice(static_cast<std::size_t>(stride * config.size[1]));
    for (std::int64_t z = first; z < last; ++z) {
        for (std::int64_t y = 0; y < config.size[1]; ++y)
            HWY_DYNAMIC_DISPATCH(rayleighRow)(rowKey(config.seed, y, z), stride, slice.data() + y * stride);
        use(z, slice.data(), stride);
    }
}

/// Rows of complex numbers, real and imaginary parts apart. It is a ring: row y takes the place of row y - `rows`.
struct ComplexRows {
    std::int64_t stride, rows;
    std::vector<float> parts[2];
    ComplexRows(std::int64_t rowStride, std::int64_t rowCount) : stride(rowStride), rows(rowCount) {
        for (auto& part : parts) part.resize(static_cast<std::size_t>(stride * rows));
    }
    float* row(int part, std::int64_t y) { return parts[part].data() + (y % rows) * stride; }
};

/// Smooths noise row by row, slice by slice. It holds only as many rows and slices in memory as there are taps.
class SpeckleSmoother {
public:
    explicit SpeckleSmoother(const SpeckleConfig& config)
        : m_config(config),
          m_taps(speckleTaps(config.smoothing)),
          m_tapCount(static_cast<std::int64_t>(m_taps.size())),
          m_radius(m_tapCount / 2),
          m_stride(paddedRow(config.size[0])),
          m_noise(paddedRow(m_stride + 2 * m_radius), 1),
          m_rows(m_stride, m_tapCount),
          m_slices(m_stride * config.size[1], m_tapCount),
          m_smoothed(m_stride, 1),
          m_result(static_cast<std::size_t>(m_stride * config.size[1])),
          m_sources(static_cast<std::size_t>(m_tapCount)) {}

    void run(std::int64_t first, std::int64_t last, const SpeckleUse& use) {
        for (std::int64_t z = first - m_radius; z < last + m_radius; ++z) {
            addSlice(z, z - (first - m_radius));
            const std::int64_t middle = z - m_radius;
            if (middle < first) continue;
            combineSlices(middle - first);
            use(middle, m_result.data(), m_stride);
        }
    }

private:
    /// Adds slice z to the ring of slices: noise smoothed along x and y.
    void addSlice(std::int64_t z, std::int64_t ring) {
        for (std::int64_t y = -m_radius; y < m_config.size[1] + m_radius; ++y) {
            HWY_DYNAMIC_DISPATCH(gaussianRow)
            (rowKey(m_config.seed, y, z), m_noise.stride, m_noise.row(0, 0), m_noise.row(1, 0));
            const std::int64_t middle = y - m_radius;
            for (int part = 0; part < 2; ++part) {
                for (std::int64_t k = 0; k < m_tapCount; ++k) source(k) = m_noise.row(part, 0) + k;
                sum(m_stride, m_rows.row(part, y + m_radius));
                if (middle < 0) continue;
                for (std::int64_t k = 0; k < m_tapCount; ++k) source(k) = m_rows.row(part, middle + k);
                sum(m_stride, m_slices.row(part, ring) + middle * m_stride);
            }
        }
    }

    void combineSlices(std::int64_t ring) {
        for (std::int64_t y = 0; y < m_config.size[1]; ++y) {
            float* parts[2] = {m_smoothed.row(0, 0), m_smoothed.row(1, 0)};
            for (int part = 0; part < 2; ++part) {
                for (std::int64_t k = 0; k < m_tapCount; ++k) source(k) = m_slices.row(part, ring + k) + y * m_stride;
                sum(m_stride, parts[part]);
            }
            HWY_DYNAMIC_DISPATCH(modulusRow)(parts[0], parts[1], m_stride, m_result.data() + y * m_stride);
        }
    }

    const float*& source(std::int64_t k) { return m_sources[static_cast<std::size_t>(k)]; }
    void sum(std::int64_t count, float* out) const {
        HWY_DYNAMIC_DISPATCH(weightedSum)(m_sources.data(), m_taps.data(), m_tapCount, count, out);
    }

    const SpeckleConfig& m_config;
    std::vector<float> m_taps;
    std::int64_t m_tapCount, m_radius, m_stride;
    ComplexRows m_noise, m_rows, m_slices, m_smoothed;
    std::vector<float> m_result;
    std::vector<const float*> m_sources;
};

}  // namespace

std::vector<float> speckleTaps(double smoothing) {
    if (!(smoothing > 0)) return {1.0F};
    const double sigma = smoothing / (2 * std::sqrt(2 * std::numbers::ln2));
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<double> taps;
    double squares = 0;
    for (int i = -radius; i <= radius; ++i) {
        taps.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        squares += taps.back() * taps.back();
    }
    std::vector<float> scaled(taps.size());
    std::transform(taps.begin(), taps.end(), scaled.begin(),
                   [norm = std::sqrt(squares)](double tap) { return static_cast<float>(tap / norm); });
    return scaled;
}

void makeSpeckle(const SpeckleConfig& config, std::int64_t first, std::int64_t last, const SpeckleUse& use) {
    if (config.smoothing > 0)
        SpeckleSmoother(config).run(first, last, use);
    else
        makeUncorrelated(config, first, last, use);
}

void finishRow(const float* echo, const float* rayleigh, std::int64_t count, const EchoFinish& finish,
               std::uint16_t* stored) {
    HWY_DYNAMIC_DISPATCH(finishRow)(echo, rayleigh, count, finish, stored);
}

}  // namespace echolucent
#endif
