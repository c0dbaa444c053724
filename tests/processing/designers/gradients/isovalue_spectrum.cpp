// Area, volume and gradient integral of isosurfaces: closed forms, the coarea identity, and surfaces on tetrahedra.
#include "processing/designers/gradients/isovalue_spectrum.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/processing/designers/gradients/spectrum_volumes.h"

namespace echolucent {
namespace {

constexpr std::size_t levelCount = ContourSpectrum::count;

double integral(const std::vector<double>& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < levelCount; ++i) sum += values[i] * ContourSpectrum::width(i);
    return sum;
}

VolumeGeometry cube(std::int64_t size) {
    VolumeGeometry geometry;
    geometry.size = {size, size, size};
    return geometry;
}

/// A ball in 48 x 48 x 48 mm, whose centre lies on no voxel.
const Ball offGridBall{{23.63, 23.29, 23.57}, 22.0};

/// Compares with the ball's closed forms, a share of which is there.
void expectBall(const ContourSpectrum& spectrum, double unitMm, double share, double tolerance) {
    const double area = unitMm * unitMm, slope = unitMm / offGridBall.reachMm;
    for (std::size_t i = 40; i <= 200; ++i) {
        const double w = ContourSpectrum::isovalue(i);
        EXPECT_NEAR(spectrum.area[i] * area, share * offGridBall.area(w), tolerance * share * offGridBall.area(w)) << i;
        EXPECT_NEAR(spectrum.gradientIntegral[i] * area, share * slope * offGridBall.area(w),
                    tolerance * share * slope * offGridBall.area(w))
            << i;
        EXPECT_NEAR(spectrum.volume[i] * area * unitMm, share * offGridBall.content(w),
                    tolerance * share * offGridBall.content(w))
            << i;
        EXPECT_NEAR(spectrum.meanGradient()[i], slope, 0.01 * slope) << i;
    }
}

TEST(IsovalueSpectrum, OfABallIsItsClosedForm) {
    expectBall(*contourSpectrum(offGridBall.volume(cube(48))), 1.0, 1.0, 0.04);
}

TEST(IsovalueSpectrum, LengthsAreUnitsWhateverTheSpacing) {
    VolumeGeometry geometry = cube(96);
    geometry.spacing = {0.5, 0.5, 0.5};
    expectBall(*contourSpectrum(offGridBall.volume(geometry)), 0.5, 1.0, 0.01);
    geometry.size = {48, 96, 64};
    geometry.spacing = {1.0, 0.5, 0.75};
    expectBall(*contourSpectrum(offGridBall.volume(geometry)), 0.5, 1.0, 0.03);
}

TEST(IsovalueSpectrum, WhereTheDataEndsIsNoSurface) {
    const Ball halved{{31.5, 31.63, 31.27}, 30.0};
    const Volume whole = halved.volume(cube(64));
    std::vector<std::uint8_t> mask(64 * 64 * 64);
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 64 >= 32 ? 1 : 0;
    const ContourSpectrum spectrum = *contourSpectrum(whole.withDataMask(mask));
    for (std::size_t i = 40; i <= 200; ++i) {
        const double w = ContourSpectrum::isovalue(i);
        EXPECT_NEAR(spectrum.area[i], 0.5 * halved.area(w), 0.03 * halved.area(w)) << i;
        EXPECT_NEAR(spectrum.volume[i], 0.5 * halved.content(w), 0.02 * halved.content(w)) << i;
    }
}

/// Gradient magnitude by its definition, per unit, of a volume whose voxels all carry data.
double gradientAt(const Volume& volume, const std::array<std::int64_t, 3>& voxel) {
    const VolumeGeometry& geometry = volume.geometry();
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<std::int64_t, 3> low = voxel, high = voxel;
        low[axis] = std::max<std::int64_t>(0, voxel[axis] - 1);
        high[axis] = std::min(geometry.size[axis] - 1, voxel[axis] + 1);
        if (low[axis] == high[axis]) continue;
        const double difference = volume.normalisedIntensity(geometry.offset(high[0], high[1], high[2])) -
                                  volume.normalisedIntensity(geometry.offset(low[0], low[1], low[2]));
        const double units =
            static_cast<double>(high[axis] - low[axis]) * geometry.spacing[static_cast<int>(axis)] / geometry.unit();
        sum += difference * difference / (units * units);
    }
    return std::sqrt(sum);
}

