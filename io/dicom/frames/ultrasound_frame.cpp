#include "io/dicom/frames/ultrasound_frame.h"

#include <algorithm>
#include <array>

#include "io/files/header_text.h"
#include "io/study/study_assembly.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

namespace {

constexpr DicomTag geometryTag{0x0020, 0x9307};
constexpr DicomTag apexTag{0x0020, 0x9308};
constexpr DicomTag matrixTag{0x0020, 0x9309};
constexpr DicomTag relationshipTag{0x0020, 0x930b};
constexpr DicomTag patientSourceTag{0x0020, 0x930c};
const std::string apexName = "(0020,9308) Apex Position";
const std::string matrixName = "(0020,9309) Volume to Transducer Mapping Matrix";

bool isRigid(const cv::Matx44d& matrix) {
    const Mat3 turn = matrix.get_minor<3, 3>(0, 0);
    const bool lastRow = matrix(3, 0) == 0 && matrix(3, 1) == 0 && matrix(3, 2) == 0 && matrix(3, 3) == 1;
    return lastRow && cv::norm(turn * turn.t() - Mat3::eye()) < 1e-3 && cv::determinant(turn) > 0 &&
           isPosition(Vec3(matrix(0, 3), matrix(1, 3), matrix(2, 3)));
}

std::string inWords(const std::string& acquisitionGeometry) {
    if (acquisitionGeometry == "APEX") return "scan lines from one apex (APEX)";
    if (acquisitionGeometry == "PATIENT") return "relative to the patient (PATIENT)";
    return quotedText(acquisitionGeometry);
}

void readApex(DcmItem& dataset, UltrasoundFrame& frame) {
    if (!dicomHas(dataset, apexTag)) {
        if (frame.acquisitionGeometry == "APEX")
            frame.warnings.push_back(apexName + " is missing, although (0020,9307) says that there is an apex.");
        return;
    }
    const auto values = dicomNumbers(dataset, apexTag, 3);
    if (values.empty() || !isPosition(Vec3(values[0], values[1], values[2]))) {
        frame.warnings.push_back(apexName + " is no position and was left out.");
        return;
    }
    frame.apexMm = Vec3(values[0], values[1], values[2]);
}

void readMatrix(DcmItem& dataset, UltrasoundFrame& frame) {
    if (!dicomHas(dataset, matrixTag)) return;
    const auto values = dicomNumbers(dataset, matrixTag, 16);
    const cv::Matx44d matrix = values.empty() ? cv::Matx44d::zeros() : cv::Matx44d(values.data());
    if (!isRigid(matrix)) {
        frame.warnings.push_back(matrixName + " is no rigid transformation and was left out.");
        return;
    }
    frame.transducerFromVolume = matrix;
    frame.relationship = dicomText(dataset, relationshipTag);
    const std::string story = frame.relationship.empty() || frame.relationship == "FIXED"
                                  ? "stated"
                                  : "nominal: " + quotedText(frame.relationship);
    frame.facts.push_back({"transducer's place", story, matrixName + ", (0020,930b)"});
}

Vec3 axisOf(const cv::Matx44d& matrix, int row) { return {matrix(row, 0), matrix(row, 1), matrix(row, 2)}; }

/// The part of a vector that is perpendicular to `forward`, as a unit vector; no value if that part is shorter than a
/// 20th of the vector.
std::optional<Vec3> across(const Vec3& vector, const Vec3& forward) {
    const Vec3 part = vector - forward * vector.dot(forward);
    if (length(part) < 0.05 * length(vector)) return std::nullopt;
    return normalized(part);
}

/// The direction down in a picture along the grid axis nearest to `forward`.
Vec3 downAlongNearestAxis(const Vec3& forward) {
    constexpr std::array axes{BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                              BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};
    const auto nearest = std::ranges::max_element(
        axes, {}, [&](BeamAxis axis) { return frameOf(Viewpoint{.beamAxis = axis}).forward.dot(forward); });
    // Nothing perpendicular to the nearest axis lies along `forward`.
    return *across(frameOf(Viewpoint{.beamAxis = *nearest}).down, forward);
}

class ProbeFinder {
public:
    ProbeFinder(const UltrasoundFrame& frame, const GridInVolumeFrame& grid, const VolumeGeometry& geometry)
        : m_frame(frame), m_grid(grid), m_geometry(geometry) {}

