// The light volume for the pictures of one volume. It is made again if its inputs changed, or if the picture before
// needed none.
#pragma once

#include <memory>
#include <optional>

#include "processing/light/light_sweep.h"
#include "processing/ray_caster/packed/packed_light.h"
#include "processing/volume/row_marks.h"

namespace echolucent::ray_casting {

class LightReaching {
public:
    explicit LightReaching(std::shared_ptr<const Volume> volume) : m_volume(std::move(volume)) {}

    /// Follows another cut of the same scan. `masked` are the rows that the new cut marks otherwise
    /// (rowsMaskedOtherwise()).
    void setCut(std::shared_ptr<const Volume> volume, const RowMarks& masked) {
        m_volume = std::move(volume);
        if (m_sweep) m_sweep->setCut(m_volume, masked);
        m_packed.reset();
    }
    /// False if cancelled. Then there is no light volume.
    [[nodiscard]] bool update(const LightOtf& otf, const RayCastSettings& settings, const Progress& progress);
    /// Time of the newest update. 0 if the light volume stayed as it was, or nobody asked for one.
    [[nodiscard]] double milliseconds() const { return m_milliseconds; }
    /// Null if the newest update() needed no light volume or was cancelled.
    [[nodiscard]] const PackedLight* packed() const { return m_packed ? &*m_packed : nullptr; }

private:
    std::shared_ptr<const Volume> m_volume;
    std::optional<LightSweep> m_sweep;  ///< made for the first picture that asks for it
    std::optional<Classification> m_classification;
    LightScene m_scene;
    std::optional<PackedLight> m_packed;
    double m_milliseconds = 0.0;
};

}  // namespace echolucent::ray_casting
