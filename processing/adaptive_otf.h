// The adaptive opacity transfer function of Petersch et al. 2005, section 4, as method.md settles it: values in, the
// curve and everything a teacher wants to see out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/progress.h"
#include "processing/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// a of the initial function where nobody asks for another: opacity at full intensity, before the clamp. Chosen by
/// looking.
inline constexpr double defaultOpacityScale = 1.0;

/// What tells tissue from fluid along a tube core.
enum class InterfaceFunction {
    variance,  ///< variance of the cell's voxels, tracked through scale space (Petersch 2005, 4.1)
    ratio,     ///< logarithm of mean behind over mean before: speckle multiplies, so its false alarms do not depend on
               ///< the mean (Touzi 1988); no scale space
};

/// What the tubes make of the initial function.
enum class CurveForm {
    product,  ///< initial function times one basis function per tube core (Petersch 2005, eq. 4)
    ramp,     ///< the mean, weighted by d, of one ramp per tube core: clear up to its fluid, full from its surface on
};

/// What lies beyond a tube's ends when its interface function is smoothed.
enum class TubeBorder {
    mirrorThenZero,  ///< mirrored in front, zero behind the far end
    circular,        ///< the far end again, as an FFT without padding gives it
};

/// How the interface function is convolved with a Gaussian.
enum class SmoothingRoute { direct, fourier, recursive };

/// How a tube core's samples are taken where they do not lie on voxels.
enum class TubeSampling { trilinear, nearest };

/// Arithmetic of samples, moments and interface function. The curve is double always.
enum class Precision { single32, double64 };

/// How the method is run. Lengths are in units (the volume's smallest spacing) along and across the tube cores.
struct AdaptiveOtfConfig {
    InterfaceFunction interfaceFunction = InterfaceFunction::ratio;
    CurveForm form = CurveForm::ramp;
    int tubeColumns = 15;      ///< tube cores across the view's right axis, >= 1 (Petersch 2005, 6.1)
    int tubeRows = 15;         ///< tube cores across the view's down axis, >= 1
    double tubeSpacing = 0.0;  ///< units between tube cores; 0: automatic, so that the grid covers the volume (13 in
                               ///< the paper's 199x197x199)
    int cellSize = 5;          ///< edge of a cell, units, 2 to 32; cells slide by one unit
    int coarsestScale = 7;     ///< Gaussian kernels of size 2^n, n from here ...
    int finestScale = 3;       ///< ... down to here
    double sigmaPerKernelSize = 0.25;  ///< standard deviation = this times 2^n units
    double kernelCut = 3.0;            ///< kernels end at this many standard deviations, renormalised
    double significance = 0.4;         ///< a local maximum counts from this share of the largest value in its range
    double floorQuantile = 0.1;  ///< this quantile of a tube's interface function is taken off before tracking, [0,1];
                                 ///< 0: nothing, as in method.md's table
    int cellStride = 1;  ///< units between the cells that are looked at, >= 1, from the tube's first on (interface
                         ///< function, tracking, prior cells); 5: abutting, as the paper's figures may be read. Sigma
                         ///< stays in units. cellMeans and interfaceFunction of a TubeCore hold all cells even so.
    TubeBorder border = TubeBorder::mirrorThenZero;
    SmoothingRoute smoothing = SmoothingRoute::direct;
    bool kernelEndsAtZero = true;          ///< lowered so that it ends at zero; false: cut, as in method.md's table
    bool coarsestMustHaveMaximum = false;  ///< true: without a maximum at the coarsest scale there is no surface;
                                           ///< false: tracking begins at the coarsest scale that has one
    double trackingRangeSigmas = 0.0;   ///< how far around a scale's maximum the next one looks, in sigmas of the scale
                                        ///< where it was found; 0: from valley to valley
    bool priorCellsMayOverlap = false;  ///< prior cells are i < s (Petersch 2005, eq. 8); false: i <= s - cellSize
    int rankBins = 0;  ///< bins of the histograms of eqs. 9 and 10, over 0 to the largest value; 0: exact ranks
    TubeSampling sampling = TubeSampling::trilinear;
    Precision precision = Precision::single32;
    int slopeHalfStep = 5;          ///< slope: central difference of cell means over +- this many units
    double leastEdgeToNoise = 4.0;  ///< a surface whose edge to noise is less weighs nothing: the absolute test that
                                    ///< ranks cannot be; 0: no test, as in method.md's table
    int lowReach = 10;  ///< I_L: mean over so many of the last prior cells; 0: over all of them (Petersch 2005, 4.1)
    int highReach = 8;  ///< I_H: largest cell mean from the surface to so many cells behind it; 0: at the surface
    double falseAlarm = 3.25;   ///< ratio: least contrast, in standard deviations of the contrast where nothing is
    double rampBegin = 0.4;     ///< ramp: an intensity is clear up to this share of the way from I_L to I_H ...
    double clearSpreads = 2.5;  ///< ... and up to so many standard deviations of the fluid's own voxels above I_L, >= 0
    double rampEnd = 1.6;       ///< ramp: full from this share of the way on; above rampBegin
    double rampOpacity = 1.0;   ///< ramp: opacity where all tube cores say surface, (0,1]
    double trustedShare = 0.05;  ///< ramp: share of the tube cores that must have a weight for the initial function to
                                 ///< have no say in the curve; below, both are mixed
    double strength = 6.75;      ///< T * d_max: one rule for any number of tube cores, >= 0
    OpacityCurve initial = PowerCurve{2, defaultOpacityScale};  ///< the initial function; its scale is a
    friend bool operator==(const AdaptiveOtfConfig&, const AdaptiveOtfConfig&) = default;
};

