// Slices that are missing, damaged, or of something else than the slices beside them.
#include "hostile_file.h"
#include "hostile_slices.h"

namespace echolucent {

namespace {

/// One slice (from 0) that `change` changes; the others are as they are.
SpoilSlice only(int which, std::function<void(HostileSlice&)> change) {
    return [which, change = std::move(change)](int number, HostileSlice& slice) {
        if (number == which) change(slice);
    };
}

/// The slices from `first` on.
SpoilSlice from(int first, std::function<void(HostileSlice&)> change) {
    return [first, change = std::move(change)](int number, HostileSlice& slice) {
        if (number >= first) change(slice);
    };
}

constexpr const char* shownAsNoData = "1 of 6 slices could not be read and are shown as no data: \"s";

std::vector<HostileFile> damagedSlices() {
    const auto empty = [](int which, int count = 6) {
        return [which, count](const std::filesystem::path& folder) {
            writeSeries(folder, count, {});
            std::filesystem::resize_file(folder / ("s0" + std::to_string(which)), 0);
        };
    };
    const auto cutPixels = [](HostileSlice& slice) { slice.cut = 5; };
    const auto noPixels = [](HostileSlice& slice) { slice.hasPixels = false; };
    const auto noSize = [](HostileSlice& slice) { slice.sized = false; };
    const auto cutInHeader = [](HostileSlice& slice) { slice.cut = 48; };
    std::vector<HostileFile> rows{
        hostileFolder("an-empty-end-slice", empty(5), HostileOutcome::opensWithNote,
                      {"1 file(s) are empty (0 bytes): \"s05\""}),
        hostileFolder("an-empty-first-slice", empty(0), HostileOutcome::opensWithNote,
                      {"1 file(s) are empty (0 bytes): \"s00\""}),
        hostileFolder("an-empty-slice-in-the-middle", empty(3), HostileOutcome::refused,
                      {"slices are missing or uneven", "1 file(s) beside it could not be read: \"s03\""}),
        hostileFolder("one-of-two-slices-empty", empty(1, 2), HostileOutcome::refused,
                      {"is a single 2D picture", "could not be read: \"s01\""})};
    struct Damage {
        const char* name;
        std::function<void(HostileSlice&)> change;
        const char* words;
    };
    const std::vector<Damage> damages{
        {"cut-in-its-pixels", cutPixels, "(7fe0,0010) Pixel Data declares 8 bytes where the file holds only 3"},
        {"without-pixel-data", noPixels, "has no (7fe0,0010) Pixel Data"},
        {"without-rows", noSize, "has pixels without Rows and Columns"},
        {"cut-in-its-header", cutInHeader, "in the middle of an element"}};
    for (const Damage& damage : damages) {
        const std::string name = std::string("slice-") + damage.name;
        for (const auto& [place, which] : {std::pair("first", 0), std::pair("middle", 2), std::pair("last", 5)})
            rows.push_back(hostileSeries(std::string("the-") + place + "-" + name, 6, only(which, damage.change),
                                         HostileOutcome::opensWithNote,
                                         {shownAsNoData + ("0" + std::to_string(which) + "\""), damage.words}));
        rows.push_back(hostileSeries("four-of-six-" + name, 6, from(2, damage.change), HostileOutcome::refused,
                                     {"holds a damaged series: 4 of 6 slices could not be read",
                                      "\"s02\", \"s03\", \"s04\" and 1 more", damage.words}));
        rows.push_back(
            hostileSeries("every-" + name, 6, from(0, damage.change), HostileOutcome::refused,
                          {"holds 6 DICOM files, and all of them are damaged", "\"s00\"", "3 more", damage.words}));
    }
    return rows;
}

std::vector<HostileFile> moreDamage() {
    const auto second = [](const std::filesystem::path& folder, const HostileSlice& slice) {
        writeBytes(folder / "t99", bytesOf(slice));
    };
    return {
        hostileSeries("a-slice-cut-before-its-series", 6, only(5, [](HostileSlice& slice) { slice.kept = 330; }),
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"s05\"", "in the middle of"}),
        hostileSeries("a-slice-cut-in-its-meta-header", 6, only(5, [](HostileSlice& slice) { slice.kept = 150; }),
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"s05\""}),
        hostileSeries("a-slice-cut-in-its-preamble", 6, only(5, [](HostileSlice& slice) { slice.kept = 100; }),
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"s05\"", "is no DICOM"}),
        hostileFolder("a-slice-overwritten-with-zeros",
                      [](const std::filesystem::path& folder) {
                          writeSeries(folder, 5, {});
                          writeBytes(folder / "s05", std::string(600, '\0'));
                      },
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"s05\"", "is no DICOM"}),
        hostileFolder("a-file-of-dicoms-ending-that-is-none",
                      [](const std::filesystem::path& folder) {
                          writeSeries(folder, 5, {});
                          writeBytes(folder / "report.DCM", "no DICOM at all");
                      },
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"report.DCM\""}),
        hostileFolder("notes-beside-slices",
                      [](const std::filesystem::path& folder) {
                          writeSeries(folder, 5, {});
                          writeBytes(folder / "notes.txt", "no DICOM at all");
                      },
                      HostileOutcome::opens, {"notes", "left out", "could not be read"}),
        hostileFolder("a-damaged-copy-beside-its-slice",
                      [second](const std::filesystem::path& folder) {
                          writeSeries(folder, 5, {});
                          HostileSlice copy;
                          copy.position = "0\\0\\2";
                          copy.cut = 3;
                          second(folder, copy);
                      },
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"t99\""}),
        hostileFolder("a-damaged-slice-far-away",
                      [second](const std::filesystem::path& folder) {
                          writeSeries(folder, 5, {});
                          HostileSlice far;
                          far.position = "0\\0\\700";
                          far.cut = 3;
                          second(folder, far);
                      },
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"t99\""}),
        hostileFolder("a-damaged-slice-of-another-patient",
                      [second](const std::filesystem::path& folder) {
                          writeSeries(folder, 5, {});
                          HostileSlice other;
                          other.position = "0\\0\\5";
                          other.patientId = "P-2";
                          other.cut = 3;
                          second(folder, other);
                      },
                      HostileOutcome::opensWithNote, {"1 damaged file(s) were left out: \"t99\""}),
        hostileSeries("a-slice-whose-pixels-do-not-decode", 6,
                      only(2,
                           [](HostileSlice& slice) {
                               slice.syntax = "1.2.840.10008.1.2.5";
                               slice.pixels = std::string(64, '\x7f');
                           }),
                      HostileOutcome::opensWithNote,
                      {"1 of 6 slices could not be read and are shown as no data: \"s02\""}),
        hostileSeries("most-slices-do-not-decode", 6,
                      from(2,
                           [](HostileSlice& slice) {
                               slice.syntax = "1.2.840.10008.1.2.5";
                               slice.pixels = std::string(64, '\x7f');
                           }),
                      HostileOutcome::refused, {"holds a damaged series: 4 of 6 slices could not be read", "\"s02\""})};
}

