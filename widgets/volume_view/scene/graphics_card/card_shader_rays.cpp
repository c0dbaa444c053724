#include "widgets/volume_view/scene/graphics_card/card_shader_parts.h"

namespace echolucent::card_shader {

const char* const raysPart = R"(
uniform vec3 first, perColumn, perRow;
uniform vec3 low, high;  // voxels
uniform vec3 spacing;    // mm
uniform float stepMm, startDepth;
uniform float ends;      // the transmittance below which a ray ends
vec3 origin, way, direction;  // the way is a step in voxels, the direction is in mm and has length 1
float depthStart, depthStep;  // mm
float enter, leave;           // steps

#ifdef PARALLEL
uniform vec3 parallelWay, forward;
#else
uniform vec3 eye, forward;
uniform float nearDepth, eyeDepth;
#endif
#if HALF_SPACES > 0
uniform vec4 halfSpaces[HALF_SPACES];
#endif
)";

const char* const frontPart = R"(
uniform sampler2D surface;  // the depths of its nodes, mm
uniform vec3 surfaceRight, surfaceDown, surfaceForward, surfaceFirst;

// How far a place, in columns and rows of nodes and mm of depth, lies behind the surface, mm.
float behind(vec3 place) {
    ivec2 count = textureSize(surface, 0);
    vec2 at = clamp(place.xy, vec2(0.0), vec2(count - 1));
    ivec2 low = min(ivec2(at), count - 2);
    vec2 share = at - vec2(low);
    vec2 near = vec2(texelFetch(surface, low, 0).r, texelFetch(surface, low + ivec2(1, 0), 0).r);
    vec2 far = vec2(texelFetch(surface, low + ivec2(0, 1), 0).r, texelFetch(surface, low + 1, 0).r);
    vec2 rows = near + share.y * (far - near);
    return place.z - (rows.x + share.x * (rows.y - rows.x));
}
// The first place in [0,1] at which a parabola through (0, a), (1/2, b), (1, c) is at least 0; 2 if there is none.
float firstRoot(float a, float b, float c) {
    if (a >= 0.0) return 0.0;
    float square = 2.0 * (a - 2.0 * b + c), linear = c - a - square;
    float discriminant = linear * linear - 4.0 * square * a;
    float nearest = 2.0;
    if (discriminant >= 0.0) {
        float q = -0.5 * (linear + (linear < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
        float one = square != 0.0 ? q / square : -1.0, other = q != 0.0 ? a / q : -1.0;
        if (one >= 0.0 && one <= 1.0) nearest = one;
        if (other >= 0.0 && other <= 1.0) nearest = min(nearest, other);
    }
    return nearest > 1.0 && c >= 0.0 ? 1.0 : nearest;
}
// As CutSurface::firstLeft().
void cutAtSurface() {
    vec3 point = origin * spacing;
    vec3 start = vec3(dot(surfaceRight, point), dot(surfaceDown, point), dot(surfaceForward, point)) - surfaceFirst;
    vec3 perMm = vec3(dot(surfaceRight, direction), dot(surfaceDown, direction), dot(surfaceForward, direction));
    vec2 last = vec2(textureSize(surface, 0) - 1);
    float from = enter * stepMm, end = leave * stepMm, begin = 0.0;
    bool begun = false;
    leave = -1e15;
    int patches = 2 * int(last.x + last.y) + 8;
    for (int i = 0; i < patches && from < end; ++i) {
        float to = end;
        for (int axis = 0; axis < 2; ++axis) {
            if (perMm[axis] == 0.0) continue;
            const float rounding = 1e-4;
            float at = start[axis] + perMm[axis] * from;
            float node = perMm[axis] > 0.0 ? max(floor(at + rounding) + 1.0, 0.0)
                                           : min(ceil(at - rounding) - 1.0, last[axis]);
            float mm = (node - start[axis]) / perMm[axis];
            if (node >= 0.0 && node <= last[axis] && mm > from) to = min(to, mm);
        }
        float a = behind(start + perMm * from), b = behind(start + perMm * (0.5 * (from + to)));
        float c = behind(start + perMm * to), entered = 0.0;
        if (!begun) {
            float root = firstRoot(a, b, c);
            begun = root <= 1.0;
            begin = from + root * (to - from);
            entered = min(root, 1.0);
        }
        if (begun) {
            enter = begin / stepMm;
            leave = end / stepMm;
        }
        if (begun && c < 0.0) {
            float root = firstRoot(c, b, a);
            float left = root <= 1.0 ? 1.0 - root : entered;
            leave = (from + max(entered, left) * (to - from)) / stepMm;
            return;
        }
        from = to;
    }
}
)";

const char* const stepsPart = R"(
void aim(vec2 pixel) {
    vec3 start = first + perColumn * pixel.x + perRow * pixel.y;
    float from = 0.0;
#ifdef PARALLEL
    origin = start;
    way = parallelWay;
    direction = forward;
    depthStart = startDepth;
    depthStep = stepMm;
#else
    direction = normalize(start);
    float cosine = dot(direction, forward);
    origin = (eye + direction * startDepth) / spacing;
    way = direction * stepMm / spacing;
    depthStart = eyeDepth + startDepth * cosine;
    depthStep = stepMm * cosine;
    from = max((nearDepth / cosine - startDepth) / stepMm, 0.0);
#endif
    enter = from;
    leave = 1e15;
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0.0) {
            if (origin[axis] < low[axis] || origin[axis] >= high[axis]) leave = -1e15;
            continue;
        }
        float a = (low[axis] - origin[axis]) / way[axis], b = (high[axis] - origin[axis]) / way[axis];
        enter = max(enter, min(a, b));
        leave = min(leave, max(a, b));
    }
#if HALF_SPACES > 0
    for (int i = 0; i < HALF_SPACES; ++i) {
        float value = halfSpaces[i].w + dot(halfSpaces[i].xyz, origin), slope = dot(halfSpaces[i].xyz, way);
        if (slope > 0.0) enter = max(enter, -value / slope);
        if (slope < 0.0) leave = min(leave, -value / slope);
        if (slope == 0.0 && value < 0.0) leave = -1e15;
    }
#endif
#ifdef BOWED
    if (enter < leave) cutAtSurface();
#endif
}

// The steps of a ray: the whole steps from `next` to before `last`, and the cut ones before and behind them.
int next, last;
float headAt, headLength, tailAt, tailLength;
bool cutIntoSteps() {
    if (!(enter < leave)) return false;
    float up = ceil(enter), down = floor(leave);
    bool whole = up <= down;
    float headEnd = whole ? up : leave;
    headLength = headEnd - enter;
    headAt = 0.5 * (enter + headEnd);
    tailLength = whole ? leave - down : 0.0;
    tailAt = 0.5 * (down + leave);
    next = whole ? int(up) : 0;
    last = whole ? int(down) : 0;
    return true;
}
)";

}  // namespace echolucent::card_shader
