#include "io/writers/enhanced_us_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcwcache.h>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "io/files/input_file.h"
#include "io/output/atomic_file.h"
#include "io/writers/dicom_item_writer.h"

namespace echolucent {

namespace {

using Phases = std::vector<std::shared_ptr<const Volume>>;

/// Identifiers and time that all parts of the object share.
struct ObjectIdentity {
    std::string volumeFrame = newDicomUid();
    std::string dimensions = newDicomUid();
    OFString date, time;
    ObjectIdentity() {
        DcmDate::getCurrentDate(date);
        DcmTime::getCurrentTime(time, OFTrue);
    }
};

class EnhancedUsObject {
public:
    EnhancedUsObject(const Phases& phases, const EnhancedUsDetails& details)
        : m_phases(phases),
          m_details(details),
          m_geometry(phases.front()->geometry()),
          m_patientPlanes(m_geometry.patientFrameKnown || !details.apexMm) {
        putIdentity();
        putEquipment();
        putFramesOfReference();
        putDimensions();
        putImage();
        putScan();
        putSharedGroups();
        putFrames();
        putPixels();
    }
    [[nodiscard]] DcmFileFormat& file() { return m_file; }

private:
    void putIdentity();
    void putEquipment();
    void putFramesOfReference();
    void putDimensions();
    void putImage();
    void putSharedGroups();
    void putFrames();
    void putPixels();
    void putDimension(const DcmTagKey& attribute, const DcmTagKey& group, const char* label);
    void putCode(const DcmTagKey& sequence, const char* scheme, const char* value, const char* meaning);
    void putScan();
    void putWindow(DicomItemWriter window) const;
    [[nodiscard]] std::vector<double> orientation() const;
    [[nodiscard]] std::vector<double> transducerFromVolume() const;

