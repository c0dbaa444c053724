#include "io/nifti/nifti_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "io/files/input_problems.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

/// Maps voxel indices to mm in NIfTI's frame (x to the right, y to the front, z up).
struct Affine {
    Mat3 steps = Mat3::eye();  ///< columns: the step from one voxel to the next along x, y, z
    Vec3 origin{0, 0, 0};
};

std::string frameWords(std::int64_t code) {
    switch (code) {
        case 1: return "scanner";
        case 2: return "aligned with another scan";
        case 3: return "Talairach";
        case 4: return "MNI 152";
        case 5: return "template";
        default: return fmt::format("of unknown code {}", code);
    }
}

constexpr std::string_view sizesCount = "the sizes of pixdim count, and the patient's frame is unknown";

class Placement {
public:
    Placement(const NiftiHeader& header, StoredVolume& stored) : m_header(header), m_stored(stored) {}
    Result<void> place();

private:
    void readUnit();
    [[nodiscard]] Result<Affine> fromSform() const;
    [[nodiscard]] Result<Affine> fromQform() const;
    Result<void> placeBySizesAlone();
    Result<void> placeBy(const Affine& affine, const std::string& key, std::int64_t code);
    void compareForms(const Affine& sform);
    void setSpacing(const Affine& affine, const std::string& key);
    [[nodiscard]] bool hasVoxelSizes() const;
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem) const {
        return fail(FailureKind::unreadable, m_stored.path, key, problem, correctHeader);
    }
    void note(std::string_view sentence) { m_stored.warnings.emplace_back(sentence); }
    void noteIgnored(std::string_view form, const Failure& why, std::string_view instead) {
        note(fmt::format("{} is ignored: {} {}; {}.", form, why.element, why.problem, instead));
    }

    const NiftiHeader& m_header;
    StoredVolume& m_stored;
    double m_mm = 1.0;  // length of the header's unit
    std::string m_unit;
};

void Placement::readUnit() {
    switch (m_header.xyztUnits & 7) {
        case 0: m_unit = "mm assumed"; return;
        case 1:
            m_mm = 1000.0;
            m_unit = "m by xyzt_units";
            return;
        case 2: m_unit = "mm by xyzt_units"; return;
        case 3:
            m_mm = 0.001;
            m_unit = "um by xyzt_units";
            return;
        default:
            m_unit = "of an unknown unit";
            m_stored.geometry.spacingKnown = false;
            note(fmt::format("xyzt_units is {}, which names no length.", m_header.xyztUnits));
    }
}

bool Placement::hasVoxelSizes() const {
    return std::all_of(m_header.pixdim.begin() + 1, m_header.pixdim.begin() + 4,
                       [](double size) { return std::isfinite(size) && size != 0.0; });
}

Result<Affine> Placement::fromSform() const {
    Affine affine;
    for (int row = 0; row < 3; ++row) {
        const auto& values = m_header.srow[static_cast<std::size_t>(row)];
        for (int axis = 0; axis < 3; ++axis) affine.steps(row, axis) = m_mm * values[static_cast<std::size_t>(axis)];
        affine.origin[row] = m_mm * values[3];
    }
    Mat3 direction = affine.steps;
    if (!normalizeDirection(direction) || !isPosition(affine.origin))
        return wrong("srow_x, srow_y, srow_z", "do not hold three independent directions and a position");
    return affine;
}

Result<Affine> Placement::fromQform() const {
    const auto [b, c, d] = m_header.quatern;
    const double rest = 1.0 - (b * b + c * c + d * d);
    constexpr double tolerance = 1e-3;  // quaternions are stored as float32
    if (!(rest >= -tolerance)) return wrong("quatern_b, quatern_c, quatern_d", "are no rotation");
    if (!hasVoxelSizes()) return wrong("pixdim", "must be finite and not 0 along x, y and z where qform_code is set");
    const double qfac = m_header.pixdim[0];
    if (!std::isfinite(qfac)) return wrong("pixdim[0]", "must be 1 or -1 where qform_code is set");
    // Half turns have a = 0. Rounding of b, c and d would turn them by some hundredths of a degree.
    const double rounding = 3.0 * (m_header.version == 1 ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                                         : std::numeric_limits<double>::epsilon());
    const double a = rest < rounding ? 0.0 : std::sqrt(rest);
    const double scale = 1.0 / std::sqrt(a * a + b * b + c * c + d * d);
    const double w = a * scale, x = b * scale, y = c * scale, z = d * scale;
    const Mat3 rotation(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
                        2 * (x * y + w * z), w * w + y * y - x * x - z * z, 2 * (y * z - w * x),  //
                        2 * (x * z - w * y), 2 * (y * z + w * x), w * w + z * z - x * x - y * y);
    const Vec3 sizes(std::abs(m_header.pixdim[1]), std::abs(m_header.pixdim[2]),
                     std::abs(m_header.pixdim[3]) * (qfac < 0 ? -1.0 : 1.0));
    Affine affine;
    affine.steps = rotation * Mat3::diag(sizes) * m_mm;
    for (int row = 0; row < 3; ++row) affine.origin[row] = m_mm * m_header.qoffset[static_cast<std::size_t>(row)];
    if (!isPosition(affine.origin))
        return wrong("qoffset_x, qoffset_y, qoffset_z", "are no position, or lie farther than 10 km from 0");
    return affine;
}

