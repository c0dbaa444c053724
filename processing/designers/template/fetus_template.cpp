// The built-in template. tests/processing/designers/template/template_reference.cpp makes its numbers anew from the
// phantom and compares.
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

#include "processing/designers/template/template_reference.h"
#include "processing/phantom/phantom_config.h"

namespace echolucent {

namespace {

/// Voxels by normalised intensity: value i counts [i/256, (i+1)/256[. Above the last value there are no voxels.
constexpr std::uint32_t fetusCounts[] = {
    0,     0,     0,     0,     0,     0,     0,     0,     0,     0,     1090,  29463, 147262, 268910, 258650, 148710,
    62195, 22981, 10033, 6107,  4754,  4208,  3962,  3952,  3806,  3886,  3715,  3587,  3397,   3379,   3411,   3280,
    3303,  3113,  3127,  2985,  3164,  3198,  3078,  3017,  3153,  3155,  3234,  3308,  3326,   3312,   3278,   3274,
    3332,  3277,  3325,  3236,  3142,  3228,  3179,  3186,  3070,  3115,  2993,  2997,  3092,   3037,   3057,   3166,
    3194,  3380,  3578,  3899,  4297,  5033,  6071,  7273,  8940,  10963, 13424, 16381, 19517,  22310,  25250,  28400,
    30904, 33041, 35383, 36647, 37127, 37775, 37227, 36836, 35868, 34600, 33125, 30962, 28812,  26832,  24773,  22946,
    21522, 19320, 17508, 16475, 14837, 13359, 12579, 11054, 10184, 9181,  8187,  7456,  6658,   6004,   5312,   4810,
    4459,  4057,  3583,  3349,  3179,  2965,  2814,  2631,  2691,  2763,  2554,  2666,  2646,   2657,   2650,   2654,
    2675,  2608,  2506,  2619,  2554,  2354,  2314,  2270,  2108,  2086,  2043,  1934,  1920,   1834,   1704,   1603,
    1557,  1437,  1376,  1263,  1237,  1241,  1136,  1014,  912,   855,   828,   769,   718,    732,    612,    534,
    516,   536,   484,   434,   363,   358,   286,   333,   297,   272,   239,   232,   190,    156,    156,    133,
    132,   109,   94,    74,    75,    74,    52,    50,    38,    38,    37,    36,    27,     29,     27,     26,
    24,    29,    20,    13,    19,    17,    10,    9,     8,     6,     8,     1,     0,      0,      2,      1,
    0,     1,     1};

/// The adaptive curve within 0.02. The intensities of the nodes are written in levels of 255.
ManualCurve fetusCurve() {
    ManualCurve curve{{{47, 0.0},
                       {54, 0.02},
                       {60, 0.05},
                       {75, 0.18},
                       {101, 0.53},
                       {115, 0.68},
                       {132, 0.82},
                       {154, 0.94},
                       {186, 1.0}}};
    for (CurveNode& node : curve.nodes) node.intensity /= 255.0;
    return curve;
}

TemplateReference fetusReference() {
    const double total = std::accumulate(std::begin(fetusCounts), std::end(fetusCounts), 0.0);
    std::vector<double> histogram(256, 0.0);
    for (std::size_t bin = 0; bin < std::size(fetusCounts); ++bin) histogram[bin] = fetusCounts[bin] / total;
    return {"simulated fetus", histogram, fetusCurve()};
}

}  // namespace

PhantomConfig fetusTemplateConfig() {
    PhantomConfig config;
    config.size = {128, 128, 128};
    config.spacing = {0.8, 0.8, 0.8};
    config.seed = 1;
    return config;
}

const SharedTemplate& fetusTemplate() {
    static const SharedTemplate shared(fetusReference());
    return shared;
}

}  // namespace echolucent