    const Phases& m_phases;
    const EnhancedUsDetails& m_details;
    const VolumeGeometry& m_geometry;
    const bool m_patientPlanes;
    const ObjectIdentity m_identity;
    DcmFileFormat m_file;
    DicomItemWriter m_root{*m_file.getDataset()};
};

std::vector<double> numbersOf(const Vec3& vector) { return {vector[0], vector[1], vector[2]}; }

void EnhancedUsObject::putIdentity() {
    m_root.text(DCM_SOPClassUID, UID_EnhancedUSVolumeStorage);
    m_root.text(DCM_SOPInstanceUID, newDicomUid());
    m_root.text(DCM_StudyInstanceUID, newDicomUid());
    m_root.text(DCM_SeriesInstanceUID, newDicomUid());
    for (const DcmTagKey& empty : {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate,
                                   DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber,
                                   DCM_PositionReferenceIndicator, DCM_Laterality, DCM_PatientOrientation})
        m_root.text(empty, "");
    m_root.text(DCM_PatientIdentityRemoved, "YES");
    m_root.text(DCM_DeidentificationMethod, "SIMULATED: there is no patient");
    m_root.text(DCM_StudyDescription, "SIMULATED");
    m_root.text(DCM_SeriesDescription, "SIMULATED");
    m_root.text(DCM_ImageComments, "SIMULATED");
    m_root.text(DCM_Modality, "US");
    m_root.text(DCM_SeriesNumber, "1");
    m_root.text(DCM_InstanceNumber, "1");
    m_root.text(DCM_ContentDate, m_identity.date);
    m_root.text(DCM_ContentTime, m_identity.time);
}

void EnhancedUsObject::putEquipment() {
    m_root.text(DCM_Manufacturer, "Echolucent");
    m_root.text(DCM_ManufacturerModelName, "Simulated scan");
    m_root.text(DCM_DeviceSerialNumber, "SIMULATED");
    m_root.text(DCM_SoftwareVersions, "SIMULATED");
    m_root.emptySequence(DCM_AcquisitionContextSequence);
    m_root.text(DCM_SynchronizationFrameOfReferenceUID, newDicomUid());
    m_root.text(DCM_SynchronizationTrigger, "NO TRIGGER");
    m_root.text(DCM_AcquisitionTimeSynchronized, "N");
}

/// The rigid map from the volume's frame of reference to the transducer's, row by row: x towards the marker, y along
/// the sound, z completes them.
std::vector<double> EnhancedUsObject::transducerFromVolume() const {
    const Vec3 origin = m_geometry.origin + m_geometry.direction * m_details.transducer.faceMm;
    const Vec3 x = m_geometry.direction * m_details.transducer.alongMarker;
    const Vec3 y = m_geometry.direction * m_details.transducer.alongSound;
    std::vector<double> matrix;
    for (const Vec3& axis : {x, y, x.cross(y)})
        matrix.insert(matrix.end(), {axis[0], axis[1], axis[2], -axis.dot(origin)});
    matrix.insert(matrix.end(), {0, 0, 0, 1});
    return matrix;
}

void EnhancedUsObject::putFramesOfReference() {
    m_root.text(DCM_FrameOfReferenceUID, newDicomUid());
    m_root.text(DCM_VolumeFrameOfReferenceUID, m_identity.volumeFrame);
    m_root.text(DCM_UltrasoundAcquisitionGeometry, m_details.apexMm ? "APEX" : "PATIENT");
    if (m_details.apexMm)
        m_root.doubles(DCM_ApexPosition, numbersOf(m_geometry.origin + m_geometry.direction * *m_details.apexMm));
    m_root.text(DCM_VolumeToTransducerRelationship, "FIXED");
    m_root.doubles(DCM_VolumeToTransducerMappingMatrix, transducerFromVolume());
    if (m_patientPlanes) m_root.text(DCM_PatientFrameOfReferenceSource, "ESTIMATED");
}

void EnhancedUsObject::putDimension(const DcmTagKey& attribute, const DcmTagKey& group, const char* label) {
    DicomItemWriter item = m_root.newItem(DCM_DimensionIndexSequence);
    item.tag(DCM_DimensionIndexPointer, attribute);
    item.tag(DCM_FunctionalGroupPointer, group);
    item.text(DCM_DimensionOrganizationUID, m_identity.dimensions);
    item.text(DCM_DimensionDescriptionLabel, label);
}

/// PS3.3 C.8.24.3.3 demands these three, in this order, for every object.
void EnhancedUsObject::putDimensions() {
    m_root.newItem(DCM_DimensionOrganizationSequence).text(DCM_DimensionOrganizationUID, m_identity.dimensions);
    m_root.text(DCM_DimensionOrganizationType, m_phases.size() > 1 ? "3D_TEMPORAL" : "3D");
    if (m_details.phaseSeconds)
        putDimension(DCM_TemporalPositionTimeOffset, DCM_TemporalPositionSequence, "Temporal position");
    else
        putDimension(DCM_TemporalPositionIndex, DCM_FrameContentSequence, "Temporal position");
    putDimension(DCM_ImagePositionVolume, DCM_PlanePositionVolumeSequence, "Spatial position");
    putDimension(DCM_DataType, DCM_ImageDataTypeSequence, "Data type");
}

void EnhancedUsObject::putImage() {
    const auto bits = static_cast<std::uint16_t>(m_phases.front()->typeName() == "uint8" ? 8 : 16);
    m_root.text(DCM_ImageType, "ORIGINAL\\PRIMARY\\VOLUME\\NONE");
    m_root.word(DCM_SamplesPerPixel, 1);
    m_root.text(DCM_PhotometricInterpretation, "MONOCHROME2");
    m_root.text(DCM_PresentationLUTShape, "IDENTITY");
    m_root.word(DCM_Columns, static_cast<std::uint16_t>(m_geometry.size[0]));
    m_root.word(DCM_Rows, static_cast<std::uint16_t>(m_geometry.size[1]));
    m_root.text(DCM_NumberOfFrames, std::to_string(m_geometry.size[2] * static_cast<std::int64_t>(m_phases.size())));
    m_root.word(DCM_BitsAllocated, bits);
    m_root.word(DCM_BitsStored, bits);
    m_root.word(DCM_HighBit, static_cast<std::uint16_t>(bits - 1));
    m_root.word(DCM_PixelRepresentation, 0);
    m_root.text(DCM_AcquisitionDateTime, m_identity.date + m_identity.time);
    m_root.doubles(DCM_AcquisitionDuration,
                   {m_details.phaseSeconds.value_or(0.0) * static_cast<double>(m_phases.size() - 1)});
    m_root.text(DCM_PositionMeasuringDeviceUsed, "RIGID");
    m_root.text(DCM_LossyImageCompression, "00");
    m_root.text(DCM_BurnedInAnnotation, "NO");
    m_root.text(DCM_RescaleIntercept, "0");
    m_root.text(DCM_RescaleSlope, "1");
}

void EnhancedUsObject::putCode(const DcmTagKey& sequence, const char* scheme, const char* value, const char* meaning) {
    DicomItemWriter code = m_root.newItem(sequence);
    code.text(DCM_CodeValue, value);
    code.text(DCM_CodingSchemeDesignator, scheme);
    code.text(DCM_CodeMeaning, meaning);
}

/// The scan's anatomy, view and transducer. The standard demands them even if nobody was scanned.
void EnhancedUsObject::putScan() {
    putCode(DCM_AnatomicRegionSequence, "DCM", "113681", "Phantom");
    putCode(DCM_ViewCodeSequence, "SCT", "62824007", "Transverse");
    putCode(DCM_TransducerScanPatternCodeSequence, "DCM", "125242", "Volume scan pattern");
    putCode(DCM_TransducerGeometryCodeSequence, "DCM", "125252", "Linear ultrasound transducer geometry");
    putCode(DCM_TransducerBeamSteeringCodeSequence, "DCM", "125257", "Fixed beam direction");
    putCode(DCM_TransducerApplicationCodeSequence, "DCM", "125261", "External Transducer");
    for (const DcmTagKey& index :
         {DCM_MechanicalIndex, DCM_BoneThermalIndex, DCM_CranialThermalIndex, DCM_SoftTissueThermalIndex})
        m_root.decimals(index, {0});
    const auto depths = m_geometry.depthsAlong(m_details.transducer.alongSound);
    const double depth = depths.farthest - depths.nearest;
    m_root.doubles(DCM_DepthsOfFocus, {depth});
    m_root.text(DCM_DepthOfScanField, std::to_string(std::lround(depth)));
}

std::vector<double> EnhancedUsObject::orientation() const {
    const Mat3& d = m_geometry.direction;
    return {d(0, 0), d(1, 0), d(2, 0), d(0, 1), d(1, 1), d(2, 1)};
}

void EnhancedUsObject::putWindow(DicomItemWriter window) const {
    const double white = m_phases.front()->whiteLevel();
    window.decimals(DCM_WindowCenter, {white / 2});
    window.decimals(DCM_WindowWidth, {white});
}

void EnhancedUsObject::putSharedGroups() {
    DicomItemWriter groups = m_root.newItem(DCM_SharedFunctionalGroupsSequence);
    DicomItemWriter measures = groups.newItem(DCM_PixelMeasuresSequence);
    measures.decimals(DCM_PixelSpacing, {m_geometry.spacing[1], m_geometry.spacing[0]});  // between rows first
    measures.decimals(DCM_SliceThickness, {m_geometry.spacing[2]});
    measures.decimals(DCM_SpacingBetweenSlices, {m_geometry.spacing[2]});
    groups.newItem(DCM_PlaneOrientationVolumeSequence).doubles(DCM_ImageOrientationVolume, orientation());
    if (m_patientPlanes)
        groups.newItem(DCM_PlaneOrientationSequence).decimals(DCM_ImageOrientationPatient, orientation());
    putWindow(groups.newItem(DCM_FrameVOILUTSequence));
    DicomItemWriter type = groups.newItem(DCM_ImageDataTypeSequence);
    type.text(DCM_DataType, "TISSUE_INTENSITY");
    type.text(DCM_AliasedDataType, "NO");
    DicomItemWriter description = groups.newItem(DCM_USImageDescriptionSequence);
    description.text(DCM_FrameType, "ORIGINAL\\PRIMARY\\VOLUME\\NONE");
    description.text(DCM_VolumetricProperties, "VOLUME");
    description.text(DCM_VolumeBasedCalculationTechnique, "NONE");
}

void EnhancedUsObject::putFrames() {
    for (std::size_t phase = 0; phase < m_phases.size(); ++phase)
        for (std::int64_t slice = 0; slice < m_geometry.size[2]; ++slice) {
            DicomItemWriter groups = m_root.newItem(DCM_PerFrameFunctionalGroupsSequence);
            DicomItemWriter content = groups.newItem(DCM_FrameContentSequence);
            const auto time = static_cast<std::uint32_t>(phase + 1);
            content.longWords(DCM_DimensionIndexValues, {time, static_cast<std::uint32_t>(slice + 1), 1});
            content.text(DCM_FrameAcquisitionDateTime, m_identity.date + m_identity.time);
            content.text(DCM_FrameReferenceDateTime, m_identity.date + m_identity.time);
            content.doubles(DCM_FrameAcquisitionDuration, {0});
            if (!m_details.phaseSeconds) content.longWords(DCM_TemporalPositionIndex, {time});
            if (m_details.phaseSeconds)
                groups.newItem(DCM_TemporalPositionSequence)
                    .doubles(DCM_TemporalPositionTimeOffset, {static_cast<double>(phase) * *m_details.phaseSeconds});
            const Vec3 position = m_geometry.patientFromVoxel(Vec3(0, 0, static_cast<double>(slice)));
            groups.newItem(DCM_PlanePositionVolumeSequence).doubles(DCM_ImagePositionVolume, numbersOf(position));
            if (m_patientPlanes)
                groups.newItem(DCM_PlanePositionSequence).decimals(DCM_ImagePositionPatient, numbersOf(position));
        }
}

void EnhancedUsObject::putPixels() {
    if (std::holds_alternative<VoxelArray<std::uint8_t>>(m_phases.front()->voxels())) {
        std::vector<std::uint8_t> pixels;
        for (const auto& phase : m_phases) {
            const auto& voxels = std::get<VoxelArray<std::uint8_t>>(phase->voxels());
            pixels.insert(pixels.end(), voxels.begin(), voxels.end());
        }
        m_root.pixels(pixels);
        return;
    }
    std::vector<std::uint16_t> pixels;
    for (const auto& phase : m_phases) {
        const auto& voxels = std::get<VoxelArray<std::uint16_t>>(phase->voxels());
        pixels.insert(pixels.end(), voxels.begin(), voxels.end());
    }
    m_root.pixels(pixels);
}

/// The bytes of the file, for writing it whole or not at all.
std::string bytesOfFile(DcmFileFormat& file) {
    std::string bytes;
    std::vector<char> buffer(std::size_t{1} << 20);
    DcmOutputBufferStream stream(buffer.data(), static_cast<offile_off_t>(buffer.size()));
    DcmWriteCache cache;
    OFCondition done = EC_StreamNotifyClient;  // DCMTK returns this if the buffer is full
    file.transferInit();
    while (done == EC_StreamNotifyClient) {
        done = file.write(stream, EXS_LittleEndianExplicit, EET_ExplicitLength, &cache);
        void* filled = nullptr;
        offile_off_t count = 0;
        stream.flushBuffer(filled, count);
        bytes.append(static_cast<const char*>(filled), static_cast<std::size_t>(count));
    }
    file.transferEnd();
    if (done.bad()) throw std::logic_error(std::string("writeEnhancedUs: ") + done.text());
    return bytes;
}

Result<void> check(const std::string& path, const Phases& phases) {
    const Volume& first = *phases.front();
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unwritable, path, "", problem, remedy);
    };
    if (std::holds_alternative<VoxelArray<float>>(first.voxels()))
        return refuse("cannot hold float32 voxels: an Enhanced US Volume has 8 or 16 bits", "Write it as .mha.");
    if (!first.valueScale().isIdentity())
        return refuse(std::string("cannot hold values that begin ") +
                          (first.blackValue() < 0.0 ? "below" : "far above") +
                          " 0: an Enhanced US Volume has 8 or 16 bits without a sign",
                      "Write it as .mha.");
    if (!first.geometry().spacingKnown)
        return refuse("cannot hold a volume of unknown spacing: an Enhanced US Volume states it", "Write it as .mha.");
    const auto& size = first.geometry().size;
    if (size[0] > 65535 || size[1] > 65535)
        return refuse(fmt::format("cannot hold slices of {} x {} pixels: DICOM counts to 65535", size[0], size[1]),
                      "Write it as .mha.");
    const auto bytes = checkedProduct(first.geometry().voxelCount(), first.typeName() == "uint8" ? 1 : 2);
    const auto all = bytes ? checkedProduct(*bytes, static_cast<std::int64_t>(phases.size())) : std::nullopt;
    if (!all || *all > 0xfffffffeLL)
        return refuse("cannot hold more than 4 GB of voxels, as DICOM counts them", "Write it as .mha.");
    return {};
}

}  // namespace

Result<void> writeEnhancedUs(const std::string& path, const Phases& phases, const EnhancedUsDetails& details) {
    if (phases.empty()) throw std::invalid_argument("writeEnhancedUs: no volume");
    for (const auto& phase : phases)
        if (phase->geometry().size != phases.front()->geometry().size ||
            phase->voxels().index() != phases.front()->voxels().index())
            throw std::invalid_argument("writeEnhancedUs: phases of different size or type");
    if (auto checked = check(path, phases); !checked) return checked;
    EnhancedUsObject object(phases, details);
    return writeFileAtomically(path, bytesOfFile(object.file()));
}

}  // namespace echolucent
