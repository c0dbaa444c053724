#include "dicom_files.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dcrlerp.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmimage/diregist.h>  // lets the JPEG encoder see colour
#include <dcmtk/dcmjpeg/djcparam.h>
#include <dcmtk/dcmjpeg/djeijg8.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpeg/djrploss.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openjpeg.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "dcmtk_conditions.h"
#include "temporary_folder.h"

namespace echolucent {

namespace {

void put(DcmItem& item, const DcmTagKey& tag, const std::string& text) {
    require(item.putAndInsertString(tag, text.c_str()), "attribute");
}

std::string decimals(const std::vector<double>& values) { return fmt::format("{}", fmt::join(values, "\\")); }
std::string pointText(const Vec3& v) { return decimals(std::vector<double>{v[0], v[1], v[2]}); }

void putFloats(DcmItem& item, const DcmTagKey& tag, const std::vector<double>& values) {
    require(item.putAndInsertFloat64Array(tag, values.data(), values.size()), "numbers");
}

void putText(DcmItem& item, const DcmTagKey& tag, const std::string& text) {
    if (!text.empty()) put(item, tag, text);
}

/// DCMTK's encoders, from the first file that needs them to the end of the program.
struct Encoders {
    Encoders() {
        DcmRLEEncoderRegistration::registerCodecs();
        DJEncoderRegistration::registerCodecs(ECC_lossyYCbCr);
        // The "cooked" encoder of DCMTK 3.6.7 dies now and then; the raw one takes the pixels as they are.
        DJLSEncoderRegistration::registerCodecs(0, 0, 0, 0, OFFalse);
    }
    ~Encoders() {
        DJLSEncoderRegistration::cleanup();
        DJEncoderRegistration::cleanup();
        DcmRLEEncoderRegistration::cleanup();
    }
    Encoders(const Encoders&) = delete;
    Encoders& operator=(const Encoders&) = delete;
};

void registerEncoders() { static const Encoders encoders; }

void putPadding(DcmDataset& dataset, const DcmTagKey& key, const std::optional<int>& value) {
    if (!value) return;
    const bool isSigned = *value < 0;
    DcmElement* element = nullptr;
    if (isSigned)
        element = new DcmSignedShort(DcmTag(key, EVR_SS));
    else
        element = new DcmUnsignedShort(DcmTag(key, EVR_US));
    require(
        isSigned ? element->putSint16(static_cast<Sint16>(*value)) : element->putUint16(static_cast<Uint16>(*value)),
        "padding");
    require(dataset.insert(element), "padding");
}

void putImageModule(DcmDataset& dataset, const TestImage& image) {
    put(dataset, DCM_SOPClassUID, image.frames > 0 ? "1.2.840.10008.5.1.4.1.1.6.2" : "1.2.840.10008.5.1.4.1.1.6.1");
    static int serial = 0;
    put(dataset, DCM_SOPInstanceUID, fmt::format("1.2.3.4.{}", ++serial));
    put(dataset, DCM_SeriesInstanceUID, image.series);
    put(dataset, DCM_Modality, "US");
    put(dataset, DCM_Manufacturer, "Test Maker");
    put(dataset, DCM_PatientName, "Secret^Name");
    put(dataset, DCM_PatientID, "SECRET-ID");
    put(dataset, DCM_InstanceNumber, std::to_string(image.instance));
    require(dataset.putAndInsertUint16(DCM_SamplesPerPixel, static_cast<Uint16>(image.samples)), "samples");
    put(dataset, DCM_PhotometricInterpretation, image.photometric);
    putText(dataset, DCM_LossyImageCompression, image.lossyImageCompression);
    putText(dataset, DCM_BurnedInAnnotation, image.burnedInAnnotation);
    if (image.samples > 1)
        require(dataset.putAndInsertUint16(DCM_PlanarConfiguration, static_cast<Uint16>(image.planar)), "planar");
    if (image.frames > 0) put(dataset, DCM_NumberOfFrames, std::to_string(image.frames));
    if (image.frameTime) {
        put(dataset, DCM_FrameTime, "40");
        require(dataset.putAndInsertTagKey(DCM_FrameIncrementPointer, DCM_FrameTime), "pointer");
    }
    require(dataset.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(image.rows)), "rows");
    require(dataset.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(image.columns)), "columns");
    require(dataset.putAndInsertUint16(DCM_BitsAllocated, static_cast<Uint16>(image.bitsAllocated)), "bits");
    require(dataset.putAndInsertUint16(DCM_BitsStored, static_cast<Uint16>(image.bitsStored)), "bits");
    require(dataset.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(image.bitsStored - 1)), "bits");
    require(dataset.putAndInsertUint16(DCM_PixelRepresentation, image.isSigned ? 1 : 0), "sign");
    putPadding(dataset, DCM_PixelPaddingValue, image.padding);
    putPadding(dataset, DCM_PixelPaddingRangeLimit, image.paddingLimit);
}

