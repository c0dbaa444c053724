#include "widgets/volume_view/scene/graphics_card/card_shader_parts.h"

namespace echolucent::card_shader {

const char* const samplesPart = R"(
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
    return ownMeanOf(from, at, BYTES);
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

const char* const opacitiesPart = R"(
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

const char* const lightPart = R"(
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

}  // namespace echolucent::card_shader
