// Describes the values that cross between the workstation and its reader process, member by member.
#pragma once

#include "io/dicom/patient.h"
#include "io/files/file_access.h"
#include "io/restricted/message.h"
#include "io/study/series_list.h"
#include "io/study/study.h"
#include "processing/document/read_options.h"

namespace echolucent {

// The functions stand in the namespace of their types, where a message finds them.
using restricted::Described;

template <typename Archive, Described<PolarAxis> Value>
void describe(Archive& archive, Value& axis) {
    archive.choice(axis.spread, PolarSpread::angles);
    archive(axis.values, axis.radiusMm);
}

template <typename Archive, Described<PolarGeometry> Value>
void describe(Archive& archive, Value& polar) {
    archive(polar.samples, polar.rangeStartMm, polar.rangeStepMm, polar.lines, polar.planes);
}

template <typename Archive, Described<RawLayout> Value>
void describe(Archive& archive, Value& layout) {
    archive(layout.size, layout.type, layout.bigEndian, layout.headerBytes, layout.spacing, layout.spacingKnown,
            layout.polar);
}

template <typename Archive, Described<ReadOptions> Value>
void describe(Archive& archive, Value& options) {
    archive(options.raw, options.framesAsSlices, options.guessNoData, options.series, options.conversionMebibytes,
            options.studyMebibytes, options.blackAtZero);
}

template <typename Archive, Described<Failure> Value>
void describe(Archive& archive, Value& failure) {
    archive.choice(failure.kind, FailureKind::cancelled);
    archive(failure.file, failure.element, failure.problem, failure.remedy, failure.framesCouldBeSlices,
            failure.layoutUnknown, failure.opacityCurve, failure.presets);
}

template <typename Archive, Described<StatedProbe> Value>
void describe(Archive& archive, Value& probe) {
    archive(probe.forward, probe.down, probe.apexMm, probe.planesKnown);
}

template <typename Archive, Described<Reduction> Value>
void describe(Archive& archive, Value& reduction) {
    archive(reduction.by, reduction.storedSize);
}

template <typename Archive, Described<VolumeGeometry> Value>
void describe(Archive& archive, Value& geometry) {
    archive(geometry.size, geometry.spacing, geometry.origin, geometry.direction, geometry.spacingKnown,
            geometry.patientFrameKnown, geometry.probe, geometry.reduction);
}

template <typename Archive, Described<ValueScale> Value>
void describe(Archive& archive, Value& scale) {
    archive(scale.black, scale.factor);
}

template <typename Archive, Described<DataBox> Value>
void describe(Archive& archive, Value& box) {
    archive(box.lowMm, box.highMm);
}

template <typename Archive, Described<GridAxis> Value>
void describe(Archive& archive, Value& axis) {
    archive.choice(axis, GridAxis::z);
}

template <typename Archive, Described<ImportFact> Value>
void describe(Archive& archive, Value& fact) {
    archive(fact.name, fact.value, fact.source);
}

template <typename Archive, Described<PhaseTimes> Value>
void describe(Archive& archive, Value& times) {
    archive(times.meanSeconds, times.starts);
}

/// Everything but the volumes, which travel in shared memory.
template <typename Archive, Described<Study> Value>
void describe(Archive& archive, Value& study) {
    archive(study.name, study.files, study.turnedAxis, study.phaseTimes);
    archive.choice(study.lossyCompression, LossyCompression::yes);
    archive.choice(study.burnedInText, BurnedInText::yes);
    archive(study.facts, study.warnings);
}

template <typename Archive, Described<SlicePlane> Value>
void describe(Archive& archive, Value& plane) {
    archive(plane.position, plane.alongRow, plane.alongColumn, plane.file);
}

template <typename Archive, Described<Rescale> Value>
void describe(Archive& archive, Value& rescale) {
    archive(rescale.slope, rescale.intercept);
}

template <typename Archive, Described<SeriesFile> Value>
void describe(Archive& archive, Value& file) {
    archive(file.path, file.instance, file.plane, file.rescale, file.padded, file.damage);
}

template <typename Archive, Described<SeriesPhases> Value>
void describe(Archive& archive, Value& phases) {
    archive(phases.count, phases.seconds, phases.source, phases.timeSource);
}

template <typename Archive, Described<SeriesEntry> Value>
void describe(Archive& archive, Value& entry) {
    archive(entry.uid, entry.object, entry.description, entry.modality, entry.distinction, entry.phases, entry.size,
            entry.multiframe, entry.files, entry.whyNot, entry.notes);
}

template <typename Archive, Described<SeriesList> Value>
void describe(Archive& archive, Value& list) {
    archive(list.path, list.series, list.files, list.warnings);
}

template <typename Archive, Described<SmallPicture> Value>
void describe(Archive& archive, Value& picture) {
    archive(picture.width, picture.height, picture.grey);
}

template <typename Archive, Described<Patient> Value>
void describe(Archive& archive, Value& patient) {
    archive(patient.name, patient.id, patient.birthDate, patient.sex, patient.studyDate, patient.gestationalAge);
}

template <typename Archive, Described<FilesBelow> Value>
void describe(Archive& archive, Value& files) {
    archive(files.paths, files.warnings);
}

}  // namespace echolucent
