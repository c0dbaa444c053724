#include "io/dicom/dicom_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace echolucent {

namespace {

using Name = std::pair<std::string_view, const char*>;

constexpr std::string_view transferRoot = "1.2.840.10008.1.2";
constexpr std::string_view storageRoot = "1.2.840.10008.5.1.4.1.1";

/// Behind transferRoot.
constexpr std::array transferSyntaxes{
    Name{"", "uncompressed, implicit, little endian"},
    Name{".1", "uncompressed, little endian"},
    Name{".1.98", "encapsulated uncompressed"},
    Name{".1.99", "deflated, little endian"},
    Name{".2", "uncompressed, big endian"},
    Name{".4.50", "JPEG baseline, with loss"},
    Name{".4.51", "JPEG extended, with loss"},
    Name{".4.52", "JPEG extended (processes 3 and 5), with loss"},
    Name{".4.53", "JPEG spectral selection, with loss"},
    Name{".4.54", "JPEG spectral selection (processes 7 and 9), with loss"},
    Name{".4.55", "JPEG full progression, with loss"},
    Name{".4.56", "JPEG full progression (processes 11 and 13), with loss"},
    Name{".4.57", "JPEG lossless (process 14)"},
    Name{".4.58", "JPEG lossless (process 15)"},
    Name{".4.59", "JPEG extended, hierarchical, with loss"},
    Name{".4.60", "JPEG extended, hierarchical, with loss"},
    Name{".4.61", "JPEG spectral selection, hierarchical, with loss"},
    Name{".4.62", "JPEG spectral selection, hierarchical, with loss"},
    Name{".4.63", "JPEG full progression, hierarchical, with loss"},
    Name{".4.64", "JPEG full progression, hierarchical, with loss"},
    Name{".4.65", "JPEG lossless, hierarchical"},
    Name{".4.66", "JPEG lossless, hierarchical"},
    Name{".4.70", "JPEG lossless"},
    Name{".4.80", "JPEG-LS, lossless"},
    Name{".4.81", "JPEG-LS, near-lossless"},
    Name{".4.90", "JPEG 2000, lossless"},
    Name{".4.91", "JPEG 2000"},
    Name{".4.92", "JPEG 2000 multi-component, lossless"},
    Name{".4.93", "JPEG 2000 multi-component"},
    Name{".4.94", "JPIP, pixels kept on a server"},
    Name{".4.95", "JPIP deflated, pixels kept on a server"},
    Name{".4.100", "MPEG-2 video"},
    Name{".4.100.1", "MPEG-2 video"},
    Name{".4.101", "MPEG-2 video"},
    Name{".4.101.1", "MPEG-2 video"},
    Name{".4.102", "MPEG-4 (H.264) video"},
    Name{".4.102.1", "MPEG-4 (H.264) video"},
    Name{".4.103", "MPEG-4 (H.264) video"},
    Name{".4.103.1", "MPEG-4 (H.264) video"},
    Name{".4.104", "MPEG-4 (H.264) video"},
    Name{".4.104.1", "MPEG-4 (H.264) video"},
    Name{".4.105", "MPEG-4 (H.264) video"},
    Name{".4.105.1", "MPEG-4 (H.264) video"},
    Name{".4.106", "MPEG-4 (H.264) stereo video"},
    Name{".4.106.1", "MPEG-4 (H.264) stereo video"},
    Name{".4.107", "HEVC (H.265) video"},
    Name{".4.108", "HEVC (H.265) video"},
    Name{".4.110", "JPEG XL, lossless"},
    Name{".4.111", "JPEG XL, recompressed JPEG"},
    Name{".4.112", "JPEG XL"},
    Name{".4.201", "High-Throughput JPEG 2000, lossless"},
    Name{".4.202", "High-Throughput JPEG 2000, lossless"},
    Name{".4.203", "High-Throughput JPEG 2000"},
    Name{".4.204", "High-Throughput JPEG 2000, pixels kept on a server"},
    Name{".4.205", "High-Throughput JPEG 2000 deflated, pixels kept on a server"},
    Name{".5", "RLE, lossless"},
    Name{".6.1", "encapsulated MIME text"},
    Name{".6.2", "XML"},
    Name{".7.1", "SMPTE video over a network"},
    Name{".7.2", "SMPTE video over a network"},
    Name{".7.3", "SMPTE sound over a network"},
    Name{".8.1", "deflated frame by frame"},
};

/// Behind storageRoot.
constexpr std::array storageClasses{
    Name{".1", "a computed radiography image"},
    Name{".1.1", "a digital X-ray image"},
    Name{".1.1.1", "a digital X-ray image"},
    Name{".1.2", "a mammography image"},
    Name{".1.2.1", "a mammography image"},
    Name{".1.3", "an intra-oral X-ray image"},
    Name{".1.3.1", "an intra-oral X-ray image"},
    Name{".2", "a CT image"},
    Name{".2.1", "an enhanced CT image"},
    Name{".2.2", "a legacy converted CT image"},
    Name{".3", "a retired ultrasound cine"},
    Name{".3.1", "an ultrasound cine"},
    Name{".4", "an MR image"},
    Name{".4.1", "an enhanced MR image"},
    Name{".4.2", "an MR spectroscopy"},
    Name{".4.3", "an enhanced MR colour image"},
    Name{".4.4", "a legacy converted MR image"},
    Name{".5", "a retired nuclear medicine image"},
    Name{".6", "a retired ultrasound image"},
    Name{".6.1", "an ultrasound image"},
    Name{".6.2", "an Enhanced US Volume"},
    Name{".6.3", "a photoacoustic image"},
    Name{".7", "a screen capture (secondary capture)"},
    Name{".7.1", "a multi-frame screen capture of single bits"},
    Name{".7.2", "a multi-frame screen capture in grey"},
    Name{".7.3", "a multi-frame screen capture in grey"},
    Name{".7.4", "a multi-frame screen capture in colour"},
    Name{".8", "a standalone overlay"},
    Name{".9", "a standalone curve"},
    Name{".9.1.1", "a 12-lead ECG"},
    Name{".9.1.2", "an ECG"},
    Name{".9.4.1", "a voice recording"},
    Name{".9.4.2", "a sound recording"},
    Name{".11.1", "a presentation state (how a picture was shown)"},
    Name{".11.2", "a presentation state (how a picture was shown in colour)"},
    Name{".11.3", "a presentation state (how a picture was shown in false colour)"},
    Name{".11.4", "a presentation state (how pictures were blended)"},
    Name{".11.5", "a presentation state (how X-ray pictures were shown)"},
    Name{".11.6", "a volumetric presentation state (planes)"},
    Name{".11.7", "a volumetric presentation state (planes)"},
    Name{".11.8", "a presentation state (how pictures were blended)"},
    Name{".11.9", "a volumetric presentation state (how a volume was rendered)"},
    Name{".11.10", "a volumetric presentation state (how a volume was segmented and rendered)"},
    Name{".11.11", "a volumetric presentation state (how volumes were rendered)"},
    Name{".12.1", "an X-ray angiography image"},
    Name{".12.1.1", "an enhanced X-ray angiography image"},
    Name{".12.2", "an X-ray fluoroscopy image"},
    Name{".12.2.1", "an enhanced X-ray fluoroscopy image"},
    Name{".13.1.1", "an X-ray 3D angiography volume"},
    Name{".13.1.2", "an X-ray 3D craniofacial volume"},
    Name{".13.1.3", "a breast tomosynthesis volume"},
    Name{".14.1", "an intravascular OCT image"},
    Name{".14.2", "an intravascular OCT image"},
    Name{".20", "a nuclear medicine image"},
    Name{".30", "a parametric map"},
    Name{".66", "raw data of a scanner"},
    Name{".66.1", "a spatial registration"},
    Name{".66.2", "a spatial fiducials object"},
    Name{".66.3", "a deformable registration"},
    Name{".66.4", "a segmentation"},
    Name{".66.5", "a surface segmentation"},
    Name{".66.6", "a tractography result"},
    Name{".67", "a real world value mapping"},
    Name{".68.1", "a surface scan mesh"},
    Name{".77.1.1", "an endoscopy image"},
    Name{".77.1.1.1", "an endoscopy video"},
    Name{".77.1.2", "a microscopy image"},
    Name{".77.1.2.1", "a microscopy video"},
    Name{".77.1.3", "a slide microscopy image"},
    Name{".77.1.4", "a photograph"},
    Name{".77.1.4.1", "a video of a camera"},
    Name{".77.1.5.1", "an ophthalmic photograph"},
    Name{".77.1.5.4", "an ophthalmic tomography volume"},
    Name{".77.1.6", "a whole slide microscopy image"},
    Name{".88.59", "a key object selection (a list of pictures)"},
    Name{".88.67", "an X-ray dose report"},
    Name{".88.72", "a structured report of an echocardiogram (text, no picture)"},
    Name{".104.1", "an encapsulated PDF document"},
    Name{".104.2", "an encapsulated CDA document"},
    Name{".104.3", "an encapsulated STL model (a surface for printing)"},
    Name{".104.4", "an encapsulated OBJ model (a surface for printing)"},
    Name{".104.5", "an encapsulated MTL material (of a surface for printing)"},
    Name{".128", "a PET image"},
    Name{".128.1", "a legacy converted PET image"},
    Name{".130", "an enhanced PET image"},
    Name{".131", "a structured display"},
    Name{".481.1", "a radiotherapy image"},
    Name{".481.2", "a radiotherapy dose"},
    Name{".481.3", "a radiotherapy structure set"},
    Name{".481.5", "a radiotherapy plan"},
};

/// Behind the same, for classes that the list above leaves out.
constexpr std::array families{
    Name{".9.", "a waveform"},
    Name{".11.", "a presentation state (how a picture was shown)"},
    Name{".12.", "an X-ray image"},
    Name{".13.", "an X-ray volume"},
    Name{".77.", "a picture in visible light"},
    Name{".78.", "measurements of an eye"},
    Name{".79.", "measurements of an eye"},
    Name{".80.", "measurements of an eye"},
    Name{".81.", "measurements of an eye"},
    Name{".82.", "measurements of an eye"},
    Name{".88.", "a structured report (text, no picture)"},
    Name{".200.", "a protocol"},
    Name{".481.", "a radiotherapy object"},
};

/// Roots of the classes that makers have defined for themselves.
constexpr std::array makers{
    Name{"1.2.840.113543.6.6.", "Philips"},     Name{"1.2.840.113663.", "Philips"},
    Name{"1.3.46.670589.", "Philips"},          Name{"1.2.840.113619.", "GE"},
    Name{"1.2.276.0.26.20010718.", "GE"},       Name{"1.2.276.0.48.", "TomTec"},
    Name{"1.3.12.2.1107.", "Siemens"},          Name{"1.2.840.113680.", "Acuson"},
    Name{"1.2.392.200036.9116.", "Canon"},      Name{"1.2.392.200036.9125.", "Fujifilm"},
    Name{"1.2.410.200001.", "Samsung Medison"},
};

template <std::size_t count>
const char* nameIn(const std::array<Name, count>& names, std::string_view uid, std::string_view root) {
    if (!uid.starts_with(root)) return nullptr;
    const auto found = std::find_if(names.begin(), names.end(),
                                    [rest = uid.substr(root.size())](const Name& name) { return name.first == rest; });
    return found == names.end() ? nullptr : found->second;
}

}  // namespace

