// A lesson while a person writes it: made from snapshots, changed step by step, and what is still wrong with it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/document/saved_session.h"
#include "processing/lesson/lesson.h"

namespace echolucent {

/// A lesson that need not hold its rules yet, and where its writer is in it.
struct LessonDraft {
    Lesson lesson;
    std::string folder{};      ///< in which it was saved last; empty if it never was
    std::size_t language = 0;  ///< the place of the texts that are edited in Lesson::texts
    std::size_t step = 0;      ///< that is edited, counted from 0
    friend bool operator==(const LessonDraft&, const LessonDraft&) = default;
};

/// Why no lesson can be made of so many snapshots of a study, as a sentence. Empty if one can be made.
[[nodiscard]] std::string whyNoLesson(const StudyReference& study, std::size_t snapshots);
/// A lesson of a step a snapshot. It has their names as titles, no words yet, and the texts of one language. The
/// snapshots' study is `scan`, for which whyNoLesson() must be empty. std::invalid_argument if it is not.
[[nodiscard]] Lesson lessonOfSnapshots(const SimulatedScan& scan, const std::vector<Snapshot>& snapshots,
                                       const std::string& language);

/// An id that no step of the lesson has, made of the letters and digits of a name.
[[nodiscard]] std::string freeLessonId(const Lesson& lesson, const std::string& name);
/// Puts a step without words at a place, 0 to the number of steps. Its title is the same in all languages.
/// std::out_of_range if there is no such place.
void insertStep(Lesson& lesson, std::size_t place, const std::string& title, const Document& set);
/// std::out_of_range if there is no such step.
void removeStep(Lesson& lesson, std::size_t step);
/// Moves a step to the place of another one. std::out_of_range if there is no such step.
void moveStep(Lesson& lesson, std::size_t step, std::size_t place);
/// Adds an answer without words to a step's question, in all languages.
void addAnswer(Lesson& lesson, std::size_t step);
/// Removes an answer in all languages. The right one stays the same if it stays. std::out_of_range if there is none.
void removeAnswer(Lesson& lesson, std::size_t step, std::size_t answer);
/// The lesson without blanks and empty lines around its texts, as a file would give them back.
[[nodiscard]] Lesson trimmed(Lesson lesson);

/// The comparisons of a condition that is none, one comparison, or one list of comparisons; no value for others.
[[nodiscard]] std::optional<std::vector<LessonCondition>> comparisonsIn(const std::optional<LessonCondition>& until);
/// The condition that all (or one) of some comparisons hold; none without any.
[[nodiscard]] std::optional<LessonCondition> conditionOf(ConditionKind allOrAny,
                                                         const std::vector<LessonCondition>& comparisons);
/// A value as a person types it: `linear`, `12.5`, `true`, `null`. A text that would be another value has quotes.
[[nodiscard]] std::string typedOf(const DocumentValue& value);
/// The value that a person typed. typedOf() of a value gives it back.
[[nodiscard]] DocumentValue valueTyped(std::string_view text);

/// Where something is wrong.
enum class LessonField {
    title,
    summary,
    steps,
    stepTitle,
    text,
    hint,
    target,
    condition,
    question,
    explanation,
    whole
};
struct LessonProblem {
    LessonField field = LessonField::whole;
    std::optional<std::size_t> step{};      ///< none for what belongs to no step
    std::optional<std::size_t> language{};  ///< the place of its texts in Lesson::texts; none if it is none of theirs
    std::string sentence;                   ///< for a person
    friend bool operator==(const LessonProblem&, const LessonProblem&) = default;
};
/// What problemsOf() asks of others.
struct LessonNames {
    /// Whether a name is a value of one of the documents of a step, or measured.
    std::function<bool(std::size_t step, const std::string& name)> isValue;
    std::function<bool(const std::string& name)> isControl;  ///< whether the window has a control of this name
};
/// All that keeps a lesson from being played and saved, one sentence a field, in the order of a lesson's parts. Empty
/// if problemOf(trimmed(lesson)) is and if all names are known.
[[nodiscard]] std::vector<LessonProblem> problemsOf(const Lesson& lesson, const LessonNames& names);

}  // namespace echolucent