void putGeometry(DcmDataset& dataset, const TestImage& image) {
    if (image.position) put(dataset, DCM_ImagePositionPatient, pointText(*image.position));
    if (image.orientation)
        put(dataset, DCM_ImageOrientationPatient,
            decimals(std::vector<double>(image.orientation->begin(), image.orientation->end())));
    if (image.pixelSpacing)
        put(dataset, DCM_PixelSpacing, decimals({(*image.pixelSpacing)[0], (*image.pixelSpacing)[1]}));
    if (!image.pixelSpacingText.empty()) put(dataset, DCM_PixelSpacing, image.pixelSpacingText);
    if (image.spacingBetweenSlices) put(dataset, DCM_SpacingBetweenSlices, decimals({*image.spacingBetweenSlices}));
    if (!image.gridOffsets.empty()) put(dataset, DCM_GridFrameOffsetVector, decimals(image.gridOffsets));
}

DcmItem& itemIn(DcmItem& parent, const DcmTagKey& sequence, long index = -2) {
    DcmItem* item = nullptr;
    require(parent.findOrCreateSequenceItem(sequence, item, index), "sequence");
    return *item;
}

void putFunctionalGroups(DcmDataset& dataset, const TestImage& image) {
    if (image.functionalGroups.empty()) return;
    const auto orientation = image.orientation.value_or(std::array<double, 6>{1, 0, 0, 0, 1, 0});
    DcmItem& shared = itemIn(dataset, DCM_SharedFunctionalGroupsSequence, 0);
    const std::vector<double> directions(orientation.begin(), orientation.end());
    if (image.patientFrame)
        put(itemIn(shared, DCM_PlaneOrientationSequence, 0), DCM_ImageOrientationPatient, decimals(directions));
    else
        putFloats(itemIn(shared, DCM_PlaneOrientationVolumeSequence, 0), DCM_ImageOrientationVolume, directions);
    if (image.pixelSpacing) {
        DcmItem& measures = itemIn(shared, DCM_PixelMeasuresSequence, 0);
        put(measures, DCM_PixelSpacing, decimals({(*image.pixelSpacing)[0], (*image.pixelSpacing)[1]}));
    }
    long index = 0;
    for (const TestFrame& frame : image.functionalGroups) {
        DcmItem& groups = itemIn(dataset, DCM_PerFrameFunctionalGroupsSequence, index++);
        if (image.patientFrame)
            put(itemIn(groups, DCM_PlanePositionSequence, 0), DCM_ImagePositionPatient, pointText(frame.position));
        else
            putFloats(itemIn(groups, DCM_PlanePositionVolumeSequence, 0), DCM_ImagePositionVolume,
                      {frame.position[0], frame.position[1], frame.position[2]});
        if (frame.seconds)
            putFloats(itemIn(groups, DCM_TemporalPositionSequence, 0), DCM_TemporalPositionTimeOffset,
                      {*frame.seconds});
        if (!frame.dataType.empty()) put(itemIn(groups, DCM_ImageDataTypeSequence, 0), DCM_DataType, frame.dataType);
    }
}

void putWindow(DcmDataset& dataset, const TestImage& image) {
    if (image.windowCentre.empty() && image.lutFunction.empty()) return;
    DcmItem* window = &dataset;
    DcmItem* rescale = &dataset;
    if (image.windowInGroups) {
        DcmItem& shared = itemIn(dataset, DCM_SharedFunctionalGroupsSequence, 0);
        window = &itemIn(shared, DCM_FrameVOILUTSequence, 0);
        rescale = &itemIn(shared, DCM_PixelValueTransformationSequence, 0);
    }
    putText(*window, DCM_WindowCenter, image.windowCentre);
    putText(*window, DCM_WindowWidth, image.windowWidth);
    putText(*window, DCM_VOILUTFunction, image.lutFunction);
    putText(*rescale, DCM_RescaleSlope, image.rescaleSlope);
    putText(*rescale, DCM_RescaleIntercept, image.rescaleIntercept);
}

