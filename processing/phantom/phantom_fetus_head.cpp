#include <array>

#include "processing/phantom/phantom_fetus.h"

namespace echolucent {

namespace {

/// The head's own frame. Its unit is half the length from brow to occiput.
Placement headPose(const Placement& fetus) {
    Placement head;
    head.origin = {0.025, 0.315, 0};
    head.axes = rotationZ(-14);  // chin towards the chest
    head.scale = 0.205;
    return fetus * head;
}

void addCranium(Sculpture flesh) {
    flesh.join(ellipsoid("cranium", {-0.14, 0.16, 0}, {0.98, 0.80, 0.76}), 0);
    flesh.join(ellipsoid("forehead", {0.38, 0.28, 0}, {0.55, 0.56, 0.60}), 0.20);
    flesh.join(ellipsoid("occiput", {-0.62, 0.02, 0}, {0.50, 0.52, 0.56}), 0.20);
}

void addFace(Sculpture flesh) {
    flesh.join(ellipsoid("face", {0.36, -0.40, 0}, {0.43, 0.46, 0.48}), 0.22);
    flesh.join(roundCone("jaw, near side", {0.62, -0.75, 0.06}, {0.00, -0.46, 0.46}, 0.15, 0.20), 0.16);
    flesh.join(roundCone("jaw, far side", {0.62, -0.75, -0.06}, {0.00, -0.46, -0.46}, 0.15, 0.20), 0.16);
    flesh.join(ellipsoid("cheek, near side", {0.54, -0.48, 0.30}, {0.25, 0.24, 0.21}), 0.14);
    flesh.join(ellipsoid("cheek, far side", {0.54, -0.48, -0.30}, {0.25, 0.24, 0.21}), 0.14);
    flesh.join(sphere("chin", {0.735, -0.80, 0}, 0.115), 0.10);
}

void addEyes(Sculpture flesh) {
    for (const double side : {1.0, -1.0}) {
        const char* orbit = side > 0 ? "orbit, near side" : "orbit, far side";
        const char* lid = side > 0 ? "eye, near side" : "eye, far side";
        const char* slit = side > 0 ? "lid slit, near side" : "lid slit, far side";
        flesh.carve(ellipsoid(orbit, {0.84, -0.17, side * 0.33}, {0.18, 0.15, 0.20}, rotationY(-side * 25)), 0.12);
        flesh.join(ellipsoid(lid, {0.68, -0.185, side * 0.31}, {0.135, 0.125, 0.15}), 0.03);
        flesh.carve(ellipsoid(slit, {0.80, -0.225, side * 0.34}, {0.10, 0.016, 0.13}), 0.03);
        flesh.join(roundCone("brow", {0.86, 0.03, side * 0.12}, {0.72, 0.04, side * 0.44}, 0.065, 0.05), 0.16);
    }
}

void addNoseAndMouth(Sculpture flesh) {
    flesh.join(roundCone("bridge of the nose", {0.79, -0.14, 0}, {0.92, -0.34, 0}, 0.075, 0.085), 0.10);
    flesh.join(sphere("tip of the nose", {0.975, -0.355, 0}, 0.088), 0.05);
    for (const double side : {1.0, -1.0})
        flesh.join(sphere("wing of the nose", {0.885, -0.39, side * 0.095}, 0.075), 0.05);
    flesh.join(roundCone("upper lip, near side", {0.895, -0.535, 0}, {0.81, -0.575, 0.17}, 0.062, 0.035), 0.05);
    flesh.join(roundCone("upper lip, far side", {0.895, -0.535, 0}, {0.81, -0.575, -0.17}, 0.062, 0.035), 0.05);
    flesh.join(roundCone("lower lip, near side", {0.865, -0.655, 0}, {0.785, -0.615, 0.15}, 0.058, 0.035), 0.05);
    flesh.join(roundCone("lower lip, far side", {0.865, -0.655, 0}, {0.785, -0.615, -0.15}, 0.058, 0.035), 0.05);
    flesh.carve(ellipsoid("mouth", {0.92, -0.597, 0}, {0.14, 0.020, 0.20}), 0.03);
}

void addEars(Sculpture flesh) {
    for (const double side : {1.0, -1.0}) {
        const double out = side * 0.74;
        flesh.join(ellipsoid("ear", {-0.14, -0.22, out}, {0.17, 0.26, 0.07}, rotationY(side * 12)), 0.05);
        flesh.carve(ellipsoid("concha", {-0.11, -0.24, out + side * 0.07}, {0.085, 0.15, 0.06}), 0.04);
        const std::array<Vec3, 6> rim{Vec3{-0.03, -0.06, 0}, {-0.13, 0.00, 0.02},  {-0.24, -0.05, 0.04},
                                      {-0.28, -0.17, 0.04},  {-0.24, -0.31, 0.03}, {-0.15, -0.43, 0.0}};
        for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
            const Vec3 from{rim[i][0], rim[i][1], out + side * (0.04 + rim[i][2])};
            const Vec3 to{rim[i + 1][0], rim[i + 1][1], out + side * (0.04 + rim[i + 1][2])};
            flesh.join(roundCone("rim of the ear", from, to, 0.042, i + 2 == rim.size() ? 0.055 : 0.042), 0.02);
        }
    }
}

}  // namespace

void addHead(FetusBodies& bodies, const Placement& fetus) {
    const Placement head = headPose(fetus);
    Sculpture flesh{bodies.flesh, head}, bone{bodies.bone, head}, chambers{bodies.chambers, head};
    addCranium(flesh);
    addFace(flesh);
    addEyes(flesh);
    addNoseAndMouth(flesh);
    addEars(flesh);

    bone.join(ellipsoid("skull", {-0.14, 0.16, 0}, {0.88, 0.70, 0.66}), 0);
    bone.join(ellipsoid("frontal bone", {0.36, 0.24, 0}, {0.44, 0.46, 0.50}), 0.20);
    bone.carve(ellipsoid("brain", {-0.14, 0.17, 0}, {0.82, 0.64, 0.60}), 0.05);
    bone.carve(ellipsoid("frontal lobe", {0.34, 0.24, 0}, {0.40, 0.42, 0.46}), 0.05);
    bone.join(roundCone("lower jaw", {0.62, -0.73, 0}, {0.05, -0.45, 0.40}, 0.05, 0.05), 0.03);
    bone.join(roundCone("lower jaw", {0.62, -0.73, 0}, {0.05, -0.45, -0.40}, 0.05, 0.05), 0.03);
    chambers.join(ellipsoid("ventricle, near side", {-0.20, 0.22, 0.22}, {0.42, 0.17, 0.09}, rotationZ(10)), 0);
    chambers.join(ellipsoid("ventricle, far side", {-0.20, 0.22, -0.22}, {0.42, 0.17, 0.09}, rotationZ(10)), 0);
}

}  // namespace echolucent
