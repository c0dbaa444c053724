// A curve that suits a volume, and what must be known of that volume to carry the curve to others.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

class Volume;
struct PhantomConfig;

/// A volume's intensities, and the curve that was made for it.
struct TemplateReference {
    std::string name;               ///< for a person
    std::vector<double> histogram;  ///< 256 shares of its voxels with data by normalised intensity: bin i holds
                                    ///< [i/256, (i+1)/256[; their sum is 1, or all are 0 where there were none
    OpacityCurve curve = ManualCurve{};
    friend bool operator==(const TemplateReference&, const TemplateReference&) = default;
};

/// A reference that copies share. They are equal where the references are.
class SharedTemplate {
public:
    /// It converts by itself, so that a reference stands wherever a shared one does.
    SharedTemplate(TemplateReference reference)
        : m_reference(std::make_shared<const TemplateReference>(std::move(reference))) {}
    // Without moves none is left without a reference.
    SharedTemplate(const SharedTemplate&) = default;
    SharedTemplate& operator=(const SharedTemplate&) = default;
    ~SharedTemplate() = default;

    [[nodiscard]] const TemplateReference& operator*() const { return *m_reference; }
    [[nodiscard]] const TemplateReference* operator->() const { return m_reference.get(); }
    friend bool operator==(const SharedTemplate& one, const SharedTemplate& other) {
        return one.m_reference == other.m_reference || *one == *other;
    }

private:
    std::shared_ptr<const TemplateReference> m_reference;  ///< never null
};

/// The reference of a volume for which a curve was made: its voxels as the picture shows them. Voxels that are not
/// finite are no data.
[[nodiscard]] TemplateReference templateFrom(const Volume& volume, OpacityCurve curve, std::string name);

/// The scene of fetusTemplate(): the fetus in its base condition.
[[nodiscard]] PhantomConfig fetusTemplateConfig();
/// The simulated fetus: makePhantom() of fetusTemplateConfig() with the default speckle reduction, and its adaptive
/// curve seen along +z, reduced to a few nodes. Its numbers are stored, because the phantom takes a while.
[[nodiscard]] const SharedTemplate& fetusTemplate();

}  // namespace echolucent
