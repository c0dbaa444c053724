#include "tests/fuzz/samples/text_header_samples.h"

#include <memory>

#include "bzip2_bytes.h"
#include "enhanced_us_files.h"
#include "io/writers/meta_image_writer.h"
#include "nifti_files.h"
#include "tests/fuzz/samples/written_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

const std::string countedLetters = "ABCDEFGHIJKLMNOPQRSTUVWX";

std::string metaImageOf(const std::string& keys, const std::string& data) {
    return "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\nElementType = MET_UCHAR\n" + keys +
           "ElementDataFile = LOCAL\n" + data;
}

std::string nrrdOf(const std::string& fields, const std::string& data) {
    return "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 3 2\n" + fields + "\n" + data;
}

std::string writtenMetaImage(int bits, int phases, MetaImageVoxels voxels) {
    return bytesOfWritten("v.mha", [&](const std::string& path) {
        return writeMetaImage(path, simulatedPhases(obliqueGeometry(), bits, phases), voxels).has_value();
    });
}

}  // namespace

std::vector<FuzzSample> metaImageSamples() {
    const std::string zlib = deflated(countedLetters);
    return {
        {"plain", metaImageOf("ElementSpacing = 0.5 0.5 1\n", countedLetters)},
        {"every-key",
         "Comment = none\nObjectType = Image\nObjectSubType = NA\nNDims = 3\nBinaryData = True\n"
         "BinaryDataByteOrderMSB = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\n"
         "CenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = 0.3 0.4 0.5\nSpacingKnown = True\n"
         "ElementSize = 0.3 0.4 0.5\nKinds = domain domain domain\nWhiteLevel = 200\nHeaderSize = 0\nDimSize = 3 2 2\n"
         "ElementType = MET_USHORT\nElementNumberOfChannels = 1\nElementDataFile = LOCAL\n" +
             countedLetters},
        {"packed", metaImageOf("ElementSpacing = 1 1 1\nCompressedData = True\nCompressedDataSize = " +
                                   std::to_string(zlib.size()) + "\n",
                               zlib)},
        {"text",
         metaImageOf("BinaryData = False\n", "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24\n")},
        {"four-axes",
         "NDims = 4\nDimSize = 2 3 2 2\nElementType = MET_UCHAR\nElementSpacing = 1 1 1 0.04\nElementDataFile = "
         "LOCAL\n" +
             countedLetters},
        {"time-stamps",
         "NDims = 4\nDimSize = 2 3 2 2\nElementType = MET_UCHAR\nElementSpacing = 0,5 0,5 1 1\nDistanceUnits = cm\n"
         "Seq_Frame0000_Timestamp = 0.5\nSeq_Frame0001_Timestamp = 0.54\nElementDataFile = LOCAL\n" +
             countedLetters},
        {"over-nifti", metaImageOf("", niftiHeader({}) + countedLetters)},
        {"frames",
         "NDims = 3\nDimSize = 4 3 2\nElementType = MET_UCHAR\nKinds = domain domain list\n"
         "Seq_Frame0000_ProbeToTrackerTransform = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n"
         "Seq_Frame0000_Timestamp = 0.5\nSeq_Frame0001_Timestamp = 0.6\nElementDataFile = LOCAL\n" +
             countedLetters},
        {"apart",
         "NDims = 3\nDimSize = 4 3 2\nElementType = MET_UCHAR\nHeaderSize = -1\nElementDataFile = voxels.raw\n"},
        {"list", "NDims = 3\nDimSize = 4 3 2\nElementType = MET_UCHAR\nElementDataFile = LIST\nv1.raw\nv2.raw\n"},
        {"pattern", "NDims = 3\nDimSize = 4 3 2\nElementType = MET_UCHAR\nElementDataFile = v%d.raw 1 2 1\n"},
        {"colour", metaImageOf("ElementNumberOfChannels = 3\n", countedLetters + countedLetters + countedLetters)},
        {"floats",
         "NDims = 3\nDimSize = 3 2 1\nElementType = MET_FLOAT\nElementByteOrderMSB = True\n"
         "ElementDataFile = LOCAL\n" +
             countedLetters},
        {"written-bytes", writtenMetaImage(8, 1, MetaImageVoxels::plain)},
        {"written-words", writtenMetaImage(16, 2, MetaImageVoxels::compressed)},
    };
}

