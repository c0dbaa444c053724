// A curve that suits a volume, and the intensities of that volume, from which the curve is carried to others.
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
    std::string name;  ///< for a person
    /// Shares of the volume's voxels with data by normalised intensity: bin i of 256 holds [i/256, (i+1)/256[. Their
    /// sum is 1, or 0 without data.
    std::vector<double> histogram;
    OpacityCurve curve = ManualCurve{};
    friend bool operator==(const TemplateReference&, const TemplateReference&) = default;
};

/// A reference that copies share. Two are equal if their references are.
class SharedTemplate {
public:
    /// A reference converts implicitly, so that it can stand for a shared one.
    SharedTemplate(TemplateReference reference)
        : m_reference(std::make_shared<const TemplateReference>(std::move(reference))) {}
    // No moves: a moved-from object would have no reference.
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

/// The reference of a volume with a curve made for it. `volume` holds the voxels as the picture shows them. Voxels that
/// are not finite are no data.
[[nodiscard]] TemplateReference templateFrom(const Volume& volume, OpacityCurve curve, std::string name);

/// The phantom of fetusTemplate(): the fetus with the defaults of PhantomConfig, in 128^3 voxels of 0.8 mm.
[[nodiscard]] PhantomConfig fetusTemplateConfig();
/// The simulated fetus: makePhantom() of fetusTemplateConfig() with the default speckle reduction. Its curve is the
/// adaptive one along +z, reduced to a few nodes. Its numbers are stored, because making the phantom takes a while.
[[nodiscard]] const SharedTemplate& fetusTemplate();

}  // namespace echolucent
