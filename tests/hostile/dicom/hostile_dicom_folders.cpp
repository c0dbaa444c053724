// Places of slices that no scanner has, folders with links and pipes, and DICOMDIRs that mislead.
#include <sys/stat.h>

#include "dicom_bytes.h"
#include "hostile_file.h"
#include "hostile_slices.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

namespace fs = std::filesystem;

HostileFile atPositions(const std::string& name, const std::vector<std::string>& positions,
                        std::vector<std::string> words, HostileOutcome outcome = HostileOutcome::refused) {
    return hostileSeries(
        "positions-" + name, static_cast<int>(positions.size()),
        [positions](int number, HostileSlice& slice) { slice.position = positions[static_cast<std::size_t>(number)]; },
        outcome, std::move(words));
}

std::vector<HostileFile> hostilePositions() {
    const std::string far = "where no scanner can be", no = "without position and orientation";
    return {
        atPositions("that-overflow", {"0\\0\\-1e300", "0\\0\\1e300"}, {far, "(0020,0032)"}),
        atPositions("whose-distance-overflows", {"0\\0\\-1.7e308", "0\\0\\1.7e308"}, {far}),
        atPositions("one-of-which-overflows", {"0\\0\\0", "0\\0\\1", "0\\0\\1e300"}, {far}),
        atPositions("that-overflow-sideways", {"1e300\\0\\0", "1e300\\0\\1"}, {far}),
        atPositions("nan", {"0\\0\\nan", "0\\0\\nan"}, {no}),
        atPositions("one-of-which-is-nan", {"0\\0\\0", "0\\0\\1", "0\\0\\nan"}, {"1 of them", no, "\"s02\""}),
        atPositions("inf", {"0\\0\\-inf", "0\\0\\inf"}, {no}),
        atPositions("one-of-which-is-inf", {"0\\0\\0", "0\\0\\1", "0\\0\\inf"}, {no, "\"s02\""}),
        atPositions("too-large-for-a-double", {"0\\0\\0", "0\\0\\1e400"}, {no}),
        atPositions("of-400-digits", {"0\\0\\0", "0\\0\\" + std::string(400, '9')}, {no}),
        atPositions("of-400-decimals", {"0\\0\\0", "0\\0\\1." + std::string(400, '0'), "0\\0\\2"}, {"slices are"},
                    HostileOutcome::opens),
        atPositions("minus-zero-and-zero", {"0\\0\\-0", "0\\0\\0"}, {"is the same for two slices"}),
        atPositions("too-near", {"0\\0\\0", "0\\0\\1e-300"}, {"is the same for two slices"}),
        atPositions("denormal", {"0\\0\\0", "0\\0\\4.9e-324"}, {"is the same for two slices"}),
        atPositions("eleven-kilometres-away", {"0\\0\\0", "0\\0\\11000000"}, {far}),
        atPositions("ten-metres-apart", {"0\\0\\0", "0\\0\\20000"}, {"which no scanner makes"}),
        atPositions("doubled", {"0\\0\\0", "0\\0\\1", "0\\0\\1", "0\\0\\2"}, {"is the same for two slices", "s0"}),
        atPositions("all-the-same", {"0\\0\\0", "0\\0\\0", "0\\0\\0"}, {"is the same for two slices"}),
        atPositions("uneven", {"0\\0\\0", "0\\0\\1", "0\\0\\2", "0\\0\\4"}, {"slices are missing or uneven"}),
        atPositions("sideways-only", {"0\\0\\0", "5\\0\\0"}, {"is the same for two slices"}),
        atPositions("of-two-numbers", {"0\\0", "0\\1"}, {no}),
        atPositions("of-four-numbers", {"0\\0\\0\\0", "0\\0\\1\\0"}, {no}),
        atPositions("hexadecimal", {"0\\0\\0", "0\\0\\0x10"}, {no}),
        atPositions("in-words", {"0\\0\\0", "0\\0\\one"}, {no, "\"s01\""}),
        hostileSeries("orientation-of-zeros", 3,
                      [](int, HostileSlice& slice) { slice.orientation = "0\\0\\0\\0\\0\\0"; }, HostileOutcome::refused,
                      {no}),
        hostileSeries("orientation-nan", 3, [](int, HostileSlice& slice) { slice.orientation = "nan\\0\\0\\0\\1\\0"; },
                      HostileOutcome::refused, {no}),
        hostileSeries("orientation-that-overflows", 3,
                      [](int, HostileSlice& slice) { slice.orientation = "1e300\\0\\0\\0\\1e300\\0"; },
                      HostileOutcome::refused, {no}),
        hostileSeries("orientation-of-parallel-directions", 3,
                      [](int, HostileSlice& slice) { slice.orientation = "1\\0\\0\\1\\0\\0"; }, HostileOutcome::refused,
                      {no}),
        hostileSeries("instances-doubled", 4, [](int, HostileSlice& slice) { slice.instance = "7"; },
                      HostileOutcome::opens, {"instance"})};
}

