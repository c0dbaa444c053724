#include "io/study/named_study.h"

namespace echolucent {

StudyFile asOpened(StudyFile file, const Study& study) {
    file.turnedAxis = study.turnedAxis;
    if (study.phases.front()->blackValue() == 0.0) file.options.blackAtZero = true;
    return file;
}

}  // namespace echolucent
