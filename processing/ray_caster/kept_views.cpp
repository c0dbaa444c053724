#include "processing/ray_caster/kept_views.h"

#include <algorithm>

namespace echolucent::ray_casting {

namespace {

/// The settings that change the samples. All others get their defaults.
RayCastSettings keyOf(RayCastSettings settings) {
    const RayCastSettings standard;
    settings.colourMap = standard.colourMap;
    settings.mixing = standard.mixing;
    settings.brightness = standard.brightness;
    settings.shading = standard.shading;
    settings.lightCoarseness = standard.lightCoarseness;
    settings.depthColouring = standard.depthColouring;
    settings.terminationTransmittance = standard.terminationTransmittance;
    settings.pixelTolerance = standard.pixelTolerance;
    settings.skipEmptySpace = standard.skipEmptySpace;
    settings.findDepth = standard.findDepth;
    return settings;
}

int packetsAcross(int pixels, int packet) { return (pixels + packet - 1) / packet; }

/// The bytes that all samples of a view take, estimated from one ray of each packet.
double bytesOfView(const RayCastSettings& settings, const RayGeometry& rays, const PacketShape& shape) {
    double samples = 0.0;
    for (int row = 0; row < settings.height; row += shape.rows)
        for (int column = 0; column < settings.width; column += shape.columns) {
            const Ray ray = rays.rayThrough(std::min(column + shape.columns / 2, settings.width - 1),
                                            std::min(row + shape.rows / 2, settings.height - 1));
            samples += static_cast<double>(ray.last - ray.first);
        }
    return samples * shape.rows * shape.columns * sizeof(std::uint16_t);
}

std::size_t bytesOf(const KeptSamples& samples) {
    std::size_t bytes = 0;
    for (const KeptSamples::Packet& packet : samples.packets)
        bytes += packet.samples.capacity() * sizeof(std::uint16_t);
    return bytes;
}

}  // namespace

KeptSamples* KeptViews::samplesFor(const RayCastSettings& settings, const RayGeometry& rays, std::size_t memoryLimit) {
    m_keeps = false;
    m_casting = SampleUse::notKept;
    if (settings.mode != RenderMode::direct) return nullptr;
    const RayCastSettings key = keyOf(settings);
    m_views.remove_if([&](const KeptView& view) { return view.key.camera != key.camera; });
    const auto found =
        std::find_if(m_views.begin(), m_views.end(), [&](const KeptView& view) { return view.key == key; });
    if (found == m_views.end()) {
        m_views.push_front({key, {}, false});
        if (m_views.size() > mostViews) m_views.pop_back();
        m_casting = SampleUse::taken;
        return nullptr;
    }
    m_views.splice(m_views.begin(), m_views, found);
    KeptSamples& samples = m_views.front().samples;
    if (!samples.packets.empty()) {
        m_keeps = true;
        m_casting = m_views.front().complete ? SampleUse::kept : SampleUse::taken;
        return &samples;
    }
    const PacketShape shape = packetShape();
    const double wanted = bytesOfView(settings, rays, shape);
    if (wanted > static_cast<double>(memoryLimit)) return nullptr;
    for (auto other = std::next(m_views.begin()); other != m_views.end(); ++other)
        if (wanted + static_cast<double>(bytes()) > static_cast<double>(memoryLimit)) {
            other->samples = {};
            other->complete = false;
        }
    m_keeps = true;
    m_casting = SampleUse::taken;
    samples.packets.resize(static_cast<std::size_t>(packetsAcross(settings.width, shape.columns)) *
                           static_cast<std::size_t>(packetsAcross(settings.height, shape.rows)));
    return &samples;
}

void KeptViews::useNone() {
    m_keeps = false;
    m_casting = SampleUse::notKept;
}

void KeptViews::finishPicture() {
    if (m_keeps) m_views.front().complete = true;
    m_finished = m_casting;
}

std::size_t KeptViews::bytes() const {
    std::size_t bytes = 0;
    for (const KeptView& view : m_views) bytes += bytesOf(view.samples);
    return bytes;
}

}  // namespace echolucent::ray_casting