void expectCoareaIdentity(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    const double unit = geometry.unit();
    const double voxel = geometry.spacing[0] * geometry.spacing[1] * geometry.spacing[2] / (unit * unit * unit);
    double first = 0.0, second = 0.0;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const double g = gradientAt(volume, {x, y, z});
                first += g * voxel;
                second += g * g * voxel;
            }
    const ContourSpectrum spectrum = *contourSpectrum(volume);
    EXPECT_NEAR(integral(spectrum.area), first, 1e-5 * first) << volume.typeName();
    EXPECT_NEAR(integral(spectrum.gradientIntegral), second, 1e-5 * second) << volume.typeName();
    EXPECT_NEAR(spectrum.volume.front(), voxel * static_cast<double>(geometry.voxelCount()), 1e-9) << volume.typeName();
}

TEST(IsovalueSpectrum, AreaOverAllIsovaluesIsTheGradientOverAllVoxels) {
    VolumeGeometry geometry;
    geometry.size = {13, 7, 9};
    geometry.spacing = {0.4, 1.1, 0.7};
    const std::vector<std::uint8_t> bytes = scatteredBytes(13 * 7 * 9, 1);
    std::vector<std::uint16_t> words(bytes.begin(), bytes.end());
    for (std::uint16_t& word : words) word = static_cast<std::uint16_t>(word * 200 + 77);
    std::vector<float> floats(bytes.begin(), bytes.end());
    for (float& value : floats) value = value * 0.013f - 0.5f;
    expectCoareaIdentity(Volume(geometry, bytes));
    expectCoareaIdentity(Volume(geometry, bytes, 190.0));
    expectCoareaIdentity(Volume(geometry, words));
    expectCoareaIdentity(Volume(geometry, floats, 2.0));
}

TEST(IsovalueSpectrum, VolumeNeverRisesAndNothingIsNegative) {
    const Volume volume(cube(16), scatteredBytes(16 * 16 * 16, 7));
    const ContourSpectrum spectrum = *contourSpectrum(volume);
    EXPECT_EQ(spectrum.volume.back(), 0.0);
    for (std::size_t i = 0; i < levelCount; ++i) {
        if (i > 0) {
            EXPECT_LE(spectrum.volume[i], spectrum.volume[i - 1]) << i;
        }
        EXPECT_GE(spectrum.area[i], 0.0) << i;
        EXPECT_GE(spectrum.gradientIntegral[i], 0.0) << i;
    }
}

TEST(IsovalueSpectrum, FlatBytesLieAtTheirOwnLevel) {
    const ContourSpectrum spectrum = *contourSpectrum(Volume(cube(4), std::vector<std::uint8_t>(64, 100)));
    EXPECT_EQ(spectrum.volume[99], 64.0);
    EXPECT_EQ(spectrum.volume[100], 32.0) << "half of the level lies above its middle";
    EXPECT_EQ(spectrum.volume[101], 0.0);
    EXPECT_EQ(integral(spectrum.area), 0.0);
    EXPECT_TRUE(maximaOf(spectrum, 0.1).empty());
    for (const double gradient : spectrum.meanGradient()) EXPECT_TRUE(std::isnan(gradient));
}

TEST(IsovalueSpectrum, VolumesOfOneVoxelAndOfNoDataAreFinite) {
    VolumeGeometry one;
    for (const Volume& volume : {Volume(one, std::vector<std::uint8_t>{17}), Volume(one, std::vector<std::uint8_t>{0}),
                                 Volume(one, std::vector<float>{std::numeric_limits<float>::quiet_NaN()}),
                                 Volume(one, std::vector<std::uint8_t>{9}).withDataMask(DataMask{0})}) {
        const ContourSpectrum spectrum = *contourSpectrum(volume);
        const double there = volume.hasData(0) ? 1.0 : 0.0;
        EXPECT_EQ(spectrum.volume.front(), there);
        EXPECT_EQ(integral(spectrum.area), 0.0);
        EXPECT_TRUE(maximaOf(spectrum, 0.0).empty());
    }
}