std::vector<FuzzSample> nrrdSamples() {
    const std::string space =
        "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,1)\n"
        "space origin: (1,2,3)\nspace units: \"mm\" \"mm\" \"mm\"\nkinds: domain domain domain\n";
    return {
        {"plain", nrrdOf("spacings: 0.5 0.5 1\nencoding: raw\n", countedLetters)},
        {"space", nrrdOf(space + "encoding: raw\n", countedLetters)},
        {"gzip", nrrdOf(space + "encoding: gzip\n", deflated(countedLetters, 31))},
        {"hex", nrrdOf("encoding: hex\n", "4142434445464748494a4b4c4d4e4f505152535455565758\n")},
        {"ascii", nrrdOf("encoding: ascii\n", "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24\n")},
        {"bzip2", nrrdOf("encoding: bzip2\n", bzipped(countedLetters, 9))},
        {"skips", nrrdOf("encoding: raw\nline skip: 1\nbyte skip: -1\n", "a line\nABC" + countedLetters)},
        {"words",
         "NRRD0004\n# a comment\ntype: short\ndimension: 3\nsizes: 3 2 2\nendian: big\nencoding: raw\n"
         "a key:=a value\n\n" +
             countedLetters},
        {"four-axes",
         "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 2 2 3 2\nkinds: list domain domain domain\n"
         "space dimension: 3\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\n\n" +
             countedLetters},
        {"sequence",
         "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 2 2 3 2\nkinds: list domain domain domain\n"
         "labels: \"time\" \"\" \"\" \"\"\nunits: \"ms\" \"\" \"\" \"\"\nspace: LPS\n"
         "space directions: none (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\naxis 0 index type:=numeric\n"
         "axis 0 index values:=10 50\n\n" +
             countedLetters},
        {"multi-volume",
         "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 2 2 3 2\nkinds: list domain domain domain\nencoding: raw\n"
         "MultiVolume.FrameLabels:=0,40\nMultiVolume.FrameIdentifyingDICOMTagName:=TriggerTime\n"
         "MultiVolume.FrameIdentifyingDICOMTagUnits:=ms\n\n" +
             countedLetters},
        {"through-time",
         "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 2 2 3 2\nspace: right-anterior-superior-time\n"
         "space directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,40)\nspace units: mm mm mm ms\nencoding: raw\n\n" +
             countedLetters},
        {"ends-of-axes",
         nrrdOf("axis mins: 0 0 0\naxis maxs: 2 2 2\ncenterings: cell node cell\nunits: um um um\nencoding: raw\n",
                countedLetters)},
        {"over-nifti", nrrdOf("encoding: gzip\n", deflated(niftiHeader({}) + countedLetters, 31))},
        {"gzip-from-its-end", nrrdOf("encoding: gzip\nbyte skip: -1\n", deflated("before" + countedLetters, 31))},
        {"frames",
         "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nkinds: domain domain time\n"
         "units: \"mm\" \"mm\" \"s\"\nspacings: 1 1 0.04\nencoding: raw\n\n" +
             countedLetters},
        {"colour",
         "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 3 2 2 2\nkinds: RGB-color domain domain domain\n"
         "encoding: raw\n\n" +
             countedLetters},
        {"apart", nrrdOf("encoding: raw\ndata file: voxels.raw\n", "")},
        {"list", nrrdOf("encoding: raw\ndata file: LIST\nv1.raw\nv2.raw\n", "")},
        {"pattern", nrrdOf("encoding: raw\ndata file: v%d.raw 1 2 1\n", "")},
    };
}

}  // namespace echolucent
