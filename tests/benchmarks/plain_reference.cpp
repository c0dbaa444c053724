#include "tests/benchmarks/plain_reference.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>
#include <variant>

namespace echolucent::bench {

namespace {

constexpr double leastTransmittance = 1e-6;

/// One ray at a time, in the order in which light is lost.
template <typename Voxel>
class PlainCaster {
public:
    PlainCaster(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings)
        : m_voxels(std::get<std::vector<Voxel>>(volume.voxels())),
          m_geometry(volume.geometry()),
          m_white(volume.whiteLevel()),
          m_curve(curve),
          m_settings(settings) {
        const ViewFrame& frame = settings.camera.frame;
        const Vec3 towards = settings.shading ? settings.shading->towardsLight : Vec3{0, 0, -1};
        m_light = normalized(frame.right * towards[0] + frame.down * towards[1] + frame.forward * towards[2]);
        m_half = normalized(m_light - frame.forward);
    }

    [[nodiscard]] Vec3 pixel(int column, int row) const {
        const Camera& camera = m_settings.camera;
        const Vec3& forward = camera.frame.forward;
        const double pixelMm = camera.heightMm / m_settings.height;
        const Vec3 point = camera.focalPoint +
                           camera.frame.right * ((column + 0.5 - m_settings.width * 0.5) * pixelMm) +
                           camera.frame.down * ((row + 0.5 - m_settings.height * 0.5) * pixelMm);
        const Vec3 start = point + forward * (m_settings.nearPlaneDepthMm - forward.dot(point));
        const double unit = m_geometry.unit(), stepMm = referenceStep * unit;
        const auto [enter, leave] = throughBox(start);
        Vec3 colour{0, 0, 0};
        double transmittance = 1.0;
        for (auto k = static_cast<std::int64_t>(std::max(0.0, enter) / stepMm); static_cast<double>(k) * stepMm < leave;
             ++k) {
            // What of the step lies in the box, sampled in its middle.
            const double from = std::max(static_cast<double>(k) * stepMm, enter);
            const double to = std::min(static_cast<double>(k + 1) * stepMm, leave);
            if (!(from < to)) continue;
            const Vec3 voxel = m_geometry.voxelFromGridMm(start + forward * (0.5 * (from + to)));
            const double intensity = normalised(voxel);
            const double opacity = opacityForStep(opacityAt(m_curve, intensity), (to - from) / unit);
            if (opacity == 0.0) continue;
            Vec3 shown = colourOf(m_settings.colourMap, intensity);
            if (m_settings.shading) shown = lit(shown, voxel);
            colour += shown * (opacity * transmittance);
            transmittance *= 1.0 - opacity;
            if (transmittance < leastTransmittance) break;
        }
        return colour;
    }

private:
    /// Where the ray from a point enters and leaves the settings' box, mm; empty (enter >= leave) where it misses.
    [[nodiscard]] std::pair<double, double> throughBox(const Vec3& start) const {
        const Vec3& forward = m_settings.camera.frame.forward;
        double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = m_settings.box->low[axis] - start[axis], high = m_settings.box->high[axis] - start[axis];
            if (forward[axis] == 0.0) {
                if (low > 0.0 || high < 0.0) return {0.0, 0.0};
                continue;
            }
            enter = std::max(enter, std::min(low / forward[axis], high / forward[axis]));
            leave = std::min(leave, std::max(low / forward[axis], high / forward[axis]));
        }
        return {enter, leave};
    }
    /// Between the outermost voxel centres only.
    [[nodiscard]] double normalised(const Vec3& voxel) const {
        std::array<std::int64_t, 3> low{}, high{};
        std::array<double, 3> share{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double at =
                std::clamp(voxel[static_cast<int>(axis)], 0.0, static_cast<double>(m_geometry.size[axis] - 1));
            low[axis] = static_cast<std::int64_t>(at);
            high[axis] = std::min(low[axis] + 1, m_geometry.size[axis] - 1);
            share[axis] = at - static_cast<double>(low[axis]);
        }
        const auto value = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
            return static_cast<double>(m_voxels[static_cast<std::size_t>(m_geometry.offset(x, y, z))]);
        };
        const auto alongX = [&](std::int64_t y, std::int64_t z) {
            return value(low[0], y, z) * (1 - share[0]) + value(high[0], y, z) * share[0];
        };
        const auto alongXY = [&](std::int64_t z) {
            return alongX(low[1], z) * (1 - share[1]) + alongX(high[1], z) * share[1];
        };
        const double stored = alongXY(low[2]) * (1 - share[2]) + alongXY(high[2]) * share[2];
        return std::clamp(stored / m_white, 0.0, 1.0);
    }

