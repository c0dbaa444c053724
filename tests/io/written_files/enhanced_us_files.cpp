#include "enhanced_us_files.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "dcmtk_conditions.h"
#include "processing/phantom/phantom.h"

namespace echolucent {

namespace {

DcmItem& itemOf(DcmItem& parent, const DcmTagKey& sequence, long index) {
    DcmItem* item = nullptr;
    require(parent.findOrCreateSequenceItem(sequence, item, index), "sequence");
    return *item;
}

}  // namespace

SharedPhases simulatedPhases(const VolumeGeometry& geometry, int bits, int phases) {
    SharedPhases volumes;
    for (int phase = 0; phase < phases; ++phase) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = geometry.size;
        config.bits = bits;
        config.phase = static_cast<double>(phase) / phases;
        config.seed = 7 + static_cast<std::uint64_t>(phase);
        const auto made = makePhantom(config);
        volumes.push_back(std::make_shared<const Volume>(geometry, made->voxels(), made->whiteLevel()));
    }
    return volumes;
}

VolumeGeometry obliqueGeometry() {
    VolumeGeometry geometry;
    geometry.size = {9, 11, 8};
    geometry.spacing = {0.31, 1.0 / 3.0, 0.7123456789};
    geometry.origin = {-12.3456789, 45.6, 1.0 / 7.0};
    geometry.direction = rotationZ(31) * rotationX(-17) * rotationY(58);
    return geometry;
}

struct EnhancedUsFile::Parts {
    std::string path;
    DcmFileFormat file;
};

EnhancedUsFile::EnhancedUsFile(std::string path) : m_parts(std::make_unique<Parts>()) {
    m_parts->path = std::move(path);
    require(m_parts->file.loadFile(m_parts->path.c_str()), "reading");
    m_parts->file.loadAllDataIntoMemory();
}

EnhancedUsFile::~EnhancedUsFile() = default;

DcmDataset& EnhancedUsFile::dataset() const { return *m_parts->file.getDataset(); }

DcmItem& EnhancedUsFile::groupOfFrame(std::size_t frame, const DcmTagKey& group) const {
    return itemOf(itemOf(dataset(), DCM_PerFrameFunctionalGroupsSequence, static_cast<long>(frame)), group, 0);
}

DcmItem& EnhancedUsFile::groupOfAll(const DcmTagKey& group) const {
    return itemOf(itemOf(dataset(), DCM_SharedFunctionalGroupsSequence, 0), group, 0);
}

void EnhancedUsFile::setIndexValues(std::size_t frame, const std::vector<unsigned>& values) const {
    auto element = std::make_unique<DcmUnsignedLong>(DCM_DimensionIndexValues);
    const std::vector<Uint32> words(values.begin(), values.end());
    require(element->putUint32Array(words.data(), static_cast<unsigned long>(words.size())), "index values");
    require(groupOfFrame(frame, DCM_FrameContentSequence).insert(element.release(), OFTrue), "index values");
}

std::size_t EnhancedUsFile::frames() const {
    Sint32 frames = 0;
    require(dataset().findAndGetSint32(DCM_NumberOfFrames, frames), "number of frames");
    return static_cast<std::size_t>(frames);
}

void EnhancedUsFile::reorderFrames(const std::vector<std::size_t>& order) const {
    DcmSequenceOfItems* sequence = nullptr;
    require(dataset().findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, sequence), "frames");
    std::vector<DcmItem*> items;
    while (sequence->card() > 0) items.push_back(sequence->remove(0UL));
    for (const std::size_t from : order) require(sequence->append(items[from]), "frames");

    Uint16 bits = 0;
    require(dataset().findAndGetUint16(DCM_BitsAllocated, bits), "bits");
    const auto permuted = [&]<typename Word>(const Word* pixels, unsigned long count) {
        const std::size_t frame = count / order.size();
        std::vector<Word> result;
        for (const std::size_t from : order)
            result.insert(result.end(), pixels + from * frame, pixels + (from + 1) * frame);
        return result;
    };
    unsigned long count = 0;
    if (bits == 8) {
        const Uint8* pixels = nullptr;
        require(dataset().findAndGetUint8Array(DCM_PixelData, pixels, &count), "pixels");
        const auto result = permuted(pixels, count);
        require(dataset().putAndInsertUint8Array(DCM_PixelData, result.data(), result.size()), "pixels");
    } else {
        const Uint16* pixels = nullptr;
        require(dataset().findAndGetUint16Array(DCM_PixelData, pixels, &count), "pixels");
        const auto result = permuted(pixels, count);
        require(dataset().putAndInsertUint16Array(DCM_PixelData, result.data(), result.size()), "pixels");
    }
}

void EnhancedUsFile::save() const {
    require(m_parts->file.saveFile(m_parts->path.c_str(), EXS_LittleEndianExplicit), "saving");
}

}  // namespace echolucent