const char* const twoSeries = "There are 2 series here; that of 4 x 2, 4 slices was read.";

std::vector<HostileFile> mixedSlices() {
    struct Mix {
        const char* name;
        std::function<void(HostileSlice&)> change;
        const char* words;
    };
    const std::vector<Mix> mixes{
        {"patient-ids", [](HostileSlice& slice) { slice.patientId = "P-4712"; }, "are of 2 patients;"},
        {"patient-names", [](HostileSlice& slice) { slice.patientName = "Muster^Berta"; }, "are of 2 patients;"},
        {"birth-dates", [](HostileSlice& slice) { slice.birthDate = "19800518"; }, "are of 2 patients;"},
        {"patients-altogether",
         [](HostileSlice& slice) { slice.patientId = slice.patientName = slice.birthDate = "1"; },
         "are of 2 patients; they are listed apart"},
        {"frames-of-reference", [](HostileSlice& slice) { slice.frame = "1.2.10"; }, "are of 2 frames of reference;"},
        {"pixel-spacings", [](HostileSlice& slice) { slice.spacing = "0.5\\0.6"; }, "are of 2 pixel spacings;"},
        {"sizes", [](HostileSlice& slice) { slice.columns = 5; }, "are of 2 sizes;"},
        {"modalities", [](HostileSlice& slice) { slice.modality = "CT"; }, "are of 2 modalities;"},
        {"photometric-interpretations", [](HostileSlice& slice) { slice.photometric = "MONOCHROME1"; },
         "are of 2 photometric interpretations;"},
        {"grey-and-colour", [](HostileSlice& slice) { slice.photometric = "RGB"; },
         "are of 2 photometric interpretations;"},
        {"patients-and-spacings",
         [](HostileSlice& slice) {
             slice.patientId = "P-2";
             slice.spacing = "1\\1";
         },
         "are of 2 patients and of 2 pixel spacings;"}};
    std::vector<HostileFile> rows;
    for (const Mix& mix : mixes) {
        rows.push_back(
            hostileSeries(std::string("two-") + mix.name, 7, from(4, mix.change), HostileOutcome::opensWithNote,
                          {mix.words, "they are listed apart", "There are 2 series here; that of 4 x 2, 4"}));
        rows.push_back(hostileSeries(std::string("two-") + mix.name + "-without-a-series", 7,
                                     [change = mix.change](int number, HostileSlice& slice) {
                                         slice.series.clear();
                                         if (number >= 4) change(slice);
                                     },
                                     HostileOutcome::opensWithNote, {mix.words, twoSeries}));
        rows.push_back(hostileSeries(std::string("interleaved-") + mix.name, 8,
                                     [change = mix.change](int number, HostileSlice& slice) {
                                         if (number % 2 == 1) change(slice);
                                     },
                                     HostileOutcome::opensWithNote, {mix.words, "they are listed apart"}));
    }
    return rows;
}