    std::optional<FoundProbe> find(std::vector<std::string>& warnings);

private:
    [[nodiscard]] Vec3 toGrid(const Vec3& direction) const { return m_grid.direction.t() * direction; }
    bool takeApex(std::vector<std::string>& warnings);
    void takeFace(std::vector<std::string>& warnings);

    const UltrasoundFrame& m_frame;
    const GridInVolumeFrame& m_grid;
    const VolumeGeometry& m_geometry;
    StatedProbe m_probe;
    std::string m_source;
};

bool ProbeFinder::takeApex(std::vector<std::string>& warnings) {
    if (!m_frame.apexMm) return false;
    if (!m_geometry.spacingKnown) {
        warnings.push_back(apexName + " was left out: it is stated in mm, and the size of the pixels is not known.");
        return false;
    }
    const Vec3 apexMm = toGrid(*m_frame.apexMm - m_grid.originMm);
    const Vec3 towardsData = m_geometry.centreMm() - apexMm;
    if (length(towardsData) < m_geometry.unit()) {
        warnings.push_back(apexName + " lies in the middle of the volume, so that it gives sound no direction.");
        return false;
    }
    m_probe.apexMm = apexMm;
    m_probe.forward = normalized(towardsData);
    m_source = apexName;
    return true;
}

/// Takes the normal of the face as the direction of sound, turned if it points away from the data.
void ProbeFinder::takeFace(std::vector<std::string>& warnings) {
    const cv::Matx44d& matrix = *m_frame.transducerFromVolume;
    const Vec3 centre = m_grid.originMm + m_grid.direction * m_geometry.centreMm();
    const bool isBehind = axisOf(matrix, 1).dot(centre) + matrix(1, 3) < 0;
    m_probe.forward = normalized(toGrid(axisOf(matrix, 1) * (isBehind ? -1.0 : 1.0)));
    m_source = matrixName;
    if (isBehind)
        warnings.push_back(matrixName +
                           " puts the volume behind the transducer's face; sound is taken to run from the face to it.");
}

std::optional<FoundProbe> ProbeFinder::find(std::vector<std::string>& warnings) {
    const bool byApex = takeApex(warnings);
    if (!byApex && !m_frame.transducerFromVolume) return std::nullopt;
    if (!byApex) takeFace(warnings);
    m_probe.down = downAlongNearestAxis(m_probe.forward);
    if (!m_frame.transducerFromVolume) return FoundProbe{m_probe, m_source};
    const auto right = across(toGrid(axisOf(*m_frame.transducerFromVolume, 0)), m_probe.forward);
    if (!right) return FoundProbe{m_probe, m_source};
    m_probe.down = m_probe.forward.cross(*right);
    m_probe.planesKnown = true;
    if (byApex) m_source += ", " + matrixName;
    return FoundProbe{m_probe, m_source};
}

}  // namespace

UltrasoundFrame readUltrasoundFrame(DcmItem& dataset) {
    UltrasoundFrame frame;
    frame.acquisitionGeometry = dicomText(dataset, geometryTag);
    if (!frame.acquisitionGeometry.empty())
        frame.facts.push_back({"acquisition geometry", inWords(frame.acquisitionGeometry), tagText(geometryTag)});
    readApex(dataset, frame);
    readMatrix(dataset, frame);
    if (const auto source = dicomText(dataset, patientSourceTag); !source.empty())
        frame.facts.push_back({"place in the patient", quotedText(source), tagText(patientSourceTag)});
    return frame;
}

std::optional<FoundProbe> probeOf(const UltrasoundFrame& frame, const GridInVolumeFrame& grid,
                                  const VolumeGeometry& geometry, std::vector<std::string>& warnings) {
    return ProbeFinder(frame, grid, geometry).find(warnings);
}

}  // namespace echolucent
