// echolucent-bench-kernel: nanoseconds a sample, ours alone (Google Benchmark). Every sample inside the volume is
// taken: no ray ends early and nothing is skipped, so that a figure says what the kernel costs and not what it leaves
// out. The floors are the same rays and samples without all that makes a picture of them.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>
#include <vector>

#include "processing/phantom/phantom.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/kernel_floor.h"

namespace {

using namespace echolucent;

constexpr int pictureEdge = 256;

/// How deep a volume is. Lighting is left out of samples that add less than 1/128 of their pixel: so that all are lit,
/// there must be fewer than that, and each opaque enough.
enum class Depth { usual, shallow };

/// A phantom whose voxels are of another type and have the same share of the white level; where it is masked, a corner
/// of it is no data.
template <typename Voxel>
std::shared_ptr<const Volume> volumeOf(Depth depth, bool masked = false) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size =
        depth == Depth::usual ? std::array<std::int64_t, 3>{128, 128, 128} : std::array<std::int64_t, 3>{256, 256, 32};
    const auto bytes = makePhantom(config);
    const auto& from = std::get<VoxelArray<std::uint8_t>>(bytes->voxels());
    const double white = std::is_same_v<Voxel, std::uint8_t> ? 255.0 : std::is_same_v<Voxel, float> ? 1.0 : 65535.0;
    std::vector<Voxel> voxels(from.size());
    std::transform(from.begin(), from.end(), voxels.begin(),
                   [&](std::uint8_t value) { return static_cast<Voxel>(value / 255.0 * white); });
    const VolumeGeometry& geometry = bytes->geometry();
    const Volume volume(geometry, std::move(voxels), white);
    if (!masked) return std::make_shared<const Volume>(volume);
    std::vector<std::uint8_t> mask(from.size(), 1);
    for (std::int64_t z = 0; z < geometry.size[2] / 4; ++z)
        for (std::int64_t y = 0; y < geometry.size[1] / 4; ++y)
            for (std::int64_t x = 0; x < geometry.size[0] / 4; ++x)
                mask[static_cast<std::size_t>(geometry.offset(x, y, z))] = 0;
    return std::make_shared<const Volume>(volume.withDataMask(std::move(mask)));
}

/// The curve is so opaque that every sample counts, and so little opaque that light is left behind the last.
OpacityCurve curveFor(Depth depth, double share = 1.0) {
    const double opacity = depth == Depth::usual ? 0.002 : 0.02;
    return ManualCurve{{{0.0, opacity * share}, {1.0, 1.2 * opacity * share}}};
}

RayCastSettings settingsOf(const Volume& volume, double turnDegrees) {
    Viewpoint view;
    view.azimuthDegrees = 20.0 + turnDegrees;
    view.elevationDegrees = -12.0;
    RayCastSettings settings;
    settings.width = settings.height = pictureEdge;
    settings.camera = defaultCamera(volume.geometry(), view, 1.0);
    settings.terminationTransmittance = 0.0;
    settings.skipEmptySpace = false;
    return settings;
}

/// Counts the samples of a picture that lie in the volume's box: there is one a unit of each ray's way through it.
double samplesOf(const Volume& volume, const RayCastSettings& settings) {
    const Vec3 low = volume.geometry().boxMinMm(), high = volume.geometry().boxMaxMm();
    const Camera& camera = settings.camera;
    const double pixelMm = camera.heightMm / settings.height;
    double lengthMm = 0.0;
    for (int row = 0; row < settings.height; ++row)
        for (int column = 0; column < settings.width; ++column) {
            const Vec3 point = camera.focalPoint +
                               camera.frame.right * ((column + 0.5 - settings.width * 0.5) * pixelMm) +
                               camera.frame.down * ((row + 0.5 - settings.height * 0.5) * pixelMm);
            double enter = -1e30, leave = 1e30;
            for (int axis = 0; axis < 3; ++axis) {
                const double a = (low[axis] - point[axis]) / camera.frame.forward[axis];
                const double b = (high[axis] - point[axis]) / camera.frame.forward[axis];
                enter = std::max(enter, std::min(a, b));
                leave = std::min(leave, std::max(a, b));
            }
            lengthMm += std::max(0.0, leave - enter);
        }
    return lengthMm / (settings.step * volume.geometry().unit());
}

