#include <cmath>
#include <numbers>

#include "processing/phantom/phantom_fetus.h"

namespace echolucent {

namespace {

double wave(double phase) { return std::sin(2 * std::numbers::pi * phase); }

void addSpine(Sculpture bone) {
    // Vertebrae along the bent back.
    constexpr int count = 14;
    for (int i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / (count - 1);
        const double bend = 4 * t * (1 - t);
        bone.join(sphere("vertebra", {-0.05 - 0.085 * bend, 0.14 - 0.56 * t, 0}, 0.014), 0);
    }
}

/// Four fingers and a thumb from a palm, fanned in the plane of `ahead` and `across`.
void addDigits(Sculpture flesh, const Vec3& root, const Vec3& ahead, const Vec3& across, double length, double spread,
               double radius) {
    for (int digit = 0; digit < 4; ++digit) {
        const double place = (digit - 1.5) / 1.5;
        const Vec3 from = root + across * (place * spread);
        const Vec3 tip = from + ahead * (length * (1 - 0.15 * std::abs(place - 0.2))) + across * (place * spread * 0.7);
        flesh.join(roundCone("finger", from, tip, radius, radius * 0.85), radius * 0.6);
    }
    const Vec3 thumb = root - ahead * (0.6 * length) + across * (spread * 1.1);
    flesh.join(roundCone("thumb", thumb, thumb + ahead * (0.5 * length) + across * (spread * 1.2), radius * 1.05,
                         radius * 0.9),
               radius * 0.8);
}

struct Limb {
    const char* upperName;
    const char* lowerName;
    Vec3 root, joint, end;
    double rootRadius, jointRadius, endRadius;
};

void addLimb(FetusBodies& bodies, const Placement& fetus, const Limb& limb) {
    Sculpture flesh{bodies.flesh, fetus}, bone{bodies.bone, fetus};
    flesh.join(roundCone(limb.upperName, limb.root, limb.joint, limb.rootRadius, limb.jointRadius), 0.035);
    flesh.join(roundCone(limb.lowerName, limb.joint, limb.end, limb.jointRadius, limb.endRadius), 0.012);
    const double boneRadius = 0.24 * limb.jointRadius;
    const auto within = [](const Vec3& a, const Vec3& b, double share) { return a + (b - a) * share; };
    bone.join(roundCone(limb.upperName, within(limb.root, limb.joint, 0.12), within(limb.root, limb.joint, 0.9),
                        boneRadius, boneRadius),
              0);
    bone.join(roundCone(limb.lowerName, within(limb.joint, limb.end, 0.1), within(limb.joint, limb.end, 0.92),
                        boneRadius * 0.85, boneRadius * 0.85),
              0);
}

void addFoot(Sculpture flesh, const Vec3& ankle, const Vec3& toes, const Vec3& sole) {
    const Vec3 heel = ankle - toes * 0.035 + sole * 0.035, ball = ankle + toes * 0.095 + sole * 0.045;
    flesh.join(sphere("heel", heel, 0.036), 0.02);
    flesh.join(roundCone("foot", heel, ball, 0.034, 0.030), 0.02);
    const Vec3 across{sole[1] * toes[2] - sole[2] * toes[1], sole[2] * toes[0] - sole[0] * toes[2],
                      sole[0] * toes[1] - sole[1] * toes[0]};
    for (int toe = 0; toe < 5; ++toe) {
        const double place = (toe - 2) / 2.0;
        const Vec3 from = ball + across * (place * 0.030);
        flesh.join(roundCone("toe", from, from + toes * (0.026 + 0.005 * place), 0.0125, 0.0115 + 0.0015 * place),
                   0.010);
    }
}

}  // namespace

void addTrunk(FetusBodies& bodies, const Placement& fetus, double phase) {
    Sculpture flesh{bodies.flesh, fetus}, bone{bodies.bone, fetus}, chambers{bodies.chambers, fetus};
    flesh.join(roundCone("neck", {-0.03, 0.20, 0}, {-0.05, 0.10, 0}, 0.085, 0.095), 0.06);
    flesh.join(ellipsoid("chest", {-0.03, -0.02, 0}, {0.135, 0.17, 0.135}), 0.06);
    flesh.join(ellipsoid("back", {-0.075, -0.15, 0}, {0.085, 0.22, 0.10}), 0.06);
    flesh.join(ellipsoid("belly", {0.02, -0.20, 0}, {0.160, 0.16, 0.150}), 0.07);
    flesh.join(ellipsoid("hips", {-0.03, -0.36, 0}, {0.115, 0.11, 0.13}), 0.07);
    flesh.join(ellipsoid("buttock, near side", {-0.072, -0.41, 0.06}, {0.100, 0.095, 0.082}), 0.04);
    flesh.join(ellipsoid("buttock, far side", {-0.072, -0.41, -0.06}, {0.100, 0.095, 0.082}), 0.04);
    flesh.join(sphere("shoulder, near side", {-0.03, 0.07, 0.12}, 0.058), 0.05);
    flesh.join(sphere("shoulder, far side", {-0.03, 0.07, -0.12}, 0.058), 0.05);
    addSpine(bone);
    const double beat = 1 + 0.22 * wave(phase);
    chambers.join(ellipsoid("heart", {0.03, 0.01, 0.01}, Vec3(0.036, 0.030, 0.030) * beat, rotationZ(-30)), 0);
    chambers.join(ellipsoid("stomach", {0.03, -0.13, 0.03}, {0.034, 0.024, 0.024}), 0);
    chambers.join(ellipsoid("bladder", {0.05, -0.335, 0}, {0.024, 0.024, 0.022}), 0);
}

void addArms(FetusBodies& bodies, const Placement& fetus, double phase) {
    Sculpture flesh{bodies.flesh, fetus};
    // Near arm: bent before the chest, the hand below the chin.
    addLimb(bodies, fetus,
            {"upper arm, near side",
             "forearm, near side",
             {-0.03, 0.06, 0.135},
             {0.09, -0.125, 0.20},
             {0.225, -0.005, 0.135},
             0.050,
             0.041,
             0.030});
    flesh.join(ellipsoid("palm, near side", {0.254, 0.030, 0.125}, {0.034, 0.044, 0.024}, rotationZ(-35)), 0.015);
    addDigits(flesh, {0.272, 0.064, 0.120}, normalized(Vec3(0.35, 0.9, -0.25)), normalized(Vec3(-0.85, 0.30, 0.25)),
              0.054, 0.027, 0.0130);

    // Far arm: it waves about the elbow.
    const double swing = 16 * wave(phase);
    const Vec3 shoulder{-0.03, 0.065, -0.135}, elbow{0.20, -0.03, -0.17};
    const Mat3 turn = rotationZ(swing);
    const Vec3 wrist = elbow + turn * Vec3(0.125, 0.115, 0.02);
    addLimb(bodies, fetus, {"upper arm, far side", "forearm, far side", shoulder, elbow, wrist, 0.048, 0.040, 0.029});
    const Vec3 ahead = turn * normalized(Vec3(0.60, 0.78, 0.10)), across = turn * normalized(Vec3(-0.78, 0.60, 0.15));
    flesh.join(ellipsoid("palm, far side", wrist + ahead * 0.035, {0.034, 0.044, 0.022}, turn * rotationZ(-38)), 0.015);
    addDigits(flesh, wrist + ahead * 0.070, ahead, across, 0.058, 0.030, 0.0130);
}

void addLegs(FetusBodies& bodies, const Placement& fetus) {
    Sculpture flesh{bodies.flesh, fetus};
    const Vec3 nearAnkle{0.195, -0.455, 0.095}, farAnkle{0.305, -0.475, -0.075};
    addLimb(bodies, fetus,
            {"thigh, near side",
             "shin, near side",
             {-0.02, -0.385, 0.085},
             {0.255, -0.235, 0.140},
             nearAnkle,
             0.080,
             0.056,
             0.034});
    addFoot(flesh, nearAnkle, normalized(Vec3(0.95, -0.12, 0.25)), normalized(Vec3(-0.15, -0.95, 0.25)));
    addLimb(bodies, fetus,
            {"thigh, far side",
             "shin, far side",
             {-0.02, -0.385, -0.085},
             {0.315, -0.265, -0.125},
             farAnkle,
             0.078,
             0.054,
             0.034});
    addFoot(flesh, farAnkle, normalized(Vec3(0.92, 0.20, 0.30)), normalized(Vec3(0.15, -0.95, 0.20)));
}

}  // namespace echolucent
