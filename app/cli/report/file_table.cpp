#include "app/cli/report/file_table.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "io/output/overwriting.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/study.h"
#include "io/study/study_assembly.h"

namespace echolucent::cli {

namespace {

/// Escapes a text for a cell of a Markdown table.
std::string tableCell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
    return text;
}

/// A fact of the import report, "value {source}"; empty if there is none of that name.
std::string factOf(const Study& study, const std::string& name) {
    const auto fact = std::find_if(study.facts.begin(), study.facts.end(),
                                   [&](const ImportFact& candidate) { return candidate.name == name; });
    return fact == study.facts.end() ? std::string() : fmt::format("{} {{{}}}", fact->value, fact->source);
}

std::string summaryOf(const Study& study) {
    const Volume& volume = *study.phases.front();
    std::string text =
        fmt::format("{}; {} {}; {}{}; white {}", factOf(study, "format"), sizeText(volume.geometry().size),
                    volume.typeName(), volume.geometry().spacingKnown ? "" : "spacing unknown, ",
                    factOf(study, "spacing"), factOf(study, "white level"));
    if (study.phases.size() > 1) text += fmt::format("; {} phases", study.phases.size());
    text += "; " + factOf(study, "voxels without data") + " without data";
    if (study.lossyCompression == LossyCompression::yes) text += "; compressed with loss";
    if (const std::size_t notes = study.warnings.size(); notes > 0)
        text += notes == 1 ? "; 1 note" : fmt::format("; {} notes", notes);
    return text;
}

/// The sentence of a failure. It leaves out the name of the row's own file.
std::string sentenceOf(Failure failure, const std::string& path) {
    failure.file = failure.file == path ? std::string() : nameFromPath(failure.file);
    return failure.sentence();
}

std::string asSlices(const std::string& path) {
    ReadOptions options;
    options.framesAsSlices = true;
    const auto study = restricted::readStudy(path, options);
    return " **As slices:** " + (study ? summaryOf(*study) + "." : sentenceOf(study.error(), path));
}

}  // namespace

std::string fileRow(const std::string& path, const std::string& shownName) {
    const auto study = restricted::readStudy(path);
    const std::string start = "| `" + tableCell(shownName) + "` | ";
    if (study) return start + "opens | " + tableCell(summaryOf(*study)) + " |";
    std::string why = sentenceOf(study.error(), path);
    if (study.error().framesCouldBeSlices) why += asSlices(path);
    return start + "refused | " + tableCell(why) + " |";
}

Result<std::string> fileTable(const std::string& folder, const Progress& progress, const std::string& output) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    std::filesystem::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error))
        if (entry->is_regular_file() && !entry->path().filename().string().starts_with('.'))
            files.push_back(entry->path());
    if (error)
        return fail(FailureKind::unreadable, folder, "", "is no folder that can be read: " + error.message(),
                    "Check the name and the permissions.");
    std::sort(files.begin(), files.end());
    std::vector<std::string> inputs;
    inputs.reserve(files.size());
    for (const std::filesystem::path& file : files) inputs.push_back(file.string());
    if (auto kept = refuseToOverwrite(inputs, {output}); !kept) return tl::unexpected(kept.error());
    std::string table = "| file | | what was read, or why not |\n|---|---|---|\n";
    for (const std::filesystem::path& file : files) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, folder, "", "was not looked through: cancelled");
        table += fileRow(file.string(), file.lexically_relative(folder).string()) + "\n";
    }
    return table;
}

}  // namespace echolucent::cli
