#include "io/dicom/pixels/jpeg_ls_bytes.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <memory>

namespace echolucent {

bool decodeJpegLsBytes(DcmDataset& dataset, const DicomPixelFormat& format, const std::vector<std::uint8_t>& data,
                       std::span<std::uint8_t> out) {
    DcmDataset narrow;
    const auto putWord = [&](const DcmTagKey& tag, std::int64_t value) {
        return narrow.putAndInsertUint16(tag, static_cast<Uint16>(value)).good();
    };
    const auto pixels = std::make_unique<DcmPixelData>(DCM_PixelData);
    auto sequence = std::make_unique<DcmPixelSequence>(DcmTag(DCM_PixelData, EVR_OB));
    auto item = std::make_unique<DcmPixelItem>(DcmTag(DCM_Item, EVR_OB));
    auto table = std::make_unique<DcmPixelItem>(DcmTag(DCM_Item, EVR_OB));
    std::vector<std::uint8_t> even = data;
    even.resize(even.size() + even.size() % 2);
    const bool described = putWord(DCM_Rows, format.rows) && putWord(DCM_Columns, format.columns) &&
                           putWord(DCM_SamplesPerPixel, format.samples) && putWord(DCM_PlanarConfiguration, 0) &&
                           putWord(DCM_BitsAllocated, 8) && putWord(DCM_BitsStored, 8) && putWord(DCM_HighBit, 7) &&
                           putWord(DCM_PixelRepresentation, 0) &&
                           narrow.putAndInsertString(DCM_PhotometricInterpretation, format.photometric.c_str()).good();
    if (!described || item->putUint8Array(even.data(), static_cast<unsigned long>(even.size())).bad()) return false;
    if (sequence->insert(table.get()).bad()) return false;
    table.release();
    if (sequence->insert(item.get()).bad()) return false;
    item.release();
    pixels->putOriginalRepresentation(dataset.getOriginalXfer(), nullptr, sequence.release());
    Uint32 first = 1;  // behind the offset table
    OFString model;
    std::vector<std::uint8_t> decoded(out.size() + out.size() % 2);
    const OFCondition done =
        pixels->getUncompressedFrame(&narrow, 0, first, decoded.data(), static_cast<Uint32>(decoded.size()), model);
    std::copy_n(decoded.begin(), out.size(), out.begin());
    return done.good();
}

}  // namespace echolucent