std::vector<HostileFile> withoutPositions() {
    std::vector<HostileFile> rows{
        hostileSeries("instances-doubled-without-positions", 4,
                      [](int number, HostileSlice& slice) {
                          slice.instance = "7";
                          slice.pixels = std::string(8, static_cast<char>(10 + number));
                          slice.position.clear();
                      },
                      HostileOutcome::opensWithNote, {"3 pictures have the instance number of another or none"}),
        hostileSeries("an-instance-missing-without-positions", 4,
                      [](int number, HostileSlice& slice) {
                          slice.instance = std::to_string(number < 2 ? number + 1 : number + 3);
                          slice.position.clear();
                      },
                      HostileOutcome::opensWithNote, {"are not consecutive (1 gaps)"}),
        hostileSeries("a-damaged-picture-without-positions", 4,
                      [](int number, HostileSlice& slice) {
                          slice.position.clear();
                          slice.cut = number == 2 ? 4 : 0;
                      },
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"s02\""})};
    for (HostileFile& row : rows) row.options.framesAsSlices = true;
    return rows;
}

std::vector<HostileFile> hostileFolders() {
    const auto folder = [](const char* name, std::function<void(const fs::path&)> spoil, std::vector<std::string> words,
                           HostileOutcome outcome = HostileOutcome::opensWithNote) {
        return hostileFolder(
            name,
            [spoil = std::move(spoil)](const fs::path& path) {
                writeSeries(path, 4, {});
                spoil(path);
            },
            outcome, std::move(words));
    };
    return {
        folder("a-link-out-of-the-folder",
               [](const fs::path& path) { fs::create_symlink("/etc/passwd", path / "s04"); },
               {"1 link(s) lead to files out of the folder and were not followed, \"s04\" among them"}),
        folder("a-link-to-a-folder-outside", [](const fs::path& path) { fs::create_symlink("/usr", path / "more"); },
               {"1 link(s) lead to folders out of this one and were not followed, \"more\" among them"}),
        folder("a-link-to-itself", [](const fs::path& path) { fs::create_symlink("s04", path / "s04"); },
               {"1 link(s) lead nowhere, \"s04\" among them"}),
        folder("a-link-to-nothing", [](const fs::path& path) { fs::create_symlink("gone", path / "s04"); },
               {"1 link(s) lead nowhere"}),
        folder(
            "a-link-to-the-folder-itself", [](const fs::path& path) { fs::create_symlink(".", path / "again"); },
            {"link", "left out", "series here"}, HostileOutcome::opens),
        folder(
            "a-link-to-a-slice-beside-it", [](const fs::path& path) { fs::create_symlink("s01", path / "s04"); },
            {"link", "left out", "series here"}, HostileOutcome::opens),
        folder(
            "a-link-in-place-of-a-slice",
            [](const fs::path& path) {
                fs::remove(path / "s01");
                fs::create_symlink("gone", path / "s01");
            },
            {"slices are missing or uneven", "1 link(s) lead nowhere, \"s01\" among them"}, HostileOutcome::refused),
        folder("a-pipe", [](const fs::path& path) { (void)mkfifo((path / "s04").c_str(), 0600); },
               {"1 pipe(s), socket(s) or device(s) were left out, \"s04\" among them"}),
        hostileFolder("only-links",
                      [](const fs::path& path) {
                          fs::create_directories(path / "in");
                          fs::create_symlink("/etc/passwd", path / "s04");
                      },
                      HostileOutcome::refused,
                      {"is a folder without DICOM images", "1 link(s) lead to files out of the folder"}),
        hostileFolder("only-empty-files",
                      [](const fs::path& path) {
                          writeBytes(path / "s1", "");
                          writeBytes(path / "s2", "");
                      },
                      HostileOutcome::refused,
                      {"is a folder without DICOM images", "2 file(s) are empty (0 bytes): \"s1\", \"s2\""}),
        hostileFolder("nothing-at-all", [](const fs::path&) {}, HostileOutcome::refused,
                      {"is a folder without DICOM images"}),
        folder("slices-five-folders-deep", [](const fs::path& path) { writeSeries(path / "1/2/3/4/5", 3, {}); },
               {"1 folder(s) deeper than 4 were not looked into, \"5\" among them"}),
        hostileFolder("only-slices-five-folders-deep",
                      [](const fs::path& path) { writeSeries(path / "1/2/3/4/5", 3, {}); }, HostileOutcome::refused,
                      {"is a folder without DICOM images", "1 folder(s) deeper than 4 were not looked into"}),
        folder("a-slice-packed-with-gzip",
               [](const fs::path& path) { writeBytes(path / "s04.gz", deflated(bytesOf(HostileSlice{}), 31)); },
               {"1 file(s) are packed with gzip"}),
        folder("a-damaged-name-with-a-newline",
               [](const fs::path& path) { writeBytes(path / "s04\n.dcm", "no DICOM"); },
               {"1 damaged file(s) were left out: \"s04 .dcm\""}),
        folder("a-damaged-name-that-is-no-utf-8",
               [](const fs::path& path) { writeBytes(path / "s\xff\xfe.dcm", "no DICOM"); },
               {"1 damaged file(s) were left out: \"s\xef\xbf\xbd\xef\xbf\xbd.dcm\""}),
        folder("a-description-of-a-megabyte",
               [](const fs::path& path) {
                   HostileSlice slice;
                   slice.series = "1.2.4";
                   slice.description = std::string(60000, 'd');
                   slice.patientName = std::string(60000, 'n');
                   writeBytes(path / "t", bytesOf(slice));
               },
               {"There are 2 series here"})};
}