TEST(IsovalueSpectrum, VoxelsThatAreNotFiniteAreNoDataWhateverTheMaskSays) {
    std::vector<float> voxels(5 * 5 * 5, 0.5f);
    voxels[62] = std::numeric_limits<float>::quiet_NaN();
    voxels[63] = std::numeric_limits<float>::infinity();
    const Volume marked =
        Volume(cube(5), voxels, 1.0).withDataMask(std::vector<std::uint8_t>(voxels.size(), std::uint8_t{1}));
    const ContourSpectrum spectrum = *contourSpectrum(marked);
    EXPECT_EQ(spectrum.volume.front(), 123.0);
    EXPECT_EQ(integral(spectrum.area), 0.0);
}

TEST(IsovalueSpectrum, HasTheSameBitsForAnyNumberOfThreads) {
    const Volume volume(cube(40), scatteredBytes(40 * 40 * 40, 3));
    const ContourSpectrum many = *contourSpectrum(volume);
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    const ContourSpectrum one = *contourSpectrum(volume);
    EXPECT_EQ(one.area, many.area);
    EXPECT_EQ(one.volume, many.volume);
    EXPECT_EQ(one.gradientIntegral, many.gradientIntegral);
}

TEST(IsovalueSpectrum, IsEmptyWhereItWasCancelled) {
    const std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(contourSpectrum(Volume(cube(4), std::vector<std::uint8_t>(64, 1)), progress).has_value());
}

/// A(w) and G(w) of the surfaces that linear interpolation on tetrahedra has: six a cube of eight voxels, each along a
/// diagonal of the cube. The density of a tetrahedron's volume over w is the quadratic B-spline on the values of its
/// corners, and its area is that times its gradient.
struct TetrahedraSpectrum {
    std::array<double, levelCount> area{}, gradientIntegral{};

    explicit TetrahedraSpectrum(const Volume& volume) {
        const VolumeGeometry& geometry = volume.geometry();
        for (std::int64_t z = 0; z + 1 < geometry.size[2]; ++z)
            for (std::int64_t y = 0; y + 1 < geometry.size[1]; ++y)
                for (std::int64_t x = 0; x + 1 < geometry.size[0]; ++x) {
                    std::array<std::size_t, 3> axes{0, 1, 2};
                    do addTetrahedron(volume, {x, y, z}, axes);
                    while (std::ranges::next_permutation(axes).found);
                }
    }

private:
    void addTetrahedron(const Volume& volume, std::array<std::int64_t, 3> voxel,
                        const std::array<std::size_t, 3>& axes) {
        const VolumeGeometry& geometry = volume.geometry();
        std::array<double, 4> values{};
        double squares = 0.0, content = 1.0 / 6.0;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            if (corner > 0) ++voxel[axes[corner - 1]];
            values[corner] = volume.normalisedIntensity(geometry.offset(voxel[0], voxel[1], voxel[2]));
            if (corner == 0) continue;
            const double edge = geometry.spacing[static_cast<int>(axes[corner - 1])] / geometry.unit();
            squares += std::pow((values[corner] - values[corner - 1]) / edge, 2);
            content *= edge;
        }
        std::ranges::sort(values);
        const double gradient = std::sqrt(squares);
        const auto below = static_cast<std::size_t>(values[0] / ContourSpectrum::isovalue(1));
        for (std::size_t i = below; i < levelCount && ContourSpectrum::isovalue(i) < values[3]; ++i) {
            const double w = ContourSpectrum::isovalue(i);
            if (w <= values[0]) continue;
            const double ofArea = gradient * content * quadraticSpline(values, w);
            area[i] += ofArea;
            gradientIntegral[i] += gradient * ofArea;
        }
    }

    static double hat(double low, double middle, double high, double w) {
        if (w <= low || w >= high) return 0.0;
        return w < middle ? 2.0 * (w - low) / ((high - low) * (middle - low))
                          : 2.0 * (high - w) / ((high - low) * (high - middle));
    }
    static double quadraticSpline(const std::array<double, 4>& at, double w) {
        return 1.5 * ((w - at[0]) * hat(at[0], at[1], at[2], w) + (at[3] - w) * hat(at[1], at[2], at[3], w)) /
               (at[3] - at[0]);
    }
};

