#include "widgets/volume_view/scene/graphics_card/card_shader.h"

#include <variant>

namespace echolucent {

namespace {

// VTK writes the version and the outputs in place of the first two lines.
constexpr const char* headPart = R"(//VTK::System::Dec
//VTK::Output::Dec
)";

constexpr const char* readingPart = R"(
uniform sampler3D voxels;
uniform vec3 size;         // voxels
uniform float toPosition;  // factor from a texel to its table position
const float white = 2040.0;

// Places are in voxels. If `coarse`, the mean has the shares along y with which the processor reads bytes.
float ownMeanOf(sampler3D from, vec3 at, bool coarse) {
    at = clamp(at, vec3(0.0), size - 1.0);
    ivec3 a = ivec3(at), b = min(a + 1, ivec3(size) - 1);
    vec3 share = at - vec3(a);
    if (coarse) share.y = floor(share.y * 128.0) / 127.0;
    vec4 near = vec4(texelFetch(from, a, 0).r, texelFetch(from, ivec3(b.x, a.yz), 0).r,
                     texelFetch(from, ivec3(a.x, b.y, a.z), 0).r, texelFetch(from, ivec3(b.xy, a.z), 0).r);
    vec4 far = vec4(texelFetch(from, ivec3(a.xy, b.z), 0).r, texelFetch(from, ivec3(b.x, a.y, b.z), 0).r,
                    texelFetch(from, ivec3(a.x, b.yz), 0).r, texelFetch(from, b, 0).r);
    vec4 slices = near + share.z * (far - near);
    vec2 rows = slices.xy + share.y * (slices.zw - slices.xy);
    return rows.x + share.x * (rows.y - rows.x);
}
float meanOf(sampler3D from, vec3 at) {
#ifdef EIGHT_FETCHES
    return ownMeanOf(from, at, false);
#else
    return textureLod(from, (at + 0.5) / size, 0.0).r;
#endif
}
float readAt(sampler3D from, vec3 at) {
#ifdef NEAREST
    return texelFetch(from, ivec3(clamp(floor(at + 0.5), vec3(0.0), size - 1.0)), 0).r;
#else
    return meanOf(from, at);
#endif
}
float positionAt(vec3 at) { return clamp(readAt(voxels, at) * toPosition, 0.0, white); }

#ifdef PRESENCE
uniform sampler3D presence;
float presenceAt(vec3 at) { return readAt(presence, at); }
#endif

uniform vec3 colourBase[4];
uniform vec3 colourSlope[4];
vec3 colourAt(float position) {
    int range = min(int(position * (4.0 / white)), 3);
    return colourBase[range] + colourSlope[range] * position;
}
)";

// Sets what RayGeometry sets.
constexpr const char* raysPart = R"(
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
#ifdef BOWED
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
#endif

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

constexpr const char* opacitiesPart = R"(
uniform float stepUnits;
#ifdef TWO_DIMENSIONAL
uniform sampler3D gradients;
uniform sampler2D nodes;
uniform float firstVisible;
float opacityOf(vec3 at, float position, float part) {
    if (position <= firstVisible) return 0.0;
    ivec2 count = textureSize(nodes, 0);
    vec2 place = vec2(position / white, readAt(gradients, at)) * vec2(count - 1);
    ivec2 a = min(ivec2(place), count - 2);
    vec2 share = place - vec2(a);
    vec2 near = vec2(texelFetch(nodes, a, 0).r, texelFetch(nodes, a + ivec2(0, 1), 0).r);
    vec2 far = vec2(texelFetch(nodes, a + ivec2(1, 0), 0).r, texelFetch(nodes, a + 1, 0).r);
    vec2 rows = near + share.x * (far - near);
    float opacity = rows.x + share.y * (rows.y - rows.x);
    return opacity >= 1.0 ? 1.0 : 1.0 - exp(stepUnits * part * log(1.0 - opacity));
}
#else
uniform sampler2D table;  // opacities and extinctions
float opacityOf(vec3 at, float position, float part) {
    int left = int(position);
    vec2 a = texelFetch(table, ivec2(left, 0), 0).rg, b = texelFetch(table, ivec2(left + 1, 0), 0).rg;
    vec2 entry = a + (position - float(left)) * (b - a);
    return part == 1.0 ? entry.x : 1.0 - exp(-part * entry.y);
}
#endif
)";

