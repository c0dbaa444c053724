// A lesson of three steps on a small simulated scan: one to read, with a question, one to do, and two panes that are
// measured.
#pragma once

#include "processing/lesson/lesson.h"

namespace echolucent {

inline Lesson smallLesson() {
    Lesson lesson;
    lesson.minutes = 3;
    lesson.begins = lessonGround({PhantomScene::fetus, {48, 48, 40}, 7});
    lesson.begins.scene.look = Look{};
    lesson.begins.panes[0].curve = CurveKind::linear;
    Document two = lesson.begins;
    two.panes = {{.curve = CurveKind::linear}, {.curve = CurveKind::quartic}};
    two.scene.motionAngle = 12.5;
    Document solved = lesson.begins;
    solved.panes[0].curve = CurveKind::parabolic;
    LessonStep see{.id = "see", .lookAt = "view3d", .answers = 2, .right = 1};
    LessonStep choose{.id = "choose", .lookAt = "otfEditor.active.parabolic", .solved = solved};
    choose.until = LessonCondition{ConditionKind::equal, "panes[0].curve", std::string("parabolic")};
    LessonStep compare{.id = "compare", .set = two};
    compare.until = LessonCondition{ConditionKind::greater, "measured.panes[1].never", 1.0};
    lesson.steps = {see, choose, compare};
    LessonText text{"en", "Two curves", "What a curve does.", {}};
    text.steps = {{"See", "Look.", "", "Why?", {"No", "Yes"}, "So."},
                  {"Choose", "Take **x²**.", "The button."},
                  {"Compare", "Wait."}};
    lesson.texts = {text};
    return lesson;
}

}  // namespace echolucent