/// The readings of the method that are reported side by side (docs/method.md).
enum class MethodReading {
    asPublished,  ///< the paper's words taken literally, with the erratum of eq. 5 and d_max 0.03
    settled,      ///< the open points settled as in method.md's table
    standard,     ///< what the program uses where nobody asks for another
};
/// "published", "settled", "default".
[[nodiscard]] std::string_view nameOf(MethodReading reading);
[[nodiscard]] std::optional<MethodReading> methodReadingFromName(std::string_view name);
/// The config of a reading; `standard` is AdaptiveOtfConfig{}.
[[nodiscard]] AdaptiveOtfConfig configOf(MethodReading reading);
/// The reading that a config is, whatever its tube grid and initial function; none: another.
[[nodiscard]] std::optional<MethodReading> readingOf(const AdaptiveOtfConfig& config);

/// What is out of range in a config, lower case, no full stop ("the cell size must be 2 to 32"); empty: nothing.
[[nodiscard]] std::string problemOf(const AdaptiveOtfConfig& config);

enum class TubeStatus {
    surface,  ///< an interface was detected with at least one cell before it
    none,     ///< no maximum, or none with a cell in front of it: d = 0
    outside,  ///< the tube core's axis misses the volume (or meets no data): not counted in T and N
};

/// One tube core. Intensities are normalised, lengths in units, positions in voxel index space.
struct TubeCore {
    int column = 0;  ///< u: index along the view's right axis
    int row = 0;     ///< v: index along the view's down axis
    TubeStatus status = TubeStatus::outside;
    std::optional<Vec3> entryVoxel;         ///< where its axis enters the volume (the picture's near cut included)
    std::optional<Vec3> surfaceVoxel;       ///< centre of the detected cell on the axis
    Vec3 firstSampleVoxel{0, 0, 0};         ///< axis position of sample 0
    int firstCell = 0;                      ///< cells before this one hold too little data: here the tube begins
    int surfaceCell = -1;                   ///< s_t, index into the arrays below; -1: none
    std::optional<double> lowIntensity;     ///< I_L: mean over the cells prior to the surface (i <= s - cellSize)
    std::optional<double> highIntensity;    ///< I_H: mean of the surface cell
    std::optional<double> lowIntensityMax;  ///< largest mean of a prior cell (eq. 8)
    std::optional<double> slope;            ///< S: per unit; may be negative
    std::optional<double> edgeToNoise;  ///< rise from the median prior cell mean to the mean slopeHalfStep behind the
                                        ///< surface, over the scatter of the prior cell means; none: too few of them
    std::optional<double> contrast;     ///< ratio: at the surface, standard deviations of the voxels of a slab
    std::optional<double> fluidSpread;  ///< ratio: standard deviation of voxels around I_L (speckle)
    double intensityWeight = 0.0;       ///< w_I, eq. 9
    double slopeWeight = 0.0;           ///< w_S, eq. 10
    double extraWeight = 1.0;  ///< 0 where I_H <= I_L (eq. 6 has no meaning there) or the edge drowns in the noise
                               ///< (leastEdgeToNoise), else 1
    double d = 0.0;            ///< d_t = d_max w_I w_S extraWeight, eq. 11

