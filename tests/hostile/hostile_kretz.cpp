// Hostile GE Voluson volumes (Kretz): items, sizes, geometry of the beams, phases, cuts.
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hostile_file.h"
#include "hostile_numbers.h"
#include "kretz_files.h"

namespace echolucent {

namespace {

HostileFile kretz(const std::string& name, const std::function<void(KretzParts&)>& change,
                  const std::vector<std::string>& words, HostileOutcome outcome = HostileOutcome::refused) {
    KretzParts parts;
    change(parts);
    return hostileFile("kretz/" + name, "v.vol", parts.bytes(), words, outcome);
}

/// Leaves the geometry of the beams out, so that the voxels are a Cartesian grid of this spacing (mm).
void makeCartesian(KretzParts& parts, double spacing) {
    parts.planeAngles = parts.lineAngles = parts.firstSample = parts.planesAxis = parts.resolution = "";
    parts.more = kretzNumbers(0x0010, 0x0022, {spacing});
}

std::vector<HostileFile> items() {
    const std::string lengthOf4Gb = bytesFrom<std::uint16_t>({0xD000, 1}) + bytesFrom<std::uint32_t>({0xFFFFFFFF});
    std::string many;
    for (int i = 0; i < 100001; ++i) many += kretzItem(0x0001, 1, "");
    return {
        kretz("an-item-of-4-gb", [&](KretzParts& p) { p.voxels = lengthOf4Gb; },
              {"declares 4294967295 bytes", "incomplete or damaged"}),
        kretz("100001-items", [&](KretzParts& p) { p.more = many; }, {"more than 100000 items"}),
        kretz("two-sizes", [](KretzParts& p) { p.size += kretzWhole(0xC000, 1, 21); }, {"stands 2 times"}),
        kretz("a-size-of-4-bytes",
              [](KretzParts& p) {
                  p.size = kretzItem(0xC000, 1, "abcd") + kretzWhole(0xC000, 2, 5) + kretzWhole(0xC000, 3, 4);
              },
              {"holds 4 bytes, where a whole number takes 2"}),
        kretz("a-size-of-0", [](KretzParts& p) { p.size = kretzSize(20, 0, 4); }, {"C000:0002 is 0"}),
        kretz("280-tb", [](KretzParts& p) { p.size = kretzSize(65535, 65535, 65535); },
              {"holds 400 bytes of voxels where the size 65535 x 65535 x 65535"}),
        kretz("a-sequence-of-1-byte-phases",
              [](KretzParts& p) {
                  makeCartesian(p, 1);
                  p.size = kretzSize(1, 1, 1);
                  p.voxels = kretzItem(0xD600, 1, std::string(1000000, 'v'));
              },
              {"makes 1000000 phases", "no more than 4096"}),
        kretz("4097-volumes",
              [](KretzParts& p) {
                  makeCartesian(p, 1);
                  p.size = kretzSize(1, 1, 2);
                  p.voxels = "";
                  for (int i = 0; i < 4097; ++i) p.voxels += kretzItem(0xD000, 1, "vv");
              },
              {"makes 4097 phases"}),
        kretz("a-broken-phase", [](KretzParts& p) { p.more = kretzItem(0xD600, 1, std::string(401, 'v')); },
              {"no whole number of volumes"}),
        kretz("compressed-voxels", [](KretzParts& p) { p.voxels = kretzItem(0x0002, 1, "wavelets"); }, {"D000:0001"}),
    };
}

std::vector<HostileFile> beams() {
    std::vector<HostileFile> rows;
    for (const double value : {noNumber, infinite, 0.0, -0.0005, 1e300, 1e-310})
        rows.push_back(kretz(fmt::format("a-range-step-of-{}", value),
                             [&](KretzParts& p) { p.resolution = kretzNumbers(0xC100, 1, {value}); }, {"C100:0001"}));
    for (const double value : {noNumber, infinite, 1e300, -1e300})
        rows.push_back(kretz(fmt::format("a-first-sample-of-{}", value),
                             [&](KretzParts& p) { p.firstSample = kretzNumbers(0xC200, 1, {value}); }, {"C200:0001"}));
    for (const double value : {noNumber, infinite, 1e300, -1e300})
        rows.push_back(kretz(fmt::format("a-planes-axis-of-{}", value),
                             [&](KretzParts& p) { p.planesAxis = kretzNumbers(0xC200, 2, {value}); }, {"C200:0002"}));
    for (const double value : {noNumber, infinite, 1e300, 1.4})
        rows.push_back(kretz(fmt::format("an-angle-of-{}", value),
                             [&](KretzParts& p) {
                                 p.lineAngles = kretzNumbers(0xC300, 2, {1.3, 1.4, value, 1.6, 1.7});
                             },
                             {"C300:0002"}));
    for (const double value : {noNumber, infinite, 0.0, -1.0, 1e300, 1e-310})
        rows.push_back(kretz(fmt::format("a-cartesian-spacing-of-{}", value),
                             [&](KretzParts& p) { makeCartesian(p, value); }, {"which no scanner makes"}));
    return rows;
}

std::vector<HostileFile> kretzCuts() {
    const std::string whole = KretzParts{}.bytes();
    const auto cut = [&](const std::string& name, std::size_t kept, const std::vector<std::string>& words,
                         HostileOutcome outcome = HostileOutcome::refused) {
        return hostileFile("kretz/" + name, "v.vol", whole.substr(0, kept), words, outcome);
    };
    const std::size_t end = whole.size() - 8, voxels = end - 408;
    return {
        cut("cut-in-its-signature", 9, {"ends after 9 bytes", "incomplete"}),
        cut("cut-after-its-signature", 16, {"C000:0001 is missing", "incomplete"}),
        cut("cut-in-the-header-of-an-item", 20, {"ends within the header of an item", "incomplete"}),
        cut("cut-in-an-item", 25, {"incomplete or damaged"}),
        cut("cut-before-its-voxels", voxels, {"D000:0001 is missing", "incomplete"}),
        cut("cut-in-its-voxels", voxels + 100, {"D000:0001", "incomplete or damaged"}),
        cut("cut-before-its-end", end, {"may have been cut off"}, HostileOutcome::opensWithNote),
        cut("cut-in-its-end", end + 5, {"ends within the header of an item", "incomplete"}),
    };
}

}  // namespace

std::vector<HostileFile> hostileKretz() {
    std::vector<HostileFile> rows;
    for (const auto part : {items, beams, kretzCuts})
        for (HostileFile& one : part()) rows.push_back(std::move(one));
    return rows;
}

}  // namespace echolucent