    /// As Shading says, every sample.
    [[nodiscard]] Vec3 lit(const Vec3& colour, const Vec3& voxel) const {
        const Shading& shading = *m_settings.shading;
        const Vec3 gradient = gradientAt(voxel);
        const double magnitude = length(gradient);
        double surface = 0.0, facing = 0.0, highlight = 0.0;
        if (magnitude > 0.0) {
            const Vec3 normal = gradient * (-1.0 / magnitude);
            const double squared = magnitude * magnitude;
            surface = squared / (squared + shading.gradientFloor * shading.gradientFloor);
            facing = std::max(0.0, (normal.dot(m_light) + shading.wrap) / (1.0 + shading.wrap));
            highlight = shading.specular * std::pow(std::max(0.0, normal.dot(m_half)), shading.specularPower);
        }
        const double factor = shading.ambient +
                              shading.diffuse * (surface * facing + (1.0 - surface) * shading.evenLight) +
                              surface * highlight;
        const Vec3 tint = shadowTintOf(m_settings.colourMap);
        Vec3 bright;
        for (int channel = 0; channel < 3; ++channel)
            bright[channel] =
                std::min(1.0, colour[channel] * factor * (tint[channel] + (1 - tint[channel]) * std::min(1.0, factor)));
        return bright;
    }
    [[nodiscard]] Vec3 gradientAt(const Vec3& voxel) const {
        Vec3 gradient{0, 0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            const double unitsPerVoxel = m_geometry.spacing[axis] / m_geometry.unit();
            const double reach = m_settings.shading->gradientReach / unitsPerVoxel;
            const double last = static_cast<double>(m_geometry.size[static_cast<std::size_t>(axis)] - 1);
            Vec3 before = voxel, after = voxel;
            before[axis] = std::max(voxel[axis] - reach, 0.0);
            after[axis] = std::min(voxel[axis] + reach, last);
            if (!(after[axis] > before[axis])) continue;
            gradient[axis] = (normalised(after) - normalised(before)) / ((after[axis] - before[axis]) * unitsPerVoxel);
        }
        return gradient;
    }

    const std::vector<Voxel>& m_voxels;
    const VolumeGeometry& m_geometry;
    double m_white;
    const OpacityCurve& m_curve;
    const RayCastSettings& m_settings;
    Vec3 m_light, m_half;
};

/// FNV-1a over the bytes of all that a reference depends on.
class Hash {
public:
    void add(const void* data, std::size_t bytes) {
        const auto* byte = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < bytes; ++i) m_value = (m_value ^ byte[i]) * 0x100000001b3ull;
    }
    void add(double value) { add(&value, sizeof value); }
    void add(const Vec3& vector) { add(vector.val, sizeof vector.val); }
    [[nodiscard]] std::string text() const {
        char hex[17];
        std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(m_value));
        return hex;
    }

private:
    std::uint64_t m_value = 0xcbf29ce484222325ull;
};

/// To be raised where PlainCaster computes another picture.
constexpr double referenceVersion = 2;

std::string hashOf(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings, int stride) {
    Hash hash;
    hash.add(referenceVersion);
    std::visit([&](const auto& voxels) { hash.add(voxels.data(), voxels.size() * sizeof voxels[0]); }, volume.voxels());
    for (const std::int64_t size : volume.geometry().size) hash.add(static_cast<double>(size));
    hash.add(volume.geometry().spacing);
    hash.add(volume.whiteLevel());
    const std::vector<double> opacities = sampledOpacities(curve, 255 * 64 + 1);
    hash.add(opacities.data(), opacities.size() * sizeof(double));
    for (int i = 0; i < 256; ++i) hash.add(colourOf(settings.colourMap, i / 255.0));
    for (const int number : {settings.width, settings.height, stride}) hash.add(static_cast<double>(number));
    const Camera& camera = settings.camera;
    for (const Vec3& vector : {camera.focalPoint, camera.frame.right, camera.frame.down, camera.frame.forward,
                               settings.box->low, settings.box->high})
        hash.add(vector);
    for (const double number : {camera.heightMm, settings.nearPlaneDepthMm, referenceStep, leastTransmittance})
        hash.add(number);
    if (settings.shading) {
        const Shading& shading = *settings.shading;
        hash.add(shading.towardsLight);
        hash.add(shadowTintOf(settings.colourMap));
        for (const double number : {shading.ambient, shading.diffuse, shading.specular, shading.specularPower,
                                    shading.gradientReach, shading.gradientFloor, shading.wrap, shading.evenLight})
            hash.add(number);
    }
    return hash.text();
}

int keptPixels(int size, int stride) { return (size + stride - 1) / stride; }

}  // namespace

ReferencePicture referencePicture(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                                  int stride) {
    ReferencePicture reference{settings.width, stride, {}};
    const int kept = keptPixels(settings.width, stride);
    reference.rgb.resize(static_cast<std::size_t>(kept) * static_cast<std::size_t>(kept) * 3);
    std::visit(
        [&]<typename Voxel>(const std::vector<Voxel>&) {
            const PlainCaster<Voxel> caster(volume, curve, settings);
            tbb::parallel_for(0, kept, [&](int row) {
                for (int column = 0; column < kept; ++column) {
                    const Vec3 colour = caster.pixel(column * stride, row * stride);
                    for (int channel = 0; channel < 3; ++channel)
                        reference.rgb[static_cast<std::size_t>((row * kept + column) * 3 + channel)] =
                            static_cast<float>(colour[channel]);
                }
            });
        },
        volume.voxels());
    return reference;
}

ReferencePicture cachedReference(const std::string& folder, const Volume& volume, const OpacityCurve& curve,
                                 const RayCastSettings& settings, int stride) {
    const int kept = keptPixels(settings.width, stride);
    ReferencePicture reference{settings.width, stride, {}};
    reference.rgb.resize(static_cast<std::size_t>(kept) * static_cast<std::size_t>(kept) * 3);
    const auto bytes = static_cast<std::streamsize>(reference.rgb.size() * sizeof(float));
    const auto path = std::filesystem::path(folder) / ("reference-" + hashOf(volume, curve, settings, stride) + ".f32");
    std::error_code none;
    if (std::filesystem::file_size(path, none) == static_cast<std::uintmax_t>(bytes)) {
        std::ifstream file(path, std::ios::binary);
        if (file.read(reinterpret_cast<char*>(reference.rgb.data()), bytes)) return reference;
    }
    reference = referencePicture(volume, curve, settings, stride);
    std::filesystem::create_directories(folder, none);
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(reference.rgb.data()), bytes);
    return reference;
}

}  // namespace echolucent::bench
