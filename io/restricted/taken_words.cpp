#include "io/restricted/taken_words.h"

#include <fmt/format.h>

#include "processing/one_line.h"

namespace echolucent::restricted {

namespace {

template <typename... Texts>
void makeLines(Texts&... texts) {
    ((texts = oneLine(texts, longestTakenLine)), ...);
}

void makeLines(std::vector<std::string>& sentences) {
    if (sentences.size() > mostTakenLines) {
        const std::size_t more = sentences.size() - (mostTakenLines - 1);
        sentences.resize(mostTakenLines - 1);
        sentences.push_back(fmt::format("{} more notes are not shown.", more));
    }
    for (std::string& sentence : sentences) makeLines(sentence);
}

}  // namespace

void makeHarmless(Failure& failure) { makeLines(failure.element, failure.problem, failure.remedy); }

void makeHarmless(Study& study) {
    makeLines(study.name);
    if (study.facts.size() > mostTakenLines) study.facts.resize(mostTakenLines);
    for (ImportFact& fact : study.facts) makeLines(fact.name, fact.value, fact.source);
    makeLines(study.warnings);
}

void makeHarmless(SeriesList& list) {
    for (SeriesEntry& entry : list.series) {
        makeLines(entry.uid, entry.object, entry.description, entry.modality, entry.distinction, entry.phases.source,
                  entry.phases.timeSource);
        makeLines(entry.notes);
        for (SeriesFile& file : entry.files)
            if (file.damage) makeHarmless(*file.damage);
        if (entry.whyNot) makeHarmless(*entry.whyNot);
    }
    makeLines(list.warnings);
}

void makeHarmless(Patient& patient) {
    makeLines(patient.name, patient.id, patient.birthDate, patient.sex, patient.studyDate, patient.gestationalAge);
}

}  // namespace echolucent::restricted