/// CPU time of all threads a sample, as "s_per_sample" (Google Benchmark writes 1.2n for nanoseconds).
void countSamples(benchmark::State& state, const Volume& volume, const RayCastSettings& settings) {
    state.counters["s_per_sample"] = benchmark::Counter(
        samplesOf(volume, settings), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

enum class Kind { unshaded, shaded, maximum, twoDimensional, shadedTwoDimensional };

/// The same opacities as nodes over intensity and gradient.
Classification twoDimensional(const OpacityCurve& curve) {
    return Classification(tabulated(256, 256, 0.5, [&](double f, double) { return opacityAt(curve, f); }));
}

template <typename Voxel, Kind kind, bool masked = false>
void castPictures(benchmark::State& state) {
    constexpr bool shaded = kind == Kind::shaded || kind == Kind::shadedTwoDimensional;
    constexpr Depth depth = shaded ? Depth::shallow : Depth::usual;
    const auto volume = volumeOf<Voxel>(depth, masked);
    constexpr bool isTwoDimensional = kind == Kind::twoDimensional || kind == Kind::shadedTwoDimensional;
    const Classification otf = isTwoDimensional ? twoDimensional(curveFor(depth)) : Classification(curveFor(depth));
    RayCaster caster(volume);
    int frame = 0;
    for (auto _ : state) {
        // The camera is turned a little, because nothing of the picture before may be used again.
        RayCastSettings settings = settingsOf(*volume, 0.01 * frame++);
        if (shaded) settings.shading = Shading{};
        if (kind == Kind::maximum) settings.mode = RenderMode::maximum;
        benchmark::DoNotOptimize(caster.cast(otf, settings));
    }
    countSamples(state, *volume, settingsOf(*volume, 0.0));
}

/// Each time another curve is shown under one camera: what is kept of the samples is classified and composited anew.
template <typename Voxel>
void editCurves(benchmark::State& state) {
    const auto volume = volumeOf<Voxel>(Depth::usual);
    RayCaster caster(volume);
    const RayCastSettings settings = settingsOf(*volume, 0.0);
    int edit = 0;
    const auto next = [&] {
        benchmark::DoNotOptimize(caster.cast(curveFor(Depth::usual, 1.0 + 0.001 * (++edit % 500)), settings));
    };
    for (int i = 0; i < 3; ++i) next();
    for (auto _ : state) next();
    countSamples(state, *volume, settings);
    state.counters["kept_bytes"] = static_cast<double>(caster.keptSampleBytes());
}

/// The same rays and samples, and nothing of a picture: the least that a sample may cost.
template <bench::FloorOf floor>
void takeSamples(benchmark::State& state) {
    constexpr Depth depth = floor == bench::FloorOf::gradient ? Depth::shallow : Depth::usual;
    const auto volume = volumeOf<std::uint8_t>(depth);
    const VolumeGeometry& geometry = volume->geometry();
    const RayCastSettings settings = settingsOf(*volume, 0.0);
    using namespace ray_casting;
    const auto packed = std::make_shared<const PackedVoxels<std::uint8_t>>(*volume);
    const RayGeometry rays(geometry, settings);
    const LightSource light = lightSource(Shading{}, geometry, settings.camera.frame, settings.colourMap);
    Picture picture = emptyPicture(settings.width, settings.height);
    KernelJob<std::uint8_t> job;
    job.voxels = packed.get();
    job.geometry = geometry;
    job.rays = &rays;
    job.light = &light;
    job.picture = &picture;
    for (auto _ : state) benchmark::DoNotOptimize(bench::sumOfSamples(job, floor));
    countSamples(state, *volume, settings);
}

/// This is done once a volume: a caster is made, and its first picture of one pixel, since some of the work may wait
/// for that.
template <typename Voxel>
void prepareCaster(benchmark::State& state) {
    const auto volume = volumeOf<Voxel>(Depth::usual);
    RayCastSettings settings = settingsOf(*volume, 0.0);
    settings.width = settings.height = 1;
    for (auto _ : state) {
        RayCaster caster(volume);
        benchmark::DoNotOptimize(caster.cast(curveFor(Depth::usual), settings));
    }
}

void registerAll() {
    const auto add = [](const char* name, void (*function)(benchmark::State&)) {
        benchmark::RegisterBenchmark(name, function)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
    };
    add("floor of unshaded/uint8", takeSamples<bench::FloorOf::value>);
    add("floor of shaded/uint8", takeSamples<bench::FloorOf::gradient>);
    add("unshaded/uint8", castPictures<std::uint8_t, Kind::unshaded>);
    add("unshaded/uint16", castPictures<std::uint16_t, Kind::unshaded>);
    add("unshaded/float32", castPictures<float, Kind::unshaded>);
    add("unshaded, no-data mask/uint8", castPictures<std::uint8_t, Kind::unshaded, true>);
    add("shaded/uint8", castPictures<std::uint8_t, Kind::shaded>);
    add("shaded/uint16", castPictures<std::uint16_t, Kind::shaded>);
    add("shaded/float32", castPictures<float, Kind::shaded>);
    add("two-dimensional/uint8", castPictures<std::uint8_t, Kind::twoDimensional>);
    add("two-dimensional/uint16", castPictures<std::uint16_t, Kind::twoDimensional>);
    add("two-dimensional/float32", castPictures<float, Kind::twoDimensional>);
    add("shaded two-dimensional/uint8", castPictures<std::uint8_t, Kind::shadedTwoDimensional>);
    add("shaded two-dimensional/uint16", castPictures<std::uint16_t, Kind::shadedTwoDimensional>);
    add("shaded two-dimensional/float32", castPictures<float, Kind::shadedTwoDimensional>);
    add("maximum/uint8", castPictures<std::uint8_t, Kind::maximum>);
    add("maximum/uint16", castPictures<std::uint16_t, Kind::maximum>);
    add("maximum/float32", castPictures<float, Kind::maximum>);
    add("edit/uint8", editCurves<std::uint8_t>);
    add("edit/uint16", editCurves<std::uint16_t>);
    add("edit/float32", editCurves<float>);
    add("once a volume/uint8", prepareCaster<std::uint8_t>);
    add("once a volume/uint16", prepareCaster<std::uint16_t>);
    add("once a volume/float32", prepareCaster<float>);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    registerAll();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
