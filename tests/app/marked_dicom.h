// Puts a text of its own into each DICOM attribute that leads to a patient, and searches for these texts.
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <cstring>
#include <vector>

namespace echolucent {

/// The attributes whose texts are searched for: the patient's own, and others that lead to the patient.
inline const std::vector<DcmTagKey> identifyingTags{DCM_PatientName,
                                                    DCM_PatientID,
                                                    DCM_IssuerOfPatientID,
                                                    DCM_OtherPatientNames,
                                                    DCM_RETIRED_OtherPatientIDs,
                                                    DCM_PatientBirthName,
                                                    DCM_PatientMotherBirthName,
                                                    DCM_PatientAddress,
                                                    DCM_PatientTelephoneNumbers,
                                                    DCM_PatientComments,
                                                    DCM_EthnicGroup,
                                                    DCM_Occupation,
                                                    DCM_AdditionalPatientHistory,
                                                    DCM_RETIRED_MedicalRecordLocator,
                                                    DCM_MilitaryRank,
                                                    DCM_BranchOfService,
                                                    DCM_PatientReligiousPreference,
                                                    DCM_CountryOfResidence,
                                                    DCM_RegionOfResidence,
                                                    DCM_MedicalAlerts,
                                                    DCM_Allergies,
                                                    DCM_ResponsiblePerson,
                                                    DCM_ResponsibleOrganization,
                                                    DCM_ReferringPhysicianName,
                                                    DCM_ReferringPhysicianAddress,
                                                    DCM_ReferringPhysicianTelephoneNumbers,
                                                    DCM_PhysiciansOfRecord,
                                                    DCM_PerformingPhysicianName,
                                                    DCM_NameOfPhysiciansReadingStudy,
                                                    DCM_OperatorsName,
                                                    DCM_RequestingPhysician,
                                                    DCM_InstitutionName,
                                                    DCM_InstitutionAddress,
                                                    DCM_InstitutionalDepartmentName,
                                                    DCM_StationName,
                                                    DCM_AccessionNumber,
                                                    DCM_StudyID,
                                                    DCM_StudyDescription,
                                                    DCM_AdmittingDiagnosesDescription,
                                                    DCM_RequestedProcedureDescription,
                                                    DCM_RequestedProcedureID,
                                                    DCM_PerformedProcedureStepDescription,
                                                    DCM_PerformedProcedureStepID,
                                                    DCM_DeviceSerialNumber,
                                                    DCM_DetectorID,
                                                    DCM_ProtocolName,
                                                    DCM_ImageComments,

                                                    DCM_ServiceEpisodeID,
                                                    DCM_AdmissionID,
                                                    DCM_CurrentPatientLocation,
                                                    DCM_PersonName,
                                                    DCM_ClinicalTrialSubjectID,
                                                    DCM_VisitComments,
                                                    DCM_PatientState};

struct Marker {
    QString attribute;
    QByteArray text;
};

/// Puts a text of its own into every identifying attribute, and dates that stand nowhere else.
inline QList<Marker> mark(const QString& path) {
    DcmFileFormat file;
    if (file.loadFile(path.toStdString().c_str()).bad()) qFatal("the study cannot be marked");
    if (file.loadAllDataIntoMemory().bad()) qFatal("the study cannot be marked");  // it is written over itself
    QList<Marker> markers;
    const auto put = [&](const DcmTagKey& key, const QByteArray& text) {
        const DcmTag tag(key);
        if (file.getDataset()->putAndInsertString(tag, text.constData()).bad()) qFatal("%s", DcmTag(key).getTagName());
        markers.append({QString::fromLatin1(DcmTag(key).getTagName()), text});
    };
    int number = 0;
    // Short enough for every kind of text, and unlike any word or number of the program.
    for (const DcmTagKey& tag : identifyingTags) put(tag, "QZX" + QByteArray::number(100 + number++) + "VKJ");
    put(DCM_PatientBirthDate, "19130227");
    put(DCM_StudyDate, "19470411");
    put(DCM_PatientBirthTime, "031759");
    put(DCM_PatientAge, "097Y");
    put(DCM_PatientSex, "O");
    markers.removeLast();  // a single letter is everywhere
    if (file.saveFile(path.toStdString().c_str(), EXS_LittleEndianExplicit).bad()) qFatal("the study is not marked");
    return markers;
}

/// UIDs that lead to the patient, and the two that tell a folder's series apart.
constexpr auto studyUid = "1.2.826.0.1.3680043.9.7133.1", frameUid = "1.2.826.0.1.3680043.9.7133.2",
               imageUid = "1.2.826.0.1.3680043.9.7133.3", firstSeriesUid = "1.2.826.0.1.3680043.9.7133.4",
               secondSeriesUid = "1.2.826.0.1.3680043.9.7133.5";

/// The smallest possible slice of a series.
inline void writeSlice(const QString& path, const char* series, int number) {
    DcmFileFormat file;
    DcmDataset& data = *file.getDataset();
    const auto put = [&](const DcmTagKey& tag, const QString& text) {
        if (data.putAndInsertString(tag, qPrintable(text)).bad()) qFatal("%s", DcmTag(tag).getTagName());
    };
    const auto count = [&](const DcmTagKey& tag, int value) {
        if (data.putAndInsertUint16(tag, static_cast<Uint16>(value)).bad()) qFatal("%s", DcmTag(tag).getTagName());
    };
    put(DCM_SOPClassUID, UID_UltrasoundImageStorage);
    put(DCM_SOPInstanceUID, QString("%1.%2.%3").arg(imageUid, QString(series).section('.', -1)).arg(number));
    put(DCM_StudyInstanceUID, studyUid);
    put(DCM_SeriesInstanceUID, series);
    put(DCM_FrameOfReferenceUID, frameUid);
    put(DCM_Modality, "US");
    put(DCM_InstanceNumber, QString::number(number + 1));
    put(DCM_ImagePositionPatient, QString("0\\0\\%1").arg(number));
    put(DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
    put(DCM_PixelSpacing, "1\\1");
    put(DCM_PhotometricInterpretation, "MONOCHROME2");
    constexpr int edge = 32;
    for (const DcmTagKey& tag : {DCM_Rows, DCM_Columns}) count(tag, edge);
    for (const DcmTagKey& tag : {DCM_BitsAllocated, DCM_BitsStored}) count(tag, 8);
    count(DCM_HighBit, 7);
    count(DCM_SamplesPerPixel, 1);
    count(DCM_PixelRepresentation, 0);
    std::vector<Uint8> pixels;
    for (int i = 0; i < edge * edge; ++i) pixels.push_back(static_cast<Uint8>(40 + (i * 7 + number * 11) % 200));
    if (data.putAndInsertUint8Array(DCM_PixelData, pixels.data(), pixels.size()).bad() ||
        file.saveFile(qPrintable(path), EXS_LittleEndianExplicit).bad())
        qFatal("%s", qPrintable(path));
}

/// All forms in which a text may be written.
inline QList<QByteArray> formsOf(const QByteArray& text) {
    QByteArray little, big;
    for (const char letter : text) {
        little.append(letter).append('\0');
        big.append('\0').append(letter);
    }
    QList<QByteArray> forms{text, little, big};
    // In base 64 a text looks different at each of the three places in a group of bytes. The letters that depend on its
    // neighbours are left out.
    for (int before = 0; before < 3; ++before) {
        const QByteArray coded = (QByteArray(before, 'x') + text + "xx").toBase64();
        const int first = (before * 8 + 5) / 6, last = static_cast<int>((before + text.size()) * 8 / 6);
        forms << coded.mid(first, last - first);
    }
    if (text.size() == 8 && std::ranges::all_of(text, [](char letter) { return letter >= '0' && letter <= '9'; }))
        forms << text.left(4) + '-' + text.mid(4, 2) + '-' + text.mid(6);
    return forms;
}

/// The markers in the bytes, as "where: attribute".
inline QStringList foundIn(const QByteArray& bytes, const QList<Marker>& markers, const QString& where) {
    QStringList found;
    for (const Marker& marker : markers)
        for (const QByteArray& form : formsOf(marker.text))
            // QByteArray::contains() took two thirds of the class's time.
            if (memmem(bytes.constData(), static_cast<std::size_t>(bytes.size()), form.constData(),
                       static_cast<std::size_t>(form.size())) != nullptr)
                found << where + ": " + marker.attribute;
    found.removeDuplicates();
    return found;
}

}  // namespace echolucent