std::vector<HostileFile> almostMixed() {
    return {
        hostileSeries("the-same-patient-spelled-otherwise", 5,
                      from(2, [](HostileSlice& slice) { slice.patientName = "MUSTER^ANNA^^^"; }), HostileOutcome::opens,
                      {"patient", "listed apart", "series here"}),
        hostileSeries("a-patient-without-name-in-some-slices", 5,
                      from(2, [](HostileSlice& slice) { slice.patientName.clear(); }), HostileOutcome::opens,
                      {"patient", "listed apart", "series here"}),
        hostileSeries("spacings-with-more-digits", 5,
                      from(2, [](HostileSlice& slice) { slice.spacing = "0.50000001\\0.4999999"; }),
                      HostileOutcome::opens, {"spacings", "listed apart", "series here"}),
        hostileSeries("each-slice-in-a-frame-of-its-own", 5,
                      [](int number, HostileSlice& slice) { slice.frame = "1.2.9." + std::to_string(number); },
                      HostileOutcome::refused, {"(0020,0052) Frame of Reference UID", "in each of 5 pictures"}),
        hostileSeries("two-rescale-slopes", 4, from(2, [](HostileSlice& slice) { slice.slope = "2"; }),
                      HostileOutcome::opensWithNote, {"rescaled by different slopes or intercepts; each by its own"}),
        hostileSeries("two-rescale-intercepts", 4, from(2, [](HostileSlice& slice) { slice.intercept = "7"; }),
                      HostileOutcome::opensWithNote, {"rescaled by different slopes or intercepts; each by its own"}),
        hostileSeries("two-rescale-lines-with-one-white", 4,
                      [](int number, HostileSlice& slice) {
                          slice.slope = number < 2 ? "1" : "-1";
                          slice.intercept = number < 2 ? "0" : "255";
                      },
                      HostileOutcome::opensWithNote, {"rescaled by different slopes or intercepts; each by its own"}),
        hostileSeries("two-orientations", 6,
                      from(3, [](HostileSlice& slice) { slice.orientation = "1\\0\\0\\0\\0\\1"; }),
                      HostileOutcome::opensWithNote, {"are of 2 orientations; they are listed apart"}),
        hostileSeries("two-bit-depths", 6, from(3, [](HostileSlice& slice) { slice.bits = 16; }),
                      HostileOutcome::refused, {"Bits Allocated", "another type than the first slice's"}),
        hostileSeries("two-signs", 6, from(3, [](HostileSlice& slice) { slice.representation = 1; }),
                      HostileOutcome::refused, {"sign", "another type than the first slice's"})};
}

}  // namespace

std::vector<HostileFile> hostileDicomSeries() {
    std::vector<HostileFile> rows;
    for (const auto part : {damagedSlices, moreDamage, mixedSlices, almostMixed})
        for (HostileFile& row : part()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace echolucent