void putPalette(DcmDataset& dataset, const TestPalette& palette) {
    const std::array<DcmTagKey, 3> descriptors{DCM_RedPaletteColorLookupTableDescriptor,
                                               DCM_GreenPaletteColorLookupTableDescriptor,
                                               DCM_BluePaletteColorLookupTableDescriptor};
    const std::array<DcmTagKey, 3> data{DCM_RedPaletteColorLookupTableData, DCM_GreenPaletteColorLookupTableData,
                                        DCM_BluePaletteColorLookupTableData};
    const std::array<const std::vector<std::uint16_t>*, 3> entries{&palette.red, &palette.green, &palette.blue};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t count = palette.bits == 8 ? entries[i]->size() * 2 : entries[i]->size();
        const std::array<Uint16, 3> descriptor{static_cast<Uint16>(count), static_cast<Uint16>(palette.first),
                                               static_cast<Uint16>(palette.bits)};
        require(dataset.putAndInsertUint16Array(DcmTag(descriptors[i], EVR_US), descriptor.data(), 3), "descriptor");
        require(dataset.putAndInsertUint16Array(DcmTag(data[i], EVR_OW), entries[i]->data(), entries[i]->size()),
                "palette");
    }
}

}  // namespace

void makeSlice(TestImage& image, double zMm, double pixelMm) {
    image.frames = 0;
    image.position = Vec3(0, 0, zMm);
    image.orientation = {1, 0, 0, 0, 1, 0};
    image.pixelSpacing = {pixelMm, pixelMm};
}

void writeDicom(const std::string& path, const TestImage& image, TestSyntax syntax) {
    DcmFileFormat file;
    DcmDataset& dataset = *file.getDataset();
    putImageModule(dataset, image);
    putGeometry(dataset, image);
    putFunctionalGroups(dataset, image);
    putWindow(dataset, image);
    if (image.palette) putPalette(dataset, *image.palette);
    if (!image.pixels16.empty())
        require(dataset.putAndInsertUint16Array(DCM_PixelData, image.pixels16.data(), image.pixels16.size()), "pixels");
    else if (!image.pixels8.empty())
        require(dataset.putAndInsertUint8Array(DCM_PixelData, image.pixels8.data(), image.pixels8.size()), "pixels");

    registerEncoders();
    const DcmRLERepresentationParameter rle;
    const DJ_RPLossless lossless;
    const DJ_RPLossy lossy(95);
    const DJLSRepresentationParameter jpegLs;
    const auto encode = [&](E_TransferSyntax xfer, const DcmRepresentationParameter* parameter) {
        require(dataset.chooseRepresentation(xfer, parameter), "encoding");
        require(file.saveFile(path.c_str(), xfer), "saving");
    };
    switch (syntax) {
        case TestSyntax::implicitLittle:
            return require(file.saveFile(path.c_str(), EXS_LittleEndianImplicit), "saving");
        case TestSyntax::explicitLittle:
            return require(file.saveFile(path.c_str(), EXS_LittleEndianExplicit), "saving");
        case TestSyntax::explicitBig: return require(file.saveFile(path.c_str(), EXS_BigEndianExplicit), "saving");
        case TestSyntax::deflated:
            return require(file.saveFile(path.c_str(), EXS_DeflatedLittleEndianExplicit), "saving");
        case TestSyntax::rle: return encode(EXS_RLELossless, &rle);
        case TestSyntax::jpegLossless: return encode(EXS_JPEGProcess14SV1, &lossless);
        case TestSyntax::jpegBaseline: return encode(EXS_JPEGProcess1, &lossy);
        case TestSyntax::jpegLs: return encode(EXS_JPEGLSLossless, &jpegLs);
    }
}