/// A DICOMDIR whose records name these files; each record links to the first.
std::string directory(const std::vector<std::string>& names, std::uint16_t inUse = 0xffff,
                      const std::string& type = "IMAGE") {
    std::vector<DicomBytes> records;
    for (const std::string& name : names) {
        DicomBytes record;
        record.put(0x0004, 0x1400, "UL", std::string("\x90\1\0\0", 4)).word(0x0004, 0x1410, inUse);
        record.put(0x0004, 0x1420, "UL", std::string("\x90\1\0\0", 4)).text(0x0004, 0x1430, "CS", type);
        if (!name.empty()) record.text(0x0004, 0x1500, "CS", name);
        records.push_back(record);
    }
    return DicomBytes().sequence(0x0004, 0x1220, records).file("1.2.840.10008.1.3.10");
}

/// A record with an unknown value, in which an item holds an element that runs to the end of the file; and behind it a
/// record with too long a type. DCMTK does not look into the value, and finds that record.
std::string directoryThatRunsOver() {
    const std::string tagsOfItem("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8), longElement("\x09\0\x01\x10\x50\xc3\0\0", 8);
    DicomBytes first, second;
    first.text(0x0004, 0x1430, "CS", "IMAGE").text(0x0004, 0x1500, "CS", "S00");
    first.put(0x0009, 0x1001, "UN", tagsOfItem + longElement + std::string(32, ' '));
    second.text(0x0004, 0x1430, "CS", std::string(40, 'I')).text(0x0004, 0x1500, "CS", "S01");
    return DicomBytes().sequence(0x0004, 0x1220, {first, second}).file("1.2.840.10008.1.3.10");
}

HostileFile hostileDirectory(const std::string& name, const std::string& bytes, HostileOutcome outcome,
                             std::vector<std::string> words, std::function<void(const fs::path&)> more = {}) {
    HostileFile row = hostileFolder(
        "dicomdir-" + name,
        [bytes, more = std::move(more)](const fs::path& path) {
            writeSeries(path / "M", 3, {}, "S");
            writeBytes(path / "M/DICOMDIR", bytes);
            writeSeries(path, 2, {}, "OUT");
            if (more) more(path / "M");
        },
        outcome, std::move(words));
    row.opened = "M/DICOMDIR";
    return row;
}

std::vector<HostileFile> hostileDirectories() {
    const std::vector<std::string> all{"S00", "S01", "S02"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), all.begin(), all.end());
        return directory(more);
    };
    const std::string none = "files that it names is in its folder or below it";
    std::vector<std::string> many;
    for (int i = 0; i < 3000; ++i) many.push_back("F" + std::to_string(i));
    return {
        hostileDirectory("in-circles", with({"S00", "S01", "S00"}), HostileOutcome::opens,
                         {"DICOMDIR", "not in its folder"}),
        hostileDirectory("that-names-itself", with({"DICOMDIR"}), HostileOutcome::opens,
                         {"damaged", "not in its folder"}),
        hostileDirectory("that-names-only-itself", directory({"DICOMDIR"}), HostileOutcome::refused,
                         {"names no DICOM images"}),
        hostileDirectory("that-names-a-folder", with({"SUB"}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names are not in its folder or below it, \"SUB\""},
                         [](const fs::path& path) { fs::create_directories(path / "SUB"); }),
        hostileDirectory("that-names-the-folder-above", with({"..\\OUT00"}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names are not in its folder", "\"../OUT00\""}),
        hostileDirectory("that-names-only-files-above", directory({"..\\OUT00", "..\\OUT01"}), HostileOutcome::refused,
                         {"none of the 2 " + none}),
        hostileDirectory("that-names-root", with({"\\etc\\passwd", "/etc/passwd"}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names"}),
        hostileDirectory("that-names-a-detour", with({"SUB\\..\\..\\OUT00"}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names"}),
        hostileDirectory("with-a-missing-file-twice", with({"GONE", "GONE", "S00"}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names are not in its folder or below it, \"GONE\""}),
        hostileDirectory("with-nothing-but-missing-files", directory(many), HostileOutcome::refused,
                         {"none of the 3000 " + none}),
        hostileDirectory("with-a-record-type-of-40-letters", directory(all, 0xffff, std::string(40, 'I')),
                         HostileOutcome::refused, {"(0004,1430) Directory Record Type", "is 40 bytes long"}),
        hostileDirectory("with-a-value-that-runs-over-its-record", directoryThatRunsOver(), HostileOutcome::refused,
                         {"is damaged: what stands at byte"}),
        hostileDirectory("without-records", directory({}), HostileOutcome::refused, {"names no files"}),
        hostileDirectory("with-records-without-files", directory({"", ""}), HostileOutcome::refused,
                         {"names no files"}),
        hostileDirectory("with-records-out-of-use", directory(all, 0), HostileOutcome::refused, {"names no files"}),
        hostileDirectory("with-a-name-of-60000-letters", with({std::string(60000, 'A')}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names", "AAA...\""}),
        hostileDirectory("with-a-newline-in-a-name", with({"A\nB"}), HostileOutcome::opensWithNote, {"\"A?B\""}),
        hostileDirectory("with-bytes-that-are-no-utf-8", with({"A\xff\xfe"}), HostileOutcome::opensWithNote,
                         {"\"A??\""}),
        hostileDirectory("that-names-twelve-folders-deep", with({"1\\2\\3\\4\\5\\6\\7\\8\\9\\10\\11\\12\\S00"}),
                         HostileOutcome::opensWithNote,
                         {"1 folder(s) deeper than 8 were not looked into", "1 of 4 files"},
                         [](const fs::path& path) { writeSeries(path / "1/2/3/4/5/6/7/8/9/10/11/12", 1, {}, "S"); }),
        hostileDirectory("that-names-a-link-out", with({"LINK"}), HostileOutcome::opensWithNote,
                         {"1 link(s) lead to files out of the folder", "1 of 4 files that the DICOMDIR names"},
                         [](const fs::path& path) {
                             HostileSlice slice;
                             slice.series = "1.2.4";
                             writeBytes(path.parent_path() / "other", bytesOf(slice));
                             fs::create_symlink(path.parent_path() / "other", path / "LINK");
                         }),
        hostileDirectory("that-names-a-link-to-a-folder-out", with({"LINK\\OUT00"}), HostileOutcome::opensWithNote,
                         {"1 of 4 files that the DICOMDIR names", "1 link(s) lead to folders out of this one"},
                         [](const fs::path& path) { fs::create_symlink(path.parent_path(), path / "LINK"); }),
        hostileDirectory("that-names-small-and-capital-letters", directory({"S00", "S01", "s02"}),
                         HostileOutcome::opens, {"DICOMDIR names"}),
        hostileDirectory("that-names-one-of-two-spellings", with({}), HostileOutcome::opens, {"damaged", "series here"},
                         [](const fs::path& path) { writeBytes(path / "s00", "another file"); }),
        hostileDirectory("cut-in-half", directory(all).substr(0, directory(all).size() / 2), HostileOutcome::refused,
                         {""}),
        hostileDirectory("that-names-a-cut-slice", with({}), HostileOutcome::opensWithNote,
                         {"1 of 3 slices could not be read and are shown as no data: \"S02\""},
                         [](const fs::path& path) { fs::resize_file(path / "S02", fs::file_size(path / "S02") - 3); }),
        hostileDirectory("that-names-an-empty-slice", with({}), HostileOutcome::opensWithNote,
                         {"1 file(s) are empty (0 bytes): \"S02\""},
                         [](const fs::path& path) { fs::resize_file(path / "S02", 0); })};
}

}  // namespace

std::vector<HostileFile> hostileDicomFolders() {
    std::vector<HostileFile> rows;
    for (const auto part : {hostilePositions, withoutPositions, hostileFolders, hostileDirectories})
        for (HostileFile& row : part()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace echolucent