TEST(IsovalueSpectrum, AgreesWithSurfacesOnTetrahedraWhereTheVolumeIsSmooth) {
    VolumeGeometry geometry;
    geometry.size = {60, 50, 44};
    geometry.spacing = {0.5, 0.6, 0.7};
    const Volume volume = floatVolume(geometry, [](const Vec3& mm) {
        const Vec3 from = mm - Vec3{14.7, 14.6, 14.8};
        const double bumps = std::sin(0.4 * from[0]) * std::cos(0.5 * from[1]) + std::sin(0.45 * from[2]);
        return 1.05 - cv::norm(from) / 14.0 + 0.06 * bumps;
    });
    const ContourSpectrum spectrum = *contourSpectrum(volume);
    const TetrahedraSpectrum tetrahedra(volume);
    for (std::size_t i = 60; i <= 170; ++i) {
        EXPECT_NEAR(spectrum.area[i], tetrahedra.area[i], 0.03 * tetrahedra.area[i]) << i;
        EXPECT_NEAR(spectrum.gradientIntegral[i], tetrahedra.gradientIntegral[i], 0.03 * tetrahedra.gradientIntegral[i])
            << i;
    }
}

/// A spectrum whose mean gradient is given and whose area is 1 but where it is given.
ContourSpectrum spectrumOf(
    const std::function<double(double)>& meanGradient,
    const std::function<double(double)>& area = [](double) { return 1.0; }) {
    ContourSpectrum spectrum;
    for (std::size_t i = 0; i < levelCount; ++i) {
        const double w = ContourSpectrum::isovalue(i);
        spectrum.area.push_back(area(w));
        spectrum.gradientIntegral.push_back(area(w) * meanGradient(w));
    }
    spectrum.volume.resize(levelCount);
    return spectrum;
}

double bump(double w, double middle, double width) { return std::exp(-std::pow((w - middle) / width, 2)); }

TEST(SpectrumMaxima, AreFoundAndTheSteepestIsTheFirst) {
    const auto maxima = maximaOf(
        spectrumOf([](double w) { return 0.02 + 0.05 * bump(w, 0.25, 0.08) + 0.08 * bump(w, 0.7, 0.05); }), 0.1);
    ASSERT_EQ(maxima.size(), 2U);
    EXPECT_NEAR(maxima[0].isovalue, 0.7, 0.004);
    EXPECT_NEAR(maxima[1].isovalue, 0.25, 0.004);
    EXPECT_GT(maxima[0].meanGradient, maxima[1].meanGradient);
    EXPECT_EQ(maxima[0].isovalue, ContourSpectrum::isovalue(maxima[0].index));
}

TEST(SpectrumMaxima, RareIntensitiesAreNotAsked) {
    const auto gradient = [](double w) { return 0.02 + 0.05 * bump(w, 0.25, 0.08) + 0.3 * bump(w, 0.9, 0.02); };
    const ContourSpectrum spectrum = spectrumOf(gradient, [](double w) { return w < 0.8 ? 1000.0 : 20.0; });
    EXPECT_NEAR(maximaOf(spectrum, 0.1).at(0).isovalue, 0.25, 0.004);
    EXPECT_NEAR(maximaOf(spectrum, 0.001).at(0).isovalue, 0.9, 0.004);
}

TEST(SpectrumMaxima, RipplesAndEndsAreNone) {
    EXPECT_TRUE(maximaOf(spectrumOf([](double w) { return 0.05 + 0.2 * w; }), 0.1).empty());
    EXPECT_TRUE(
        maximaOf(spectrumOf([](double w) { return 0.05 + 0.2 * w + 0.001 * std::sin(90.0 * w); }), 0.1).empty());
    EXPECT_TRUE(maximaOf(spectrumOf([](double) { return 0.1; }), 0.1).empty());
    EXPECT_TRUE(maximaOf(spectrumOf([](double) { return 0.0; }, [](double) { return 0.0; }), 0.1).empty());
}

TEST(SpectrumMaxima, APlateauIsOneMaximum) {
    const auto maxima = maximaOf(spectrumOf([](double w) { return w > 0.4 && w < 0.6 ? 0.1 : 0.05; }), 0.1);
    ASSERT_EQ(maxima.size(), 1U);
    EXPECT_NEAR(maxima[0].isovalue, 0.5, 0.11);
}

}  // namespace
}  // namespace echolucent