/// Notes how far a qform that does not count would have moved the volume's corners.
void Placement::compareForms(const Affine& sform) {
    if (m_header.qformCode <= 0) return;
    const auto qform = fromQform();
    if (!qform) {
        noteIgnored("qform", qform.error(), "sform counts");
        return;
    }
    double farthest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 voxel;
        for (int axis = 0; axis < 3; ++axis)
            voxel[axis] = (corner >> axis & 1) != 0
                              ? static_cast<double>(m_stored.geometry.size[static_cast<std::size_t>(axis)] - 1)
                              : 0.0;
        farthest =
            std::max(farthest, length(sform.origin + sform.steps * voxel - qform->origin - qform->steps * voxel));
    }
    if (farthest > 0.5 * m_stored.geometry.unit())
        note(fmt::format("qform and sform put the volume's corners up to {:.3g} mm apart; sform counts.", farthest));
}

/// Takes the stored voxel sizes if the steps of `affine` agree with them but for rounding. Else takes the lengths of
/// the steps, with a note if there are other voxel sizes.
void Placement::setSpacing(const Affine& affine, const std::string& key) {
    Vec3& spacing = m_stored.geometry.spacing;
    bool agrees = hasVoxelSizes();
    for (int axis = 0; axis < 3; ++axis) {
        spacing[axis] = length(Vec3(affine.steps(0, axis), affine.steps(1, axis), affine.steps(2, axis)));
        const double size = m_mm * std::abs(m_header.pixdim[static_cast<std::size_t>(axis) + 1]);
        agrees = agrees && std::abs(size - spacing[axis]) <= 1e-4 * spacing[axis];
    }
    if (agrees)
        for (int axis = 0; axis < 3; ++axis)
            spacing[axis] = m_mm * std::abs(m_header.pixdim[static_cast<std::size_t>(axis) + 1]);
    else if (hasVoxelSizes())
        note(fmt::format("pixdim gives {:.6g} x {:.6g} x {:.6g} (in {}), which {} does not agree with; {} counts.",
                         m_header.pixdim[1], m_header.pixdim[2], m_header.pixdim[3], m_unit, key, key));
    m_stored.spacingSource = (agrees ? "pixdim, " : key + ", ") + m_unit;
}

Result<void> Placement::placeBy(const Affine& affine, const std::string& key, std::int64_t code) {
    VolumeGeometry& geometry = m_stored.geometry;
    setSpacing(affine, key);
    const Mat3 lpsFromRas = Mat3::diag({-1, -1, 1});
    geometry.direction = lpsFromRas * affine.steps;
    geometry.origin = lpsFromRas * affine.origin;
    m_stored.ownAxes = {-1, -1, 1};
    if (!normalizeDirection(geometry.direction)) return wrong(key, "does not hold three independent directions");
    if (auto warning = skewWarning(geometry.direction); !warning.empty()) note(warning);
    geometry.patientFrameKnown = saysMoreThanItsAxes(geometry.direction);
    m_stored.facts.push_back(
        {"patient frame", frameWords(code) + ", RAS turned into LPS", fmt::format("{}, {}_code {}", key, key, code)});
    return {};
}

Result<void> Placement::placeBySizesAlone() {
    const auto& pixdim = m_header.pixdim;
    if (pixdim[1] == 0 && pixdim[2] == 0 && pixdim[3] == 0) {
        m_stored.geometry.spacingKnown = false;
        return {};
    }
    if (!hasVoxelSizes())
        return wrong("pixdim", fmt::format("must be finite and not 0 along x, y and z, not {:.6g} {:.6g} {:.6g}",
                                           pixdim[1], pixdim[2], pixdim[3]));
    for (int axis = 0; axis < 3; ++axis)
        m_stored.geometry.spacing[axis] = m_mm * std::abs(pixdim[static_cast<std::size_t>(axis) + 1]);
    m_stored.spacingSource = "pixdim, " + m_unit;
    const bool stated = m_header.sformCode > 0 || m_header.qformCode > 0;
    m_stored.facts.push_back({"patient frame", stated ? "unknown" : "not stated",
                              fmt::format("sform_code {}, qform_code {}", m_header.sformCode, m_header.qformCode)});
    return {};
}

Result<void> Placement::place() {
    for (std::size_t axis = 0; axis < 3; ++axis) m_stored.geometry.size[axis] = m_header.dim[axis + 1];
    readUnit();
    if (std::any_of(m_header.pixdim.begin() + 1, m_header.pixdim.begin() + 4, [](double size) { return size < 0; }))
        note("pixdim is negative, which NIfTI does not allow: taken as positive.");
    if (m_header.sformCode > 0) {
        const auto sform = fromSform();
        if (sform) {
            if (auto placed = placeBy(*sform, "sform", m_header.sformCode); !placed) return placed;
            compareForms(*sform);
            return {};
        }
        noteIgnored("sform", sform.error(), m_header.qformCode > 0 ? "qform counts" : sizesCount);
    }
    if (m_header.qformCode <= 0) return placeBySizesAlone();
    const auto qform = fromQform();
    if (qform) return placeBy(*qform, "qform", m_header.qformCode);
    noteIgnored("qform", qform.error(), sizesCount);
    return placeBySizesAlone();
}

}  // namespace

Result<void> placeNifti(const NiftiHeader& header, StoredVolume& stored) { return Placement(header, stored).place(); }

}  // namespace echolucent
