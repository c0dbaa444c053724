#include "tests/benchmarks/plain_reference.h"

#include <tbb/parallel_for.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <variant>

#include "processing/ray_caster/plain/plain_caster.h"

namespace echolucent::bench {

namespace {

constexpr double leastTransmittance = 1e-6;

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

/// This number is to be raised where PlainCaster computes another picture.
constexpr double referenceVersion = 3;

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
    for (const double number : {camera.heightMm, settings.front->depthMm, referenceStep, leastTransmittance})
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
    RayCastSettings converged = settings;
    converged.step = referenceStep;
    converged.terminationTransmittance = leastTransmittance;
    const Volume allData = volume.withDataMask(std::vector<std::uint8_t>{});
    const PlainCaster caster(allData, curve, converged);
    tbb::parallel_for(0, kept, [&](int row) {
        for (int column = 0; column < kept; ++column) {
            const Vec3 colour = caster.pixel(column * stride, row * stride).colour;
            for (int channel = 0; channel < 3; ++channel)
                reference.rgb[static_cast<std::size_t>((row * kept + column) * 3 + channel)] =
                    static_cast<float>(colour[channel]);
        }
    });
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
