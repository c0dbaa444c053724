// GE Voluson volumes in which one item is wrong, each with the words that its sentence must hold.
#include <functional>

#include <fmt/format.h>

#include "dicom_bytes.h"
#include "hostile_file.h"
#include "hostile_numbers.h"
#include "kretz_files.h"

namespace echolucent {

namespace {

HostileFile malformedKretz(const std::string& name, const std::function<void(KretzParts&)>& change,
                           std::vector<std::string> words) {
    KretzParts parts;
    change(parts);
    return hostileFile("malformed-kretz/" + name, "v.vol", parts.bytes(), std::move(words));
}

std::vector<HostileFile> wrongSizes() {
    return {
        malformedKretz(
            "the-largest-size", [](KretzParts& p) { p.size = kretzSize(65535, 65535, 65535); },
            {"D000:0001 holds 400 bytes of voxels where the size 65535 x 65535 x 65535 needs 281462092005375"}),
        malformedKretz("without-a-size", [](KretzParts& p) { p.size = ""; },
                       {"C000:0001 is missing: the size of the volume is not known"}),
        malformedKretz("a-size-twice", [](KretzParts& p) { p.size += kretzWhole(0xC000, 1, 21); },
                       {"C000:0001 stands 2 times, and must stand once"}),
        malformedKretz("no-lines", [](KretzParts& p) { p.size = kretzSize(20, 0, 4); }, {"C000:0002 is 0"}),
        malformedKretz("a-size-of-3-bytes",
                       [](KretzParts& p) {
                           p.size = kretzItem(0xC000, 1, "123") + kretzWhole(0xC000, 2, 5) + kretzWhole(0xC000, 3, 4);
                       },
                       {"C000:0001 holds 3 bytes, where a whole number takes 2"}),
        malformedKretz("one-voxel-too-few",
                       [](KretzParts& p) { p.voxels = kretzItem(0xD000, 1, std::string(399, 'v')); },
                       {"D000:0001 holds 399 bytes of voxels where the size 20 x 5 x 4 needs 400"}),
        malformedKretz("without-voxels", [](KretzParts& p) { p.voxels = ""; }, {"D000:0001 is missing"}),
        malformedKretz("a-sequence-of-no-whole-volumes",
                       [](KretzParts& p) { p.more = kretzItem(0xD600, 1, std::string(401, 'v')); },
                       {"D600:0001 holds 401 bytes, which is no whole number of volumes of 400"}),
        malformedKretz("an-empty-sequence", [](KretzParts& p) { p.more = kretzItem(0xD600, 1, ""); },
                       {"no whole number of volumes"}),
        malformedKretz("5000-phases-of-one-voxel",
                       [](KretzParts& p) {
                           p.size = kretzSize(1, 1, 1);
                           p.more = kretzItem(0xD600, 1, std::string(5000, 'v'));
                       },
                       {"D600:0001 makes 5000 phases, and no more than 4096 can be opened"}),
    };
}

std::vector<HostileFile> wrongBeams() {
    const auto lines = [](const std::vector<double>& angles) {
        return [angles](KretzParts& p) { p.lineAngles = kretzNumbers(0xC300, 2, angles); };
    };
    const auto planes = [](const std::vector<double>& angles) {
        return [angles](KretzParts& p) { p.planeAngles = kretzNumbers(0xC300, 1, angles); };
    };
    return {
        malformedKretz("without-angles-of-lines", [](KretzParts& p) { p.lineAngles = ""; },
                       {"C300:0002 is missing: there are angles of planes, but none of lines"}),
        malformedKretz("without-angles-of-planes", [](KretzParts& p) { p.planeAngles = ""; },
                       {"C300:0001 is missing: there are angles of lines, but none of planes"}),
        malformedKretz("too-few-angles-of-lines", lines({1.3, 1.4, 1.5, 1.6}),
                       {"C300:0002 holds 32 bytes, where the angles of 5 lines take 40"}),
        malformedKretz("two-lines-at-one-angle", lines({1.3, 1.4, 1.4, 1.6, 1.7}),
                       {"neither rise nor fall throughout"}),
        malformedKretz("planes-that-turn-back", planes({1.4, 1.6, 1.5, 1.7}),
                       {"the planes of C300:0001, C200:0002", "neither rise nor fall throughout"}),
        malformedKretz("a-plane-at-nan", planes({1.4, noNumber, 1.5, 1.7}), {"hold nan radians, which is no angle"}),
        malformedKretz("a-line-many-turns-away", lines({-50, 1.4, 1.5, 1.6, 1.7}),
                       {"radians, which is no angle between minus and plus half a turn"}),
        malformedKretz("without-a-resolution", [](KretzParts& p) { p.resolution = ""; },
                       {"C100:0001 is missing although"}),
        malformedKretz("a-resolution-of-0", [](KretzParts& p) { p.resolution = kretzNumbers(0xC100, 1, {0}); },
                       {"the range of C100:0001, C200:0001 has a step of 0 mm, which no scanner has"}),
        malformedKretz("a-resolution-of-nan",
                       [=](KretzParts& p) { p.resolution = kretzNumbers(0xC100, 1, {noNumber}); },
                       {"has a step of nan mm"}),
        malformedKretz("without-a-first-sample", [](KretzParts& p) { p.firstSample = ""; },
                       {"C200:0001 is missing although"}),
        malformedKretz("a-first-sample-beyond-the-earth",
                       [](KretzParts& p) { p.firstSample = kretzNumbers(0xC200, 1, {1e300}); }, {"which no probe has"}),
        malformedKretz("an-axis-behind-the-first-sample",
                       [](KretzParts& p) { p.planesAxis = kretzNumbers(0xC200, 2, {-90}); },
                       {"turn about an axis that lies behind the first sample"}),
    };
}

std::vector<HostileFile> wrongItems() {
    std::vector<HostileFile> rows{
        malformedKretz(
            "an-item-beyond-the-file",
            [](KretzParts& p) {
                p.end = bytesFrom<std::uint16_t>({0xD000, 2}) + bytesFrom<std::uint32_t>({0xFFFFFFFF}) + "short";
            },
            {"declares 4294967295 bytes where only 5 follow"}),
        malformedKretz("a-header-of-an-item-that-is-cut", [](KretzParts& p) { p.end = "abc"; },
                       {"ends within the header of an item"}),
        malformedKretz("100001-items-more",
                       [](KretzParts& p) {
                           for (int i = 0; i < 100001; ++i) p.more += kretzItem(7, 7, "");
                       },
                       {"has more than 100000 items, which no scanner writes"}),
        hostileFile("malformed-kretz/only-the-signature", "file.bin", "KRETZFILE 1.0   ",
                    {"the size of the volume is not known"}),
    };
    const std::string words = "is a compressed GE Voluson volume (Kretz, wavelet), which cannot be read";
    for (const std::uint16_t element : {0x1000, 0x1100, 0x1200})
        rows.push_back(malformedKretz(fmt::format("wavelets-of-{:x}", element),
                                      [=](KretzParts& p) { p.voxels = kretzItem(0x0002, element, "wavelets"); },
                                      {words}));
    rows.push_back(malformedKretz("wavelets-beside-too-few-voxels",
                                  [](KretzParts& p) {
                                      p.voxels = kretzItem(0xD000, 1, "short");
                                      p.more = kretzItem(0x0002, 0x1000, "wavelets");
                                  },
                                  {words}));
    rows.push_back(malformedKretz("wavelets-without-a-size",
                                  [](KretzParts& p) {
                                      p.size = "";
                                      p.voxels = kretzItem(0x0002, 0x1000, "wavelets");
                                  },
                                  {words}));
    return rows;
}

/// A volume in a private element of DICOM, behind a picture, of which the last bytes are missing.
HostileFile cutInDicom(std::size_t missing) {
    DicomBytes file;
    file.picture(4, 2, 0).put(0x7fe0, 0x0010, "OW", std::string(8, 'p')).text(0x7fe1, 0x0010, "LO", "KRETZ_US");
    std::string volume = KretzParts().bytes();
    volume.resize((volume.size() + 1) / 2 * 2, '\0');
    std::string bytes = file.put(0x7fe1, 0x1001, "OB", volume).file(pictureClass);
    bytes.resize(bytes.size() - missing);
    return hostileFile(fmt::format("malformed-kretz/in-dicom-{}-bytes-missing", missing), "v.dcm", bytes,
                       {fmt::format("(7fe1,1001) declares a volume of {} bytes where the file holds only {}",
                                    volume.size(), volume.size() - missing)});
}

std::vector<HostileFile> cutsInDicom() { return {cutInDicom(2), cutInDicom(20), cutInDicom(222), cutInDicom(400)}; }

}  // namespace

std::vector<HostileFile> hostileMalformedKretz() {
    std::vector<HostileFile> all;
    for (const auto rows : {wrongSizes, wrongBeams, wrongItems, cutsInDicom})
        for (HostileFile& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace echolucent
