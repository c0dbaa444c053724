#include "io/dicom/patient.h"

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <optional>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/elements/dicom_scan.h"
#include "io/dicom/series/large_stack.h"

namespace echolucent {

namespace {

/// "1980-05-17" of "19800517".
std::string dateText(const std::string& stored) {
    const bool date = stored.size() == 8 &&
                      std::ranges::all_of(stored, [](unsigned char letter) { return std::isdigit(letter) != 0; });
    return date ? stored.substr(0, 4) + '-' + stored.substr(4, 2) + '-' + stored.substr(6) : stored;
}

std::optional<std::chrono::sys_days> dayOf(const std::string& stored) {
    const std::string date = dateText(stored);
    if (date == stored) return std::nullopt;
    const std::chrono::year_month_day day(std::chrono::year(std::stoi(date.substr(0, 4))),
                                          std::chrono::month(static_cast<unsigned>(std::stoi(date.substr(5, 2)))),
                                          std::chrono::day(static_cast<unsigned>(std::stoi(date.substr(8)))));
    return day.ok() ? std::optional(std::chrono::sys_days(day)) : std::nullopt;
}

std::string gestationalAge(const std::string& lastMenstruation, const std::string& study) {
    constexpr long longest = 45 * 7;  // days
    const auto from = dayOf(lastMenstruation), to = dayOf(study);
    if (!from || !to) return {};
    const long days = (*to - *from).count();
    if (days < 0 || days > longest) return {};
    return std::to_string(days / 7) + '+' + std::to_string(days % 7);
}

bool isDicomFile(const std::string& path) {
    constexpr std::size_t preambleAndMagic = 132;
    const auto input = InputFile::open(path);
    if (!input) return false;
    const auto beginning = input->beginning(preambleAndMagic);
    return beginning && looksLikeDicom(*beginning);
}

struct Said {
    Patient patient;
    std::string series;
};

/// Gives names in UTF-8 if the file's character set is known, else as stored.
Said saidIn(DcmDataset& dataset) {
    // On some systems DCMTK has no library of character sets. Names then stay as stored.
    (void)dataset.convertToUTF8();
    return {
        {.name = dicomText(dataset, {0x0010, 0x0010}),
         .id = dicomText(dataset, {0x0010, 0x0020}),
         .birthDate = dateText(dicomText(dataset, {0x0010, 0x0030})),
         .sex = dicomText(dataset, {0x0010, 0x0040}),
         .studyDate = dateText(dicomText(dataset, {0x0008, 0x0020})),
         .gestationalAge = gestationalAge(dicomText(dataset, {0x0010, 0x21d0}), dicomText(dataset, {0x0008, 0x0020}))},
        dicomText(dataset, {0x0020, 0x000e})};
}

Result<Patient> patientOf(const std::vector<Said>& files, const std::string& file) {
    const Patient& first = files.front().patient;
    for (const Said& said : files) {
        if (said.patient.name != first.name || said.patient.id != first.id)
            return fail(FailureKind::unreadable, file, "",
                        "lies beside files of another patient, so that it cannot be told whose study it is",
                        "Keep the files of each patient in a folder of their own.");
    }
    Patient agreed = first;
    for (std::string Patient::*fact :
         {&Patient::birthDate, &Patient::sex, &Patient::studyDate, &Patient::gestationalAge})
        for (const Said& said : files)
            if (said.patient.*fact != first.*fact) (agreed.*fact).clear();
    if (agreed.studyDate.empty()) agreed.gestationalAge.clear();  // an age needs the day on which it was counted
    return agreed;
}

Result<Patient> readAll(const std::vector<std::string>& files, const std::string& series, const Progress& progress) {
    std::vector<Said> all, ofSeries;
    for (const std::string& path : files) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
        if (!isDicomFile(path)) continue;
        const auto file = DicomFile::load(path, true, progress);
        if (!file) continue;  // it could not be read when the study was opened either
        all.push_back(saidIn(file->dataset()));
        if (!series.empty() && all.back().series == series) ofSeries.push_back(all.back());
    }
    if (all.empty())
        return fail(FailureKind::unreadable, files.empty() ? std::string() : files.front(), "",
                    "is no DICOM file that can be read, so that it names no patient");
    return patientOf(ofSeries.empty() ? all : ofSeries, files.front());
}

}  // namespace

Patient withTyped(Patient ofFiles, const Patient& typed) {
    if (!typed.studyDate.empty() && typed.studyDate != ofFiles.studyDate) ofFiles.gestationalAge.clear();
    for (std::string Patient::*fact : {&Patient::name, &Patient::id, &Patient::birthDate, &Patient::sex,
                                       &Patient::studyDate, &Patient::gestationalAge})
        if (!(typed.*fact).empty()) ofFiles.*fact = typed.*fact;
    return ofFiles;
}

bool areDicomFiles(const std::vector<std::string>& files) {
    return !files.empty() && (isDicomFile(files.front()) || isDicomFile(files.back()));
}

Result<Patient> readPatient(const std::vector<std::string>& files, const std::string& series,
                            const Progress& progress) {
    Result<Patient> patient = fail(FailureKind::unreadable, {}, {}, "no patient was read");
    runWithLargeStack([&] { patient = readAll(files, series, progress); });
    return patient;
}

}  // namespace echolucent
