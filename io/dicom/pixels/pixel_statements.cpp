#include "io/dicom/pixels/pixel_statements.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "io/dicom/elements/dicom_attributes.h"

namespace echolucent {

namespace {

/// Whether a transfer syntax always loses. JPEG 2000 may lose or not; only the attribute (0028,2110) tells.
bool syntaxLoses(E_TransferSyntax syntax) {
    return syntax == EXS_JPEGProcess1 || syntax == EXS_JPEGProcess2_4 || syntax == EXS_JPEGProcess6_8 ||
           syntax == EXS_JPEGProcess10_12 || syntax == EXS_JPEGLSLossy;
}

/// Whether the pixels may hold text that nothing declares. Pictures of a screen may: cines and colour. The planes of an
/// Enhanced US Volume are no pictures of a screen.
bool couldHoldText(DcmDataset& dataset) {
    if (dicomText(dataset, {0x0008, 0x0016}) == UID_EnhancedUSVolumeStorage) return false;
    const std::string photometric = dicomText(dataset, {0x0028, 0x0004});
    const bool grey = photometric.empty() || photometric.starts_with("MONOCHROME");
    return !grey || dicomWholeNumber(dataset, {0x0028, 0x0008}).value_or(1) > 1;
}

}  // namespace

StatedLoss statedLoss(DcmDataset& dataset) {
    const E_TransferSyntax syntax = dataset.getOriginalXfer();
    const std::string stated = dicomText(dataset, {0x0028, 0x2110});
    if (stated == "01") return {LossyCompression::yes, "(0028,2110) Lossy Image Compression"};
    if (syntaxLoses(syntax)) return {LossyCompression::yes, "(0002,0010) Transfer Syntax UID"};
    if (stated == "00") return {LossyCompression::no, "(0028,2110) Lossy Image Compression"};
    const std::string sopClass = dicomText(dataset, {0x0008, 0x0016});
    const bool ultrasound = sopClass == UID_UltrasoundImageStorage || sopClass == UID_UltrasoundMultiframeImageStorage;
    if (ultrasound && syntax != EXS_JPEG2000)
        return {LossyCompression::no, "(0028,2110) is absent, as it may be where an ultrasound image lost nothing"};
    return {LossyCompression::unknown, "(0028,2110) is absent"};
}

void sayLoss(DcmDataset& dataset, StudyParts& parts) {
    const StatedLoss loss = statedLoss(dataset);
    if (!parts.lossSource.empty() && loss.compression <= parts.lossyCompression) return;
    parts.lossyCompression = loss.compression;
    parts.lossSource = loss.source;
}

void sayBurnedInText(DcmDataset& dataset, bool alwaysVolume, StudyParts& parts) {
    const std::string stated = dicomText(dataset, {0x0028, 0x0301});
    BurnedInText text = BurnedInText::no;
    std::string source = "(0028,0301) Burned In Annotation";
    if (stated == "YES") {
        text = BurnedInText::yes;
    } else if (stated != "NO") {
        source += stated.empty() ? " is absent" : " says neither YES nor NO";
        if (!alwaysVolume && couldHoldText(dataset))
            text = BurnedInText::unknown;
        else
            source += "; the voxels are no pictures of a screen";
    }
    if (!parts.burnedInTextSource.empty() && text <= parts.burnedInText) return;
    parts.burnedInText = text;
    parts.burnedInTextSource = std::move(source);
}

}  // namespace echolucent