std::string transferSyntaxName(std::string_view uid) {
    if (uid == "1.2.840.113619.5.2") return "GE's private mixture of byte orders";
    const char* name = nameIn(transferSyntaxes, uid, transferRoot);
    return name != nullptr ? name : "a coding that is not known here";
}

std::string objectName(std::string_view sopClassUid) {
    if (sopClassUid.empty()) return "an object that does not say of what kind it is";
    if (sopClassUid == directorySopClass) return "a DICOMDIR (a list of files)";
    if (sopClassUid == qlabSopClass) return "a Philips QLAB Cartesian volume";
    if (sopClassUid == "1.2.840.113543.6.6.1.3.10001") return "a Philips 3D volume in its maker's own coding";
    if (const char* name = nameIn(storageClasses, sopClassUid, storageRoot)) return name;
    for (const auto& [family, name] : families)
        if (sopClassUid.starts_with(storageRoot) && sopClassUid.substr(storageRoot.size()).starts_with(family))
            return name;
    for (const auto& [root, maker] : makers)
        if (sopClassUid.starts_with(root)) return std::string("a private object of ") + maker;
    return "an object of a kind that is not known here";
}

bool holdsPicture(std::string_view sopClassUid) {
    const std::string name = objectName(sopClassUid);
    constexpr std::array words{" image",        " cine",     "US Volume", " screen capture", " angiography volume",
                               "facial volume", "synthesis", " video",    " not known here", " does not say"};
    return std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

}  // namespace echolucent
