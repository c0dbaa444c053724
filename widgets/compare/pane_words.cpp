#include "widgets/compare/pane_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "processing/document/panes.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {
QString words(const char* text) { return QCoreApplication::translate("echolucent::ComparePanel", text); }
}  // namespace

QString labelOfCurve(CurveKind kind) {
    switch (kind) {
        case CurveKind::adaptive: return words("Adaptive curve");
        case CurveKind::manual: return words("Manual curve");
        case CurveKind::linear: return words("Piecewise linear curve (eq. 1)");
        case CurveKind::parabolic: return words("x² (parabolic curve)");
        case CurveKind::quartic: return words("x⁴ (quartic curve)");
    }
    return {};
}

QString labelOfDesigner(Designer designer) {
    if (designer == designerOf(AdaptiveConfig{})) return words("Adaptive, as a designer");
    return textOf(labelOf(designer));
}

QString wordsOf(MotionOtf otf) {
    switch (otf) {
        case MotionOtf::oneOtf: return words("one OTF");
        case MotionOtf::eachView: return words("each view's OTF");
        case MotionOtf::mean: return words("mean of 5");
        case MotionOtf::movingLeastSquares: return words("least squares");
        case MotionOtf::leastFlicker: return words("least flicker");
    }
    return {};
}

QString wordsOf(MethodReading reading) {
    switch (reading) {
        case MethodReading::asPublished: return words("as published");
        case MethodReading::settled: return words("settled");
        case MethodReading::firstVersion: return words("as in 0.1");
        case MethodReading::standard: return words("default");
    }
    return {};
}

QString nameOfPane(const Pane& choice) {
    QString name;
    if (isAdaptive(choice) && !choice.withoutTubes.empty()) {
        QStringList tubes;
        for (const int tube : choice.withoutTubes) tubes << QString::number(tube);
        name = words("Adaptive without tube core %1").arg(tubes.join(QStringLiteral(", ")));
    } else if (choice.designer) {
        name = labelOfDesigner(designerOf(*choice.designer));
    } else {
        const bool own = choice.curve == CurveKind::linear && choice.linear && *choice.linear != LinearCurve{};
        name = own ? words("Piecewise linear curve of its own") : labelOfCurve(choice.curve);
    }
    if (choice.method && isAdaptive(choice)) {
        const auto reading = readingOf(*choice.method);
        name += QStringLiteral(", ") + (reading ? wordsOf(*reading) : words("own parameters"));
    }
    if (choice.motionOtf) name += QStringLiteral(", ") + wordsOf(*choice.motionOtf);
    return choice.phase ? words("%1, volume %2").arg(name).arg(*choice.phase + 1) : name;
}

}  // namespace echolucent
