#include "app/pages/lesson_handout.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include "app/pages/html_page.h"
#include "io/lesson/lesson_settings.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/pane_picture/small_picture.h"
#include "processing/phantom/phantom.h"

namespace echolucent {

namespace {

std::string paneWords(const Document& document, std::size_t pane) {
    const DesignerConfig* designer = designerConfigOf(document, pane);
    const std::string otf = designer != nullptr ? std::string(labelOf(designerOf(*designer)))
                                                : std::string(nameOf(document.panes.at(pane).curve));
    return document.panes.size() == 1 ? otf : fmt::format("{}: {}", pane + 1, otf);
}

char letterOf(std::size_t answer) { return static_cast<char>('a' + answer); }

std::string scanWords(const SimulatedScan& scan) {
    return fmt::format("simulated scan \"{}\" of {} x {} x {} voxels, seed {}", nameOf(scan.scene), scan.size[0],
                       scan.size[1], scan.size[2], scan.seed);
}

void addStep(HtmlPage& page, const Lesson& lesson, const LessonStepText& words, const LessonPictures& pictures) {
    for (const auto& [picture, caption] : pictures) page.picture(picture, caption);
    page.markdown(words.text, lesson.images);
    if (!words.hint.empty()) page.markdown("*Hint:* " + words.hint, lesson.images);
    page.markdown(words.question, lesson.images);
    for (std::size_t i = 0; i < words.answers.size(); ++i)
        page.markdown(fmt::format("({}) {}", letterOf(i), words.answers[i]), lesson.images);
}

void addAnswers(HtmlPage& page, const Lesson& lesson, const LessonText& text) {
    bool first = true;
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        const LessonStepText& words = text.steps.at(step);
        if (words.answers.empty()) continue;
        if (std::exchange(first, false)) page.heading("Answers");
        const std::size_t right = lesson.steps[step].right;
        page.markdown(fmt::format("**{}. ({})** {}", step + 1, letterOf(right), words.answers.at(right)),
                      lesson.images);
        page.markdown(words.explanation, lesson.images);
    }
}

void addSettings(HtmlPage& page, const Lesson& lesson) {
    std::vector<std::vector<std::string>> rows;
    const auto settings = settingsOf(lesson);
    for (std::size_t step = 0; step < settings.size(); ++step)
        for (const LessonSetting& setting : settings[step])
            rows.push_back({"step " + std::to_string(step + 1), setting.path, setting.value});
    if (rows.empty()) return;
    page.heading("What the steps set");
    page.table({"", "value", "is"}, rows,
               "Where a step goes on from the one before, it sets what is named here alone.");
}

}  // namespace

std::optional<std::vector<LessonPictures>> lessonPictures(const Lesson& lesson, const Progress& progress) {
    const auto& scan = std::get<SimulatedScan>(lesson.begins.study);
    PhantomConfig config = defaultPhantom(scan.scene);
    config.size = scan.size;
    config.seed = scan.seed;
    auto volume = makePhantom(config, progress);
    if (!volume) return std::nullopt;
    PaneCaster caster({.scans = {std::make_shared<const Volume>(std::move(*volume))}});
    std::vector<LessonPictures> pictures;
    std::optional<Document> shown;
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        LessonPictures& own = pictures.emplace_back();
        const Document document = documentBefore(lesson, step);
        if (shown == document) continue;
        shown = document;
        constexpr std::array widths{480, 320, 240, 240};  // pixels, of 1 to 4 panes
        const int width = widths.at(document.panes.size() - 1);
        for (std::size_t pane = 0; pane < document.panes.size(); ++pane) {
            auto picture = smallPicture(caster, document, pane, width, width * 3 / 4, progress);
            if (!picture) return std::nullopt;
            own.emplace_back(std::move(*picture), paneWords(document, pane));
        }
    }
    return pictures;
}

std::string lessonHandout(const Lesson& lesson, const LessonHandout& handout) {
    const LessonText& text = textIn(lesson, handout.language);
    HtmlPage page(text.title, HtmlPage::anyBytes);
    page.markdown(text.summary, lesson.images);
    page.paragraph(fmt::format("{} minutes. All pictures show a {}: no patient.", lesson.minutes,
                               scanWords(std::get<SimulatedScan>(lesson.begins.study))));
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        const LessonStepText& words = text.steps.at(step);
        page.heading(fmt::format("{}. {}", step + 1, words.title));
        addStep(page, lesson, words, step < handout.pictures.size() ? handout.pictures[step] : LessonPictures{});
    }
    addAnswers(page, lesson, text);
    addSettings(page, lesson);
    page.paragraph("Made with " + handout.program + ".");
    return page.text();
}

}  // namespace echolucent
