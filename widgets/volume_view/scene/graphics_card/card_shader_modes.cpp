#include "widgets/volume_view/scene/graphics_card/card_shader_parts.h"

namespace echolucent::card_shader {

const char* const directPart = R"(
#ifdef JUMPS
uniform sampler3D distances;
uniform vec3 bricks;
// How many steps from the next one on show nothing.
int emptySteps() {
    const float edge = 8.0, margin = 0.01;
    vec3 cube = origin + way * (float(next) + 0.5) + 1.0;
    vec3 brick = clamp(floor(cube / edge), vec3(0.0), bricks - 1.0);
    float distance = floor(texelFetch(distances, ivec3(brick), 0).r * 255.0 + 0.5);
    if (distance == 0.0) return 0;
    float steps = float(last - next);
    for (int axis = 0; axis < 3; ++axis) {
        float before = brick[axis] - distance + 1.0, behind = brick[axis] + distance;
        if (way[axis] > 0.0 && behind < bricks[axis])
            steps = min(steps, (behind * edge - margin - cube[axis]) / way[axis]);
        if (way[axis] < 0.0 && before > 0.0) steps = min(steps, (before * edge + margin - cube[axis]) / way[axis]);
    }
    return max(int(steps), 0);
}
#endif

vec3 colour = vec3(0.0);
float transmittance = 1.0, unlit = 1.0;

// The share of a cut's face changes over half a step.
float leftOfCutFace(float opacity, float units) {
    float tissue = min(units, opacity * 16.0);
    return 1.0 / (1.0 + 0.5 * ((1.0 / 16.0 + 1.0) * units - tissue));
}
void add(float at, float part, bool clear) {
    vec3 place = origin + way * at;
    float position = clear ? 0.0 : positionAt(place);
    float opacity = clear ? 0.0 : opacityOf(place, position, part), alpha = opacity, border = 0.0;
#ifdef PRESENCE
    float present = presenceAt(place);
#ifdef NEAREST
    alpha *= present >= 0.5 ? 1.0 : 0.0;
#else
    alpha *= clamp(2.0 * present - 0.5, 0.0, 1.0);
#endif
    border = clamp((0.875 - present) / 0.375, 0.0, 1.0);
#endif
#ifdef LIT
    float left = leftOfCutFace(opacity, part * stepUnits), unlitHere = max(unlit * left, border);
    unlit = unlitHere * left;
#endif
    if (!(alpha > 0.0)) return;
    vec3 seen = colourAt(position);
    float added = transmittance * alpha;
#ifdef LIT
    seen = lit(seen, lightOn(place, added), unlitHere);
#endif
#ifdef TINTED
    seen *= nearTint + tintChange * clamp((depthStart + depthStep * at - tintDepth) * tintPerMm, 0.0, 1.0);
#endif
    colour += added * seen;
    transmittance -= added;
}
bool ended() { return transmittance <= 0.0 || transmittance < ends; }

vec4 castRay() {
#ifdef LIT
    vec3 between = towardsLight - direction;
    halfway = dot(between, between) > 0.0 ? normalize(between) : vec3(0.0);
#endif
    // All steps go through one call, so that the program stays short.
    bool isHead = headLength > 0.0, fresh = true;
    int clearUpTo = 0;
    for (;;) {
        float at = headAt, part = headLength;
        bool clear = false;
        if (isHead) {
            isHead = false;
        } else if (next < last) {
            if (fresh || (next & 7) == 0) {
                fresh = false;
                if (ended()) break;
#ifdef JUMPS
                int empty = next < clearUpTo ? 0 : emptySteps();
                if (empty >= 8) {
#ifdef LIT
#ifdef PRESENCE
                    // Edges of the data farther back hardly matter.
                    int passed = empty - 8;
                    clearUpTo = next + empty;
#else
                    int passed = empty;
#endif
                    unlit *= exp(-2.0 * log(1.0 + 0.5 * (1.0 / 16.0 + 1.0) * stepUnits) * float(passed));
                    next += passed;
#else
                    next += empty;
#endif
                    fresh = true;
                    if (next >= clearUpTo) continue;
                    fresh = false;
                }
#endif
            }
            at = float(next) + 0.5;
            part = 1.0;
            clear = next < clearUpTo;
            ++next;
        } else if (tailLength > 0.0) {
            if (ended()) break;
            at = tailAt;
            part = tailLength;
            tailLength = 0.0;
        } else {
            break;
        }
        add(at, part, clear);
    }
    return vec4(min(colour, vec3(1.0)), 1.0 - transmittance);
}
)";

const char* const extremesPart = R"(
vec4 castRay() {
    float value = 0.0, count = 0.0;
    bool isHead = headLength > 0.0;
    for (;;) {
        float at = headAt, part = headLength;
        if (isHead) {
            isHead = false;
        } else if (next < last) {
            at = float(next) + 0.5;
            part = 1.0;
            ++next;
        } else if (tailLength > 0.0) {
            at = tailAt;
            part = tailLength;
            tailLength = 0.0;
        } else {
            break;
        }
        vec3 place = origin + way * at;
#ifdef PRESENCE
        // All or nothing at the rim of the data: there a card's filter would show other pixels.
#ifdef NEAREST
        if (presenceAt(place) < 0.5) continue;
#else
        if (ownMeanOf(presence, place, BYTES) < 0.5) continue;
#endif
#endif
        float position = positionAt(place);
#if defined(MEAN)
        value += part * position;
#elif defined(MINIMUM)
        if (count == 0.0 || position < value) value = position;
#else
        if (count == 0.0 || position > value) value = position;
#endif
        count += part;
    }
    if (count == 0.0) return vec4(0.0);
#ifdef MEAN
    value /= count;
#endif
    return vec4(colourAt(clamp(value, 0.0, white)), 1.0);
}
)";

const char* const pixelPart = R"(
uniform float brightness, weight;
in vec2 texCoord;
void main() {
    if (texCoord.x < -1.0) discard;  // never; VTK's rectangle asks that this is read
    vec4 seen = vec4(0.0);
    aim(floor(gl_FragCoord.xy));
    if (cutIntoSteps()) seen = castRay();
    if (brightness != 1.0) seen.rgb = min(seen.rgb * brightness, vec3(seen.a));
    gl_FragData[0] = seen * weight;
}
)";

}  // namespace echolucent::card_shader