std::string nestedDicom(int depth, bool implicitVr) {
    const std::string syntax =
        implicitVr ? std::string("1.2.840.10008.1.2\0", 18) : std::string("1.2.840.10008.1.2.1\0", 20);
    std::string bytes = std::string(128, '\0') + "DICM";
    bytes += std::string("\x02\0\x10\0UI", 6) + static_cast<char>(syntax.size()) + std::string(1, '\0') + syntax;
    const std::string sequence = implicitVr ? std::string("\x40\0\x75\x02\xff\xff\xff\xff", 8)
                                            : std::string("\x40\0\x75\x02SQ\0\0\xff\xff\xff\xff", 12);
    const std::string item("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8);
    const std::string itemEnd("\xfe\xff\x0d\xe0\0\0\0\0", 8);
    const std::string sequenceEnd("\xfe\xff\xdd\xe0\0\0\0\0", 8);
    for (int level = 0; level < depth; ++level) bytes += sequence + item;
    for (int level = 0; level < depth; ++level) bytes += itemEnd + sequenceEnd;
    return bytes;
}

std::string codedJpeg2000(const TestPlanes& frame) {
    opj_cparameters_t parameters;
    opj_set_default_encoder_parameters(&parameters);
    parameters.tcp_numlayers = 1;
    parameters.cp_disto_alloc = 1;
    parameters.numresolution = 1;
    parameters.tcp_mct = frame.transform ? 1 : 0;
    opj_image_cmptparm_t component{};
    component.dx = component.dy = 1;
    component.w = static_cast<OPJ_UINT32>(frame.columns);
    component.h = static_cast<OPJ_UINT32>(frame.rows);
    component.prec = static_cast<OPJ_UINT32>(frame.bits);
    component.sgnd = frame.isSigned ? 1 : 0;
    std::vector<opj_image_cmptparm_t> components(frame.planes.size(), component);
    opj_image_t* image = opj_image_create(static_cast<OPJ_UINT32>(components.size()), components.data(),
                                          components.size() == 3 ? OPJ_CLRSPC_SRGB : OPJ_CLRSPC_GRAY);
    image->x1 = component.w;
    image->y1 = component.h;
    for (std::size_t plane = 0; plane < components.size(); ++plane)
        std::copy(frame.planes[plane].begin(), frame.planes[plane].end(), image->comps[plane].data);
    const std::string path =
        (std::filesystem::temp_directory_path() / fmt::format("echolucent-{}.j2k", getpid())).string();
    opj_codec_t* codec = opj_create_compress(OPJ_CODEC_J2K);
    opj_setup_encoder(codec, &parameters, image);
    opj_stream_t* stream = opj_stream_create_default_file_stream(path.c_str(), OPJ_FALSE);
    const bool done =
        opj_start_compress(codec, image, stream) && opj_encode(codec, stream) && opj_end_compress(codec, stream);
    opj_stream_destroy(stream);
    opj_destroy_codec(codec);
    opj_image_destroy(image);
    if (!done) throw std::runtime_error("JPEG 2000 encoding");
    std::ifstream file(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    std::remove(path.c_str());
    return bytes;
}

std::string codedFullChroma(const TestImage& image) {
    const DJCodecParameter parameters(ECC_lossyYCbCr, EDC_never, EUC_default, EPC_colorByPixel);
    DJCompressIJG8Bit encoder(parameters, EJM_baseline, 95);
    std::vector<Uint8> pixels = image.pixels8;
    Uint8* coded = nullptr;
    Uint32 length = 0;
    require(encoder.encode(static_cast<Uint16>(image.columns), static_cast<Uint16>(image.rows), EPI_RGB, 3,
                           pixels.data(), coded, length),
            "JPEG encoding");
    const std::string bytes(reinterpret_cast<const char*>(coded), length);
    delete[] coded;
    return bytes;
}

std::string codedFrame(const TestImage& image, TestSyntax syntax) {
    const TemporaryFolder folder;
    writeDicom(folder.file("a"), image, syntax);
    DcmFileFormat file;
    DcmElement* element = nullptr;
    DcmPixelSequence* sequence = nullptr;
    DcmPixelItem* item = nullptr;
    Uint8* bytes = nullptr;
    require(file.loadFile(folder.file("a").c_str()), "loading");
    require(file.getDataset()->findAndGetElement(DCM_PixelData, element), "pixel data");
    require(static_cast<DcmPixelData*>(element)->getEncapsulatedRepresentation(file.getDataset()->getOriginalXfer(),
                                                                               nullptr, sequence),
            "fragments");
    require(sequence->getItem(item, 1), "fragment");
    require(item->getUint8Array(bytes), "bytes");
    return {reinterpret_cast<const char*>(bytes), item->getLength()};
}

void writeJpeg2000Dicom(const std::string& path, int columns, int rows, const std::vector<std::uint8_t>& pixels) {
    TestImage image;
    image.columns = columns;
    image.rows = rows;
    image.frames = 2;
    DcmFileFormat file;
    DcmDataset& dataset = *file.getDataset();
    putImageModule(dataset, image);
    const std::string coded =
        codedJpeg2000({.columns = columns, .rows = rows, .planes = {std::vector<int>(pixels.begin(), pixels.end())}});
    std::vector<Uint8> codestream(coded.begin(), coded.end());
    auto* sequence = new DcmPixelSequence(DcmTag(DCM_PixelData, EVR_OB));
    sequence->insert(new DcmPixelItem(DcmTag(DCM_Item, EVR_OB)));
    DcmOffsetList offsets;
    for (int frame = 0; frame < 2; ++frame)
        require(sequence->storeCompressedFrame(offsets, codestream.data(), static_cast<Uint32>(codestream.size()), 0),
                "frame");
    auto* pixelData = new DcmPixelData(DCM_PixelData);
    pixelData->putOriginalRepresentation(EXS_JPEG2000LosslessOnly, nullptr, sequence);
    require(dataset.insert(pixelData, OFTrue), "pixel data");
    require(file.saveFile(path.c_str(), EXS_JPEG2000LosslessOnly), "saving");
}

}  // namespace echolucent