constexpr const char* lightPart = R"(
#ifdef LIT
uniform vec3 towardsLight, unitsPerVoxel, reach, shadowTint;
uniform float ambient, diffuse, evenLight, wrap, floorSquare, specular, specularPower;
uniform float worthGradient;
vec3 halfway;
// The full key light on surfaces.
float keyLight(vec3 at) {
    vec3 gradient = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        vec3 before = at, after = at;
        before[axis] = clamp(at[axis] - reach[axis], 0.0, size[axis] - 1.0);
        after[axis] = clamp(at[axis] + reach[axis], 0.0, size[axis] - 1.0);
        float units = (after[axis] - before[axis]) * unitsPerVoxel[axis];
        if (units > 0.0) gradient[axis] = (meanOf(voxels, after) - meanOf(voxels, before)) * (toPosition / white) / units;
    }
    float square = dot(gradient, gradient);
    if (!(square > 0.0)) return diffuse * evenLight;
    vec3 normal = gradient * -inversesqrt(square);
    float share = square / (square + floorSquare);
    float facing = max(0.0, (dot(normal, towardsLight) + wrap) / (1.0 + wrap));
    float cosine = clamp(dot(normal, halfway), 0.0, 1.0);
    float highlight = cosine > 0.0 ? specular * pow(cosine, specularPower) : 0.0;
    return diffuse * (share * facing + (1.0 - share) * evenLight) + share * highlight;
}
#ifdef REACHING
uniform sampler3D reaching;
uniform vec3 lightSize, lightPerVoxel, lightFirst;
uniform float shadow, occlusion, translucency;
vec2 reachingAt(vec3 at) {
    vec3 place = clamp(at * lightPerVoxel + lightFirst, vec3(0.0), lightSize - 1.0);
#ifdef EIGHT_FETCHES
    ivec3 a = ivec3(place), b = min(a + 1, ivec3(lightSize) - 1);
    vec3 share = place - vec3(a);
    vec4 near = mix(vec4(texelFetch(reaching, a, 0).rg, texelFetch(reaching, ivec3(a.x, b.y, a.z), 0).rg),
                    vec4(texelFetch(reaching, ivec3(b.x, a.yz), 0).rg, texelFetch(reaching, ivec3(b.xy, a.z), 0).rg),
                    share.x);
    vec4 far = mix(vec4(texelFetch(reaching, ivec3(a.xy, b.z), 0).rg, texelFetch(reaching, ivec3(a.x, b.yz), 0).rg),
                   vec4(texelFetch(reaching, ivec3(b.x, a.y, b.z), 0).rg, texelFetch(reaching, b, 0).rg), share.x);
    vec4 slices = mix(near, far, share.z);
    return mix(slices.xy, slices.zw, share.y);
#else
    return textureLod(reaching, (place + 0.5) / lightSize, 0.0).rg;
#endif
}
#endif
vec3 lightOn(vec3 at, float seen) {
    vec3 even = vec3(ambient + diffuse * evenLight);
    bool worth = seen >= worthGradient;
#ifdef REACHING
    if (seen < worthGradient / 16.0) return even;
    float key = worth ? keyLight(at) : diffuse * evenLight;
    vec2 shares = reachingAt(at);
    float k = shares.x;
    vec3 warm = vec3(mix(k, sqrt(k), translucency), k, mix(k, k * k, translucency));
    return ambient * (1.0 - occlusion * (1.0 - shares.y)) + (1.0 - shadow * (1.0 - warm)) * key;
#else
    return worth ? vec3(ambient + keyLight(at)) : even;
#endif
}
vec3 lit(vec3 colour, vec3 factor, float unlit) {
    vec3 mixed = mix(factor, vec3(1.0), unlit);
    return min(vec3(1.0), colour * mixed * mix(shadowTint, vec3(1.0), min(vec3(1.0), mixed)));
}
#endif

#ifdef TINTED
uniform vec3 nearTint, tintChange;
uniform float tintDepth, tintPerMm;
#endif
)";

constexpr const char* directPart = R"(
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
float transmittance = 1.0, depth = 1e38, unlit = 1.0;

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
    float before = transmittance;
    transmittance -= added;
    if (before > 0.5 && transmittance <= 0.5) depth = depthStart + depthStep * at;
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

constexpr const char* extremesPart = R"(
float depth = 1e38;
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
        bool better = count == 0.0;
        value += part * position;
#elif defined(MINIMUM)
        bool better = count == 0.0 || position < value;
        if (better) value = position;
#else
        bool better = count == 0.0 || position > value;
        if (better) value = position;
#endif
        if (better) depth = depthStart + depthStep * at;
        count += part;
    }
    if (count == 0.0) return vec4(0.0);
#ifdef MEAN
    value /= count;
#endif
    return vec4(colourAt(clamp(value, 0.0, white)), 1.0);
}
)";

constexpr const char* pixelPart = R"(
uniform float brightness, weight;
in vec2 texCoord;
void main() {
    if (texCoord.x < -1.0) discard;  // never; VTK's rectangle asks that this is read
    vec4 seen = vec4(0.0);
    aim(floor(gl_FragCoord.xy));
    bool any = cutIntoSteps();
    if (any) seen = castRay();
    if (brightness != 1.0) seen.rgb = min(seen.rgb * brightness, vec3(seen.a));
    gl_FragData[0] = seen * weight;
#ifdef DEPTHS
    gl_FragData[1] = vec4(any ? depth : 1e38);
#endif
}
)";

}  // namespace

std::string cardShader(const CardPicture& picture, const RayCastSettings& settings, CardReading reading) {
    const bool isDirect = settings.mode == RenderMode::direct;
    std::string source = headPart;
    const auto define = [&](const char* name, bool holds) {
        if (holds) source += std::string("#define ") + name + "\n";
    };
    define("EIGHT_FETCHES", reading == CardReading::eightFetches);
    define("NEAREST", settings.interpolation == Interpolation::nearest);
    define("PRESENCE", picture.presence != nullptr);
    define("PARALLEL", picture.rays.parallel);
    define("BOWED", picture.surface != nullptr);
    define("TWO_DIMENSIONAL", isDirect && picture.gradients);
    define("LIT", isDirect && settings.shading.has_value());
    define("REACHING", isDirect && settings.shading && picture.light);
    define("TINTED", isDirect && settings.depthColouring.has_value());
    define("JUMPS", isDirect && picture.bricks);
    define("MEAN", settings.mode == RenderMode::mean);
    define("MINIMUM", settings.mode == RenderMode::minimum);
    define("DEPTHS", settings.findDepth);
    const bool bytes = std::holds_alternative<VoxelArray<std::uint8_t>>(picture.scan->filled.voxels());
    source += std::string("#define BYTES ") + (bytes ? "true" : "false") + "\n";
    source += "#define HALF_SPACES " + std::to_string(picture.rays.halfSpaces.size()) + "\n";
    source += readingPart;
    source += raysPart;
    if (isDirect)
        source += std::string(opacitiesPart) + lightPart + directPart;
    else
        source += extremesPart;
    return source + pixelPart;
}

}  // namespace echolucent