    std::vector<float> cellMeans;          ///< mean normalised intensity of cell i (samples i ... i+cellSize-1)
    std::vector<float> interfaceFunction;  ///< the interface indicating function of cell i: variance of normalised
                                           ///< intensity, or the contrast at its middle (ratio)
    std::vector<int> trackedCells;         ///< detected cell at each scale, for Fig. 4: from the coarsest that has a
                                           ///< maximum to the finest, the unsmoothed function last
};

/// Where the time went, in ms of wall time. The tubes' stages run mixed on all threads; their wall time is shared out
/// by the time the threads spent in each.
struct StageTimes {
    double sampling = 0.0, cells = 0.0, detection = 0.0, weights = 0.0, curve = 0.0, total = 0.0;
};

struct AdaptiveOtf {
    static constexpr int sampleCount = 256;
    AdaptiveOtfConfig config;                      ///< as asked for
    std::array<double, 2> tubeSpacingUnits{0, 0};  ///< as used, along the view's right and down axes
    Viewpoint view;
    Vec3 directionVoxel{0, 0, 1};          ///< unit, voxel index space
    double tubeLengthUnit = 1.0;           ///< mm per unit
    int tubesMeetingVolume = 0;            ///< T and N
    int tubesWithSurface = 0;              ///< status surface and d > 0
    double dMax = 0.0;                     ///< strength / T
    std::vector<TubeCore> tubes;           ///< row-major: index = row * tubeColumns + column
    std::optional<double> leastContrast;   ///< ratio: a boundary counted from here on
    std::optional<double> fluidIntensity;  ///< ratio: means below it counted as fluid; none: no boundary anywhere
    double trust = 1.0;                    ///< ramp: the curve is trust * ramp + (1 - trust) * initial function, [0,1]
    std::vector<double> logOpacity;        ///< sampleCount values: ln of the curve before any clamp; the product:
                                           ///< ln initial(x) + sum ln(1+d) g(x)
    SampledCurve curve;                    ///< min(1, exp(logOpacity))
    std::string message;  ///< a sentence where something could not be done ("no surface found: ..."); else empty
    StageTimes times;
};

/// Runs the method. Empty only where progress.cancel was raised. The same bits for any number of threads.
/// Throws std::invalid_argument where problemOf(config) is not empty.
[[nodiscard]] std::optional<AdaptiveOtf> adaptOpacity(const Volume& volume, const Viewpoint& view,
                                                      const AdaptiveOtfConfig& config, const Progress& progress = {});

/// g_t(x) of eq. 5 with its erratum, in the scaled form: u = ((x - low) + (x - high)) / (high - low),
/// g = u exp((1 - u^2) / 2). -1 at low, +1 at high. Needs high > low.
[[nodiscard]] double basisFunction(double intensity, double low, double high);

}  // namespace echolucent
