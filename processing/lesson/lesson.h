// A lesson: steps on a simulated scan, each with a text, what it sets, and when it is done.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "processing/document/document.h"
#include "processing/lesson/lesson_condition.h"

namespace echolucent {

/// The limits of a lesson. What exceeds them is refused before it is kept.
inline constexpr std::size_t mostLessonSteps = 60;
inline constexpr std::size_t mostLessonLanguages = 20;
inline constexpr std::size_t mostLessonConditions = 200;  ///< of all steps together
inline constexpr std::size_t mostLessonAnswers = 6, fewestLessonAnswers = 2;
inline constexpr std::size_t mostLessonImages = 40;
inline constexpr std::size_t longestLessonId = 40;                       ///< bytes of a step's id
inline constexpr std::size_t longestLessonTitle = 120;                   ///< bytes
inline constexpr std::size_t longestLessonText = 8'000;                  ///< bytes of each text
inline constexpr std::size_t largestLessonImage = std::size_t{4} << 20;  ///< bytes of a file
inline constexpr int largestLessonImageSide = 2000;                      ///< pixels
inline constexpr std::int64_t largestLessonScan = 256;                   ///< voxels along an axis

struct LessonStep {
    std::string id;        ///< lower case letters, digits and hyphens; unique in the lesson
    std::string lookAt{};  ///< object name of what is outlined in the window; empty for nothing
    /// What the step sets; none if it goes on from the step before.
    std::optional<Document> set{};
    std::optional<LessonCondition> until{};  ///< when it is done; none if it is only read
    /// The document with which `until` holds, if a document alone can make it so.
    std::optional<Document> solved{};
    std::size_t answers = 0;  ///< of its question; 0 if it asks none
    std::size_t right = 0;    ///< which of them is right, counted from 0
    friend bool operator==(const LessonStep&, const LessonStep&) = default;
};

/// What a step says in one language, as Markdown.
struct LessonStepText {
    std::string title;
    std::string text;
    std::string hint{};                  ///< empty for none
    std::string question{};              ///< empty for none
    std::vector<std::string> answers{};  ///< of the question
    std::string explanation{};           ///< what is said once the question is answered; may be empty
    friend bool operator==(const LessonStepText&, const LessonStepText&) = default;
};

/// A lesson's texts in one language.
struct LessonText {
    std::string language;  ///< "en": the name of the text's file
    std::string title;
    std::string summary;                  ///< one or two sentences
    std::vector<LessonStepText> steps{};  ///< by place among the steps
    friend bool operator==(const LessonText&, const LessonText&) = default;
};

struct Lesson {
    int minutes = 20;  ///< that it takes, 1 to 600
    Document begins;   ///< with which it begins; its study is the lesson's simulated scan
    std::vector<LessonStep> steps{};
    std::vector<LessonText> texts{};              ///< at least one
    std::map<std::string, std::string> images{};  ///< bytes of PNG and JPEG files, by name
    friend bool operator==(const Lesson&, const Lesson&) = default;
};

/// The document from which a lesson on a simulated scan departs: the program's defaults, the whole scan seen along the
/// beam.
[[nodiscard]] Document lessonGround(const SimulatedScan& scan);
/// The document with which a step begins if each step before it was solved. Throws std::out_of_range if there is no
/// such step.
[[nodiscard]] Document documentBefore(const Lesson& lesson, std::size_t step);
/// The document of a step that is solved: LessonStep::solved, else documentBefore().
[[nodiscard]] Document documentAfter(const Lesson& lesson, std::size_t step);
/// The texts in a language ("pt-br"), else in this language without its country, else in English, else the first ones.
/// The lesson must have texts.
[[nodiscard]] const LessonText& textIn(const Lesson& lesson, const std::string& language);
/// Whether a text may be a step's id.
[[nodiscard]] bool isLessonId(const std::string& id);
/// Whether a text may name a language: two or three lower case letters, and two more of a country ("en", "pt-br").
[[nodiscard]] bool isLessonLanguage(const std::string& language);

/// problemOf() of all but the texts and the images.
[[nodiscard]] std::string problemOfSteps(const Lesson& lesson);
/// What breaks a rule, with its key ("steps[2].id must be ..."): lower case, no full stop. Empty if nothing does.
[[nodiscard]] std::string problemOf(const Lesson& lesson);

}  // namespace echolucent
