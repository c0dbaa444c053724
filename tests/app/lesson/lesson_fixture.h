// The real main window for tests that play lessons.
#pragma once

#include "app/lesson/lesson_player.h"
#include "tests/app/lesson/small_lesson.h"
#include "tests/app/window_fixture.h"

namespace echolucent {

class LessonFixture : public WindowFixture {
public:
    /// A person's own study. Pictures play no part.
    void writeStudy() {
        lookAtNoPicture();
        lookAlongAssumedBeam();
        m_study = file("heart.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    [[nodiscard]] const QString& study() const { return m_study; }
    [[nodiscard]] const Document& document() { return window().document().document(); }
    [[nodiscard]] LessonPlayer& player() { return window().lessonPlayer(); }
    void enter(const Lesson& lesson) {
        player().enter(lesson);
        QTRY_VERIFY(player().playing());
        waitUntilIdle();
    }

private:
    QString m_study;
};

}  // namespace echolucent
